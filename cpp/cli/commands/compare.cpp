// girth compare: how far a few models are apart.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands/comparison_options.h"
#include "commands/table.h"
#include "process/interrupt.h"
#include "process/progress_line.h"
#include "process/report.h"
#include "text/json_text.h"
#include "text/number_text.h"

namespace girth::cli {
namespace {

using study::Descriptor;
using study::Signatures;
using study::StudyFields;

struct Options : ComparisonOptions {
  /// Among a few models the words are nearly as many as the features: by the nearest word alone all
  /// would be equally far apart.
  Options() { signatures.words = study::WordChoice::Soft; }
  std::vector<std::string> models;
  bool json{false};
};

/// The models' distances to each other, row by row.
std::string matrixJson(const Signatures& signatures, const Descriptor& descriptor,
                       std::size_t models) {
  std::string rows;
  for (std::size_t i = 0; i < models; ++i) {
    std::string row;
    for (std::size_t j = 0; j < models; ++j) {
      const double distance = i == j ? 0 : signatures.distance(descriptor.name, i, j);
      row += (j == 0 ? "" : ",") +
             (std::isfinite(distance) ? io::formatNumber(distance) : std::string("null"));
    }
    rows += (i == 0 ? "[" : ",[") + row + "]";
  }
  return "{\"name\":" + io::jsonString(descriptor.name) + ",\"distances\":[" + rows + "]}";
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
  for (std::size_t m = 0; m < options.models.size(); ++m) {
    ProgressLine progress(options.models[m]);
    const ExecutionContext context = watched(options.threads, progress);
    auto computed = comparedFields(options.models[m], descriptors.value(), options, context);
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
    std::string models, tables;
    for (const std::string& model : options.models) {
      models += (models.empty() ? "" : ",") + io::jsonString(model);
    }
    for (const Descriptor& descriptor : descriptors.value()) {
      tables +=
          (tables.empty() ? "" : ",") + matrixJson(signatures, descriptor, options.models.size());
    }
    std::printf("{\"models\":[%s],\"descriptors\":[%s]}\n", models.c_str(), tables.c_str());
    return 0;
  }
  for (std::size_t i = 0; i < options.models.size(); ++i) {
    for (std::size_t j = i + 1; j < options.models.size(); ++j) {
      std::printf("%s - %s\n", options.models[i].c_str(), options.models[j].c_str());
      for (const std::string& name : names) {
        std::printf("  %-14s %s\n", name.c_str(),
                    readable(signatures.distance(name, i, j)).c_str());
      }
    }
  }
  return 0;
}

Run add(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("MODEL", options->models, "Two models or more")->required();
  addComparisonOptions(app, *options);
  app.add_flag("--json", options->json, "Print the distances as JSON");
  return [options] { return run(*options); };
}

}  // namespace

const Command kCompare{"compare", "Print how far models are apart", add};

}  // namespace girth::cli
