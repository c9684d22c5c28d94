#include "loops/handles/homology.h"

#include <algorithm>
#include <cmath>

#include "girth/parallel.h"
#include "mesh/angles.h"
#include "mesh/sides.h"
#include "mesh/vector.h"

namespace girth::loops {
namespace {

/// Sums that are farther than this from a whole number are none.
constexpr double kWhole = 1e-3;

std::uint64_t directed(Index from, Index to) { return std::uint64_t{from} << 32 | to; }

/// The angle of (x, y) against the x axis, in (−π, π]; 0 for no vector.
double signedAngle(double x, double y) {
  if (x == 0 && y == 0) return 0;
  return y < 0 ? -angleOf(x, -y) : angleOf(x, y);
}

struct HalfAngle {
  double x, y;
};

/// Half the solid angle of a triangle as seen from the origin, as a direction (van Oosterom and
/// Strackee 1983).
HalfAngle halfSolidAngle(const Vec3& a, const Vec3& b, const Vec3& c, double lengthA,
                         double lengthB, double lengthC) {
  return {
      lengthA * lengthB * lengthC + dot(a, b) * lengthC + dot(b, c) * lengthA + dot(a, c) * lengthB,
      dot(a, cross(b, c))};
}

/// The part of Gauss's integral, 1/4π ∫∫ (p − q)·(dp × dq) / |p − q|³, of two segments: the solid
/// angle of the parallelogram of their differences. 0 for segments in one plane.
double gaussIntegral(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) {
  const Vec3 a = p0 - q0, b = p1 - q0, c = p1 - q1, d = p0 - q1;
  const double la = norm(a), lb = norm(b), lc = norm(c), ld = norm(d);
  const HalfAngle u = halfSolidAngle(a, b, c, la, lb, lc), v = halfSolidAngle(a, c, d, la, lc, ld);
  return -signedAngle(u.x * v.x - u.y * v.y, u.x * v.y + u.y * v.x) / (2 * kPi);
}

/// The halfedges on the ways of two nodes back to where they meet: of `b` from there on, of `a` up
/// to there.
template <class Parent>
void waysToMeeting(Index a, Index b, const std::vector<Index>& depth, const std::vector<Index>& to,
                   const Parent& parent, std::vector<Index>& ofA, std::vector<Index>& ofB) {
  while (a != b) {
    if (depth[a] >= depth[b]) {
      ofA.push_back(to[a]);
      a = parent(to[a]);
    } else {
      ofB.push_back(to[b]);
      b = parent(to[b]);
    }
  }
}

}  // namespace

ClosedSurface::ClosedSurface(const SurfaceMesh& mesh)
    : ownVertices(mesh.vertexCount()), ownFaces(mesh.faceCount()) {
  for (const Vertex v : mesh.vertices()) places.push_back(mesh.position(v));
  for (const Halfedge h : mesh.halfedges()) {
    from.push_back(mesh.from(h));
    twins.push_back(mesh.twin(h));
  }
  for (const Halfedge first : mesh.halfedges()) {
    if (twins[first] != kNoIndex) continue;
    const Index centre = vertexCount();
    const auto begin = static_cast<Index>(from.size());
    Vec3 sum;
    double corners = 0;
    Halfedge h = first;
    do {
      const auto side = static_cast<Index>(from.size());
      sum = sum + mesh.position(mesh.from(h));
      corners += 1;
      from.insert(from.end(), {mesh.to(h), mesh.from(h), centre});
      // Its second side is the third of the face before.
      twins.insert(twins.end(), {h, side - 1, side + 4});
      twins[h] = side;
      h = mesh.outgoing(mesh.to(h));
    } while (h != first);
    const auto end = static_cast<Index>(from.size());
    twins[begin + 1] = end - 1;
    twins[end - 1] = begin + 1;
    places.push_back((1 / corners) * sum);
  }
}

Homology::Homology(const SurfaceMesh& mesh, const ClosedSurface& closed, Index component)
    : closed_(&closed),
      toVertex_(closed.vertexCount(), kNoIndex),
      toFace_(closed.from.size() / 3, kNoIndex),
      vertexDepth_(closed.vertexCount(), kNoIndex),
      faceDepth_(closed.from.size() / 3, kNoIndex),
      inTree_(closed.from.size(), false) {
  Index root = 0;
  while (mesh.componentOf(Vertex(root)) != component) ++root;
  growEdgeTree(root);
  growFaceTree();
  for (const Index face : faces_) {
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      if (!inTree_[h] && h < closed.twins[h]) closing_.push_back(h);
    }
  }
  for (std::size_t k = 0; k < closing_.size(); ++k) {
    for (const Index h : crossingsOf(k)) {
      const Index a = closed.from[h], b = closed.from[nextSide(h)];
      crossed_[directed(a, b)].push_back({k, 1});
      crossed_[directed(b, a)].push_back({k, -1});
    }
  }
}

