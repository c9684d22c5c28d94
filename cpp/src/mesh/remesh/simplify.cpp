#include "mesh/remesh/simplify.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <utility>
#include <vector>

#include "mesh/nearest_point.h"
#include "mesh/remesh/cancellation_poll.h"
#include "mesh/remesh/changing_mesh.h"
#include "mesh/remesh/face_checks.h"
#include "mesh/remesh/quadric.h"
#include "mesh/remesh/result.h"
#include "mesh/vertex_normals.h"

namespace girth::remeshing {

namespace {

/// How much the distance to the vertices that were counts besides that to the planes of the faces:
/// it keeps triangles in shape where the surface is flat, and makes the best place of a vertex a
/// single one everywhere.
constexpr double kPlaceShare = 1e-3;
/// How much a boundary counts more than a surface: boundaries stay where they are.
constexpr double kBoundaryShare = 100;
/// How much faces at sharp points count more than others.
constexpr double kPointShare = 100;
/// Flips at the end may turn faces by no more than this: cos 8°.
constexpr double kHardlyTurned = 0.99;

class Simplifier {
 public:
  Simplifier(const SurfaceMesh& original, Index faces, const ExecutionContext& context)
      : original_(original), wanted_(faces), context_(context), poll_(context), mesh_(original) {
    // Around the middle, so that squares lose no bits.
    for (const Vertex v : original.vertices()) {
      middle_ = middle_ + 1.0 / original.vertexCount() * original.position(v);
    }
    collectPlanes();
  }

  Result<RemeshedSurface> run() {
    // Edges that could not be collapsed may be later: their neighbours have changed. After some
    // rounds only as long as that is much.
    constexpr int kFullRounds = 16;
    constexpr Index kLittle = 256;  // one of so many faces
    Index before = kNoIndex;
    for (int round = 0; mesh_.faceCount() > wanted_; ++round) {
      const Index gone = before - mesh_.faceCount();
      if (gone == 0 || (round > kFullRounds && gone < before / kLittle)) break;
      before = mesh_.faceCount();
      queue_ = {};
      for (Index h = 0; h < mesh_.halfedgeCount(); ++h) {
        if (poll_.stopped()) return CancellationPoll::error();
        if (mesh_.isFirstOfEdge(h)) push(h);
      }
      if (!collapse()) return CancellationPoll::error();
    }
    widenAngles(mesh_, kHardlyTurned, poll_);
    const NearestSearch search = searchOf(original_);
    auto result = resultOf(mesh_, poll_, [&](Index v) {
      const auto found = nearestFacing(original_, search, faceNormals_, mesh_, v);
      return SurfacePoint::inFace(Face(found.triangle), found.weights);
    });
    if (result && context_.onProgress) context_.onProgress(1);
    return result;
  }

 private:
  /// The cheapest edge first; of equal ones, the first.
  struct Entry {
    double cost;
    Index halfedge;
    /// The last changes of its two ends when it was entered.
    Index changeFrom, changeTo;
    bool operator<(const Entry& other) const {
      return cost != other.cost ? cost > other.cost : halfedge > other.halfedge;
    }
  };

  /// How much a face counts: more where it holds a sharp point, one whose angles sum to less than
  /// π. Loops of all around hang on such a point, however small it is (paper, section 3.1).
  double weightOf(Face face) const {
    for (const Vertex v : original_.faceVertices(face)) {
      if (original_.totalAngle(v) < std::numbers::pi) return kPointShare;
    }
    return 1;
  }

