#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "curves.h"
#include "girth/cut_surface.h"
#include "girth/describe/bottleneck.h"
#include "girth/describe/handles.h"
#include "girth/describe/limb_axis.h"
#include "girth/describe/necks.h"
#include "girth/describe/remove_handles.h"
#include "girth/io/write_cut.h"
#include "girth/path_profile.h"
#include "points.h"
#include "result_dict.h"
#include "surface.h"
#include "working.h"

namespace py = pybind11;

namespace girth::python {
namespace {

using Shared = std::shared_ptr<Surface>;

py::dict necksOf(const Shared& surface, double minProminence, const Running& running) {
  const Necks found = compute<Necks>(
      running, [surface, minProminence](const ExecutionContext& context) -> Result<Necks> {
        const auto girth = surface->girth(0, {context.threads, context.cancel, {}});
        if (!girth) return girth.error();
        return findNecks(surface->mesh(), girth.value()->values, {minProminence}, context);
      });
  return dictOf(surface->loaded(), found);
}

py::dict handlesOf(const Shared& surface, std::size_t basePoints, const Running& running) {
  const Handles found =
      compute<Handles>(running, [surface, basePoints](const ExecutionContext& context) {
        return findHandles(surface->mesh(), {basePoints}, context);
      });
  return dictOf(surface->loaded(), found);
}

/// (vertices, faces, account) of the surface without its short handles.
py::tuple withoutHandles(const Shared& surface, double length, std::size_t basePoints,
                         const Running& running) {
  const auto removal = compute<HandleRemoval>(
      running, [surface, length, basePoints](const ExecutionContext& context) {
        return removeHandles(surface->mesh(), length, {basePoints}, context);
      });
  return py::make_tuple(positionArray(removal.mesh), triangleArray(removal.mesh),
                        dictOf(surface->loaded(), removal));
}

py::dict bottleneckOf(const Shared& surface, const Point& from, const Point& to,
                      const Running& running) {
  const SurfacePoint start = pointOf(from), end = pointOf(to);
  const Bottleneck found = compute<Bottleneck>(
      running, [surface, start, end](const ExecutionContext& context) -> Result<Bottleneck> {
        const auto girth = surface->girth(0, {context.threads, context.cancel, {}});
        if (!girth) return girth.error();
        return findBottleneck(surface->mesh(), girth.value()->values, start, end, context);
      });
  return dictOf(surface->loaded(), found);
}

using Stations = std::vector<PathStation>;

/// (distances, girths, kinds, places) along the shortest paths from each point to the next.
py::tuple profileOf(const Shared& surface, const std::vector<Point>& through, std::size_t samples,
                    bool crossings, const Running& running) {
  std::vector<SurfacePoint> points;
  for (const Point& point : through) points.push_back(pointOf(point));
  const PathProfileOptions options{samples, crossings};
  const Stations stations = compute<Stations>(
      running, [surface, points, options](const ExecutionContext& context) -> Result<Stations> {
        std::vector<SurfacePoint> path;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
          const auto piece = surface->path(points[i], points[i + 1], context.ofOneThread());
          if (!piece) return piece.error();
          if (piece.value().points.empty()) {
            Error error = makeError(ErrorCode::InvalidPoint, -1,
                                    "points " + std::to_string(i) + " and " +
                                        std::to_string(i + 1) + " lie in different components");
            error.hint = "choose points that a way over the surface joins";
            return error;
          }
          path.insert(path.end(), piece.value().points.begin(), piece.value().points.end());
        }
        return girthAlong(surface->mesh(), path, options, context);
      });
  std::vector<double> distances, girths;
  std::vector<std::uint8_t> kinds;
  std::vector<SurfacePoint> places;
  for (const PathStation& station : stations) {
    distances.push_back(station.distance);
    girths.push_back(station.girth);
    kinds.push_back(static_cast<std::uint8_t>(station.kind));
    places.push_back(station.point);
  }
  return py::make_tuple(arrayOf(std::move(distances)), arrayOf(std::move(girths)),
                        arrayOf(std::move(kinds)), placesOf(surface->mesh(), places));
}

using Axis = std::vector<AxisStation>;

/// The loops along a limb. `profile`: of each station its distance, ring, median and least girth.
py::list axisOf(const Shared& surface, const Array<double>& profile, const CurveArrays& places,
                const Running& running) {
  const SurfaceCurve points = pointsOf(places);
  const auto numbers = spanOf(profile);
  GirthProfile stations;
  for (std::size_t i = 0; i < std::min(points.size(), numbers.size() / 4); ++i) {
    const double* of = numbers.data() + 4 * i;
    stations.push_back({of[0], of[1], of[2], of[3], points[i]});
  }
  const Axis axis =
      compute<Axis>(running, [surface, stations](const ExecutionContext& context) -> Result<Axis> {
        return limbAxis(surface->mesh(), stations, context);
      });
  return listOf(surface->loaded(), axis);
}

/// (parts, part of each face of the input)
py::tuple cutAlong(const Shared& surface, const std::vector<CurveArrays>& curves, bool cap,
                   const Running& running) {
  std::vector<SurfaceCurve> along;
  for (const CurveArrays& curve : curves) along.push_back(pointsOf(curve));
  const auto model = compute<io::CutModel>(
      running, [surface, along, cap](const ExecutionContext& context) -> Result<io::CutModel> {
        const auto cut = cutSurface(surface->mesh(), along, {cap}, context);
        if (!cut) return cut.error();
        return io::cutModel(cut.value());
      });
  py::list parts;
  for (const SurfaceComponent& part : model.parts) {
    std::vector<Index> rows;
    for (const Face face : part.faces) {
      const Face whole = model.faces[face];
      rows.push_back(whole == Face::none ? kNoIndex : surface->loaded().inputOfFace[whole]);
    }
    py::dict one = dictOf(surface->loaded(), partMeasures(part.mesh));
    one["vertices"] = positionArray(part.mesh);
    one["faces"] = triangleArray(part.mesh);
    one["face_rows"] = numberArray(rows);
    parts.append(one);
  }
  return py::make_tuple(parts, numberArray(io::partOfFaces(surface->loaded(), model)));
}

}  // namespace

void bindLoops(py::module_& module) {
  module.def("necks", &necksOf);
  module.def("handles", &handlesOf);
  module.def("remove_handles", &withoutHandles);
  module.def("bottleneck", &bottleneckOf);
  module.def("profile", &profileOf);
  module.def("axis", &axisOf);
  module.def("cut", &cutAlong);
}

}  // namespace girth::python
