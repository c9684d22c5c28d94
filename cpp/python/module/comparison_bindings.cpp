#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "girth/distribution.h"
#include "girth/study/descriptor_rows.h"
#include "girth/study/pair_distances.h"
#include "girth/study/signatures.h"
#include "girth/study/study_fields.h"
#include "surface.h"
#include "working.h"

namespace py = pybind11;

namespace girth::python {
namespace {

using study::Descriptor;
using study::FieldGroup;
using study::StudyFields;
using Shared = std::shared_ptr<Surface>;

std::vector<Descriptor> descriptorsOf(const std::vector<std::string>& names) {
  std::vector<Descriptor> descriptors;
  for (const std::string& name : names) {
    descriptors.push_back(study::parseDescriptor(name).value());
  }
  return descriptors;
}

study::FieldParameters parametersOf(Index faces, Index smooth) {
  study::FieldParameters parameters;
  parameters.faces = faces;
  parameters.smoothing = smooth;
  return parameters;
}

/// All parameters that the fields of these descriptors depend on, as a text.
std::string parametersText(const std::vector<std::string>& names, Index faces, Index smooth) {
  std::string text;
  for (const FieldGroup group : study::groupsOf(descriptorsOf(names))) {
    text += study::parametersText(group, parametersOf(faces, smooth)) + "\n";
  }
  return text;
}

/// The fields of one surface that the descriptors are made of: (weights, {name: values}), the
/// values of shape (vertices, numbers of each).
py::tuple comparedFields(const Shared& surface, const std::vector<std::string>& names, Index faces,
                         Index smooth, const Running& running) {
  const std::vector<FieldGroup> groups = study::groupsOf(descriptorsOf(names));
  const study::FieldParameters parameters = parametersOf(faces, smooth);
  auto all = compute<StudyFields>(
      running, [surface, groups, parameters](const ExecutionContext& c) -> Result<StudyFields> {
        const ExecutionContext quiet{c.threads, c.cancel, {}};
        const auto prepared = study::studySurface(surface->mesh(), parameters, quiet);
        if (!prepared) return prepared.error();
        StudyFields fields;
        const auto count = static_cast<double>(groups.size());
        for (std::size_t g = 0; g < groups.size(); ++g) {
          const auto begun = static_cast<double>(g);
          const auto report = [&c, begun, count](double f) { c.onProgress((begun + f) / count); };
          auto some = study::studyFields(prepared.value(), groups[g], parameters,
                                         {c.threads, c.cancel, report});
          if (!some) return some.error();
          fields.weights = std::move(some.value().weights);
          for (auto& field : some.value().fields) fields.fields.push_back(std::move(field));
          report(1);
        }
        return fields;
      });
  py::dict values;
  for (study::StudyField& field : all.fields) {
    const auto dimensions = static_cast<py::ssize_t>(field.dimensions);
    const auto vertices = static_cast<py::ssize_t>(field.values.size()) / dimensions;
    values[py::str(field.name)] = arrayOf(std::move(field.values), {vertices, dimensions});
  }
  return py::make_tuple(arrayOf(std::move(all.weights)), values);
}

using Fields = std::pair<Array<double>, std::map<std::string, Array<double>>>;

StudyFields fieldsOf(const Fields& given) {
  const auto weights = spanOf(given.first);
  StudyFields fields{{weights.begin(), weights.end()}, {}};
  for (const auto& [name, values] : given.second) {
    const auto numbers = spanOf(values);
    fields.fields.push_back(
        {name, static_cast<std::size_t>(values.shape(1)), {numbers.begin(), numbers.end()}});
  }
  return fields;
}

using Matrix = std::vector<double>;

Result<std::vector<Matrix>> matricesOf(const std::vector<StudyFields>& models,
                                       const std::vector<Descriptor>& descriptors,
                                       const ExecutionContext& context) {
  const std::vector<std::string> terms = study::termsOf(descriptors);
  const Error stopped = makeError(ErrorCode::Cancelled, -1, "stopped");
  study::SignatureOptions options;
  // As the command does for a few models: with each feature counted for its nearest word only, all
  // models would be equally far apart.
  options.words = study::WordChoice::Soft;
  study::Signatures signatures(terms, models.size(), options);
  for (std::size_t m = 0; m < models.size(); ++m) signatures.add(m, models[m]);
  const ExecutionContext quiet{context.threads, context.cancel, {}};
  if (const auto finished = signatures.finish(quiet); !finished) return finished.error();
  for (std::size_t m = 0; signatures.needsWords() && m < models.size(); ++m) {
    signatures.addWords(m, models[m]);
  }
  std::map<std::string, study::PairDistances> distances;
  for (const std::string& term : terms) {
    const auto distance = [&signatures, term](std::size_t one, std::size_t other) {
      return signatures.distance(term, one, other);
    };
    auto& pairs =
        distances.emplace(term, study::PairDistances(models.size(), distance)).first->second;
    if (!pairs.prepare(quiet)) return stopped;
  }
  std::vector<Matrix> matrices;
  for (const Descriptor& descriptor : descriptors) {
    study::DescriptorRows rows(descriptor, distances, models.size());
    std::vector<double> row(models.size());
    Matrix matrix;
    for (std::size_t m = 0; m < models.size(); ++m) {
      if (!rows.row(m, row, quiet)) return stopped;
      matrix.insert(matrix.end(), row.begin(), row.end());
    }
    matrices.push_back(std::move(matrix));
  }
  return matrices;
}

/// For each descriptor the distances between all models.
py::list compared(const std::vector<Fields>& given, const std::vector<std::string>& names,
                  const Running& running) {
  const auto models = std::make_shared<std::vector<StudyFields>>();
  for (const Fields& fields : given) models->push_back(fieldsOf(fields));
  const std::vector<Descriptor> descriptors = descriptorsOf(names);
  auto matrices =
      compute<std::vector<Matrix>>(running, [models, descriptors](const ExecutionContext& context) {
        return matricesOf(*models, descriptors, context);
      });
  const auto count = static_cast<py::ssize_t>(models->size());
  py::list result;
  for (Matrix& matrix : matrices) result.append(arrayOf(std::move(matrix), {count, count}));
  return result;
}

/// (values, shares) of a distribution.
py::tuple distribution(const Array<double>& values, const Array<double>& weights) {
  Distribution result = distributionOf(spanOf(values), spanOf(weights));
  return py::make_tuple(arrayOf(std::move(result.values)), arrayOf(std::move(result.shares)));
}

Distribution distributionFrom(const Array<double>& values, const Array<double>& shares) {
  const auto numbers = spanOf(values);
  const auto parts = spanOf(shares);
  return {{numbers.begin(), numbers.end()}, {parts.begin(), parts.end()}};
}

/// The exact distances of one distribution, of the number `own`, from some of those that lie behind
/// each other in `values` and `shares`: number i from offsets[i] to offsets[i + 1]. In each pair
/// the lower number comes first, as in the matrices of `compared`: the order shows in the last bit.
Array<double> transportDistances(const Array<double>& ownValues, const Array<double>& ownShares,
                                 std::int64_t ownNumber, const Array<double>& values,
                                 const Array<double>& shares, const Array<std::int64_t>& offsets,
                                 const Array<std::int64_t>& wanted) {
  const Distribution own = distributionFrom(ownValues, ownShares);
  std::vector<double> distances;
  {
    const py::gil_scoped_release released;
    for (const std::int64_t i : spanOf(wanted)) {
      const auto begin = static_cast<std::size_t>(offsets.data()[i]);
      const auto size = static_cast<std::size_t>(offsets.data()[i + 1]) - begin;
      const auto numbers = spanOf(values).subspan(begin, size);
      const auto parts = spanOf(shares).subspan(begin, size);
      const Distribution other{{numbers.begin(), numbers.end()}, {parts.begin(), parts.end()}};
      distances.push_back(i < ownNumber ? earthMoversDistance(other, own)
                                        : earthMoversDistance(own, other));
    }
  }
  return arrayOf(std::move(distances));
}

}  // namespace

void bindComparison(py::module_& module) {
  module.def("descriptor_names", &study::descriptorNames);
  module.def("parameters_text", &parametersText);
  module.def("compared_fields", &comparedFields);
  module.def("compare", &compared);
  module.def("distribution", &distribution);
  module.def("transport_distances", &transportDistances);
}

}  // namespace girth::python
