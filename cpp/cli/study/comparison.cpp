#include "study/comparison.h"

#include <utility>

namespace girth::cli {

using study::Descriptor;
using study::StudyFields;

Result<std::vector<Descriptor>> parseDescriptors(const std::vector<std::string>& names) {
  std::vector<Descriptor> descriptors;
  for (const std::string& name : names) {
    auto descriptor = study::parseDescriptor(name);
    if (!descriptor) return descriptor.error();
    descriptors.push_back(std::move(descriptor).value());
  }
  return descriptors;
}

Result<StudyFields> comparedFields(const SurfaceMesh& mesh,
                                   const std::vector<Descriptor>& descriptors,
                                   const ComparisonOptions& options,
                                   const ExecutionContext& context) {
  const auto surface = study::studySurface(mesh, options.fields, context);
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

}  // namespace girth::cli
