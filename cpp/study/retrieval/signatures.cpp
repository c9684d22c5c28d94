#include "girth/study/signatures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "girth/study/histogram.h"
#include "retrieval/common_quantile.h"

namespace girth::study {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

enum class Kind : std::uint8_t { Scalar, Joint, Words };

struct Row {
  std::string name;
  Kind kind;
  /// The fields it is made of; the second only of joint ones.
  std::string_view field, second;
  std::vector<FieldGroup> groups;
  /// Values count by their logarithms.
  bool logarithm{false};
};

const std::vector<Row>& plainTable() {
  static const std::vector<Row> rows{
      {"igf", Kind::Scalar, "igf", "", {FieldGroup::Girth}},
      {"igf-ms", Kind::Scalar, "igf-ms", "", {FieldGroup::MarchedGirth}},
      {"sdf", Kind::Scalar, "sdf", "", {FieldGroup::Diameter}},
      {"geoaverage", Kind::Scalar, "geoaverage", "", {FieldGroup::Extent}},
      {"geofarthest", Kind::Scalar, "geofarthest", "", {FieldGroup::Extent}},
      {"hks", Kind::Words, "hks", "", {FieldGroup::Spectral}},
      {"sihks", Kind::Words, "sihks", "", {FieldGroup::Spectral}},
      {"wks", Kind::Words, "wks", "", {FieldGroup::Spectral}},
      {"igf-sdf", Kind::Joint, "igf", "sdf", {FieldGroup::Girth, FieldGroup::Diameter}},
  };
  return rows;
}

const std::vector<Row>& table() {
  static const std::vector<Row> rows = [] {
    std::vector<Row> all = plainTable();
    for (Row row : plainTable()) {
      if (row.kind != Kind::Scalar) continue;
      row.name = "log-" + row.name;
      row.logarithm = true;
      all.push_back(std::move(row));
    }
    return all;
  }();
  return rows;
}

const Row* rowOf(std::string_view name) {
  const auto row = std::find_if(table().begin(), table().end(),
                                [&](const Row& candidate) { return candidate.name == name; });
  return row == table().end() ? nullptr : &*row;
}

Error notADescriptor(std::string_view text) {
  Error error = makeError(ErrorCode::Usage, -1, "\"" + std::string(text) + "\" is no descriptor");
  error.hint = "use";
  for (const Row& row : table()) error.hint += " " + row.name + ",";
  error.hint += " or sums such as igf+sdf and 2*igf+sdf";
  return error;
}

/// A plain decimal number of at most a million, without an exponent, independent of the locale.
bool parseWeight(std::string_view text, double& weight) {
  std::uint64_t digits = 0, scale = 1;
  bool point = false;
  std::size_t count = 0;
  for (const char c : text) {
    if (c == '.' && !point) {
      point = true;
    } else if (c >= '0' && c <= '9' && ++count <= 12) {
      digits = 10 * digits + static_cast<std::uint64_t>(c - '0');
      if (point) scale *= 10;
    } else {
      return false;
    }
  }
  weight = static_cast<double>(digits) / static_cast<double>(scale);
  return count > 0 && weight > 0 && weight <= 1e6;
}

/// The least and the greatest of the values that are finite; the wrong way round where none is.
HistogramRange endsOf(std::span<const double> values) {
  HistogramRange ends{std::numeric_limits<double>::infinity(),
                      -std::numeric_limits<double>::infinity()};
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    ends.low = std::min(ends.low, value);
    ends.high = std::max(ends.high, value);
  }
  return ends;
}

HistogramRange rangeOf(std::span<const double> values) {
  HistogramRange range = endsOf(values);
  if (range.low == range.high) range.high += std::max(1.0, std::fabs(range.low));
  return range.low < range.high ? range : HistogramRange{};
}

/// A model's values as they are compared: on their common scale, then by their logarithms if asked
/// for; what is not positive has none.
std::vector<double> comparedValues(std::span<const double> values, ValueScale scale,
                                   bool logarithm) {
  std::vector<double> compared(values.begin(), values.end());
  if (scale != ValueScale::AsIs) {
    const auto [least, greatest] = endsOf(values);
    const double low = scale == ValueScale::Span ? least : 0;
    const double span = greatest - low;
    // Times 0: what has no value keeps none.
    for (double& value : compared) value = span > 0 ? (value - low) / span : 0 * value;
  }
  if (logarithm) {
    for (double& value : compared) value = value > 0 ? std::log(value) : kNone;
  }
  return compared;
}

