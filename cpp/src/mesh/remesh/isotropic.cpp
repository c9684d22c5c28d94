#include "mesh/remesh/isotropic.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <utility>

#include "mesh/nearest_point.h"
#include "mesh/remesh/cancellation_poll.h"
#include "mesh/remesh/changing_mesh.h"
#include "mesh/remesh/face_checks.h"
#include "mesh/remesh/result.h"
#include "mesh/vertex_normals.h"

namespace girth::remeshing {

namespace {

/// Edges between faces whose normals differ by more than this are sharp: cos 50°.
constexpr double kSharp = 0.6427876096865394;
/// Sharp lines shorter than this, in edges of the result, are details that it cannot show.
constexpr double kShortestLine = 4;
/// Rounds of all operations; the size of the edges is mended after each.
constexpr int kRounds = 12;
/// The number of faces is met to within this share.
constexpr double kCountTolerance = 0.01;
/// Faces made by a flip face as those before did, within this cosine: 46°.
constexpr double kSmooth = 0.7;

class IsotropicRemesher {
 public:
  IsotropicRemesher(const SurfaceMesh& original, Index faces, const ExecutionContext& context)
      : original_(original),
        wanted_(faces),
        context_(context),
        poll_(context),
        mesh_(original),
        search_(searchOf(original)),
        faceNormals_(normalsOfFaces(original)) {
    // Equilateral triangles of the same area in all.
    length_ = std::sqrt(original.area() / faces * 4 / std::sqrt(3.0));
  }

  Result<RemeshedSurface> run() {
    findLines();
    for (int round = 0; round < kRounds; ++round) {
      if (poll_.stoppedByNow()) return CancellationPoll::error();
      splitLongEdges();
      if (poll_.stoppedByNow()) return CancellationPoll::error();
      collapseShortEdges();
      equalizeValences();
      relax();
      progress(0.9 * (round + 1) / kRounds);
      // Towards the number: edges scale with the root of the area that a face has.
      const double share = static_cast<double>(mesh_.faceCount()) / wanted_;
      if (round > 1) length_ *= std::clamp(std::sqrt(share), 0.8, 1.25);
    }
    meetCount();
    for (int round = 0; round < 3; ++round) {
      if (poll_.stoppedByNow()) return CancellationPoll::error();
      widenAngles(mesh_, kSmooth, poll_);
      relax();
    }
    widenAngles(mesh_, kSmooth, poll_);
    hints_.resize(mesh_.vertexCount(), kNoIndex);
    auto result = resultOf(mesh_, poll_, [&](Index v) { return placeOf(v); });
    if (result) progress(1);
    return result;
  }

 private:
  void progress(double fraction) const {
    if (context_.onProgress) context_.onProgress(fraction);
  }

  // --- Lines -------------------------------------------------------------------------------------

  /// Marks sharp edges that make lines long enough to be seen, and collects what vertices on lines
  /// are brought back to.
  void findLines() {
    std::vector<Index> sharp;
    for (const Halfedge h : original_.halfedges()) {
      const Halfedge twin = original_.twin(h);
      if (twin == kNoIndex || h > twin) continue;
      if (dot(faceNormals_[h / 3], faceNormals_[twin / 3]) < kSharp) sharp.push_back(h);
    }
    // Lines that hang together, by their vertices.
    std::vector<Index> group(original_.vertexCount());
    for (Index v = 0; v < group.size(); ++v) group[v] = v;
    const auto rootOf = [&](Index v) {
      while (group[v] != v) v = group[v] = group[group[v]];
      return v;
    };
    for (const Index h : sharp) {
      const Index a = rootOf(original_.from(Halfedge(h))), b = rootOf(original_.to(Halfedge(h)));
      group[std::max(a, b)] = std::min(a, b);
    }
    std::vector<double> lengthOf(group.size(), 0);
    for (const Index h : sharp)
      lengthOf[rootOf(original_.from(Halfedge(h)))] += original_.length(Halfedge(h));
    std::vector<std::array<Vec3, 3>> segments;
    const auto addSegment = [&](Index h) {
      const Vec3 &a = original_.position(original_.from(Halfedge(h))),
                 &b = original_.position(original_.to(Halfedge(h)));
      segments.push_back({a, b, b});
      halfedgeOfSegment_.push_back(h);
    };
    for (const Index h : sharp) {
      if (lengthOf[rootOf(original_.from(Halfedge(h)))] < kShortestLine * length_) continue;
      mesh_.setLine(h, true);
      addSegment(h);
    }
    for (const Halfedge h : original_.halfedges()) {
      if (original_.twin(h) == kNoIndex) addSegment(h);
    }
    lines_ = NearestSearch(std::move(segments));
    findCorners();
  }

