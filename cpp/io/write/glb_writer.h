// Puts together a GLB file: surfaces, and lines on them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "girth/io/read_mesh.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"
#include "gltf/document/tinygltf.h"

namespace girth::io {

/// A file of meshes with one primitive each, every one in a node of its own, valid by the rules of
/// glTF 2.0. All that is added belongs to the mesh that endMesh ends.
class GlbWriter {
 public:
  GlbWriter();

  /// Positions as the attribute POSITION.
  void addPositions(std::span<const Vec3> positions);
  /// One number a vertex, or `width` of them, 2 to 4, as floats, under a name such as "_IGF"; -1
  /// for NaN, which glTF does not have.
  void addValues(const std::string& attribute, std::span<const double> values, Index width = 1);
  /// Red, green, blue and alpha a vertex, linear, 16 bits each, as the attribute COLOR_0.
  void addColours(std::span<const std::uint16_t> channels);
  /// Colours in [0, 1], as floats.
  void addColours(std::span<const double> channels);
  /// Three vertices a triangle.
  void addTriangles(const SurfaceMesh& mesh);
  /// Three vertices a triangle, of triangles that are no mesh.
  void addTriangles(std::span<const Index> triangles);

  /// Ends a mesh. `mode`: TINYGLTF_MODE_... `extras`: of the mesh, one object of JSON. `name`: of
  /// its node; empty for none.
  void endMesh(int mode, const std::string& extras, const std::string& name = {});

  /// The whole file; to be called once. `unit`: that of the positions; where it is known, the nodes
  /// scale it to metres. Without any mesh it is an empty scene. Error: LIMIT_EXCEEDED where the
  /// file would pass 4 GB.
  Result<std::string> file(std::string_view unit);

 private:
  using Bytes = std::vector<unsigned char>;

  Bytes& bytes() { return model_.buffers[0].data; }
  /// Adds an accessor over a view of its own: what has been appended since `begin`.
  int addAccessor(std::size_t begin, std::size_t count, int type, int componentType, int target);
  /// Colours show as they are, from both sides.
  void showColours();

  tinygltf::Model model_;
  tinygltf::Primitive primitive_;
};

/// Adds a mesh that is a line strip through points of a surface; `extras` and `name` as for
/// endMesh.
void addLine(const LoadedMesh& loaded, const std::vector<SurfacePoint>& points,
             const std::string& extras, const std::string& name, GlbWriter& writer);

}  // namespace girth::io
