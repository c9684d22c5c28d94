// Points, vertices and faces of a surface as text, in the numbers of the file.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "girth/describe/description.h"
#include "girth/io/read_mesh.h"
#include "girth/surface_point.h"

namespace girth::io {

/// x, y and z between separators.
std::string pointText(const Vec3& point, char separator);

/// The vertex of the file that a vertex of the surface comes from; "null" where it was made here.
std::string inputText(const LoadedMesh& loaded, Vertex vertex);

/// Vertices of the surface as a JSON array of the file's; those made here are left out.
std::string inputsJson(const LoadedMesh& loaded, const std::vector<Vertex>& vertices);

/// Faces of the surface as a JSON array of the file's; those made here are left out.
std::string facesJson(const LoadedMesh& loaded, const std::vector<Face>& faces);

/// The numbers of those vertices that the file has.
std::string numbersJson(const LoadedMesh& loaded, const VertexNumbers& numbers);

/// Places in a list as a JSON array.
std::string numbersJson(std::span<const Index> places);

/// `position`, and the `vertices` of the file (one, the two of an edge, or the three of a face)
/// that the point lies between, with their `weights`.
std::string pointJson(const LoadedMesh& loaded, const SurfacePoint& point);

/// A vertex as `pointJson` writes it; null where it is none.
std::string vertexJson(const LoadedMesh& loaded, Vertex vertex);

/// The positions of points as a JSON array.
std::string positionsJson(const LoadedMesh& loaded, std::span<const SurfacePoint> points);

/// Points as a JSON array, one a line.
std::string pointsJson(const LoadedMesh& loaded, std::span<const SurfacePoint> points);

/// Appends a polyline as vertices and a line element of OBJ; the last point of a closed one equals
/// the first. `count`: of the vertices that stand before it and, from now on, with it.
void appendLine(const LoadedMesh& loaded, const std::vector<SurfacePoint>& points, bool isClosed,
                std::size_t& count, std::string& obj);

}  // namespace girth::io