  /// Where lines turn sharply, seen at the size of the new edges: zigzags smaller than that are
  /// none.
  void findCorners() {
    corner_.assign(mesh_.vertexCount(), 0);
    std::vector<Index> onLines;
    std::vector<double> turn(mesh_.vertexCount(), 1);  // its cosine
    for (Index v = 0; v < mesh_.vertexCount(); ++v) {
      const Index lines = mesh_.linesAt(v);
      if (lines == 2) onLines.push_back(v);
      if (lines == 1 || lines > 2) corner_[v] = 1;
    }
    for (const Index v : onLines) {
      const auto [one, two] = lineNeighbours(v);
      const Vec3 in = mesh_.position(v) - mesh_.position(walk(v, one, length_, [](Index) {}));
      const Vec3 out = mesh_.position(walk(v, two, length_, [](Index) {})) - mesh_.position(v);
      const double size = norm(in) * norm(out);
      turn[v] = size > 0 ? dot(in, out) / size : 1;
    }
    for (const Index v : onLines) {
      if (turn[v] >= kSharp) continue;
      bool sharpest = true;  // among those near
      const auto compare = [&](Index w) {
        if (turn[w] < turn[v] || (turn[w] == turn[v] && w < v)) sharpest = false;
      };
      const auto [one, two] = lineNeighbours(v);
      walk(v, one, length_ / 2, compare);
      walk(v, two, length_ / 2, compare);
      if (sharpest) corner_[v] = 1;
    }
  }

  /// The two neighbours along the line of a vertex on one.
  std::pair<Index, Index> lineNeighbours(Index vertex) const {
    std::pair<Index, Index> found{kNoIndex, kNoIndex};
    mesh_.forEachNeighbour(vertex, [&](Index v, bool line) {
      if (line) (found.first == kNoIndex ? found.first : found.second) = v;
    });
    return found;
  }

  /// Walks along a line from a vertex by way of a neighbour, until it has gone `distance` or the
  /// line ends, and returns where it is. Visits all vertices but the first.
  template <class Visit>
  Index walk(Index vertex, Index by, double distance, Visit&& visit) const {
    constexpr int kMostSteps = 1000;
    Index before = vertex, at = by;
    double gone = norm(mesh_.position(at) - mesh_.position(before));
    for (int step = 0; step < kMostSteps; ++step) {
      visit(at);
      if (gone >= distance || at == vertex || mesh_.linesAt(at) != 2) break;
      const auto [one, two] = lineNeighbours(at);
      const Index after = one == before ? two : one;
      gone += norm(mesh_.position(after) - mesh_.position(at));
      before = at;
      at = after;
    }
    return at;
  }

  /// The nearest point of the lines of a vertex's component.
  NearestSearch::Found nearestOnLines(const Vec3& place, Index vertex) const {
    return lines_.nearest(place, [&](Index segment) {
      return componentOf(original_, halfedgeOfSegment_[segment] / 3) == mesh_.component(vertex);
    });
  }

  /// 0: a vertex is free; 2: it may move along a line; otherwise it stays.
  Index linesAt(Index vertex) const {
    if (vertex < corner_.size() && corner_[vertex] != 0) return 3;
    return mesh_.linesAt(vertex);
  }

