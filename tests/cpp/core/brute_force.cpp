#include "brute_force.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace girth::test {

BruteForce::BruteForce(const SurfaceMesh& mesh, Index source, double longest, std::size_t limit)
    : mesh_(mesh),
      source_(source),
      longest_(longest),
      limit_(limit),
      conesOfFace_(mesh.faceCount()) {
  arrivals_.push_back({source, 0, 0, kNone, kNone});
  leave(0, 0, mesh.totalAngle(Vertex(source)));
  while (!todo_.empty() && complete_) {
    const std::size_t cone = todo_.back();
    todo_.pop_back();
    grow(cone);
  }
}

BruteForce::Point BruteForce::apex(Index h) const {
  // From the three lengths alone.
  const double c = mesh_.length(Halfedge(h)), a = mesh_.length(SurfaceMesh::next(Halfedge(h))),
               b = mesh_.length(SurfaceMesh::previous(Halfedge(h)));
  const double x = (b * b + c * c - a * a) / (2 * c);
  return {x, std::sqrt(b * b - x * x)};
}

double BruteForce::directionOf(Index halfedge) const {
  double angle = 0;
  Halfedge h = mesh_.outgoing(mesh_.from(Halfedge(halfedge)));
  for (; h != halfedge; h = mesh_.twin(SurfaceMesh::previous(h))) angle += mesh_.cornerAngle(h);
  return angle;
}

// All directions strictly between start and start + width: a cone for each corner, a path for each
// edge.
void BruteForce::leave(std::size_t arrival, double start, double width) {
  const Index v = arrivals_[arrival].vertex;
  const double sigma = arrivals_[arrival].length, total = mesh_.totalAngle(Vertex(v));
  const bool all = arrival == 0;
  Halfedge h = mesh_.outgoing(Vertex(v));
  double corner = 0;
  do {
    const double opening = mesh_.cornerAngle(h);
    for (int turn = -2; turn <= 2; ++turn) {
      const double from = start + turn * total - corner;
      if ((all || mesh_.isBoundary(Vertex(v))) && turn != 0) continue;
      if (all || (from < 0 && from + width > 0)) {
        const Halfedge twin = mesh_.twin(h);
        const double back = twin == kNoIndex ? mesh_.totalAngle(mesh_.to(h)) : directionOf(twin);
        arrive(mesh_.to(h), sigma + mesh_.length(h), back, kNone, arrival);
      }
      const Halfedge last = SurfaceMesh::previous(h);
      if (mesh_.twin(last) == kNoIndex &&
          (all || (from < opening && from + width > opening))) {  // the boundary on the far side
        arrive(mesh_.from(last), sigma + mesh_.length(last), 0, kNone, arrival);
      }
      const double low = all ? 0 : std::max(from, 0.0);
      const double high = all ? opening : std::min(from + width, opening);
      if (low >= high) continue;
      const Halfedge across = SurfaceMesh::next(h);
      if (mesh_.twin(across) == kNoIndex) continue;
      const Point root = apex(across);
      const double length = mesh_.length(across);
      // Rays from the corner, turned from the side of h, onto the x axis on which `across` lies.
      const auto hit = [&](double angle) {
        const double heading =
            std::atan2(-root.y, -root.x) + angle;  // towards the start of `across`
        return root.x - root.y * std::cos(heading) / std::sin(heading);
      };
      const double b0 = low <= 0 ? 0 : hit(low), b1 = high >= opening ? length : hit(high);
      cones_.push_back({mesh_.twin(across),
                        {length - root.x, -root.y},
                        sigma,
                        length - b1,
                        length - b0,
                        kNone,
                        arrival});
      todo_.push_back(cones_.size() - 1);
    }
    corner += opening;
    h = mesh_.twin(SurfaceMesh::previous(Halfedge(h)));
  } while (h != kNoIndex && h != mesh_.outgoing(Vertex(v)));
}

void BruteForce::arrive(Index vertex, double length, double direction, std::size_t cone,
                        std::size_t before) {
  if (length > longest_) return;
  arrivals_.push_back({vertex, length, direction, cone, before});
  const double total = mesh_.totalAngle(Vertex(vertex));
  if (!mesh_.isBoundary(Vertex(vertex))) {
    if (total > 2 * M_PI) leave(arrivals_.size() - 1, direction + M_PI, total - 2 * M_PI);
    return;
  }
  // Up to the boundaries and along them.
  const std::size_t number = arrivals_.size() - 1;
  if (direction + M_PI < total) leave(number, direction + M_PI, total - direction);
  if (direction - M_PI > 0) leave(number, -M_PI, direction);
}

