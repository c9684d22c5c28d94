// Curves on a surface as JavaScript receives them.
#pragma once

#include <emscripten/val.h>

#include <vector>

#include "described.h"
#include "girth/surface_point.h"
#include "job_surface.h"
#include "surface_point.h"

namespace girth::bind {

/// {points, polyline} of `ClosedLoop` and `LevelCurve` of types.ts.
inline emscripten::val drawnCurve(const JobSurface& surface,
                                  const std::vector<SurfacePoint>& points) {
  emscripten::val places = emscripten::val::array();
  std::vector<Vec3> drawn;
  drawn.reserve(points.size());
  for (const SurfacePoint& point : points) {
    places.call<void>("push", surfacePointOf(point));
    drawn.push_back(positionOf(surface.mesh(), point));
  }
  emscripten::val result = emscripten::val::object();
  result.set("points", places);
  result.set("polyline", drawnPoints(drawn, surface.origin()));
  return result;
}

}  // namespace girth::bind