  void collectPlanes() {
    faceNormals_ = normalsOfFaces(original_);
    quadrics_.resize(original_.vertexCount());
    changes_.resize(original_.vertexCount(), 0);
    for (const Halfedge h : original_.halfedges()) {
      const Vertex a = original_.from(h), b = original_.to(h);
      const Vec3 p = original_.position(a) - middle_;
      const double third =
          weightOf(SurfaceMesh::faceOf(h)) * original_.area(SurfaceMesh::faceOf(h)) / 3;
      quadrics_[a] += Quadric::ofPlane(p, faceNormals_[h / 3], third);
      quadrics_[a] += Quadric::ofPoint(p, kPlaceShare * third);
      if (original_.twin(h) != kNoIndex) continue;
      // A plane through the boundary, upright on its face.
      const double length = original_.length(h);
      const Vec3 along = 1 / length * (original_.position(b) - original_.position(a));
      const Quadric boundary =
          Quadric::ofPlane(p, cross(along, faceNormals_[h / 3]), kBoundaryShare * length * length);
      quadrics_[a] += boundary;
      quadrics_[b] += boundary;
    }
  }

  Quadric quadricOf(Index h) const {
    Quadric sum = quadrics_[mesh_.from(h)];
    sum += quadrics_[mesh_.to(h)];
    return sum;
  }

  /// Where the ends of an edge meet best, seen from the middle.
  Vec3 meetingPoint(Index h, const Quadric& quadric) const {
    const Vec3 half = 0.5 * (mesh_.position(mesh_.from(h)) + mesh_.position(mesh_.to(h)));
    return quadric.least().value_or(half - middle_);
  }

  void push(Index h) {
    const Quadric quadric = quadricOf(h);
    const double cost = quadric.at(meetingPoint(h, quadric));
    queue_.push({cost, h, changes_[mesh_.from(h)], changes_[mesh_.to(h)]});
  }

  /// Collapses edges until there are few enough faces or nothing is left to try; false where it was
  /// asked to stop.
  bool collapse() {
    constexpr Index kReportEvery = 1024;
    Index sinceLook = 0;
    while (mesh_.faceCount() > wanted_ && !queue_.empty()) {
      if (poll_.stopped()) return false;
      if (++sinceLook == kReportEvery) {
        sinceLook = 0;
        progress();
      }
      const Entry entry = queue_.top();
      queue_.pop();
      const Index h = entry.halfedge;
      if (!mesh_.isAlive(h / 3)) continue;
      const Index a = mesh_.from(h), b = mesh_.to(h);
      if (changes_[a] != entry.changeFrom || changes_[b] != entry.changeTo) continue;
      if (!mesh_.canCollapse(h)) continue;
      const Quadric quadric = quadricOf(h);
      const Vec3 place = meetingPoint(h, quadric) + middle_;
      if (!keepsFacing(mesh_, a, place, b) || !keepsFacing(mesh_, b, place, a)) continue;
      const Index left = mesh_.collapse(h, place);
      quadrics_[left] = quadric;
      changes_[left] = ++collapses_;
      mesh_.forEachOutgoing(left, [&](Index out) {
        push(out);
        const Index back = ChangingMesh::previous(out);
        if (mesh_.twin(back) == kNoIndex) push(back);
      });
    }
    return true;
  }

  void progress() {
    if (!context_.onProgress) return;
    const double before = original_.faceCount(), now = mesh_.faceCount();
    reached_ = std::max(reached_, 0.95 * (before - now) / (before - wanted_));
    context_.onProgress(reached_);
  }

  const SurfaceMesh& original_;
  Index wanted_;
  const ExecutionContext& context_;
  CancellationPoll poll_;
  ChangingMesh mesh_;
  Vec3 middle_;
  std::vector<Vec3> faceNormals_;
  std::vector<Quadric> quadrics_;  ///< by vertex, about the middle
  std::vector<Index> changes_;     ///< the collapse that each vertex last came from; 0: none
  Index collapses_{0};
  std::priority_queue<Entry> queue_;
  double reached_{0};
};

}  // namespace

Result<RemeshedSurface> simplify(const SurfaceMesh& mesh, Index faces,
                                 const ExecutionContext& context) {
  return Simplifier(mesh, faces, context).run();
}

}  // namespace girth::remeshing