/// Breadth first along the surface's own edges; then the centres of the cones.
void Homology::growEdgeTree(Index root) {
  const ClosedSurface& closed = *closed_;
  std::vector<Index> outgoing(closed.vertexCount(), kNoIndex);
  for (Index h = 0; h < closed.from.size(); ++h) outgoing[closed.from[h]] = h;
  vertices_.push_back(root);
  vertexDepth_[root] = 0;
  const auto grow = [&](bool alongOwn) {
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const Index v = vertices_[i];
      Index h = outgoing[v];
      do {
        const Index to = closed.from[nextSide(h)];
        if (vertexDepth_[to] == kNoIndex && (!alongOwn || closed.isOwn(h))) {
          vertexDepth_[to] = vertexDepth_[v] + 1;
          toVertex_[to] = h;
          inTree_[h] = inTree_[closed.twins[h]] = true;
          vertices_.push_back(to);
        }
        h = closed.twins[previousSide(h)];
      } while (h != outgoing[v]);
    }
  };
  grow(true);
  grow(false);
}

/// Breadth first, where a cone is entered all over it at once: so no edge of a cone is left.
void Homology::growFaceTree() {
  const ClosedSurface& closed = *closed_;
  const auto reach = [&](Index halfedge) {
    const Index face = faceOfSide(closed.twins[halfedge]);
    if (inTree_[halfedge] || faceDepth_[face] != kNoIndex) return false;
    faceDepth_[face] = faceDepth_[faceOfSide(halfedge)] + 1;
    toFace_[face] = halfedge;
    inTree_[halfedge] = inTree_[closed.twins[halfedge]] = true;
    faces_.push_back(face);
    return true;
  };
  // Within a cone, from the face it is entered at.
  const auto fill = [&](Index entered) {
    std::vector<Index> pending{entered};
    while (!pending.empty()) {
      const Index face = pending.back();
      pending.pop_back();
      for (Index h = 3 * face; h < 3 * face + 3; ++h) {
        if (!closed.isOwn(h) && reach(h)) pending.push_back(faceOfSide(closed.twins[h]));
      }
    }
  };
  Index root = 0;
  while (vertexDepth_[closed.from[3 * root]] == kNoIndex) ++root;
  faceDepth_[root] = 0;
  faces_.push_back(root);
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    for (Index h = 3 * faces_[i]; h < 3 * faces_[i] + 3; ++h) {
      const Index next = faceOfSide(closed.twins[h]);
      if (reach(h) && next >= closed.ownFaces) fill(next);
    }
  }
}

std::vector<SurfacePoint> Homology::basisCurve(std::size_t k) const {
  const auto parent = [&](Index h) { return closed_->from[h]; };
  const Index start = closed_->from[closing_[k]], end = closed_->from[nextSide(closing_[k])];
  std::vector<SurfacePoint> points;
  for (Index v = start; v != vertices_[0]; v = parent(toVertex_[v])) {
    points.push_back(SurfacePoint::atVertex(Vertex(v)));
  }
  points.push_back(SurfacePoint::atVertex(Vertex(vertices_[0])));
  std::reverse(points.begin(), points.end());
  for (Index v = end; v != vertices_[0]; v = parent(toVertex_[v])) {
    points.push_back(SurfacePoint::atVertex(Vertex(v)));
  }
  points.push_back(points.front());
  return points;
}

