// girth signature and girth compare: what retrieval is made of, for a few models.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "commands.h"
#include "files.h"
#include "girth/study/histogram.h"
#include "girth/study/signatures.h"
#include "interrupt.h"
#include "model_fields.h"
#include "progress_line.h"
#include "report.h"
#include "text/json_text.h"
#include "text/number_text.h"

namespace girth::cli {
namespace {

using study::Descriptor;
using study::Signatures;
using study::StudyFields;

/// Reports an error of one of the models.
int fail(const std::string& model, const Error& error) { return reportError(model, error); }

Result<std::vector<Descriptor>> descriptorsOf(const std::vector<std::string>& names) {
  std::vector<Descriptor> descriptors;
  for (const std::string& name : names) {
    auto descriptor = study::parseDescriptor(name);
    if (!descriptor) return descriptor.error();
    descriptors.push_back(std::move(descriptor).value());
  }
  return descriptors;
}

Result<StudyFields> fieldsOf(const std::string& model, const std::vector<Descriptor>& descriptors,
                             const ComparisonOptions& options, const ExecutionContext& context) {
  const auto mesh = readSurface(model);
  if (!mesh) return mesh.error();
  const auto surface = study::studySurface(mesh.value(), options.fields, context);
  if (!surface) return surface.error();
  StudyFields all;
  for (const study::FieldGroup group : study::groupsOf(descriptors)) {
    auto fields = study::studyFields(surface.value(), group, options.fields, context);
    if (!fields) return fields.error();
    all.weights = std::move(fields.value().weights);
    for (auto& field : fields.value().fields) all.fields.push_back(std::move(field));
  }
  return all;
}

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
  std::string text;
  for (const double share : shares) text += (text.empty() ? "" : ",") + io::formatNumber(share);
  return "{\"name\":" + io::jsonString(name) + ",\"low\":" + io::formatNumber(range.low) +
         ",\"high\":" + io::formatNumber(range.high) + ",\"shares\":[" + text + "]}";
}

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

}  // namespace

int runSignature(const SignatureCommandOptions& options) {
  const std::string extension = extensionOf(options.output);
  if (const auto error = checkOutput(options.output, {".csv", ".json"})) {
    return reportError(options.output, *error);
  }
  const auto descriptors = descriptorsOf(
      options.descriptors.empty() ? std::vector<std::string>{"igf"} : options.descriptors);
  if (!descriptors) return reportError("", descriptors.error());
  ComparisonOptions comparison = options;
  comparison.signatures.bins = 0;  // the distributions themselves are wanted
  ProgressLine progress(options.model);
  const ExecutionContext context = watched(options.threads, progress);
  const auto fields = fieldsOf(options.model, descriptors.value(), comparison, context);
  if (!fields) return fail(options.model, fields.error());
  std::vector<std::string> names;
  for (const Descriptor& descriptor : descriptors.value()) names.push_back(descriptor.name);
  Signatures signatures(names, 1, comparison.signatures);
  signatures.add(0, fields.value());
  constexpr std::size_t kBins = 512;
  std::string rows;
  for (const std::string& name : names) {
    const Distribution* distribution = signatures.distributionOf(name, 0);
    if (distribution == nullptr) {
      return reportError("", usageError(name + " has no histogram of one dimension",
                                        "name one-dimensional fields, such as igf or sdf"));
    }
    if (distribution->empty()) {
      return fail(options.model, makeError(ErrorCode::EmptyMesh, -1, name + " has no value"));
    }
    const double low = std::min(0.0, distribution->values.front());
    const double high = distribution->values.back();
    const study::HistogramRange range{low, high > low ? high : low + 1};
    const auto shares = study::histogramOf(
        *distribution, range, options.signatures.bins == 0 ? kBins : options.signatures.bins);
    if (extension == ".csv") {
      rows += signatureCsv(name, shares, range);
    } else {
      rows += (rows.empty() ? "\n" : ",\n") + signatureJson(name, shares, range);
    }
  }
  const std::string content = extension == ".csv" ? "descriptor,low,high,share,cumulative\n" + rows
                                                  : "{\"file\":" + io::jsonString(options.model) +
                                                        ",\"signatures\":[" + rows + "]}\n";
  if (const auto error = writeFile(options.output, content)) {
    return reportError(options.output, *error);
  }
  return 0;
}

int runCompare(const CompareOptions& options) {
  const std::vector<std::string> byDefault{"igf", "sdf", "geoaverage", "geofarthest"};
  const auto descriptors =
      descriptorsOf(options.descriptors.empty() ? byDefault : options.descriptors);
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
    auto computed = fieldsOf(options.models[m], descriptors.value(), options, context);
    if (!computed) return fail(options.models[m], computed.error());
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

}  // namespace girth::cli
