#include "loops/cut/cavities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

#include "girth/level_curves.h"
#include "infinity.h"
#include "loops/tight/loop_shape.h"
#include "mesh/angles.h"
#include "mesh/face_shape.h"
#include "mesh/prepare/least_area.h"
#include "mesh/vector.h"

namespace girth::loops {
namespace {

/// Nearer to a plane than this share of the surface: on it.
constexpr double kOnPlane = 1e-9;

/// Limit for a cap with holes.
constexpr std::size_t kMostEdges = 1000;

struct Point2 {
  double x, y;
};

double turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// A plane with coordinates.
struct Plane {
  Vec3 centre, normal, u, v;

  Plane(const Vec3& at, const Vec3& across) : centre(at), normal(across) {
    const Vec3 any = std::fabs(across.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 along = cross(across, any);
    u = (1 / norm(along)) * along;
    v = cross(normal, u);
  }
  double height(const Vec3& p) const { return dot(p - centre, normal); }
  Point2 at(const Vec3& p) const { return {dot(p - centre, u), dot(p - centre, v)}; }
  std::vector<Point2> polygon(const std::vector<Vec3>& points) const {
    std::vector<Point2> all;
    for (const Vec3& p : points) all.push_back(at(p));
    return all;
  }
};

bool contains(const std::vector<Point2>& polygon, const Point2& p) {
  bool isInside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point2 &a = polygon[i], &b = polygon[j];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) isInside = !isInside;
  }
  return isInside;
}

/// A component by its place and volume.
struct Body {
  Vertex first{Vertex::none};
  Vec3 low, high;
  double volume{0};
  std::vector<Face> faces;
};

std::vector<Body> bodiesIn(const SurfaceMesh& mesh) {
  std::vector<Body> bodies(mesh.componentCount());
  for (const Vertex v : mesh.vertices()) {
    Body& body = bodies[mesh.componentOf(v)];
    const Vec3& p = mesh.position(v);
    if (body.first == Vertex::none) body = {v, p, p, 0, {}};
    body.low = {std::min(body.low.x, p.x), std::min(body.low.y, p.y), std::min(body.low.z, p.z)};
    body.high = {std::max(body.high.x, p.x), std::max(body.high.y, p.y),
                 std::max(body.high.z, p.z)};
  }
  for (const Face f : mesh.faces()) {
    const auto [a, b, c] = mesh.faceVertices(f);
    Body& body = bodies[mesh.componentOf(a)];
    const Vec3& o = mesh.position(body.first);
    body.volume += dot(mesh.position(a) - o, cross(mesh.position(b) - o, mesh.position(c) - o)) / 6;
    body.faces.push_back(f);
  }
  return bodies;
}

bool boxEncloses(const Body& outer, const Body& inner) {
  return outer.low.x < inner.low.x && outer.low.y < inner.low.y && outer.low.z < inner.low.z &&
         outer.high.x > inner.high.x && outer.high.y > inner.high.y && outer.high.z > inner.high.z;
}

/// By the solid angle of all faces, seen from a point of the inner one.
bool encloses(const SurfaceMesh& mesh, const Body& outer, const Body& inner) {
  const Vec3& from = mesh.position(inner.first);
  double angle = 0;
  for (const Face f : outer.faces) {
    const auto corners = mesh.faceVertices(f);
    const Vec3 p = mesh.position(corners[0]) - from, q = mesh.position(corners[1]) - from,
               r = mesh.position(corners[2]) - from;
    const double lp = norm(p), lq = norm(q), lr = norm(r);
    angle += 2 * std::atan2(dot(p, cross(q, r)),
                            lp * lq * lr + dot(p, q) * lr + dot(q, r) * lp + dot(r, p) * lq);
  }
  return std::fabs(angle) > 2 * kPi;
}

Index componentAt(const SurfaceMesh& mesh, const SurfacePoint& point) {
  const Vertex v = point.kind == SurfacePoint::Kind::AtVertex ? point.vertex()
                   : point.kind == SurfacePoint::Kind::OnEdge ? mesh.from(point.halfedge())
                                                              : mesh.faceVertices(point.face())[0];
  return mesh.componentOf(v);
}

/// A curve with what it measures.
struct Measured {
  Index component;
  std::vector<Vec3> places;
  LoopShape shape;
};

std::optional<Measured> measured(const SurfaceMesh& mesh, const SurfaceCurve& curve) {
  if (curve.size() < 4) return std::nullopt;
  Measured result{componentAt(mesh, curve.front()), placesOf(mesh, curve), {}};
  if (norm(result.places.front() - result.places.back()) > 0) return std::nullopt;
  result.shape = shapeOf(result.places);
  if (!(norm(result.shape.normal) > 0.5)) return std::nullopt;
  return result;
}

/// Makes the caps, one given curve after the other.
class CapMaker {
 public:
  CapMaker(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves)
      : mesh_(mesh), bodies_(bodiesOf(mesh)), made_{{curves.begin(), curves.end()}, {}} {
    for (const SurfaceCurve& curve : curves) given_.push_back(measured(mesh, curve));
    isUsed_.resize(given_.size(), false);
  }

