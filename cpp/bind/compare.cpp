// Shapes compared by descriptors: their fields one by one, then the distances between all of them.

#include <emscripten/bind.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "boundary.h"
#include "girth/study/descriptor_rows.h"
#include "girth/study/pair_distances.h"
#include "girth/study/signatures.h"
#include "girth/study/study_fields.h"
#include "studies_surface.h"

using emscripten::val;

namespace girth::bind {
namespace {

using study::Descriptor;
using study::PairDistances;
using study::Signatures;
using study::StudyFields;

Result<std::vector<Descriptor>> descriptorsOf(const val& names) {
  std::vector<Descriptor> descriptors;
  for (unsigned i = 0; i < names["length"].as<unsigned>(); ++i) {
    auto descriptor = study::parseDescriptor(names[i].as<std::string>());
    if (!descriptor) return descriptor.error();
    descriptors.push_back(std::move(descriptor).value());
  }
  return descriptors;
}

/// {groups}, the names of those that descriptors (an array of texts) need, or an error.
val fieldGroups(const val& names) {
  return guarded([&] {
    const auto descriptors = descriptorsOf(names);
    if (!descriptors) return toJs(descriptors.error());
    val groups = val::array();
    for (const study::FieldGroup group : study::groupsOf(descriptors.value())) {
      groups.call<void>("push", std::string(toString(group)));
    }
    val result = val::object();
    result.set("groups", groups);
    return result;
  });
}

/// `StudyFields` of protocol.ts: one group of a surface, or an error.
val studyFields(StudiesSurface& surface, const std::string& name, double faces, double smooth,
                const val& onProgress) {
  return guarded([&] {
    const auto* const end = std::end(study::kFieldGroups);
    const auto* const group =
        std::find_if(std::begin(study::kFieldGroups), end,
                     [&](study::FieldGroup one) { return toString(one) == name; });
    if (group == end) {
      return toJs(makeError(ErrorCode::Usage, -1, "there are no fields '" + name + "'"));
    }
    if (!(faces >= 0 && faces <= 1e9)) {
      return toJs(
          makeError(ErrorCode::InvalidOption, -1, "the number of faces is not between 0 and 1e9"));
    }
    study::FieldParameters parameters;
    parameters.faces = static_cast<Index>(faces);
    parameters.smoothing = indexOf(smooth);
    const ExecutionContext context = reportingTo(onProgress);
    if (const auto error = surface.prepareStudy(parameters)) return toJs(*error);
    const auto fields = study::studyFields(surface.study(), *group, parameters, context);
    if (!fields) return toJs(fields.error());
    val list = val::array();
    for (const study::StudyField& field : fields.value().fields) {
      val entry = val::object();
      entry.set("name", field.name);
      entry.set("dimensions", static_cast<double>(field.dimensions));
      entry.set("values", copyOut<double>("Float64Array", field.values));
      list.call<void>("push", entry);
    }
    val result = val::object();
    result.set("weights", copyOut<double>("Float64Array", fields.value().weights));
    result.set("fields", list);
    return result;
  });
}

/// All fields of a model, from an array of `StudyFields`.
StudyFields fieldsOf(const val& groups) {
  StudyFields all;
  for (unsigned g = 0; g < groups["length"].as<unsigned>(); ++g) {
    const val group = groups[g];
    if (g == 0) all.weights = copyIn<double>(group["weights"]);
    const val fields = group["fields"];
    for (unsigned i = 0; i < fields["length"].as<unsigned>(); ++i) {
      const val field = fields[i];
      all.fields.push_back({field["name"].as<std::string>(), field["dimensions"].as<unsigned>(),
                            copyIn<double>(field["values"])});
    }
  }
  return all;
}

/// {matrices}: for each descriptor the distances between all models (each an array of
/// `StudyFields`), row after row, or an error.
val compare(const val& models, const val& names, const val& onProgress) {
  return guarded([&] {
    const auto descriptors = descriptorsOf(names);
    if (!descriptors) return toJs(descriptors.error());
    const unsigned count = models["length"].as<unsigned>();
    const std::vector<std::string> terms = study::termsOf(descriptors.value());
    study::SignatureOptions options;
    // In a few models nearly every feature becomes a word of its own. With each feature counted for
    // its nearest word only, all models would be equally far apart.
    options.words = study::WordChoice::Soft;
    const auto signatures = std::make_shared<Signatures>(terms, count, options);
    for (unsigned m = 0; m < count; ++m) signatures->add(m, fieldsOf(models[m]));
    if (const auto finished = signatures->finish(); !finished) return toJs(finished.error());
    for (unsigned m = 0; signatures->needsWords() && m < count; ++m) {
      signatures->addWords(m, fieldsOf(models[m]));
    }
    std::map<std::string, PairDistances> distances;
    for (const std::string& term : terms) {
      const auto distance = [signatures, term](std::size_t one, std::size_t other) {
        return signatures->distance(term, one, other);
      };
      distances.emplace(term, PairDistances(count, distance))
          .first->second.prepare(reportingTo(onProgress));
    }
    val matrices = val::array();
    for (const Descriptor& descriptor : descriptors.value()) {
      study::DescriptorRows rows(descriptor, distances, count);
      std::vector<double> row(count), matrix;
      for (unsigned m = 0; m < count; ++m) {
        rows.row(m, row);
        matrix.insert(matrix.end(), row.begin(), row.end());
      }
      matrices.call<void>("push", copyOut<double>("Float64Array", matrix));
    }
    val result = val::object();
    result.set("matrices", matrices);
    return result;
  });
}

EMSCRIPTEN_BINDINGS(girthCompare) {
  emscripten::function("fieldGroups", &fieldGroups);
  emscripten::function("studyFields", &studyFields);
  emscripten::function("compare", &compare);
}

}  // namespace
}  // namespace girth::bind