std::vector<Index> Homology::edgesOf(std::size_t k) const {
  const Index closing = closing_[k];
  std::vector<Index> there, back;
  waysToMeeting(
      closed_->from[closing], closed_->from[nextSide(closing)], vertexDepth_, toVertex_,
      [&](Index h) { return closed_->from[h]; }, there, back);
  there.push_back(closing);
  for (const Index h : back) there.push_back(closed_->twins[h]);
  return there;
}

std::vector<Index> Homology::crossingsOf(std::size_t k) const {
  const Index closing = closing_[k];
  std::vector<Index> there, back;
  waysToMeeting(
      faceOfSide(closing), faceOfSide(closed_->twins[closing]), faceDepth_, toFace_,
      [](Index h) { return faceOfSide(h); }, there, back);
  there.push_back(closing);
  for (const Index h : back) there.push_back(closed_->twins[h]);
  return there;
}

/// The run between two vertices is moved to the chain of edges on its left.
HomologyClass Homology::classOf(const Unfolding& unfolding, const TautLoop& loop) const {
  HomologyClass result(rank(), 0);
  const auto along = [&](Index from, Index to) {
    const auto found =
        crossed_.find(directed(unfolding.vertexInMesh(from), unfolding.vertexInMesh(to)));
    if (found == crossed_.end()) return;
    for (const Share& share : found->second) result[share.curve] += share.sign;
  };
  for (std::size_t i = 0; i < loop.runs.size(); ++i) {
    const Run& run = loop.runs[i];
    // Without vertices the chain is closed: it starts on the left of the last edge.
    Index at = loop.vertices.empty() ? unfolding.crossing(run.back()).to() : loop.vertices[i];
    for (const Index h : run) {
      const Index left = unfolding.crossing(h).to();
      if (left != at) along(at, left);
      at = left;
    }
    if (loop.vertices.empty()) continue;
    along(at, loop.vertices[(i + 1) % loop.vertices.size()]);
  }
  return result;
}

Vec3 Homology::middleOfFace(Index face) const {
  const auto place = [&](Index k) { return closed_->places[closed_->from[3 * face + k]]; };
  return (1.0 / 3) * (place(0) + place(1) + place(2));
}

Vec3 Homology::areaVector(Index face) const {
  const auto place = [&](Index k) { return closed_->places[closed_->from[3 * face + k]]; };
  return cross(place(1) - place(0), place(2) - place(0));
}

/// Gauss's integral of an edge and a curve from the middle of a face across another edge into the
/// next face.
double Homology::linkOf(Index edge, Index crossing) const {
  const auto from = [&](Index h) { return closed_->places[closed_->from[h]]; };
  const Vec3 a = from(edge), b = from(nextSide(edge));
  const Vec3 before = middleOfFace(faceOfSide(crossing)),
             behind = middleOfFace(faceOfSide(closed_->twins[crossing])),
             between = 0.5 * (from(crossing) + from(nextSide(crossing)));
  return gaussIntegral(a, b, before, between) + gaussIntegral(a, b, between, behind);
}

/// Between the faces at an edge, on the side that their normals point to.
double Homology::outerAngle(Index halfedge) const {
  const Vec3 left = areaVector(faceOfSide(halfedge)),
             right = areaVector(faceOfSide(closed_->twins[halfedge]));
  Vec3 along =
      closed_->places[closed_->from[nextSide(halfedge)]] - closed_->places[closed_->from[halfedge]];
  along = (1 / norm(along)) * along;
  return kPi + signedAngle(dot(left, right), dot(along, cross(left, right)));
}

