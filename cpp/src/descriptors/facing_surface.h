// The surface that faces a point through the body, or through the space around it, and how near it
// is.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "descriptors/touching_ball.h"
#include "girth/surface_mesh.h"
#include "girth/thickness.h"
#include "mesh/nearest_point.h"

namespace girth {

/// USAGE where an angle is out of range.
std::optional<Error> checkThicknessOptions(const ThicknessOptions& options);

/// Balls that touch a surface (web/docs/definitions.md, section 4, Definition 4.1). Immutable once
/// made: threads may share it.
class FacingSurface {
 public:
  /// The mesh must outlive it. O(n log n).
  FacingSurface(const SurfaceMesh& mesh, const ThicknessOptions& options);

  /// The smallest of the balls at a vertex; infinite where nothing faces it.
  TouchingBall atVertex(Vertex vertex) const;

  /// The smallest of the balls that touch within a face, among those smaller than `limit`; infinite
  /// where there is none. The smallest ball of each pair of faces is one of them; `counts(ball)`,
  /// where it is given, says which of them are to count.
  TouchingBall inFace(Face face, double limit,
                      const std::function<bool(const TouchingBall&)>& counts = {}) const;

  /// The ball at a point of a face, if it is smaller than `limit`; else infinite.
  TouchingBall atPoint(Face face, const Vec3& p, double limit) const;

  /// How the surface goes on across an edge, seen by balls.
  enum class Bend : std::uint8_t {
    Smooth,  ///< by at most 30°
    Inward,  ///< a crease that sticks into what is measured
    Outward  ///< a crease round what is measured
  };
  Bend bendAt(Halfedge halfedge) const;

 private:
  /// The directions of the normals below a box of the tree: each coordinate within an interval.
  struct Directions {
    Vec3 low, high;
    bool hasSpikes;
  };

  /// A unit vector into the body, or out of it.
  Vec3 inward(Face face) const { return (-side_) * normals_[face]; }
  std::vector<Vec3> directionsAt(Vertex vertex) const;
  TouchingBall at(const Vec3& p, const Vec3& inward, Index component, Vertex vertex,
                  double limit) const;
  bool mayFace(const Directions& directions, const Vec3& inward) const;
  TouchingBall straightFrom(Vertex vertex) const;
  void straightBetween(Halfedge edge, TouchingBall& best,
                       const std::function<bool(const TouchingBall&)>& counts) const;
  bool recedes(Halfedge halfedge, const Vec3& direction) const;
  bool areApart(Face face, Index component) const;
  bool isBehind(Face face, Vertex vertex, const Vec3& inward) const;
  double bend(Halfedge halfedge) const;
  bool isSpike(Vertex vertex) const;
  bool edgeFaces(Halfedge halfedge, const Vec3& inward) const;
  bool vertexFaces(Vertex vertex, const Vec3& inward) const;
  bool isExact(Face face) const;
  double reachOf(Face face) const;
  std::optional<Base> baseBefore(Face face, bool exact, const Vec3& inward, const Target& target,
                                 double limit) const;
  bool meetAtSharpVertex(Face face, Face other, Vec3& at) const;
  template <class Try>
  void forEachTarget(Face face, const Vec3& inward, Try&& tryTarget) const;

  const SurfaceMesh& mesh_;
  double side_;      // 1 inside, −1 outside
  double cosSharp_;  // cosine of the angle below which faces face each other
  std::vector<Vec3> normals_;
  // Edges and corners of each face that stick into the body (or out of it) sharply.
  std::vector<std::uint8_t> spikes_;
  std::vector<bool> isBody_;   // components: closed, round a volume of their own
  std::vector<bool> atSpike_;  // vertices: corners of such an edge, or such a corner
  NearestSearch tree_;
  std::vector<Directions> directions_;
};

}  // namespace girth
