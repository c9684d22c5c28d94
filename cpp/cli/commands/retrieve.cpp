// girth retrieve: how well descriptors find shapes of the same class in a collection.
#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands/comparison_options.h"
#include "commands/table.h"
#include "process/report.h"
#include "study/retrieval.h"

namespace girth::cli {
namespace {

/// The paper's, its composite both ways, and what does best without training.
std::vector<std::string> defaultDescriptors() {
  return {"igf",
          "igf-ms",
          "sdf",
          "geoaverage",
          "geofarthest",
          "hks",
          "sihks",
          "wks",
          "igf-sdf",
          "igf+sdf",
          "log-igf",
          "log-sdf",
          "log-igf+log-sdf",
          "log-igf+log-sdf+sihks"};
}

int run(const RetrievalOptions& options) {
  auto descriptors =
      parseDescriptors(options.descriptors.empty() ? defaultDescriptors() : options.descriptors);
  if (!descriptors) return reportError("", descriptors.error());
  const auto shard = parseShard(options.shard.empty() ? "0/1" : options.shard);
  if (!shard) return reportError("", shard.error());
  if (options.classes.size() > options.folders.size()) {
    return reportError("", usageError("there are more class files than folders",
                                      "give each folder its own --classes, in the same order"));
  }
  return runRetrieval(options, std::move(descriptors).value(), shard.value());
}

Run add(CLI::App& app) {
  constexpr double kPercent = 100;
  const auto options = std::make_shared<RetrievalOptions>();
  app.add_option("DIR", options->folders, "Folders of models")->required();
  app.add_option("--classes", options->classes,
                 "A .csv with the columns file and class, or a .cla, for each folder; by default "
                 "its classes.csv, its only .cla, or else its folders are the classes")
      ->take_all()
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  addComparisonOptions(app, *options);
  app.add_option_function<double>(
         "--axis", [options](double percent) { options->signatures.axis = percent / kPercent; },
         "One-dimensional fields: per cent of the collection's area whose values are "
         "distinguished, "
         "the greatest rest counting alike; 95 by default, 100: all")
      ->check(CLI::Range(1.0, kPercent));
  app.add_option("-o,--output", options->output, "The folder to write the report into")->required();
  app.add_option("--cache", options->cache,
                 "The folder in which computed fields are kept; cache in the report's folder by "
                 "default. Several processes may share it");
  app.add_option("--shard", options->shard,
                 "I/N: only compute the fields of share I of N, from 0, into the cache; run "
                 "without it when all are done");
  app.add_option("--title", options->title, "What the report is called");
  return [options] { return run(*options); };
}

}  // namespace

const Command kRetrieve{
    "retrieve", "Measure how well descriptors find shapes of the same class in a collection", add};

}  // namespace girth::cli
