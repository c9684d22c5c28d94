// girth signature: the histograms that a model is compared by.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "commands/comparison_options.h"
#include "commands/table.h"
#include "girth/distribution.h"
#include "girth/io/json_text.h"
#include "girth/study/histogram.h"
#include "model/loading.h"
#include "process/output.h"
#include "process/progress_line.h"
#include "process/report.h"
#include "text/number_text.h"

namespace girth::cli {
namespace signature_command {
namespace {

using study::Descriptor;
using study::Signatures;

struct Options : ComparisonOptions {
  std::string model;
  ModelOptions preparing;
  Output output;
};

std::string signatureCsv(const std::string& name, const std::vector<double>& shares,
                         const study::HistogramRange& range) {
  std::string text;
  const double width = (range.high - range.low) / static_cast<double>(shares.size());
  double sum = 0;
  for (std::size_t bin = 0; bin < shares.size(); ++bin) {
    sum += shares[bin];
    const double low = range.low + width * static_cast<double>(bin);
    text += name + "," + io::formatNumber(low) + "," + io::formatNumber(low + width) + "," +
            io::formatNumber(shares[bin]) + "," + io::formatNumber(sum) + "\n";
  }
  return text;
}

std::string signatureJson(const std::string& name, const std::vector<double>& shares,
                          const study::HistogramRange& range) {
  io::JsonList list;
  for (const double share : shares) list.add(io::numberJson(share));
  return io::JsonObject()
      .add("name", name)
      .add("low", range.low)
      .add("high", range.high)
      .addJson("shares", list.text())
      .text();
}

int run(const Options& options) {
  const std::string extension = options.output.ending();
  if (const auto error = checkOutput(options.output, std::span(&options.model, 1), false)) {
    return reportError(options.output.path, *error);
  }
  const auto descriptors = parseDescriptors(
      options.descriptors.empty() ? std::vector<std::string>{"igf"} : options.descriptors);
  if (!descriptors) return reportError("", descriptors.error());
  ComparisonOptions comparison = options;
  comparison.signatures.bins = 0;  // the distributions themselves are wanted
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());
  ProgressLine progress(options.model);
  const ExecutionContext context = watched(options.threads, progress);
  const auto fields = comparedFields(loaded.value().mesh, descriptors.value(), comparison, context);
  if (!fields) return reportError(options.model, fields.error());
  std::vector<std::string> names;
  for (const Descriptor& descriptor : descriptors.value()) names.push_back(descriptor.name);
  Signatures signatures(names, 1, comparison.signatures);
  signatures.add(0, fields.value());
  constexpr std::size_t kBins = 512;
  // Lengths of a model that is scaled to area 1 have no unit.
  const std::string unit = options.fields.unitArea ? "" : loaded.value().unit;
  std::string rows;
  io::JsonList list(true);
  for (const std::string& name : names) {
    const Distribution* distribution = signatures.distributionOf(name, 0);
    if (distribution == nullptr) {
      return reportError("", usageError(name + " has no histogram of one dimension",
                                        "name one-dimensional fields, such as igf or sdf"));
    }
    if (distribution->empty()) {
      return reportError(options.model,
                         makeError(ErrorCode::EmptyMesh, -1, name + " has no value"));
    }
    const double low = std::min(0.0, distribution->values.front());
    const double high = distribution->values.back();
    const study::HistogramRange range{low, high > low ? high : low + 1};
    const auto shares = study::histogramOf(
        *distribution, range, options.signatures.bins == 0 ? kBins : options.signatures.bins);
    if (extension == ".csv") {
      rows += signatureCsv(name, shares, range);
    } else {
      list.add(signatureJson(name, shares, range));
    }
  }
  io::JsonObject json;
  json.add("file", options.model).add("unit", unit).addJson("signatures", list.text());
  const std::string content =
      extension == ".csv" ? "descriptor,low,high,share,cumulative\n" + rows : json.text() + "\n";
  if (const auto error = writeOutput(options.output, content)) {
    return reportError(options.output.path, *error);
  }
  return 0;
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->model, "The model to read").required();
  addOutputOptions(table, options->output, {".csv", ".json"}, "Write them: .csv or .json")
      .required();
  addComparisonOptions(table, *options);
  addSubdivideOption(table, options->preparing);
  addModelOptions(table, options->preparing);
  table.example("girth signature a.obj -o a.csv",
                "The histogram of the girth: descriptor, low, high, share, cumulative.");
  table.example("girth signature a.obj --descriptors igf,sdf --bins 64 -o a.json",
                "Girth and shape diameter, in 64 bins each.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace signature_command

const Command kSignature{"signature", "Write the histograms that a model is compared by",
                         signature_command::add};

}  // namespace girth::cli
