// Options that several commands have.
#pragma once

#include <cstdint>

#include "cli_app.h"

namespace girth::cli {

/// The most faces that can be asked for.
constexpr std::uint32_t kMostFaces = 100'000'000;

/// Adds `--threads`. 0, the default: as many as there are cores.
void addThreadsOption(CLI::App& app, unsigned& threads);

}  // namespace girth::cli
