#include "commands/common_options.h"

#include <CLI/CLI.hpp>

namespace girth::cli {

void addThreadsOption(CLI::App& app, unsigned& threads) {
  app.add_option("--threads", threads, "Threads; as many as there are cores by default")
      ->check(CLI::Range(1u, 1024u));
}

}  // namespace girth::cli