  // --- Split and collapse ------------------------------------------------------------------------

  void splitLongEdges() {
    const double longest = 4.0 / 3 * length_;
    // The longest first: thin faces come apart evenly.
    struct Entry {
      double length;
      Index halfedge;
      bool operator<(const Entry& other) const {
        return length != other.length ? length < other.length : halfedge > other.halfedge;
      }
    };
    std::priority_queue<Entry> queue;
    const auto push = [&](Index h) {
      const double length = mesh_.length(h);
      if (length > longest) queue.push({length, h});
    };
    for (Index h = 0; h < mesh_.halfedgeCount(); ++h) {
      if (mesh_.isFirstOfEdge(h)) push(h);
    }
    // Hair and spikes are long for their area: the size of the edges is mended after this round.
    const std::size_t most = 4 * std::size_t{wanted_} + original_.faceCount();
    while (!queue.empty() && mesh_.faceCount() < most && !poll_.stopped()) {
      const Entry entry = queue.top();
      queue.pop();
      if (mesh_.length(entry.halfedge) != entry.length) continue;  // halved meanwhile
      const auto place = splittingPoint(entry.halfedge);
      if (!place) continue;
      const Index m = mesh_.split(entry.halfedge, *place);
      // Also the sides of the faces around, some of which have new numbers.
      mesh_.forEachOutgoing(m, [&](Index h) {
        push(h);
        push(ChangingMesh::next(h));
        const Index back = ChangingMesh::previous(h);
        if (mesh_.twin(back) == kNoIndex) push(back);
      });
    }
  }

  void collapseShortEdges() {
    const double shortest = 4.0 / 5 * length_, longest = 4.0 / 3 * length_;
    for (Index h = 0; h < mesh_.halfedgeCount() && !poll_.stopped(); ++h) {
      if (mesh_.isFirstOfEdge(h) && mesh_.length(h) < shortest) tryCollapse(h, longest);
    }
  }

  /// Where the two ends of an edge may meet; nothing where a line would be lost.
  std::optional<Vec3> meetingPoint(Index h) const {
    const Index a = mesh_.from(h), b = mesh_.to(h);
    const Index linesA = linesAt(a), linesB = linesAt(b);
    if (linesA == 0 && linesB == 0) return 0.5 * (mesh_.position(a) + mesh_.position(b));
    if (linesA == 0) return mesh_.position(b);
    if (linesB == 0) return mesh_.position(a);
    if (!mesh_.isLine(h)) return std::nullopt;
    if (linesA != 2 && linesB != 2) return std::nullopt;
    if (linesA != 2) return mesh_.position(a);
    if (linesB != 2) return mesh_.position(b);
    return middleOf(h);
  }

  /// The middle of an edge; of a line, the point of the line there.
  Vec3 middleOf(Index h) const {
    const Vec3 middle = 0.5 * (mesh_.position(mesh_.from(h)) + mesh_.position(mesh_.to(h)));
    return mesh_.isLine(h) ? nearestOnLines(middle, mesh_.from(h)).position : middle;
  }

  /// The middle of an edge where its faces come apart into such as face alike; else the straight
  /// one: a line that bends back may come to lie on the other sides of the faces. Nothing where
  /// the edge has to stay whole: a half of the thinnest faces has no area.
  std::optional<Vec3> splittingPoint(Index h) const {
    if (!mesh_.canSplit(h)) return std::nullopt;
    const Vec3 middle = middleOf(h);
    const auto comesApart = [&](Index side) {
      const Vec3 before = mesh_.areaVector(side / 3), apex = mesh_.position(mesh_.apex(side));
      return facesAs(before, mesh_.position(mesh_.from(side)), middle, apex) &&
             facesAs(before, middle, mesh_.position(mesh_.to(side)), apex);
    };
    const Index twin = mesh_.twin(h);
    if (comesApart(h) && (twin == kNoIndex || comesApart(twin))) return middle;
    const Vec3 straight = 0.5 * (mesh_.position(mesh_.from(h)) + mesh_.position(mesh_.to(h)));
    const auto halvesHaveArea = [&](Index side) {
      const Vec3& apex = mesh_.position(mesh_.apex(side));
      return hasArea(mesh_.position(mesh_.from(side)), straight, apex) &&
             hasArea(straight, mesh_.position(mesh_.to(side)), apex);
    };
    if (halvesHaveArea(h) && (twin == kNoIndex || halvesHaveArea(twin))) return straight;
    return std::nullopt;
  }

