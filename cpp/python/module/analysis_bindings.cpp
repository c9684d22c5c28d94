#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "girth/analyses.def"
#include "girth/describe/limbs.h"
#include "girth/describe/parts.h"
#include "girth/describe/persistent_maxima.h"
#include "girth/describe/print_check.h"
#include "girth/describe/segments.h"
#include "girth/describe/tips.h"
#include "girth/fields.h"
#include "girth/io/write_segments.h"
#include "girth/segments.h"
#include "options_from.h"
#include "result_dict.h"
#include "surface.h"
#include "working.h"

namespace py = pybind11;

namespace girth::python {
namespace {

using Shared = std::shared_ptr<Surface>;

/// The girth, and the tips by it.
Result<Tips> tipsByGirth(const Surface& surface, double persistence,
                         const ExecutionContext& context) {
  const auto girth = surface.girth(persistence, context);
  if (!girth) return girth.error();
  return findTips(surface.mesh(), girth.value()->values, {context.threads, context.cancel, {}});
}

py::dict tipsOf(const Shared& surface, double persistence, const Running& running) {
  const Tips found =
      compute<Tips>(running, [surface, persistence](const ExecutionContext& context) {
        return tipsByGirth(*surface, persistence, context);
      });
  return dictOf(surface->loaded(), found);
}

py::list limbsOf(const Shared& surface, Index stations, double persistence,
                 const Running& running) {
  const Limbs found = compute<Limbs>(
      running, [surface, stations, persistence](const ExecutionContext& c) -> Result<Limbs> {
        const auto tips = tipsByGirth(*surface, persistence, c);
        if (!tips) return tips.error();
        const ExecutionContext quiet{c.threads, c.cancel, {}};
        const auto girth = surface->girth(persistence, quiet);
        if (!girth) return girth.error();
        return findLimbs(surface->mesh(), girth.value()->values, tips.value().tips, {stations},
                         quiet);
      });
  return listOf(surface->loaded(), found.limbs);
}

struct FoundParts {
  PartThresholds thresholds;
  Parts parts;
};

/// Thresholds below 0 are found from the fields.
Result<FoundParts> partsOf(const Surface& surface, PartOptions options, double persistence,
                           const ExecutionContext& context) {
  const auto girth = surface.girth(persistence, context);
  if (!girth) return girth.error();
  const auto diameter = surface.diameter({context.threads, context.cancel, {}});
  if (!diameter) return diameter.error();
  const PartThresholds suggested =
      suggestedThresholds(surface.mesh(), girth.value()->values, *diameter.value());
  if (options.thresholds.girth < 0) options.thresholds.girth = suggested.girth;
  if (options.thresholds.shapeDiameter < 0) {
    options.thresholds.shapeDiameter = suggested.shapeDiameter;
  }
  auto parts = findParts(surface.mesh(), girth.value()->values, *diameter.value(), options);
  if (!parts) return parts.error();
  return FoundParts{options.thresholds, std::move(parts).value()};
}

/// (threshold of the girth, of the shape diameter, part of each vertex, parts)
py::tuple partsByThresholds(const Shared& surface, double girth, double shapeDiameter,
                            double smoothing, double persistence, const Running& running) {
  const PartOptions options{{girth, shapeDiameter}, smoothing};
  const auto found = compute<FoundParts>(
      running, [surface, options, persistence](const ExecutionContext& context) {
        return partsOf(*surface, options, persistence, context);
      });
  return py::make_tuple(found.thresholds.girth, found.thresholds.shapeDiameter,
                        numberArray(found.parts.partOf),
                        listOf(surface->loaded(), found.parts.parts));
}

/// Thresholds as above.
Result<io::SegmentedModel> segmentsAtNecks(const Surface& surface, double minProminence,
                                           const PartOptions& options,
                                           const ExecutionContext& context) {
  const ExecutionContext quiet{context.threads, context.cancel, {}};
  auto parts = partsOf(surface, options, 0, context);
  if (!parts) return parts.error();
  auto tips = tipsByGirth(surface, 0, quiet);
  if (!tips) return tips.error();
  const auto girth = surface.girth(0, quiet);
  if (!girth) return girth.error();
  const SurfaceMesh& mesh = surface.mesh();
  const auto necks = findNecks(mesh, girth.value()->values, {minProminence}, quiet);
  if (!necks) return necks.error();
  const FoundParts& found = parts.value();
  return io::segmentedModel(mesh, necks.value().necks, found.parts.kinds,
                            {found.thresholds, options.smoothing}, std::move(tips.value().tips),
                            quiet);
}

/// (threshold of the girth, of the shape diameter, part of each face of the input, segments, necks
/// that were passed over)
py::tuple segmentsByNecks(const Shared& surface, double minProminence, double girth,
                          double shapeDiameter, double smoothing, const Running& running) {
  const PartOptions options{{girth, shapeDiameter}, smoothing};
  const auto found = compute<io::SegmentedModel>(
      running, [surface, minProminence, options](const ExecutionContext& context) {
        return segmentsAtNecks(*surface, minProminence, options, context);
      });
  py::list segments;
  for (const Segment& segment : found.segments) {
    py::list apexes;
    for (const Index tip : segment.tips)
      apexes.append(rowOf(surface->loaded(), found.tips[tip].apex));
    py::dict one = dictOf(surface->loaded(), segment);
    one["area"] = segment.area;
    one["tips"] = std::vector<Index>(segment.tips);
    one["apexes"] = apexes;
    segments.append(one);
  }
  const PartThresholds& used = found.kinds.thresholds;
  return py::make_tuple(used.girth, used.shapeDiameter,
                        numberArray(io::partOfFaces(surface->loaded(), found.model)), segments,
                        std::vector<Index>(found.crossing));
}

/// The maxima of values at the surface's vertices, or their minima.
py::list maximaOf(const Shared& surface, const Array<double>& values, bool minima) {
  const double sign = minima ? -1 : 1;
  std::vector<double> heights;
  for (const double value : spanOf(values)) heights.push_back(sign * value);
  auto found = persistentMaxima(surface->mesh(), heights).value();
  for (PersistentMaximum& maximum : found) maximum.value *= sign;
  return listOf(surface->loaded(), found);
}

/// Computes the fields that the limits need, and checks them.
Result<PrintCheck> checkByLimits(const Surface& surface, const PrintLimits& limits,
                                 const ExecutionContext& context) {
  const ExecutionContext quiet{context.threads, context.cancel, {}};
  std::shared_ptr<const GirthField> girth;
  FieldValues thickness;
  if (limits.tubeDiameter > 0) {
    auto found = surface.girth(0, context);
    if (!found) return found.error();
    girth = std::move(found).value();
  }
  if (limits.wallThickness > 0) {
    auto found = fieldValues(surface.mesh(), "thickness", {}, quiet);
    if (!found) return found.error();
    thickness = std::move(found).value();
  }
  PrintFields fields{{}, thickness.values};
  if (girth) fields.girth = girth->values;
  return checkPrint(surface.mesh(), fields, limits, {}, quiet);
}

py::dict printCheckOf(const Shared& surface, double tubeDiameter, double wallThickness, double gap,
                      const Running& running) {
  const PrintLimits limits{tubeDiameter, wallThickness, gap};
  const auto found =
      compute<PrintCheck>(running, [surface, limits](const ExecutionContext& context) {
        return checkByLimits(*surface, limits, context);
      });
  return dictOf(surface->loaded(), found);
}

template <Described Options, Described Found>
py::dict resultOf(const Shared& surface, const py::handle& given, const Running& running,
                  Result<Found> (*analysis)(const SurfaceMesh&, const Options&,
                                            const ExecutionContext&)) {
  Options options;
  OptionsFrom().read(given, options);
  const auto found =
      compute<Found>(running, [surface, options, analysis](const ExecutionContext& context) {
        return analysis(surface->mesh(), options, context);
      });
  return dictOf(surface->loaded(), found);
}

/// The result of an analysis of girth/analyses.def by its name. `options`: in their order.
py::dict analyse(const std::string& name, const Shared& surface, const py::tuple& options,
                 const Running& running) {
#define GIRTH_ANALYSIS(analysis, Options, Found, function) \
  if (name == #analysis) return resultOf(surface, options, running, function);
#include "girth/analyses.def"
  throwError(makeError(ErrorCode::Usage, -1, "there is no analysis '" + name + "'"));
}

}  // namespace

void bindAnalysis(py::module_& module) {
  module.def("analyse", &analyse);
  module.def("tips", &tipsOf);
  module.def("limbs", &limbsOf);
  module.def("parts", &partsByThresholds);
  module.def("segments", &segmentsByNecks);
  module.def("maxima", &maximaOf);
  module.def("print_check", &printCheckOf);
}

}  // namespace girth::python
