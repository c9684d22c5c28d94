// Options that several commands have.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "girth/error.h"
#include "girth/io/read_mesh.h"
#include "girth/io/write_field.h"
#include "model/model_options.h"
#include "options/option_table.h"

namespace girth::cli {

/// Adds `--threads`. 0, the default: as many as there are cores.
void addThreadsOption(OptionTable& table, unsigned& threads);

/// Adds what commands that measure one model have: `--subdivide`, the options on how a model is
/// prepared, `--threads` and `--json`.
void addMeasuringOptions(OptionTable& table, ModelOptions& preparing, unsigned& threads,
                         bool& json);

/// Adds an option for a length as it is typed, with or without a unit.
Option& addLengthOption(OptionTable& table, std::string_view declaration, std::string& length,
                        std::string text);

/// Reads such a length in a unit; leaves `length` as it is where none was given. Error: USAGE.
std::optional<Error> readLength(const std::string& text, const std::string& unit, double& length);

/// Adds `--jobs`, for commands that take many models.
void addJobsOption(OptionTable& table, unsigned& jobs);

/// Threads for each of several jobs, where none were asked for: together as many as there are
/// cores.
unsigned threadsOfJob(unsigned threads, unsigned jobs);

/// Adds `--positions`: x, y, z, and units in the header.
void addPositionsOption(OptionTable& table, bool& positions);

/// The columns that the option asks of writers.
io::Columns columnsOf(bool positions);

}  // namespace girth::cli
