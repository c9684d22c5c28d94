// A model, and points and vertices of its surface, as text, in the numbers of the file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "girth/cut_surface.h"
#include "girth/io/read_mesh.h"
#include "girth/surface_point.h"

namespace girth::io {

/// What the JSON about a model begins with: `file`, `unit`, and where it was measured on fewer
/// triangles than the file has, `fewerFaces`, their number.
std::string modelJson(std::string_view file, const LoadedMesh& loaded);

/// x, y and z between separators.
std::string pointText(const Vec3& point, char separator);

/// The vertex of the file that a vertex of the surface comes from; "null" where it was made here.
std::string inputText(const LoadedMesh& loaded, Vertex vertex);

/// Vertices of the surface as a JSON array of the file's; those made here are left out.
std::string inputsJson(const LoadedMesh& loaded, const std::vector<Vertex>& vertices);

/// `,"persistence":0.5`: of the girth that something was found by; nothing where it is 0.
std::string persistenceJson(double persistence);

/// `position`, and the `vertices` of the file (one, the two of an edge, or the three of a face)
/// that the point lies between, with their `weights`.
std::string pointJson(const LoadedMesh& loaded, const SurfacePoint& point);

/// Points as a JSON array, one a line.
std::string pointsJson(const LoadedMesh& loaded, const std::vector<SurfacePoint>& points);

/// `area` and `volume` of each side of a curve, as a JSON array.
std::string sidesJson(const std::vector<CurveSide>& sides);

/// Appends a closed polyline as vertices and a line element of OBJ; the last point equals the
/// first. `count`: of the vertices that stand before it and, from now on, with it.
void appendClosedLine(const LoadedMesh& loaded, const std::vector<SurfacePoint>& points,
                      std::size_t& count, std::string& obj);

}  // namespace girth::io
