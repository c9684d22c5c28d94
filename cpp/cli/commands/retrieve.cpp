// girth retrieve: how well descriptors find shapes of the same class in a collection.
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands/comparison_options.h"
#include "commands/table.h"
#include "girth/study/surface_changes.h"
#include "process/report.h"
#include "study/retrieval.h"
#include "text/number_text.h"

namespace girth::cli {
namespace retrieve_command {
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

Run add(OptionTable& table) {
  constexpr double kPercent = 100;
  const auto options = std::make_shared<RetrievalOptions>();
  table.add("DIR", options->folders, "Folders of models").required();
  table.add("-o,--output DIR", options->output, "The folder to write the report into").required();
  table.add("--classes FILE", options->classes,
            "A .csv with the columns file and class, or a .cla, for each folder; by default its "
            "classes.csv, its only .cla, or else its folders are the classes");
  addComparisonOptions(table, *options);
  addSubdivideOption(table, options->preparing);
  addModelOptions(table, options->preparing);
  table
      .onValue(
          "--axis PERCENT",
          [options](const std::string& text) {
            const std::optional<double> percent = io::parseNumber(text);
            if (!percent) return "\"" + text + "\" is no number";
            options->signatures.axis = *percent / kPercent;
            return std::string();
          },
          "One-dimensional fields: per cent of the collection's area whose values are "
          "distinguished, the greatest rest counting alike; 95 by default, 100: all")
      .range(1, kPercent);
  table
      .add("--noise EDGES", options->fields.noise,
           "Noise added to every model, in mean edge lengths, as rough scans have it; 0 by default")
      .range(0, study::kMostNoise);
  table.add("--cache DIR", options->cache,
            "The folder in which computed fields are kept; cache in the report's folder by "
            "default. Several processes may share it");
  table.add("--shard I/N", options->shard,
            "Only compute the fields of share I of N, from 0, into the cache; run without it when "
            "all are done");
  table.add("--title TEXT", options->title, "Title of the report");
  table.note(
      "Many models",
      "All models have one report, so there is no --jobs. Small models are computed --threads at a "
      "time, large ones on all threads. --shard divides them among processes and machines.");
  table.example("girth retrieve shapes/ -o report/",
                "A report on a collection whose folders are its classes.");
  table.example("girth retrieve shapes/ -o report/ --shard 0/2",
                "One of two machines computes its half of the fields.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace retrieve_command

const Command kRetrieve{
    "retrieve", "Measure how well descriptors find shapes of the same class in a collection",
    retrieve_command::add};

}  // namespace girth::cli