/// Some of a model's features, evenly spread over its vertices, each standing for its neighbours.
struct FeatureSample {
  std::vector<double> features, weights;
};

FeatureSample sampleOf(const StudyField& field, const std::vector<double>& weights,
                       std::size_t most) {
  FeatureSample sample;
  const std::size_t count = std::min(most, weights.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t vertex = (2 * i + 1) * weights.size() / (2 * count);
    const auto begin =
        field.values.begin() + static_cast<std::ptrdiff_t>(vertex * field.dimensions);
    sample.features.insert(sample.features.end(), begin,
                           begin + static_cast<std::ptrdiff_t>(field.dimensions));
    sample.weights.push_back(weights[vertex]);
  }
  return sample;
}

}  // namespace

std::vector<std::string> descriptorNames() {
  std::vector<std::string> names;
  for (const Row& row : table()) names.push_back(row.name);
  return names;
}

Result<Descriptor> parseDescriptor(std::string_view text) {
  Descriptor descriptor{std::string(text), {}};
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('+', at), text.size());
    std::string_view term = text.substr(at, end - at);
    double weight = 1;
    if (const std::size_t star = term.find('*'); star != std::string_view::npos) {
      if (!parseWeight(term.substr(0, star), weight)) return notADescriptor(text);
      term.remove_prefix(star + 1);
    }
    if (rowOf(term) == nullptr) return notADescriptor(text);
    descriptor.terms.push_back({weight, std::string(term)});
    at = end + 1;
  }
  return descriptor;
}

std::vector<FieldGroup> groupsOf(const std::vector<Descriptor>& descriptors) {
  std::vector<FieldGroup> groups;
  for (const FieldGroup group : kFieldGroups) {
    const bool needed =
        std::any_of(descriptors.begin(), descriptors.end(), [&](const Descriptor& descriptor) {
          return std::any_of(descriptor.terms.begin(), descriptor.terms.end(),
                             [&](const Descriptor::Term& term) {
                               const auto& of = rowOf(term.name)->groups;
                               return std::find(of.begin(), of.end(), group) != of.end();
                             });
        });
    if (needed) groups.push_back(group);
  }
  return groups;
}

struct Signatures::Content {
  /// One descriptor's signatures of all models; which of them are used depends on its kind.
  struct Column {
    const Row* row;
    std::vector<Distribution> distributions;
    std::vector<std::vector<double>> histograms;
    HistogramRange range;
    std::vector<JointHistogram> joints;
    double firstScale{1}, secondScale{1};
    std::vector<FeatureSample> samples;
    std::size_t dimensions{0};
    Vocabulary vocabulary;
    std::vector<std::vector<double>> bags;
  };

  SignatureOptions options;
  std::map<std::string, Column, std::less<>> columns;

  void addTo(Column& column, std::size_t model, const StudyFields& fields) const {
    const StudyField* field = fields.find(column.row->field);
    if (field == nullptr) return;
    switch (column.row->kind) {
      case Kind::Scalar:
        column.distributions[model] = girth::distributionOf(
            comparedValues(field->values, options.scale, column.row->logarithm), fields.weights);
        break;
      case Kind::Joint: {
        const StudyField* second = fields.find(column.row->second);
        if (second == nullptr) return;
        column.joints[model] =
            jointHistogramOf(field->values, second->values, fields.weights,
                             {options.jointBins, rangeOf(field->values), rangeOf(second->values)});
        break;
      }
      case Kind::Words:
        column.samples[model] = sampleOf(*field, fields.weights, options.featuresPerModel);
        break;
    }
  }

  void endAxis(Column& column) const {
    if (!(options.axis < 1)) return;
    const double greatest = commonQuantile(column.distributions, options.axis);
    for (Distribution& distribution : column.distributions) capValues(distribution, greatest);
  }

  void binAll(Column& column) const {
    std::vector<double> ends;
    for (const Distribution& distribution : column.distributions) {
      if (distribution.empty()) continue;
      ends.push_back(distribution.values.front());
      ends.push_back(distribution.values.back());
    }
    column.range = rangeOf(ends);
    for (Distribution& distribution : column.distributions) {
      column.histograms.push_back(histogramOf(distribution, column.range, options.bins));
    }
    column.distributions.clear();
  }