  bool tryCollapse(Index h, double longest) {
    const auto place = meetingPoint(h);
    if (!place || !mesh_.canCollapse(h)) return false;
    const Index a = mesh_.from(h), b = mesh_.to(h);
    for (const auto& [moved, other] : {std::pair(a, b), std::pair(b, a)}) {
      bool fits = true;
      mesh_.forEachNeighbour(moved, [&](Index v, bool) {
        if (v != a && v != b && norm(mesh_.position(v) - *place) > longest) fits = false;
      });
      if (!fits || !keepsFacing(mesh_, moved, *place, other)) return false;
    }
    const Index left = mesh_.collapse(h, *place);
    const auto isCorner = [&](Index v) { return v < corner_.size() && corner_[v] != 0; };
    if (isCorner(a) || isCorner(b)) {
      corner_.resize(std::max<std::size_t>(corner_.size(), left + 1), 0);
      corner_[left] = 1;
    }
    hints_.resize(mesh_.vertexCount(), kNoIndex);
    hints_[left] = kNoIndex;
    return true;
  }

  // --- Flips -------------------------------------------------------------------------------------

  void equalizeValences() {
    const auto excess = [&](Index v, int change) {
      const int ideal = mesh_.isBoundary(v) ? 4 : 6;
      const int off = static_cast<int>(mesh_.valence(v)) + change - ideal;
      return off * off;
    };
    for (Index h = 0; h < mesh_.halfedgeCount() && !poll_.stopped(); ++h) {
      if (!mesh_.isFirstOfEdge(h) || mesh_.twin(h) == kNoIndex || !mesh_.canFlip(h)) continue;
      const Index a = mesh_.from(h), b = mesh_.to(h);
      const Index c = mesh_.apex(h), d = mesh_.apex(mesh_.twin(h));
      const int before = excess(a, 0) + excess(b, 0) + excess(c, 0) + excess(d, 0);
      const int after = excess(a, -1) + excess(b, -1) + excess(c, 1) + excess(d, 1);
      if (after < before && flipsSmoothly(mesh_, h, kSmooth)) mesh_.flip(h);
    }
  }

  // --- Moving ------------------------------------------------------------------------------------

  /// Moves every vertex towards the middle of its neighbours, along the surface.
  void relax() {
    hints_.resize(mesh_.vertexCount(), kNoIndex);
    for (Index v = 0; v < mesh_.vertexCount() && !poll_.stopped(); ++v) {
      if (!mesh_.isVertexAlive(v)) continue;
      const Index lines = linesAt(v);
      Vec3 place = mesh_.position(v);
      if (lines == 0) {
        Vec3 middle, normal;
        double weights = 0;
        mesh_.forEachOutgoing(v, [&](Index h) {
          const Vec3 area = mesh_.areaVector(h / 3);
          const double weight = norm(area);
          middle = middle + weight / 3 *
                                (mesh_.position(v) + mesh_.position(mesh_.to(h)) +
                                 mesh_.position(mesh_.apex(h)));
          normal = normal + area;
          weights += weight;
        });
        const double size = norm(normal);
        if (!(size > 0)) continue;
        normal = 1 / size * normal;
        const Vec3 step = 1 / weights * middle - place;
        place = onSurface(v, place + step - dot(step, normal) * normal, normal);
      } else if (lines == 2) {
        Vec3 middle;
        mesh_.forEachNeighbour(v, [&](Index w, bool line) {
          if (line) middle = middle + 0.5 * mesh_.position(w);
        });
        place = nearestOnLines(middle, v).position;
      }
      if (keepsFacing(mesh_, v, place, v)) mesh_.setPosition(v, place);
    }
  }

