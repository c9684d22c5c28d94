// How `girth igf` computes, one function for each method.
#pragma once

#include <span>
#include <string>

#include "commands/igf/options.h"
#include "girth/barcode.h"
#include "girth/girth_field.h"
#include "girth/refined_girth.h"
#include "model/partial_field.h"

namespace girth::cli::igf_command {

/// The exact, marched or naive girth, going on from what a stopped run has left, where there is
/// something.
Result<GirthField> computeAll(const std::string& model, const SurfaceMesh& mesh,
                              const PartialField& partial, const Options& options,
                              double persistence);

/// The refined girth. A run that is stopped leaves nothing: no value counts before its neighbours
/// are known.
Result<RefinedGirth> computeRefined(const std::string& model, const SurfaceMesh& mesh,
                                    const Options& options);

/// I_tau at all vertices, read off their barcodes.
GirthField girthOf(std::span<const Barcode> barcodes, double persistence);

/// The field of a remeshed surface at the vertices of the original.
GirthField fieldOnOriginal(const GirthField& field, const SurfaceMesh& remeshed,
                           const SurfaceMesh& original);

}  // namespace girth::cli::igf_command
