// Random surfaces, each known by its seed: closed grids with random heights, blobs, handles, tubes,
// cones and boxes, with good and bad triangulations, some with holes.
#pragma once

#include <cstdint>
#include <string>

#include "girth/surface_point.h"
#include "shapes.h"

namespace girth::test {

struct RandomMesh {
  Shape shape;
  /// Without holes.
  bool closed{true};
  /// How it was made, for messages.
  std::string history;
};

/// Corners narrower than this, in radians, make needles, which rounded coordinates turn by as much
/// as the corners do.
constexpr double kNeedle = 1e-6;

/// The surface of this seed: connected, of some 20 to 200 vertices, without corners narrower than
/// `narrowest`.
RandomMesh randomMesh(std::uint64_t seed, double narrowest = kNeedle);

/// A surface with sides halved and faces divided at random; old vertices keep their numbers. The
/// new vertices lie no nearer to the ends of a side than `closest` times its length.
Shape divided(const Shape& shape, double closest, Index times, std::uint64_t seed);

/// Another shape in space of the same surface: cut along a random plane, and what lies beyond the
/// plane reflected by it. Old vertices keep their numbers; those on the cut are new.
Shape reflected(const Shape& shape, std::uint64_t seed);

/// A shape without vertices that no face uses; the others are numbered anew.
Shape withoutLoneVertices(const Shape& shape);

/// A shape from which random faces, or all faces round a vertex, are cut out here and there, as
/// long as it stays in one piece. Vertices are numbered anew.
Shape withHoles(const Shape& shape, Index cuts, std::uint64_t seed);

/// A surface with one more vertex, at a point of a face or of an edge: the last one.
Shape withVertexAt(const Shape& shape, const SurfacePoint& point);

/// Whether a surface, open edges being boundaries, can be made of it, without corners narrower than
/// `narrowest`.
bool isSurface(const Shape& shape, double narrowest = kNeedle);

}  // namespace girth::test
