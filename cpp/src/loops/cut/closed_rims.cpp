#include "loops/cut/closed_rims.h"

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "loops/cut/clear_cap.h"
#include "mesh/box.h"
#include "mesh/crossing_faces.h"
#include "mesh/vector.h"

namespace girth::loops {
namespace {

/// How a rim is closed.
struct Closing {
  double share;  ///< share of the way to its neighbours by which it is drawn back
  bool isClear;  ///< by triangles that cross nothing, rather than by those of least area
};

/// In the order in which they are tried.
constexpr std::array kClosings{
    Closing{0.25, false}, Closing{0.0625, false}, Closing{0.015625, false}, Closing{0, false},
    Closing{0.25, true},  Closing{0.0625, true},  Closing{0.015625, true},  Closing{0, true}};

/// A cut surface whose rims are drawn back and closed.
class Rims {
 public:
  explicit Rims(const CutSurface& cut) : cut_(cut), capOf_(cut.mesh.vertexCount(), kNoIndex) {
    numberCaps();
    findMoves();
  }

  std::size_t caps() const { return caps_; }

  /// As said for each cap; one that no triangles close which cross nothing is left as it is. Error:
  /// that of SurfaceMesh::fromArrays.
  Result<SurfaceMesh> closedBy(std::span<const Closing> closings) const {
    const SurfaceMesh& mesh = cut_.mesh;
    std::vector<Vec3> places;
    for (const Vertex v : mesh.vertices()) {
      const double share = capOf_[v] == kNoIndex ? 0 : closings[capOf_[v]].share;
      places.push_back(mesh.position(v) + share * moves_[v]);
    }
    std::vector<std::array<Vertex, 3>> faces;
    for (const Face f : mesh.faces()) faces.push_back(mesh.faceVertices(f));
    // Caps to be triangulated anew are not in each other's way before they are.
    std::set<Index> pending;
    for (Index cap = 0; cap < caps_; ++cap) {
      if (closings[cap].isClear) pending.insert(cap);
    }
    while (!pending.empty()) {
      triangulateClear(*pending.begin(), pending, places, faces);
      pending.erase(pending.begin());
    }
    std::vector<double> positions;
    std::vector<Index> triangles;
    for (const Vec3& place : places) positions.insert(positions.end(), {place.x, place.y, place.z});
    for (const auto& face : faces) triangles.insert(triangles.end(), face.begin(), face.end());
    return SurfaceMesh::fromArrays(positions, triangles, OpenEdges::Boundary);
  }

  /// The faces of each cap of a surface drawn back, and faces that its rim moved, which cross
  /// others; not faces that did so before.
  std::vector<std::vector<Face>> crossing(const SurfaceMesh& drawn) const {
    std::vector<Face> changed;
    for (const Face f : drawn.faces()) {
      if (!capsAt(f).empty()) changed.push_back(f);
    }
    const std::vector<std::pair<Face, Face>> now = crossingFaces(drawn, changed);
    std::vector<Face> old;
    for (const auto& [f, g] : now) {
      if (!isNew(f) && !isNew(g)) old.push_back(f);
    }
    std::vector<std::pair<Face, Face>> before;
    if (!old.empty()) before = crossingFaces(cut_.mesh, old);
    std::vector<std::vector<Face>> result(caps_);
    for (const auto& [f, g] : now) {
      const bool areOld = !isNew(f) && !isNew(g);
      if (areOld && std::binary_search(before.begin(), before.end(), std::pair{f, g})) continue;
      for (const Face face : {f, g}) {
        for (const Index cap : capsAt(face)) result[cap].push_back(face);
      }
    }
    for (std::vector<Face>& faces : result) {
      std::sort(faces.begin(), faces.end());
      faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    }
    return result;
  }

 private:
  bool isNew(Face f) const { return cut_.faces[f] == Face::none; }

  std::vector<Index> capsAt(Face f) const {
    std::vector<Index> caps;
    for (const Vertex v : cut_.mesh.faceVertices(f)) {
      if (capOf_[v] != kNoIndex && std::find(caps.begin(), caps.end(), capOf_[v]) == caps.end()) {
        caps.push_back(capOf_[v]);
      }
    }
    return caps;
  }

