#include "girth/subdivide_surface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace girth {
namespace {

/// Triangles that are being cut. An edge is known by its ends; on a surface, at most one face has
/// it in each direction.
class Bisection {
 public:
  explicit Bisection(const PreparedSurface& surface)
      : inputOfVertex_(surface.inputOfVertex), inputOfFace_(surface.inputOfFace) {
    const SurfaceMesh& mesh = surface.mesh;
    for (const Vertex v : mesh.vertices()) positions_.push_back(mesh.position(v));
    for (const Face f : mesh.faces()) {
      const auto corners = mesh.faceVertices(f);
      triangles_.push_back({corners[0], corners[1], corners[2]});
    }
    for (Index f = 0; f < triangles_.size(); ++f) {
      const Triangle& t = triangles_[f];
      for (std::size_t k = 0; k < 3; ++k) faceOf_[keyOf(t[k], t[(k + 1) % 3])] = f;
    }
    for (const Triangle& t : triangles_) {
      for (std::size_t k = 0; k < 3; ++k) push(t[k], t[(k + 1) % 3]);
    }
  }

  std::size_t faces() const { return triangles_.size(); }

  /// Cuts the longest edge, and the faces beside it.
  void cutLongest() {
    while (true) {
      const auto [squaredLength, a, b] = edges_.top();
      edges_.pop();
      const bool isThere = faceOf_.count(keyOf(a, b)) > 0 || faceOf_.count(keyOf(b, a)) > 0;
      if (!isThere) continue;
      const Vec3 &p = positions_[a], &q = positions_[b];
      const auto middle = static_cast<Index>(positions_.size());
      positions_.push_back({p.x + (q.x - p.x) / 2, p.y + (q.y - p.y) / 2, p.z + (q.z - p.z) / 2});
      inputOfVertex_.push_back(kNoIndex);
      cutFace(a, b, middle);
      cutFace(b, a, middle);
      push(a, middle);
      push(middle, b);
      return;
    }
  }

  Result<PreparedSurface> result(PreparedSurface surface) && {
    std::vector<double> coordinates;
    coordinates.reserve(3 * positions_.size());
    for (const Vec3& p : positions_) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
    std::vector<Index> corners;
    corners.reserve(3 * triangles_.size());
    for (const Triangle& t : triangles_) corners.insert(corners.end(), t.begin(), t.end());
    auto mesh = SurfaceMesh::fromArrays(coordinates, corners, OpenEdges::Boundary);
    if (!mesh) return mesh.error();
    surface.mesh = std::move(mesh).value();
    surface.inputOfVertex = std::move(inputOfVertex_);
    surface.inputOfFace = std::move(inputOfFace_);
    return surface;
  }

 private:
  using Triangle = std::array<Index, 3>;
  /// The squared length first; of equal ones the numbers of the ends decide.
  using Edge = std::tuple<double, Index, Index>;

  static std::uint64_t keyOf(Index from, Index to) { return std::uint64_t{from} << 32 | to; }

  void push(Index a, Index b) {
    const Vec3 &p = positions_[a], &q = positions_[b];
    const double x = q.x - p.x, y = q.y - p.y, z = q.z - p.z;
    edges_.emplace(x * x + y * y + z * z, std::min(a, b), std::max(a, b));
  }

  /// Cuts the face that has the edge in this direction, if there is one, from the edge's middle to
  /// the corner opposite.
  void cutFace(Index from, Index to, Index middle) {
    const auto found = faceOf_.find(keyOf(from, to));
    if (found == faceOf_.end()) return;
    const Index face = found->second;
    faceOf_.erase(found);
    Triangle& triangle = triangles_[face];
    std::size_t k = 0;
    while (triangle[k] != from) ++k;
    const Index opposite = triangle[(k + 2) % 3];
    triangle[(k + 1) % 3] = middle;
    const auto other = static_cast<Index>(triangles_.size());
    triangles_.push_back({middle, to, opposite});
    inputOfFace_.push_back(inputOfFace_[face]);
    faceOf_[keyOf(from, middle)] = face;
    faceOf_[keyOf(middle, opposite)] = face;
    faceOf_[keyOf(middle, to)] = other;
    faceOf_[keyOf(to, opposite)] = other;
    faceOf_[keyOf(opposite, middle)] = other;
    push(middle, opposite);
  }

  std::vector<Vec3> positions_;
  std::vector<Triangle> triangles_;
  std::vector<Index> inputOfVertex_, inputOfFace_;
  std::unordered_map<std::uint64_t, Index> faceOf_;
  std::priority_queue<Edge> edges_;
};

}  // namespace

Result<PreparedSurface> subdivideSurface(PreparedSurface surface, Index faces,
                                         const ExecutionContext& context) {
  if (surface.mesh.faceCount() >= faces) return surface;
  Bisection bisection(surface);
  while (bisection.faces() < faces) {
    if (bisection.faces() % 1024 < 2 && context.cancelled()) {
      return makeError(ErrorCode::Cancelled, -1, "stopped before it was finished");
    }
    bisection.cutLongest();
  }
  return std::move(bisection).result(std::move(surface));
}

}  // namespace girth