  /// The standard deviations of both fields over all models: what makes lengths of different kinds
  /// comparable without knowing anything of classes.
  static void scaleAxes(Column& column) {
    const auto deviation = [&](const std::vector<double> JointHistogram::*axis) {
      double sum = 0, squares = 0, weight = 0;
      for (const JointHistogram& joint : column.joints) {
        for (std::size_t i = 0; i < joint.shares.size(); ++i) {
          const double value = (joint.*axis)[i];
          sum += joint.shares[i] * value;
          squares += joint.shares[i] * value * value;
          weight += joint.shares[i];
        }
      }
      const double mean = sum / weight;
      const double variance = squares / weight - mean * mean;
      return variance > 0 ? std::sqrt(variance) : 1;
    };
    column.firstScale = deviation(&JointHistogram::first);
    column.secondScale = deviation(&JointHistogram::second);
  }

  Result<bool> chooseWords(Column& column, const ExecutionContext& context) const {
    FeatureSample all;
    for (FeatureSample& sample : column.samples) {
      all.features.insert(all.features.end(), sample.features.begin(), sample.features.end());
      all.weights.insert(all.weights.end(), sample.weights.begin(), sample.weights.end());
      sample = {};
    }
    if (all.weights.empty()) return true;
    auto vocabulary = vocabularyOf(all.features, all.features.size() / all.weights.size(),
                                   all.weights, options.vocabulary, context);
    if (!vocabulary) return vocabulary.error();
    column.vocabulary = std::move(vocabulary).value();
    return true;
  }
};

Signatures::Signatures(std::vector<std::string> names, std::size_t models, SignatureOptions options)
    : content_(std::make_unique<Content>()) {
  content_->options = options;
  for (const std::string& name : names) {
    const Row* row = rowOf(name);
    if (row == nullptr) continue;
    Content::Column& column = content_->columns[name];
    column.row = row;
    switch (row->kind) {
      case Kind::Scalar:
        column.distributions.resize(models);
        break;
      case Kind::Joint:
        column.joints.resize(models);
        break;
      case Kind::Words:
        column.samples.resize(models);
        column.bags.resize(models);
        break;
    }
  }
}

Signatures::~Signatures() = default;
Signatures::Signatures(Signatures&&) noexcept = default;
Signatures& Signatures::operator=(Signatures&&) noexcept = default;

void Signatures::add(std::size_t model, const StudyFields& fields) {
  for (auto& [name, column] : content_->columns) content_->addTo(column, model, fields);
}

Result<bool> Signatures::finish(const ExecutionContext& context) {
  for (auto& [name, column] : content_->columns) {
    if (column.row->kind == Kind::Scalar) {
      content_->endAxis(column);
      if (content_->options.bins > 0) content_->binAll(column);
    }
    if (column.row->kind == Kind::Joint) Content::scaleAxes(column);
    if (column.row->kind == Kind::Words) {
      if (auto chosen = content_->chooseWords(column, context); !chosen) return chosen;
    }
  }
  return true;
}

bool Signatures::needsWords() const {
  return std::any_of(content_->columns.begin(), content_->columns.end(),
                     [](const auto& column) { return column.second.row->kind == Kind::Words; });
}

void Signatures::addWords(std::size_t model, const StudyFields& fields) {
  for (auto& [name, column] : content_->columns) {
    const StudyField* field = fields.find(column.row->field);
    if (column.row->kind != Kind::Words || field == nullptr) continue;
    column.bags[model] =
        bagOfFeatures(column.vocabulary, field->values, fields.weights, content_->options.words);
  }
}

const Distribution* Signatures::distributionOf(std::string_view name, std::size_t model) const {
  const auto found = content_->columns.find(name);
  if (found == content_->columns.end()) return nullptr;
  const auto& distributions = found->second.distributions;
  return model < distributions.size() ? &distributions[model] : nullptr;
}

double Signatures::distance(std::string_view name, std::size_t one, std::size_t two) const {
  const auto found = content_->columns.find(name);
  if (found == content_->columns.end()) return kNone;
  const Content::Column& column = found->second;
  // The lower number first: rounding depends on the order.
  if (one > two) std::swap(one, two);
  switch (column.row->kind) {
    case Kind::Scalar:
      return content_->options.bins > 0
                 ? histogramDistance(column.histograms[one], column.histograms[two], column.range)
                 : earthMoversDistance(column.distributions[one], column.distributions[two]);
    case Kind::Joint: {
      if (column.joints[one].empty() || column.joints[two].empty()) return kNone;
      const auto distance = jointDistance(column.joints[one], column.joints[two], column.firstScale,
                                          column.secondScale);
      return distance ? distance.value() : kNone;
    }
    case Kind::Words:
      return bagDistance(column.bags[one], column.bags[two]);
  }
  return kNone;
}

}  // namespace girth::study