  /// Replaces the faces of a cap by those of least area that cross none but of caps left out.
  void triangulateClear(Index cap, const std::set<Index>& leftOut, std::span<const Vec3> places,
                        std::vector<std::array<Vertex, 3>>& faces) const {
    std::vector<Index> own;
    std::vector<std::array<Vertex, 3>> before;
    for (Index f = 0; f < faces.size(); ++f) {
      if (!isNew(Face(f)) || capOf_[faces[f][0]] != cap) continue;
      own.push_back(f);
      before.push_back(faces[f]);
    }
    const std::vector<Vertex> polygon = polygonOf(before);
    if (polygon.empty()) return;
    std::vector<Vec3> corners;
    for (const Vertex v : polygon) corners.push_back(places[v]);
    const Box room(corners);
    std::vector<PlacedFace> others;
    for (Index f = 0; f < faces.size(); ++f) {
      const auto& [a, b, c] = faces[f];
      if (isNew(Face(f)) && leftOut.count(capOf_[a]) > 0) continue;
      const Triangle3 place{places[a], places[b], places[c]};
      if (Box(place).overlaps(room)) others.push_back({faces[f], place});
    }
    const auto clear = clearCap(polygon, places, others);
    for (std::size_t i = 0; clear && i < own.size(); ++i) faces[own[i]] = (*clear)[i];
  }

  /// New faces that share a vertex are of one cap.
  void numberCaps() {
    const SurfaceMesh& mesh = cut_.mesh;
    std::vector<std::vector<Face>> around(mesh.vertexCount());
    for (const Face f : mesh.faces()) {
      if (!isNew(f)) continue;
      for (const Vertex v : mesh.faceVertices(f)) around[v].push_back(f);
    }
    for (const Vertex seed : mesh.vertices()) {
      if (around[seed].empty() || capOf_[seed] != kNoIndex) continue;
      capOf_[seed] = static_cast<Index>(caps_);
      std::vector<Vertex> pending{seed};
      while (!pending.empty()) {
        const Vertex at = pending.back();
        pending.pop_back();
        for (const Face f : around[at]) {
          for (const Vertex v : mesh.faceVertices(f)) {
            if (capOf_[v] != kNoIndex) continue;
            capOf_[v] = static_cast<Index>(caps_);
            pending.push_back(v);
          }
        }
      }
      ++caps_;
    }
  }

  /// The mean way from a vertex of a rim to its neighbours off the rim, and from the middle of a
  /// cap that of the vertices round it.
  void findMoves() {
    const SurfaceMesh& mesh = cut_.mesh;
    const auto isRim = [&](Vertex v) { return capOf_[v] != kNoIndex && v < cut_.points.size(); };
    moves_.resize(mesh.vertexCount());
    for (const bool isMiddle : {false, true}) {
      std::vector<double> counts(mesh.vertexCount(), 0);
      std::vector<Vec3> sums(mesh.vertexCount());
      for (const Halfedge h : mesh.halfedges()) {
        for (const auto& [v, to] :
             {std::pair{mesh.from(h), mesh.to(h)}, {mesh.to(h), mesh.from(h)}}) {
          if (isMiddle ? v < cut_.points.size() || !isRim(to)
                       : !isRim(v) || isRim(to) || to >= cut_.points.size()) {
            continue;
          }
          sums[v] = sums[v] + (isMiddle ? moves_[to] : mesh.position(to) - mesh.position(v));
          counts[v] += 1;
        }
      }
      for (const Vertex v : mesh.vertices()) {
        if (counts[v] > 0) moves_[v] = (1 / counts[v]) * sums[v];
      }
    }
  }

  const CutSurface& cut_;
  std::size_t caps_{0};
  std::vector<Index> capOf_;  // caps by vertex of rims and caps
  std::vector<Vec3> moves_;
};

}  // namespace

Result<ClosedRims> closedRims(const CutSurface& cut, const ExecutionContext& context) {
  const Rims rims(cut);
  // For each cap, which of the closings; all begin with the first.
  std::vector<std::size_t> tried(rims.caps(), 0);
  std::vector<bool> isWithoutRoom(rims.caps(), false);
  std::size_t first = 0;
  while (true) {
    if (context.cancelled()) return makeError(ErrorCode::Cancelled, -1, "cancelled");
    std::vector<Closing> closings;
    for (const std::size_t t : tried) closings.push_back(kClosings[t]);
    auto drawn = rims.closedBy(closings);
    if (!drawn) {
      if (++first == kClosings.size()) return drawn.error();
      for (std::size_t& t : tried) t = std::max(t, first);
      continue;
    }
    const std::vector<std::vector<Face>> crossing = rims.crossing(drawn.value());
    bool isChanged = false;
    std::vector<Face> faces;
    for (std::size_t cap = 0; cap < crossing.size(); ++cap) {
      faces.insert(faces.end(), crossing[cap].begin(), crossing[cap].end());
      if (crossing[cap].empty() || isWithoutRoom[cap]) continue;
      isChanged = true;
      isWithoutRoom[cap] = ++tried[cap] == kClosings.size();
      // It crosses something anyway: drawn back, its two sides do not touch at least.
      if (isWithoutRoom[cap]) tried[cap] = first;
    }
    if (isChanged) continue;
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return ClosedRims{std::move(drawn).value(), static_cast<Index>(faces.size())};
  }
}

}  // namespace girth::loops
