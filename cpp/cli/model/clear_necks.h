// The necks of a model that a command lists or cuts along, and the option that chooses them.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "girth/io/read_mesh.h"
#include "girth/necks.h"
#include "options/option_table.h"

namespace girth::cli {

/// `--min-prominence`; `words`: the sentence that help has of it.
void addProminenceOption(OptionTable& table, std::string& typed, const std::string& words);

/// The typed prominence in model units; none where none was typed. Errors: those of readLength.
Result<std::optional<double>> readProminence(const std::string& typed, const std::string& unit);

/// The necks of at least this prominence. Without one the surface's suggested prominence decides,
/// and a note states how many it leaves out. `model`: for progress and note. Errors: those of
/// findNecks.
Result<Necks> computeNecks(const std::string& model, const io::LoadedMesh& loaded,
                           std::span<const double> girth, std::optional<double> minProminence,
                           unsigned threads);

}  // namespace girth::cli
