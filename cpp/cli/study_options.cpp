#include "study_options.h"

#include <CLI/CLI.hpp>
#include <cstdint>

namespace girth::cli {
namespace {

constexpr const char* kAccuracy = "accuracy";
constexpr const char* kRobustness = "robustness";

}  // namespace

void addStudyOptions(CLI::App& group, StudyOptions& options) {
  group.require_subcommand(1);
  CLI::App* accuracy =
      group.add_subcommand(kAccuracy, "How near the girth by fast marching is to the exact one");
  accuracy->add_option("MODEL", options.accuracy.models, "Models to read")->required();
  accuracy
      ->add_option("--faces", options.accuracy.faces,
                   "Remesh larger models to so many triangles; 0, the default: leave all as they "
                   "are")
      ->check(CLI::Range(std::uint32_t{0}, std::uint32_t{100'000'000}));
  accuracy
      ->add_option("--threads", options.accuracy.threads,
                   "Threads; as many as there are cores by default")
      ->check(CLI::Range(1u, 1024u));
  addRobustnessOptions(
      *group.add_subcommand(
          kRobustness, "How little the girth changes with a surface's triangles, noise and pose"),
      options.robustness);
}

int runStudy(const CLI::App& group, const StudyOptions& options) {
  if (group.got_subcommand(kAccuracy)) return runAccuracyStudy(options.accuracy);
  if (group.got_subcommand(kRobustness)) return runRobustnessStudy(options.robustness);
  return 1;
}

}  // namespace girth::cli