  HollowCurves run() {
    // First those on bodies, so that those on their cavities find theirs.
    for (const bool isOnCavity : {false, true}) {
      for (std::size_t i = 0; i < given_.size(); ++i) {
        if (!given_[i] || isUsed_[i]) continue;
        const Index body = bodies_[given_[i]->component];
        if ((body != given_[i]->component) == isOnCavity) make(i, body);
      }
    }
    return std::move(made_);
  }

 private:
  struct Section {
    std::size_t curve;
    Index component;
    std::vector<Point2> polygon;
  };

  void make(std::size_t number, Index body) {
    const Measured& given = *given_[number];
    const Plane plane(given.shape.centre, given.shape.normal);
    std::vector<Index> cavities;
    for (Index component = 0; component < bodies_.size(); ++component) {
      if (component != body && bodies_[component] == body) cavities.push_back(component);
    }
    if (cavities.empty()) return;
    const std::size_t before = made_.curves.size();
    std::vector<Section> sections = sectionsBy(plane, body, cavities, number);
    const std::vector<Point2> own = plane.polygon(given.places);
    // The rim: the given curve, or the one on the body round it.
    const Section* rim = nullptr;
    double least = kInfinity;
    for (const Section& section : sections) {
      if (section.component != body) continue;
      if (given.component == body) {
        if (section.curve == number) rim = &section;
      } else if (contains(section.polygon, own.front()) && areaOf(section.polygon) < least) {
        least = areaOf(section.polygon);
        rim = &section;
      }
    }
    HollowCap cap{0, {}, given.shape.normal};
    std::vector<bool> isKept(made_.curves.size(), false);
    if (rim != nullptr) {
      cap.rim = rim->curve;
      for (const Section& section : sections) {
        if (section.component == body || !contains(rim->polygon, section.polygon.front())) continue;
        cap.holes.push_back(section.curve);
      }
    }
    if (rim == nullptr || cap.holes.empty()) {
      made_.curves.resize(before);
      return;
    }
    for (std::size_t curve : cap.holes) keep(curve, before, isKept);
    keep(cap.rim, before, isKept);
    // Curves that are not cut along are left out.
    std::vector<std::size_t> place(made_.curves.size());
    std::size_t count = before;
    for (std::size_t i = 0; i < made_.curves.size(); ++i) {
      place[i] = i < before ? i : count;
      if (i < before || !isKept[i]) continue;
      if (count != i) made_.curves[count] = std::move(made_.curves[i]);
      ++count;
    }
    made_.curves.resize(count);
    cap.rim = place[cap.rim];
    for (std::size_t& curve : cap.holes) curve = place[curve];
    made_.caps.push_back(std::move(cap));
  }

  void keep(std::size_t curve, std::size_t before, std::vector<bool>& isKept) {
    if (curve < before) {
      if (curve < isUsed_.size()) isUsed_[curve] = true;
    } else {
      isKept[curve] = true;
    }
  }