  /// The nearest point of the original that faces as the vertex does.
  Vec3 onSurface(Index v, const Vec3& place, const Vec3& normal) {
    const auto found = search_.nearest(
        place,
        [&](Index f) {
          return dot(faceNormals_[f], normal) > 0 &&
                 componentOf(original_, f) == mesh_.component(v);
        },
        hints_[v]);
    if (found.triangle == kNoIndex) return mesh_.position(v);
    hints_[v] = found.triangle;
    return found.position;
  }

  // --- The number of faces -----------------------------------------------------------------------

  void meetCount() {
    const double most = wanted_ * (1 + kCountTolerance), least = wanted_ * (1 - kCountTolerance);
    constexpr int kMostRounds = 20;
    for (int round = 0; round < kMostRounds && !poll_.stoppedByNow(); ++round) {
      if (mesh_.faceCount() > most) {
        if (!collapseShortest(static_cast<Index>(mesh_.faceCount() - wanted_) / 2 + 1)) return;
      } else if (mesh_.faceCount() < least) {
        splitLongest((wanted_ - mesh_.faceCount()) / 2 + 1);
      } else {
        return;
      }
      equalizeValences();
      relax();
    }
  }

  std::vector<std::pair<double, Index>> edgesByLength() const {
    std::vector<std::pair<double, Index>> edges;
    for (Index h = 0; h < mesh_.halfedgeCount(); ++h) {
      if (mesh_.isFirstOfEdge(h)) edges.emplace_back(mesh_.length(h), h);
    }
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  bool collapseShortest(Index count) {
    bool any = false;
    for (const auto& [length, h] : edgesByLength()) {
      if (count == 0) break;
      if (!mesh_.isAlive(h / 3) || mesh_.length(h) > 1.2 * length) continue;
      if (tryCollapse(h, 2 * length_)) {
        --count;
        any = true;
      }
    }
    return any;
  }

  void splitLongest(Index count) {
    const auto edges = edgesByLength();
    for (auto edge = edges.rbegin(); edge != edges.rend() && count > 0; ++edge) {
      const auto place = splittingPoint(edge->second);
      if (!place) continue;
      mesh_.split(edge->second, *place);
      --count;
    }
  }

  // --- The result --------------------------------------------------------------------------------

  SurfacePoint placeOf(Index v) const {
    const Vec3& p = mesh_.position(v);
    if (mesh_.linesAt(v) > 0 && !lines_.empty()) {
      const auto found = nearestOnLines(p, v);
      return SurfacePoint::onHalfedge(Halfedge(halfedgeOfSegment_[found.triangle]),
                                      1 - found.weights[0]);
    }
    const auto found = nearestFacing(original_, search_, faceNormals_, mesh_, v, hints_[v]);
    return SurfacePoint::inFace(Face(found.triangle), found.weights);
  }

  const SurfaceMesh& original_;
  Index wanted_;
  const ExecutionContext& context_;
  CancellationPoll poll_;
  ChangingMesh mesh_;
  NearestSearch search_, lines_;
  std::vector<Index> halfedgeOfSegment_;
  std::vector<Vec3> faceNormals_;
  std::vector<Index> hints_;          ///< the face of the original that each vertex was last on
  std::vector<std::uint8_t> corner_;  ///< vertices where lines turn, meet or end
  double length_;                     ///< the length that edges should have
};

}  // namespace

Result<RemeshedSurface> remeshEvenly(const SurfaceMesh& mesh, Index faces,
                                     const ExecutionContext& context) {
  return IsotropicRemesher(mesh, faces, context).run();
}

}  // namespace girth::remeshing
