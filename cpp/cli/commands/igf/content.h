// The files that `girth igf` writes.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "commands/igf/options.h"
#include "girth/girth_field.h"
#include "girth/girth_solver.h"

namespace girth::cli::igf_command {

/// The vertices of the surface whose loops are wanted. Error: VERTEX_OUT_OF_RANGE.
Result<std::vector<Vertex>> basesOf(const io::LoadedMesh& loaded, const Options& options);

/// The values in the format of the output. Errors: those of the loops and tips; those of the
/// writers.
Result<std::string> contentFor(const Work& work, const GirthField& girth, const Options& options);

/// The saddles of all vertices in the format of `--barcode`.
std::string barcodesFor(const Work& work, std::span<const Barcode> barcodes,
                        const Options& options);

}  // namespace girth::cli::igf_command
