// Puts together a GLB file of one mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "girth/surface_mesh.h"

namespace girth::io {

/// A file with one node, one mesh and one primitive, valid by the rules of glTF 2.0.
class GlbWriter {
 public:
  /// Positions as the attribute POSITION.
  void addPositions(std::span<const Vec3> positions);
  /// One number a vertex, as floats, under a name such as "_IGF"; -1 for NaN, which glTF has not.
  void addValues(const std::string& attribute, std::span<const double> values);
  /// Red, green, blue and alpha a vertex, linear, 16 bits each, as the attribute COLOR_0.
  void addColours(std::span<const std::uint16_t> channels);
  /// Three vertices a triangle.
  void addTriangles(const SurfaceMesh& mesh);

  /// The whole file. `mode`: 4 triangles, 3 line strip. `extras`: of the mesh, JSON, may be empty.
  /// `unit`: that of the positions, where known: its node then scales it to metres.
  /// Error: LIMIT_EXCEEDED where it would pass 4 GB.
  Result<std::string> file(int mode, std::string_view unit, const std::string& extras) const;

 private:
  /// Adds an accessor over its own view of what has been appended since `begin`.
  std::size_t addAccessor(std::size_t begin, std::size_t count, const std::string& type,
                          int componentType, int target, const std::string& more);
  void addAttribute(const std::string& name, std::size_t accessor);

  std::string binary_, views_, accessors_, attributes_, indices_;
  std::size_t accessorCount_{0};
  bool coloured_{false};
};

}  // namespace girth::io
