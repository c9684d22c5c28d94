// Pieces of curves drawn tight: how straight runs leave and pass vertices, and the shortest way
// through a run.
//
// The nodes of a curve are the vertices that it passes, and its ends, which may lie on edges and in
// faces too. Numbers are those of the unfolding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "girth/surface_point.h"
#include "loops/tight/strip.h"

namespace girth::loops {

enum class Side : std::uint8_t { Left, Right };

inline SurfacePoint vertexNode(Index vertex) { return SurfacePoint::atVertex(Vertex(vertex)); }

/// A direction in which a run leaves a vertex.
struct Departure {
  /// The number of an edge among the vertex's, counter-clockwise: the one that it follows, or the
  /// one on the right of the face that it leaves through.
  std::size_t edge{0};
  bool alongEdge{false};
  /// As Unfolding::direction.
  double direction{0};
};

/// A curve at one of its vertices.
struct Passage {
  Departure in, out;
  /// The angles on both sides; infinite beyond the boundary.
  double left{0}, right{0};
};

/// The passage of a vertex: from a node over a straight run, and over another one to a node.
Passage passageOf(const Unfolding& unfolding, const SurfacePoint& before, const Run& in,
                  Index vertex, const Run& out, const SurfacePoint& after);

/// The edges that a curve crosses that passes a vertex on one side instead. The side lies within
/// the surface.
Run around(const Unfolding& unfolding, Index vertex, const Passage& passage, Side side);

/// The shortest way through a run from node to node: appends the vertices between that it passes,
/// and the runs before, between and behind them.
void pull(const Unfolding& unfolding, const SurfacePoint& from, Run run, const SurfacePoint& to,
          std::vector<Index>& vertices, std::vector<Run>& runs);

/// Where a straight run from node to node begins and ends, in the plane of its strip.
Vec2 startIn(const Unfolding& unfolding, const Strip& strip, const Run& run,
             const SurfacePoint& from);
Vec2 endIn(const Unfolding& unfolding, const Strip& strip, const Run& run, const SurfacePoint& to);

/// The length of a straight run, in the units of the unfolding.
double lengthOfRun(const Unfolding& unfolding, const SurfacePoint& from, const Run& run,
                   const SurfacePoint& to);

/// Appends the points of the mesh at which a straight run crosses its edges.
void appendCrossings(const Unfolding& unfolding, const SurfacePoint& from, const Run& run,
                     const SurfacePoint& to, std::vector<SurfacePoint>& points);

/// The point of the mesh at a share of a halfedge.
SurfacePoint edgePoint(const Unfolding& unfolding, Index halfedge, double share);

}  // namespace girth::loops