void BruteForce::grow(std::size_t number) {
  if (cones_.size() > limit_) {
    complete_ = false;
    return;
  }
  const Cone cone = cones_[number];
  const double nearest = std::clamp(cone.root.x, cone.b0, cone.b1) - cone.root.x;
  if (cone.sigma + std::hypot(nearest, cone.root.y) > longest_) return;
  const Index h = cone.halfedge;
  conesOfFace_[SurfaceMesh::faceOf(Halfedge(h))].push_back(number);

  const Point o = apex(h);
  const double length = mesh_.length(Halfedge(h));
  // Where the line from the root to the apex crosses the halfedge decides who goes where.
  const double split = cone.root.x - cone.root.y * (o.x - cone.root.x) / (o.y - cone.root.y);
  if (split > cone.b0 && split < cone.b1) {
    const double back = std::atan2(-o.y, -o.x);  // from the apex to the start of h
    const double towards = std::atan2(cone.root.y - o.y, cone.root.x - o.x);
    arrive(mesh_.from(SurfaceMesh::previous(Halfedge(h))),
           cone.sigma + std::hypot(o.x - cone.root.x, o.y - cone.root.y),
           directionOf(SurfaceMesh::previous(Halfedge(h))) + (towards - back), number, kNone);
  }
  // Child through the side from A to B (in the plane of h), seen from outside: B is its start.
  const auto child = [&](Index side, Point start, double sideLength, Point end, double low,
                         double high) {
    if (mesh_.twin(Halfedge(side)) == kNoIndex) return;
    const Point u{(end.x - start.x) / sideLength, (end.y - start.y) / sideLength};
    const auto hit =
        [&](double x) {  // the ray over x on the halfedge, along the side from its start
          const double dx = x - cone.root.x, dy = -cone.root.y;
          return ((x - start.x) * dy - (0 - start.y) * dx) / (u.x * dy - u.y * dx);
        };
    const double rx = cone.root.x - start.x, ry = cone.root.y - start.y;
    const double t0 = std::clamp(hit(low), 0.0, sideLength),
                 t1 = std::clamp(hit(high), 0.0, sideLength);
    if (t1 <= t0) return;
    cones_.push_back({mesh_.twin(Halfedge(side)),
                      {rx * u.x + ry * u.y, u.x * ry - u.y * rx},
                      cone.sigma,
                      t0,
                      t1,
                      number,
                      kNone});
    todo_.push_back(cones_.size() - 1);
  };
  const Halfedge left = SurfaceMesh::previous(Halfedge(h)), right = SurfaceMesh::next(Halfedge(h));
  if (cone.b0 < split)
    child(left, {0, 0}, mesh_.length(left), o, cone.b0, std::min(cone.b1, split));
  if (cone.b1 > split) {
    child(right, o, mesh_.length(right), {length, 0}, std::max(cone.b0, split), cone.b1);
  }
}

double BruteForce::distanceTo(Index face, double x, double y) const {
  double best = std::numeric_limits<double>::infinity();
  // The point in the plane of each halfedge of the face, by turning from one to the next.
  Point q{x, y};
  for (Index k = 0; k < 3; ++k) {
    const Index h = 3 * face + k;
    for (const Arrival& arrival : arrivals_) {
      if (arrival.vertex == mesh_.from(Halfedge(h)))
        best = std::min(best, arrival.length + std::hypot(q.x, q.y));
    }
    for (const std::size_t i : conesOfFace_[face]) {
      const Cone& cone = cones_[i];
      if (cone.halfedge != h) continue;
      const double at = cone.root.x - cone.root.y * (q.x - cone.root.x) / (q.y - cone.root.y);
      const double slack = 1e-9 * mesh_.length(Halfedge(h));
      if (at < cone.b0 - slack || at > cone.b1 + slack) continue;
      best = std::min(best, cone.sigma + std::hypot(q.x - cone.root.x, q.y - cone.root.y));
    }
    q = inPlaneOfNext(h, q);
  }
  return best;
}

BruteForce::Point BruteForce::inPlaneOfNext(Index h, Point q) const {
  const Point o = apex(h);
  const double length = mesh_.length(Halfedge(h)),
               next = mesh_.length(SurfaceMesh::next(Halfedge(h)));
  const double ux = (o.x - length) / next, uy = o.y / next;
  return {(q.x - length) * ux + q.y * uy, ux * q.y - uy * (q.x - length)};
}

double BruteForce::distanceInPlaneOf(Index halfedge, Point q) const {
  for (; halfedge % 3 != 0; halfedge = SurfaceMesh::next(Halfedge(halfedge)))
    q = inPlaneOfNext(halfedge, q);
  return distanceTo(halfedge / 3, q.x, q.y);
}