Result<std::optional<IntegerMatrix>> Homology::linking(const ExecutionContext& context) const {
  const ClosedSurface& closed = *closed_;
  // Each edge and each crossing once, whichever curves it belongs to; signs tell its direction.
  struct Uses {
    std::vector<Index> elements;
    std::unordered_map<Index, std::size_t> number;
    std::vector<std::vector<Share>> shares;

    void add(Index halfedge, Index twin, std::size_t curve) {
      const Index element = std::min(halfedge, twin);
      const auto [place, isNew] = number.try_emplace(element, elements.size());
      if (isNew) {
        elements.push_back(element);
        shares.emplace_back();
      }
      shares[place->second].push_back({curve, halfedge == element ? 1 : -1});
    }
  };
  Uses edges, crossings;
  for (std::size_t k = 0; k < rank(); ++k) {
    for (const Index h : edgesOf(k)) edges.add(h, closed.twins[h], k);
    for (const Index h : crossingsOf(k)) crossings.add(h, closed.twins[h], k);
  }
  std::vector<std::vector<double>> rows(edges.elements.size());
  const bool isDone = parallelFor(rows.size(), 1, {context.threads, context.cancel, {}},
                                  [&](std::size_t begin, std::size_t) {
                                    const Index edge = edges.elements[begin];
                                    std::vector<double>& row = rows[begin];
                                    row.assign(rank(), 0);
                                    for (std::size_t i = 0; i < crossings.elements.size(); ++i) {
                                      // Where a curve crosses the edge itself, it lies in the
                                      // planes of the edge: 0.
                                      if (crossings.elements[i] == edge) continue;
                                      const double link = linkOf(edge, crossings.elements[i]);
                                      for (const Share& share : crossings.shares[i])
                                        row[share.curve] += share.sign * link;
                                    }
                                  });
  if (!isDone || context.cancelled()) {
    return makeError(ErrorCode::Cancelled, -1, "the search for handles was cancelled");
  }
  std::vector<std::vector<double>> sums(rank(), std::vector<double>(rank(), 0));
  for (std::size_t e = 0; e < rows.size(); ++e) {
    for (const Share& share : edges.shares[e]) {
      for (std::size_t k = 0; k < rank(); ++k) sums[share.curve][k] += share.sign * rows[e][k];
    }
  }
  double volume = 0;
  for (const Index face : faces_) volume += dot(middleOfFace(face), areaVector(face));
  // Moved to the normals' side, a curve passes the edge that it crosses on that side: from the
  // plane of one face to that of the other it turns round it by the angle there. Moved to the other
  // side it crosses once less.
  IntegerMatrix matrix(rank(), HomologyClass(rank(), 0));
  for (std::size_t i = 0; i < rank(); ++i) {
    for (std::size_t k = 0; k < rank(); ++k) {
      const double sum = sums[i][k] + (i == k ? outerAngle(closing_[k]) / (2 * kPi) : 0);
      const double whole = std::round(sum);
      if (!(std::fabs(sum - whole) < kWhole)) return std::optional<IntegerMatrix>();
      matrix[i][k] = static_cast<std::int64_t>(whole);
    }
  }
  if (volume < 0) {
    for (std::size_t i = 0; i < rank(); ++i) {
      for (std::size_t k = 0; k < rank(); ++k) matrix[i][k] = (i == k ? 1 : 0) - matrix[i][k];
    }
  }
  std::int64_t trace = 0;
  for (std::size_t i = 0; i < rank(); ++i) trace += matrix[i][i];
  bool isProjection = 2 * static_cast<std::size_t>(std::max<std::int64_t>(trace, 0)) == rank();
  for (std::size_t i = 0; i < rank(); ++i) {
    isProjection = isProjection && product(matrix[i], matrix) == matrix[i];
  }
  return isProjection ? std::optional(std::move(matrix)) : std::optional<IntegerMatrix>();
}

HomologyClass product(const HomologyClass& row, const IntegerMatrix& matrix) {
  HomologyClass result(row.size(), 0);
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i] == 0) continue;
    for (std::size_t k = 0; k < row.size(); ++k) result[k] += row[i] * matrix[i][k];
  }
  return result;
}

}  // namespace girth::loops
