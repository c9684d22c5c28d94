// How long a saddle must last to count: `--persistence` (web/docs/definitions.md, section 2).
#pragma once

#include <string>

#include "girth/error.h"
#include "girth/io/read_mesh.h"
#include "options/option_table.h"

namespace girth::cli {

/// Adds `--persistence`, a length or a percentage of the square root of the area. `typed` keeps it
/// as it was typed; it stays empty where it is not given. `of`: the fields that it is for, where it
/// is not for all.
Option& addPersistenceOption(OptionTable& table, std::string& typed, const std::string& of = "");

/// Adds `--persistence` for models of different sizes: as a percentage only, kept as a share.
void addPersistenceShareOption(OptionTable& table, double& share, const std::string& of);

/// The typed persistence as a length in the unit of the model; 0 where none was typed. Error:
/// USAGE, where it has a unit and the model has none that is known.
Result<double> persistenceOf(const std::string& typed, const io::LoadedMesh& loaded);

/// The words of a summary on it: ", persistence 0.5 mm"; none where it is 0.
std::string persistenceText(double persistence, const io::LoadedMesh& loaded);

}  // namespace girth::cli
