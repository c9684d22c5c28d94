#include "descriptors/facing_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mesh/angles.h"
#include "mesh/neighbours.h"
#include "mesh/vertex_normals.h"

namespace girth {

namespace {

constexpr double kOutOfReach = std::numeric_limits<double>::infinity();
/// The cosine of the angle by which normals differ across a crease: 30°.
constexpr double kCosCrease = 0.86602540378443865;
/// Up to this cosine the two faces at an edge are flat.
constexpr double kCosFlat = 1 - 1e-9;
/// Distances that are rounding, in shares of the lengths that they were computed from.
constexpr double kPlaneRounding = 1e-14;

/// Sines of angles that are rounding.
constexpr double kGrazing = 1e-9;

/// Bits of FacingSurface::spikes_: edge k, corner k.
constexpr std::uint8_t edgeBit(Index k) { return static_cast<std::uint8_t>(1u << k); }
constexpr std::uint8_t cornerBit(Index k) { return static_cast<std::uint8_t>(8u << k); }

Vec3 unit(const Vec3& v) {
  const double length = norm(v);
  return length > 0 ? (1 / length) * v : Vec3{};
}

Vec3 lower(const Vec3& a, const Vec3& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vec3 upper(const Vec3& a, const Vec3& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

/// How far a box reaches from a point in a direction.
double deepest(const NearestSearch::Box& box, const Vec3& p, const Vec3& direction) {
  const Vec3 low = box.low - p, high = box.high - p;
  return std::max(low.x * direction.x, high.x * direction.x) +
         std::max(low.y * direction.y, high.y * direction.y) +
         std::max(low.z * direction.z, high.z * direction.z);
}

/// The squared distance of two boxes.
double squaredGap(const Vec3& low, const Vec3& high, const NearestSearch::Box& box) {
  const auto gap = [](double from, double to, double otherFrom, double otherTo) {
    return std::max({0.0, otherFrom - to, from - otherTo});
  };
  const Vec3 off{gap(low.x, high.x, box.low.x, box.high.x),
                 gap(low.y, high.y, box.low.y, box.high.y),
                 gap(low.z, high.z, box.low.z, box.high.z)};
  return dot(off, off);
}

/// Which components are closed and enclose a volume, as bodies do; cavities enclose a negative one.
std::vector<bool> bodiesOf(const SurfaceMesh& mesh) {
  std::vector<double> volumes(mesh.componentCount(), 0);
  std::vector<Vec3> origins(mesh.componentCount());
  for (const Vertex v : mesh.vertices()) origins[mesh.componentOf(v)] = mesh.position(v);
  for (const Face f : mesh.faces()) {
    const auto [a, b, c] = mesh.faceVertices(f);
    const Index component = mesh.componentOf(a);
    const Vec3& origin = origins[component];
    volumes[component] +=
        dot(mesh.position(a) - origin, cross(mesh.position(b) - origin, mesh.position(c) - origin));
  }
  std::vector<bool> isBody;
  for (Index c = 0; c < mesh.componentCount(); ++c) {
    isBody.push_back(mesh.boundaryCount(c) == 0 && volumes[c] > 0);
  }
  return isBody;
}

bool haveEndInCommon(const SurfaceMesh& mesh, Halfedge a, Halfedge b) {
  return mesh.from(a) == mesh.from(b) || mesh.from(a) == mesh.to(b) || mesh.to(a) == mesh.from(b) ||
         mesh.to(a) == mesh.to(b);
}

/// The faces around a vertex, by their halfedges that start there, counter-clockwise.
std::vector<Halfedge> fanOf(const SurfaceMesh& mesh, Vertex vertex) {
  std::vector<Halfedge> fan;
  forEachEdge(mesh, vertex, [&](Halfedge h, Index) {
    if (mesh.from(h) == vertex) fan.push_back(h);
  });
  return fan;
}

}  // namespace

FacingSurface::FacingSurface(const SurfaceMesh& mesh, const ThicknessOptions& options)
    : mesh_(mesh),
      side_(options.side == ThicknessSide::Inside ? 1 : -1),
      cosSharp_(cosSin(options.sharpRadians).cos),
      normals_(normalsOfFaces(mesh)),
      spikes_(mesh.faceCount(), 0),
      isBody_(bodiesOf(mesh)),
      atSpike_(mesh.vertexCount(), false),
      tree_(searchOf(mesh)) {
  std::vector<bool> isSpikeVertex(mesh.vertexCount());
  for (const Vertex v : mesh.vertices()) isSpikeVertex[v] = isSpike(v);
  for (const Halfedge h : mesh.halfedges()) {
    const Face f = SurfaceMesh::faceOf(h);
    const Index k = h - 3 * f;
    if (mesh.twin(h) != Halfedge::none) {
      const double cosine = dot(normals_[f], normals_[SurfaceMesh::faceOf(mesh.twin(h))]);
      if (cosine < kCosCrease && bend(h) > 0) {
        spikes_[f] |= edgeBit(k);
        atSpike_[mesh.from(h)] = true;
      }
    }
    if (isSpikeVertex[mesh.from(h)]) {
      spikes_[f] |= cornerBit(k);
      atSpike_[mesh.from(h)] = true;
    }
  }
  directions_ = tree_.overBoxes<Directions>(
      [&](Index f) {
        return Directions{normals_[f], normals_[f], spikes_[f] != 0};
      },
      [](Directions& sum, const Directions& other) {
        sum = {lower(sum.low, other.low), upper(sum.high, other.high),
               sum.hasSpikes || other.hasSpikes};
      });
}

/// By how much the face across an edge rises above the plane of this one, towards the side that
/// balls do not lie on: above 0, the edge sticks into what is measured.
double FacingSurface::bend(Halfedge halfedge) const {
  const Halfedge twin = mesh_.twin(halfedge);
  const Vec3& opposite = mesh_.position(mesh_.from(SurfaceMesh::previous(twin)));
  return side_ * dot(normals_[SurfaceMesh::faceOf(halfedge)],
                     opposite - mesh_.position(mesh_.from(halfedge)));
}

/// Whether the surface goes down from a vertex on all sides, seen by balls, and steeply.
bool FacingSurface::isSpike(Vertex vertex) const {
  if (mesh_.isBoundary(vertex)) return false;
  Vec3 mean{};
  for (const Halfedge h : fanOf(mesh_, vertex)) {
    mean = mean + mesh_.cornerAngle(h) * normals_[SurfaceMesh::faceOf(h)];
  }
  mean = unit(mean);
  bool steep = false;
  for (const Halfedge h : fanOf(mesh_, vertex)) {
    const Vec3 edge = mesh_.position(mesh_.to(h)) - mesh_.position(vertex);
    if (side_ * dot(edge, mean) < 0) return false;
    steep |= dot(normals_[SurfaceMesh::faceOf(h)], mean) < kCosCrease;
  }
  return steep;
}

/// Whether the faces at an edge that sticks into the body both lead away from a ball that comes
/// along `inward`.
bool FacingSurface::edgeFaces(Halfedge halfedge, const Vec3& inward) const {
  const Vec3 edge = mesh_.position(mesh_.to(halfedge)) - mesh_.position(mesh_.from(halfedge));
  const double along = dot(edge, inward);
  if (along * along > (1 - cosSharp_ * cosSharp_) * dot(edge, edge)) return false;
  return recedes(halfedge, inward);
}

/// Whether neither of the faces at an edge leads against a direction.
bool FacingSurface::recedes(Halfedge halfedge, const Vec3& direction) const {
  const Vec3 edge = mesh_.position(mesh_.to(halfedge)) - mesh_.position(mesh_.from(halfedge));
  for (const Halfedge h : {halfedge, mesh_.twin(halfedge)}) {
    const Vec3 rest =
        mesh_.position(mesh_.from(SurfaceMesh::previous(h))) - mesh_.position(mesh_.from(h));
    const Vec3 across = rest - (dot(rest, edge) / dot(edge, edge)) * edge;
    if (dot(across, direction) < -kGrazing * norm(across)) return false;
  }
  return true;
}

/// Whether no edge at a vertex that sticks into the body leads against a ball that comes along
/// `inward`.
bool FacingSurface::vertexFaces(Vertex vertex, const Vec3& inward) const {
  bool all = true;
  forEachNeighbour(mesh_, vertex, [&](Index neighbour) {
    const Vec3 edge = mesh_.position(Vertex(neighbour)) - mesh_.position(vertex);
    if (dot(edge, inward) < -kGrazing * norm(edge)) all = false;
  });
  return all;
}

bool FacingSurface::mayFace(const Directions& directions, const Vec3& inward) const {
  if (directions.hasSpikes) return true;
  const Vec3 in = side_ * inward;
  const double most = std::max(directions.low.x * in.x, directions.high.x * in.x) +
                      std::max(directions.low.y * in.y, directions.high.y * in.y) +
                      std::max(directions.low.z * in.z, directions.high.z * in.z);
  return most >= cosSharp_ - 1e-12;
}

/// Calls `tryTarget(target, at)` for what of a face counts for balls along `inward`: all of it, or
/// its edges and corners that stick out. `at`: the vertices that the target has.
template <class Try>
void FacingSurface::forEachTarget(Face face, const Vec3& inward, Try&& tryTarget) const {
  const Vec3 normal = side_ * normals_[face];
  const auto& corners = tree_.triangle(face);
  if (dot(normal, inward) >= cosSharp_) {
    tryTarget(Target{corners, 3, normal});
    return;
  }
  if (spikes_[face] == 0) return;
  for (Index k = 0; k < 3; ++k) {
    const Halfedge h = SurfaceMesh::side(face, k);
    if ((spikes_[face] & edgeBit(k)) && edgeFaces(h, inward)) {
      tryTarget(Target{{corners[k], corners[(k + 1) % 3], corners[k]}, 2, {}});
    }
    if ((spikes_[face] & cornerBit(k)) && vertexFaces(mesh_.from(h), inward)) {
      tryTarget(Target{{corners[k], corners[k], corners[k]}, 1, {}});
    }
  }
}

/// Whether a face belongs to another body than a component, so that inside the one there is nothing
/// of the other.
bool FacingSurface::areApart(Face face, Index component) const {
  const Index other = mesh_.componentOf(mesh_.faceVertices(face)[0]);
  return side_ > 0 && other != component && isBody_[other] && isBody_[component];
}

/// Whether a face at a vertex goes on behind its tangent plane: a sharp edge or tip.
bool FacingSurface::isBehind(Face face, Vertex vertex, const Vec3& inward) const {
  for (const Vertex corner : mesh_.faceVertices(face)) {
    const Vec3 edge = mesh_.position(corner) - mesh_.position(vertex);
    if (corner != vertex && dot(edge, inward) > kGrazing * norm(edge)) return true;
  }
  return false;
}

/// The smallest ball at a point of a component, which may be one of its vertices, among those
/// smaller than `limit`.
TouchingBall FacingSurface::at(const Vec3& p, const Vec3& inward, Index component, Vertex vertex,
                               double limit) const {
  TouchingBall best;
  best.diameter = limit;
  const auto urgency = [&](Index node, const NearestSearch::Box& box) {
    if (!mayFace(directions_[node], inward) || !(deepest(box, p, inward) > 0)) return kOutOfReach;
    if (best.diameter < kOutOfReach) {
      const double radius = best.diameter / 2;
      if (box.squaredDistance(p + radius * inward) >= radius * radius) return kOutOfReach;
    }
    return box.squaredDistance(p);
  };
  const auto look = [&](Index f) {
    const double slope = side_ * dot(normals_[f], inward);
    if (slope >= cosSharp_) {
      // A ball that reaches the face's plane is no larger than one that reaches the face.
      const double distance = side_ * dot(tree_.triangle(f)[0] - p, normals_[f]);
      if (2 * distance >= (1 + slope) * best.diameter) return;
    } else if (spikes_[f] == 0) {
      return;
    }
    const Face face(f);
    if (areApart(face, component)) return;
    const auto [a, b, c] = mesh_.faceVertices(face);
    if (a == vertex || b == vertex || c == vertex) {
      if (slope >= cosSharp_ && isBehind(face, vertex, inward)) best = {0, p, p, face};
      return;
    }
    forEachTarget(face, inward, [&](const Target& target) {
      TouchingBall ball = ballAt(p, inward, target);
      ball.across = face;
      if (ball.diameter < best.diameter) best = ball;
    });
  };
  tree_.search(urgency, look);
  if (best.diameter < limit || limit == kOutOfReach) return best;
  return {};
}

/// The directions in which balls are laid at a vertex: into the body, one for each of the sides
/// between its creases.
std::vector<Vec3> FacingSurface::directionsAt(Vertex vertex) const {
  const std::vector<Halfedge> fan = fanOf(mesh_, vertex);
  const std::size_t count = fan.size();
  const auto normal = [&](std::size_t i) { return normals_[SurfaceMesh::faceOf(fan[i % count])]; };
  const bool open = mesh_.isBoundary(vertex);
  // The first face behind a crease, or behind the boundary.
  std::size_t first = 0;
  for (std::size_t i = 0; i < count && !open; ++i) {
    if (dot(normal(i + count - 1), normal(i)) < kCosCrease) {
      first = i;
      break;
    }
  }
  std::vector<Vec3> directions;
  for (std::size_t i = 0; i < count;) {
    // Nelson Max 1999: exact where the neighbours lie on a sphere.
    Vec3 sum{};
    const std::size_t begin = i;
    do {
      const Halfedge h = fan[(first + i) % count], back = SurfaceMesh::previous(h);
      const Vec3& at = mesh_.position(vertex);
      const double a = mesh_.length(h), b = mesh_.length(back), c = mesh_.length(fan[0]);
      const Vec3 u = (1 / a) * (mesh_.position(mesh_.to(h)) - at),
                 v = (1 / b) * (mesh_.position(mesh_.from(back)) - at);
      sum = sum + (c / a) * (c / b) * cross(u, v);
      ++i;
    } while (i < count && dot(normal(first + i - 1), normal(first + i)) >= kCosCrease);
    const Vec3 mean = unit(sum);
    bool even = true;
    for (std::size_t k = begin; k < i; ++k) even &= dot(normal(first + k), mean) >= kCosCrease;
    if (even) {
      directions.push_back((-side_) * mean);
      continue;
    }
    for (std::size_t k = begin; k < i; ++k) directions.push_back((-side_) * normal(first + k));
  }
  return directions;
}

/// At a vertex that sticks into the body a ball may come from many sides; the smallest comes
/// straight from the nearest point.
TouchingBall FacingSurface::straightFrom(Vertex vertex) const {
  TouchingBall best;
  const Vec3& p = mesh_.position(vertex);
  const auto isFree = [&](const Vec3& direction) {
    bool free = true;
    forEachNeighbour(mesh_, vertex, [&](Index neighbour) {
      const Vec3 edge = mesh_.position(Vertex(neighbour)) - p;
      free &= dot(edge, direction) <= kGrazing * norm(edge);
    });
    return free;
  };
  const auto urgency = [&](Index, const NearestSearch::Box& box) {
    const double squared = box.squaredDistance(p);
    return squared < best.diameter * best.diameter ? squared : kOutOfReach;
  };
  const auto look = [&](Index f) {
    const auto [a, b, c] = mesh_.faceVertices(Face(f));
    if (a == vertex || b == vertex || c == vertex) return;
    if (areApart(Face(f), mesh_.componentOf(vertex))) return;
    const Vec3 q = nearestInTriangle(p, tree_.triangle(f)).position;
    const double distance = norm(q - p);
    if (!(distance > 0 && distance < best.diameter)) return;
    const Vec3 direction = (1 / distance) * (q - p);
    if (!isFree(direction)) return;
    forEachTarget(Face(f), direction, [&](const Target& target) {
      TouchingBall ball = ballAt(p, direction, target);
      ball.across = Face(f);
      if (ball.diameter < best.diameter) best = ball;
    });
  };
  tree_.search(urgency, look);
  return best;
}

/// Tries balls between an edge that sticks into the body and others.
void FacingSurface::straightBetween(Halfedge edge, TouchingBall& best,
                                    const std::function<bool(const TouchingBall&)>& counts) const {
  const Vec3 p = mesh_.position(mesh_.from(edge)), u = mesh_.position(mesh_.to(edge)) - p;
  const Vec3 low = lower(p, p + u), high = upper(p, p + u);
  const auto urgency = [&](Index node, const NearestSearch::Box& box) {
    if (!directions_[node].hasSpikes) return kOutOfReach;
    const double squared = squaredGap(low, high, box);
    return squared < best.diameter * best.diameter ? squared : kOutOfReach;
  };
  const Index component = mesh_.componentOf(mesh_.from(edge));
  const auto look = [&](Index f) {
    if (areApart(Face(f), component)) return;
    for (Index k = 0; k < 3; ++k) {
      const Halfedge other = SurfaceMesh::side(Face(f), k);
      if (!(spikes_[f] & edgeBit(k)) || haveEndInCommon(mesh_, edge, other)) continue;
      const Vec3 q = mesh_.position(mesh_.from(other)), v = mesh_.position(mesh_.to(other)) - q;
      // Where the two lines are nearest; at the ends, vertices see to it.
      const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v);
      const double divisor = uu * vv - uv * uv;
      double s = (dot(q - p, u) * vv - dot(q - p, v) * uv) / divisor;
      double t = (dot(q - p, u) * uv - dot(q - p, v) * uu) / divisor;
      if (!(divisor > 1e-12 * uu * vv)) {
        // Parallel: in the middle of where they lie abreast.
        const double a = dot(q - p, u) / uu, b = dot(q + v - p, u) / uu;
        const double begin = std::max(0.0, std::min(a, b)), end = std::min(1.0, std::max(a, b));
        if (!(begin < end)) continue;
        s = (begin + end) / 2;
        t = dot(p + s * u - q, v) / vv;
      }
      if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) continue;
      const Vec3 from = p + s * u, to = q + t * v;
      const double distance = norm(to - from);
      if (!(distance > 0 && distance < best.diameter)) continue;
      const Vec3 direction = (1 / distance) * (to - from);
      const TouchingBall ball{distance, from, to, Face(f)};
      if (recedes(other, direction) && recedes(edge, -1 * direction) && (!counts || counts(ball))) {
        best = ball;
      }
    }
  };
  tree_.search(urgency, look);
}

TouchingBall FacingSurface::atVertex(Vertex vertex) const {
  TouchingBall best;
  if (atSpike_[vertex]) best = straightFrom(vertex);
  for (const Vec3& direction : directionsAt(vertex)) {
    const TouchingBall ball =
        at(mesh_.position(vertex), direction, mesh_.componentOf(vertex), vertex, kOutOfReach);
    if (ball.diameter < best.diameter) best = ball;
  }
  return best;
}

TouchingBall FacingSurface::atPoint(Face face, const Vec3& p, double limit) const {
  const Index component = mesh_.componentOf(mesh_.faceVertices(face)[0]);
  return at(p, inward(face), component, Vertex::none, limit);
}

FacingSurface::Bend FacingSurface::bendAt(Halfedge halfedge) const {
  const Face face = SurfaceMesh::faceOf(halfedge),
             other = SurfaceMesh::faceOf(mesh_.twin(halfedge));
  if (dot(normals_[face], normals_[other]) >= kCosCrease) return Bend::Smooth;
  return bend(halfedge) > 0 ? Bend::Inward : Bend::Outward;
}

/// Whether the surface is flat across the edges of a face, or ends there, or has creases.
bool FacingSurface::isExact(Face face) const {
  for (Index k = 0; k < 3; ++k) {
    const Halfedge twin = mesh_.twin(SurfaceMesh::side(face, k));
    if (twin == Halfedge::none) continue;
    const double cosine = dot(normals_[face], normals_[SurfaceMesh::faceOf(twin)]);
    if (cosine >= kCosCrease && cosine <= kCosFlat) return false;
  }
  return true;
}

/// The part of a face from which a target is seen from behind its normal; nothing where the target
/// is too far for balls smaller than `limit`.
std::optional<Base> FacingSurface::baseBefore(Face face, bool exact, const Vec3& inward,
                                              const Target& target, double limit) const {
  const auto& corners = tree_.triangle(face);
  Base base;
  base.inward = inward;
  base.exact = exact;
  if (target.count < 3) {
    std::copy(corners.begin(), corners.end(), base.corners.begin());
    return base;
  }
  std::array<double, 3> distances;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 to = target.corners[0] - corners[k];
    distances[k] = dot(to, target.normal);
    const double rounding = kPlaneRounding * norm(to);
    if (std::fabs(distances[k]) <= rounding) distances[k] = 0;
  }
  const auto [nearest, farthest] = std::minmax_element(distances.begin(), distances.end());
  if (!(*farthest > 0)) return std::nullopt;
  // A ball that reaches the target's plane is no larger.
  if (2 * *nearest >= (1 + dot(target.normal, inward)) * limit) return std::nullopt;
  base.count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (distances[k] >= 0) base.corners[base.count++] = corners[k];
    if (distances[k] * distances[next] < 0) {
      const double share = distances[k] / (distances[k] - distances[next]);
      base.corners[base.count++] = corners[k] + share * (corners[next] - corners[k]);
    }
  }
  return base;
}

