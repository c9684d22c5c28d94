// Options that several commands have.
#pragma once

#include <cstddef>
#include <cstdint>
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

/// The index of a listed thing that was asked for by its number, from 0. `things`: their name, such
/// as "necks"; `none`: the remedy where there are none. The number behind the last stands for the
/// last, with a note, since numbers counted from 1 before 1.0. Error: USAGE.
Result<std::size_t> numberWithin(std::int64_t number, std::size_t count, const std::string& things,
                                 const std::string& none);

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
