// girth compare: how far a few models are apart.
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands/comparison_options.h"
#include "commands/table.h"
#include "girth/io/json_text.h"
#include "model/loading.h"
#include "process/interrupt.h"
#include "process/progress_line.h"
#include "process/report.h"
#include "study/typical_distance.h"

namespace girth::cli {
namespace compare_command {
namespace {

using study::Descriptor;
using study::Signatures;
using study::StudyFields;

struct Options : ComparisonOptions {
  /// Among a few models the words are nearly as many as the features: by the nearest word alone all
  /// would be equally far apart.
  Options() { signatures.words = study::WordChoice::Soft; }
  std::vector<std::string> models;
  ModelOptions preparing;
  bool json{false};
};

/// The models' distances to each other, row by row.
std::string matrixJson(const Signatures& signatures, const Descriptor& descriptor,
                       const Options& options) {
  const std::size_t models = options.models.size();
  const auto typical = typicalDistance(descriptor.name, options);
  io::JsonList rows;
  for (std::size_t i = 0; i < models; ++i) {
    io::JsonList row;
    for (std::size_t j = 0; j < models; ++j) {
      row.add(io::numberJson(i == j ? 0 : signatures.distance(descriptor.name, i, j)));
    }
    rows.add(row.text());
  }
  io::JsonObject usual;
  if (typical) usual.add("poses", typical->poses).add("classes", typical->classes);
  return io::JsonObject()
      .add("name", descriptor.name)
      .addJson("distances", rows.text())
      .addJson("typical", typical ? usual.text() : "null")
      .text();
}

/// The distances of every pair, each beside what is usual.
void printText(const Signatures& signatures, const std::vector<std::string>& names,
               const Options& options) {
  bool isAnyTypical = false;
  for (std::size_t i = 0; i < options.models.size(); ++i) {
    for (std::size_t j = i + 1; j < options.models.size(); ++j) {
      std::printf("%s - %s\n", options.models[i].c_str(), options.models[j].c_str());
      std::printf("  %-14s %12s %8s %8s\n", "", "distance", "poses", "classes");
      for (const std::string& name : names) {
        const auto typical = typicalDistance(name, options);
        isAnyTypical = isAnyTypical || typical;
        std::printf("  %-14s %12s %8s %8s\n", name.c_str(),
                    readable(signatures.distance(name, i, j)).c_str(),
                    typical ? readable(typical->poses).c_str() : "-",
                    typical ? readable(typical->classes).c_str() : "-");
      }
    }
  }
  if (isAnyTypical) {
    std::printf(
        "poses, classes: the usual distance of two poses of one shape, and of two shapes "
        "of different classes\n");
  }
}

int run(const Options& options) {
  const std::vector<std::string> byDefault{"igf", "sdf", "geoaverage", "geofarthest"};
  const auto descriptors =
      parseDescriptors(options.descriptors.empty() ? byDefault : options.descriptors);
  if (!descriptors) return reportError("", descriptors.error());
  std::vector<std::string> names;
  for (const Descriptor& descriptor : descriptors.value()) {
    if (descriptor.terms.size() > 1 || descriptor.terms[0].weight != 1) {
      return reportError(
          "", usageError(descriptor.name + " is a sum, which needs a collection to scale "
                                           "its terms by",
                         "name single descriptors, or use girth retrieve"));
    }
    names.push_back(descriptor.name);
  }
  if (options.models.size() < 2) {
    return reportError(
        "", usageError("there is nothing to compare it with", "name two models or more"));
  }
  Signatures signatures(names, options.models.size(), options.signatures);
  std::vector<StudyFields> fields;
  // Models scaled to area 1 have no unit, and different ones have none in common.
  std::string unit;
  for (std::size_t m = 0; m < options.models.size(); ++m) {
    const auto loaded = loadModel(options.models[m], options.preparing);
    if (!loaded) return reportError(options.models[m], loaded.error());
    if (m == 0 && !options.fields.unitArea) unit = loaded.value().unit;
    if (loaded.value().unit != unit) unit.clear();
    ProgressLine progress(options.models[m]);
    const ExecutionContext context = watched(options.threads, progress);
    auto computed = comparedFields(loaded.value().mesh, descriptors.value(), options, context);
    if (!computed) return reportError(options.models[m], computed.error());
    signatures.add(m, computed.value());
    fields.push_back(std::move(computed).value());
  }
  if (const auto finished = signatures.finish({options.threads, &catchInterrupts(), {}});
      !finished) {
    return reportError("", finished.error());
  }
  for (std::size_t m = 0; m < fields.size(); ++m) signatures.addWords(m, fields[m]);
  if (options.json) {
    io::JsonList models, tables;
    for (const std::string& model : options.models) models.add(io::jsonString(model));
    for (const Descriptor& descriptor : descriptors.value()) {
      tables.add(matrixJson(signatures, descriptor, options));
    }
    std::puts(io::JsonObject()
                  .addJson("models", models.text())
                  .add("unit", unit)
                  .addJson("descriptors", tables.text())
                  .text()
                  .c_str());
    return 0;
  }
  if (hasSummary()) printText(signatures, names, options);
  return 0;
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->models, "Two models or more").required();
  addComparisonOptions(table, *options);
  addSubdivideOption(table, options->preparing);
  addModelOptions(table, options->preparing);
  table.add("--json", options->json, "Print the distances as JSON");
  table.note(
      "How to read a distance",
      "Beside each distance stands the median distance of two poses of one shape, and that of "
      "two shapes of different classes, over the 600 models of SHREC'11. By igf, 95 of 100 pairs "
      "of poses are nearer than 0.065, and 95 of 100 pairs of different classes farther than "
      "0.043.");
  table.note("Many models",
             "All models have one answer, so there is no --jobs; --threads divides the work on "
             "each model.");
  table.example("girth compare a.obj b.obj", "How far two shapes are apart, by four descriptors.");
  table.example("girth compare *.off --descriptors igf --json",
                "Every pair of many, by the girth alone.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace compare_command

const Command kCompare{"compare", "Print how far models are apart", compare_command::add};

}  // namespace girth::cli