/// Whether two faces that face each other have a corner in common: there they make a sharp edge or
/// tip.
bool FacingSurface::meetAtSharpVertex(Face face, Face other, Vec3& at) const {
  const auto corners = mesh_.faceVertices(face), others = mesh_.faceVertices(other);
  for (const Vertex v : corners) {
    if (std::find(others.begin(), others.end(), v) == others.end()) continue;
    if (!isBehind(other, v, inward(face)) || !isBehind(face, v, inward(other))) continue;
    at = mesh_.position(v);
    return true;
  }
  return false;
}

/// How far a face reaches from its middle: no farther than two thirds of a median, which is no
/// longer than the longest side.
double FacingSurface::reachOf(Face face) const {
  return 2.0 / 3 *
         std::max({mesh_.length(SurfaceMesh::side(face, 0)),
                   mesh_.length(SurfaceMesh::side(face, 1)),
                   mesh_.length(SurfaceMesh::side(face, 2))});
}

TouchingBall FacingSurface::inFace(Face face, double limit,
                                   const std::function<bool(const TouchingBall&)>& counts) const {
  TouchingBall best;
  best.diameter = limit;
  const auto& corners = tree_.triangle(face);
  const Vec3 in = inward(face);
  const Vec3 low = lower(lower(corners[0], corners[1]), corners[2]);
  const Vec3 high = upper(upper(corners[0], corners[1]), corners[2]);
  const Index component = mesh_.componentOf(mesh_.faceVertices(face)[0]);
  const bool exact = isExact(face);
  const Vec3 middle = (1.0 / 3) * (corners[0] + corners[1] + corners[2]);
  const double reach = reachOf(face);
  const auto urgency = [&](Index node, const NearestSearch::Box& box) {
    if (!mayFace(directions_[node], in) || !(deepest(box, corners[0], in) > 0)) return kOutOfReach;
    if (!exact) {
      // Only what lies straight ahead counts.
      const Vec3 to = 0.5 * (box.low + box.high) - middle;
      const double around = reach + 0.5 * norm(box.high - box.low);
      const Vec3 aside = to - dot(to, in) * in;
      if (dot(aside, aside) > around * around) return kOutOfReach;
    }
    // All balls of this diameter lie in this box.
    const double radius = best.diameter / 2;
    const Vec3 shift = std::isfinite(radius) ? radius * in : Vec3{};
    const double squared = squaredGap(low + shift, high + shift, box);
    return squared < radius * radius ? squared : kOutOfReach;
  };
  const auto look = [&](Index f) {
    const Face other(f);
    if (other == face) return;
    if (side_ * dot(normals_[other], in) < cosSharp_ && spikes_[other] == 0) return;
    // No ball reaches what lies behind the plane, or too far aside for its depth.
    const auto& q = tree_.triangle(other);
    const double depth = std::max(
        {dot(q[0] - corners[0], in), dot(q[1] - corners[0], in), dot(q[2] - corners[0], in)});
    if (!(depth > 0)) return;
    const Vec3 to = (1.0 / 3) * (q[0] + q[1] + q[2]) - middle;
    const double along = dot(to, in), off = dot(to, to) - along * along;
    const double around = reach + reachOf(other);
    if (off > around * around) {
      const double aside = std::sqrt(off) - around;
      if (aside * aside >= best.diameter * depth) return;
    }
    if (areApart(other, component)) return;
    forEachTarget(other, in, [&](const Target& target) {
      if (Vec3 at; target.count == 3 && meetAtSharpVertex(face, other, at)) {
        const TouchingBall ball{0, at, at, other};
        if (!counts || counts(ball)) best = ball;
        return;
      }
      const auto base = baseBefore(face, exact, in, target, best.diameter);
      if (!base) return;
      TouchingBall ball = ballBetween(*base, target);
      ball.across = other;
      if (ball.diameter < best.diameter && (!counts || counts(ball))) best = ball;
    });
  };
  tree_.search(urgency, look);
  for (Index k = 0; k < 3; ++k) {
    if (spikes_[face] & edgeBit(k)) straightBetween(SurfaceMesh::side(face, k), best, counts);
  }
  if (best.diameter < limit) return best;
  return {};
}

}  // namespace girth