  static double areaOf(const std::vector<Point2>& polygon) {
    double twice = 0;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
      twice += polygon[j].x * polygon[i].y - polygon[i].x * polygon[j].y;
    }
    return std::fabs(twice) / 2;
  }

  /// The curves that a plane cuts out of a body and its cavities, which are added to the curves; or
  /// the given curves that run round the same place.
  std::vector<Section> sectionsBy(const Plane& plane, Index body,
                                  const std::vector<Index>& cavities, std::size_t number) {
    double extent = 0;
    std::vector<double> heights;
    for (const Vertex v : mesh_.vertices()) {
      heights.push_back(plane.height(mesh_.position(v)));
      extent = std::max(extent, norm(mesh_.position(v) - plane.centre));
    }
    for (double& height : heights) {
      if (std::fabs(height) <= kOnPlane * extent) height = 0;
    }
    std::vector<Section> sections;
    const auto cut = levelCurves(mesh_, heights, 0);
    if (!cut) return sections;
    const auto isOfThese = [&](Index component) {
      return component == body ||
             std::find(cavities.begin(), cavities.end(), component) != cavities.end();
    };
    const std::vector<Point2> own = plane.polygon(given_[number]->places);
    sections.push_back({number, given_[number]->component, own});
    for (const SurfaceCurve& curve : cut.value()) {
      const auto one = measured(mesh_, curve);
      if (!one || !isOfThese(one->component)) continue;
      std::vector<Point2> polygon = plane.polygon(one->places);
      if (one->component == given_[number]->component && isBeside(*one, *given_[number])) continue;
      const auto same = samePlace(*one, number);
      if (same) {
        sections.push_back({*same, one->component, plane.polygon(given_[*same]->places)});
      } else {
        sections.push_back({made_.curves.size(), one->component, std::move(polygon)});
        made_.curves.push_back(curve);
      }
    }
    return sections;
  }

  /// Whether two curves run round one place: the middle of one lies nearer to the other's than they
  /// are thick.
  static bool isBeside(const Measured& a, const Measured& b) {
    return norm(a.shape.centre - b.shape.centre) < std::min(a.shape.radius, b.shape.radius) &&
           std::fabs(dot(a.shape.normal, b.shape.normal)) > 0.7;
  }

  std::optional<std::size_t> samePlace(const Measured& section, std::size_t number) const {
    for (std::size_t i = 0; i < given_.size(); ++i) {
      if (i == number || isUsed_[i] || !given_[i] || given_[i]->component != section.component)
        continue;
      if (isBeside(section, *given_[i])) return i;
    }
    return std::nullopt;
  }

  const SurfaceMesh& mesh_;
  std::vector<Index> bodies_;  // by component
  HollowCurves made_;
  std::vector<std::optional<Measured>> given_;
  std::vector<bool> isUsed_;
};

}  // namespace

std::vector<Index> bodiesOf(const SurfaceMesh& mesh) {
  const std::vector<Body> all = bodiesIn(mesh);
  std::vector<Index> bodyOf(all.size());
  std::iota(bodyOf.begin(), bodyOf.end(), Index{0});
  std::vector<Index> order;
  for (const Index component : bodyOf) {
    if (mesh.boundaryCount(component) == 0) order.push_back(component);
  }
  const auto isInward = [&](Index component) { return all[component].volume < 0; };
  if (std::all_of(order.begin(), order.end(), isInward) ||
      std::none_of(order.begin(), order.end(), isInward)) {
    return bodyOf;
  }
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return std::pair(all[a].low.x, a) < std::pair(all[b].low.x, b);
  });
  // Bodies whose boxes reach as far along x, the smallest first.
  std::vector<Index> open;
  for (const Index inner : order) {
    std::erase_if(open, [&](Index o) { return !(all[o].high.x > all[inner].low.x); });
    for (const Index outer : open) {
      if (!boxEncloses(all[outer], all[inner]) || !encloses(mesh, all[outer], all[inner])) continue;
      if (all[outer].volume * all[inner].volume < 0) bodyOf[inner] = outer;
      break;
    }
    const auto isSmaller = [&](Index a, Index b) {
      return std::fabs(all[a].volume) < std::fabs(all[b].volume);
    };
    open.insert(std::upper_bound(open.begin(), open.end(), inner, isSmaller), inner);
  }
  return bodyOf;
}