double BruteForce::distanceTo(const SurfacePoint& point) const {
  if (point.kind == SurfacePoint::Kind::AtVertex) {
    double best = point.element == source_ ? 0 : std::numeric_limits<double>::infinity();
    for (const Arrival& arrival : arrivals_) {
      if (arrival.vertex == point.element) best = std::min(best, arrival.length);
    }
    return best;
  }
  const Index face = point.kind == SurfacePoint::Kind::InFace ? point.element : point.element / 3;
  std::array<double, 3> weights{};
  if (point.kind == SurfacePoint::Kind::InFace) {
    weights = point.weights;
  } else {
    weights[point.element % 3] = point.weights[0];
    weights[(point.element + 1) % 3] = point.weights[1];
  }
  const Point o = apex(3 * face);
  return distanceTo(face, weights[1] * mesh_.length(Halfedge(3 * face)) + weights[2] * o.x,
                    weights[2] * o.y);
}

// The surface distance of the point at a given length along a loop that returns to the source.
std::optional<double> BruteForce::distanceAlong(const Arrival& loop, double length) const {
  Arrival arrival = loop;
  for (;;) {
    if (arrival.cone == kNone) {  // along an edge from the vertex before
      const Arrival& before = arrivals_[arrival.before];
      if (length >= before.length) {
        Halfedge h = mesh_.outgoing(Vertex(before.vertex));
        double share = (length - before.length) / (arrival.length - before.length);
        while (mesh_.to(h) != arrival.vertex) {
          const Halfedge left = SurfaceMesh::previous(h);
          h = mesh_.twin(left);
          if (h != kNoIndex) continue;
          h = left;  // along the boundary on the far side
          share = 1 - share;
          break;
        }
        return distanceTo(SurfacePoint::onHalfedge(h, share));
      }
      arrival = before;
      continue;
    }
    // Backwards through the cones: the line from the root to `end` lies in the plane of each.
    std::size_t number = arrival.cone;
    Point end = apex(cones_[number].halfedge);
    for (;;) {
      const Cone& cone = cones_[number];
      const double dx = end.x - cone.root.x, dy = end.y - cone.root.y;
      const double crossing = cone.root.x - cone.root.y * dx / dy;
      const double atCrossing = cone.sigma + std::hypot(crossing - cone.root.x, cone.root.y);
      if (length >= atCrossing) {
        const double share = (length - cone.sigma) / std::hypot(dx, dy);
        return distanceInPlaneOf(cone.halfedge,
                                 {cone.root.x + share * dx, cone.root.y + share * dy});
      }
      if (cone.parent == kNone) {
        // The line starts at a vertex; in the face before the halfedge, nothing is in the way.
        const Arrival& start = arrivals_[cone.arrival];
        if (length < start.length) {
          arrival = start;
          break;
        }
        const Halfedge twin = mesh_.twin(Halfedge(cone.halfedge));
        const double share = (length - cone.sigma) / (atCrossing - cone.sigma);
        const double side = mesh_.length(twin);
        const Point from{side - cone.root.x, -cone.root.y}, to{side - crossing, 0};
        return distanceInPlaneOf(
            twin, {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
      }
      // The crossing in the plane of the parent: the apex side it lies on.
      const Cone& parent = cones_[cone.parent];
      const Halfedge twin = mesh_.twin(Halfedge(cone.halfedge));
      const double t = (mesh_.length(twin) - crossing) / mesh_.length(twin);
      const Point o = apex(parent.halfedge);
      const Point right{mesh_.length(Halfedge(parent.halfedge)), 0};
      const Point a = twin == SurfaceMesh::next(Halfedge(parent.halfedge)) ? right : o;
      const Point b = twin == SurfaceMesh::next(Halfedge(parent.halfedge)) ? o : Point{0, 0};
      end = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      number = cone.parent;
    }
  }
}

std::optional<double> BruteForce::shortestLoop() const {
  std::vector<const Arrival*> loops;
  for (const Arrival& arrival : arrivals_) {
    if (arrival.vertex == source_ && arrival.length > 0) loops.push_back(&arrival);
  }
  std::sort(loops.begin(), loops.end(),
            [](const Arrival* a, const Arrival* b) { return a->length < b->length; });
  for (const Arrival* loop : loops) {
    const auto distance = distanceAlong(*loop, loop->length / 2);
    if (distance && *distance >= loop->length / 2 * (1 - 1e-9)) return loop->length;
  }
  return std::nullopt;
}

}  // namespace girth::test
