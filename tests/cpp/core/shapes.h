// Shapes for tests, drawn by formula: closed, oriented, with any triangulation asked for.
#pragma once

#include <cstdint>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth::test {

/// Vertices and triangles on their way to a SurfaceMesh.
struct Shape {
  std::vector<double> positions;
  std::vector<Index> triangles;

  Index add(double x, double y, double z);
  void face(Index a, Index b, Index c);
  Index vertexCount() const { return static_cast<Index>(positions.size() / 3); }
  /// The surface; fails the test if there is none.
  SurfaceMesh mesh(OpenEdges openEdges = OpenEdges::Refuse) const;
};

/// Repeatable random numbers, the same on every platform.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ull + 1) {}
  /// In [0, 1).
  double operator()();
  /// In 0 … count − 1.
  Index below(Index count) { return static_cast<Index>((*this)() * count); }

 private:
  std::uint64_t state_;
};

/// A tube over a closed polygon in the xy plane (x, y pairs), from z = 0 to `height`, with `rings`
/// bands of rectangles, each cut in two, and flat caps round their centres. Vertex (ring, corner)
/// has the number ring × corners + corner.
Shape prism(const std::vector<double>& polygon, double height, Index rings);

/// A regular polygon with sides of length `side`, each divided into `parts`.
std::vector<double> regularPolygon(Index sides, double side, Index parts = 1);

/// A rod with `corners` sides in `rings` bands, bent to most of a circle: its ends face each other.
Shape bentRod(Index corners, Index rings);

/// A rod with bumps and dents, and round ends.
Shape bumpyRod(Index around, Index rings, double height);

/// A pyramid over a regular polygon: `sides` faces with the given angle at the apex and slant edge
/// of length 1, in `rings` bands. Vertex 0 is the apex; then come the rings, `sides` vertices each.
Shape pyramid(Index sides, double apexAngle, Index rings);

/// A box [0,a]×[0,b]×[0,c] with a grid of nx × ny × nz cells, each square cut in two.
Shape box(double a, double b, double c, Index nx, Index ny, Index nz);

/// A ring of `around` sections, each a polygon of `across` corners: a polyhedral torus of radii R
/// and r.
Shape torus(double R, double r, Index around, Index across);

/// An octahedron, 1-to-4 subdivided `levels` times, on the unit sphere.
Shape octasphere(Index levels);
/// An icosahedron likewise.
Shape icosphere(Index levels);

Shape tetrahedron();

/// Two plates of `across` × `across` cells joined along their rims and round `holes` × `holes`
/// square holes: genus holes².
Shape plate(Index holes);
/// A plate with holes in a rectangle.
Shape plate(Index holesAcross, Index holesAlong);

/// A surface with 1-to-4 subdivision; old vertices keep their numbers.
Shape subdivided(const Shape& shape);

/// A surface with another triangulation: flips edges between coplanar faces at random.
Shape retriangulated(const Shape& shape, std::uint64_t seed);

/// Vertices moved at random by up to `amount` times the mean edge length.
Shape perturbed(const Shape& shape, double amount, std::uint64_t seed);

/// A surface with vertices and faces renumbered at random. `newNumber[v]` is what became of
/// v.
Shape relabelled(const Shape& shape, std::uint64_t seed, std::vector<Index>& newNumber);

/// Each vertex p moved to s·R·p + t, R a rotation.
Shape moved(const Shape& shape, double scale, double angle, double shift);

/// Each vertex moved by (x, y, z).
Shape shifted(Shape shape, double x, double y, double z);

/// Two shapes as one: the vertices and faces of the second are numbered after the first's.
Shape together(Shape shape, const Shape& other);

}  // namespace girth::test