HollowCurves throughCavities(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves) {
  if (mesh.componentCount() < 2) return {{curves.begin(), curves.end()}, {}};
  return CapMaker(mesh, curves).run();
}

std::vector<Index> triangulatedCap(std::vector<Index> rim, std::vector<std::vector<Index>> holes,
                                   const Vec3& normal, std::span<const Vec3> places,
                                   const std::function<bool(Index, Index)>& isJoined) {
  const Plane plane({}, normal);
  const auto at = [&](Index vertex) { return plane.at(places[vertex]); };
  std::size_t edges = rim.size();
  for (const std::vector<Index>& hole : holes) edges += hole.size();
  if (edges > kMostEdges) return {};
  // The rim and all holes as one polygon, along bridges that cross nothing.
  std::vector<Index> polygon = std::move(rim);
  std::vector<std::pair<Index, Index>> bridges;
  const auto crosses = [&](const std::vector<Index>& curve, Index a, Index b) {
    const Point2 p = at(a), q = at(b);
    for (std::size_t i = 0, j = curve.size() - 1; i < curve.size(); j = i++) {
      if (curve[i] == a || curve[i] == b || curve[j] == a || curve[j] == b) continue;
      const Point2 r = at(curve[i]), s = at(curve[j]);
      if (turn(p, q, r) * turn(p, q, s) <= 0 && turn(r, s, p) * turn(r, s, q) <= 0) return true;
    }
    return false;
  };
  while (!holes.empty()) {
    std::vector<std::tuple<double, std::size_t, std::size_t, std::size_t>> ways;
    for (std::size_t h = 0; h < holes.size(); ++h) {
      for (std::size_t k = 0; k < holes[h].size(); ++k) {
        for (std::size_t i = 0; i < polygon.size(); ++i) {
          ways.emplace_back(norm(places[holes[h][k]] - places[polygon[i]]), h, k, i);
        }
      }
    }
    std::sort(ways.begin(), ways.end());
    const auto way = std::find_if(ways.begin(), ways.end(), [&](const auto& one) {
      const auto& [length, h, k, i] = one;
      const Index a = polygon[i], b = holes[h][k];
      return !crosses(polygon, a, b) &&
             std::none_of(holes.begin(), holes.end(),
                          [&](const std::vector<Index>& hole) { return crosses(hole, a, b); });
    });
    if (way == ways.end()) return {};
    const auto [length, h, k, i] = *way;
    std::vector<Index>& hole = holes[h];
    std::rotate(hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(k), hole.end());
    hole.push_back(hole.front());
    hole.push_back(polygon[i]);
    bridges.emplace_back(polygon[i], hole.front());
    polygon.insert(polygon.begin() + static_cast<std::ptrdiff_t>(i) + 1, hole.begin(), hole.end());
    holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(h));
  }
  double extent = 0;
  for (const Index vertex : polygon) {
    const Vec3& p = places[vertex];
    extent = std::max({extent, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  std::vector<Vec3> scaled;
  for (const Index vertex : polygon) scaled.push_back(scaleFor(extent) * places[vertex]);
  const auto found = prepare::leastAreaTriangulation(scaled, [&](std::size_t i, std::size_t j) {
    const Index a = polygon[i], b = polygon[j];
    const auto isBridge = [&](const auto& bridge) {
      return bridge == std::pair{a, b} || bridge == std::pair{b, a};
    };
    return a != b && !isJoined(a, b) && std::none_of(bridges.begin(), bridges.end(), isBridge);
  });
  std::vector<Index> triangles;
  if (!found) return triangles;
  for (const auto& corners : found->triangles) {
    for (const std::size_t corner : corners) triangles.push_back(polygon[corner]);
  }
  return triangles;
}

}  // namespace girth::loops
