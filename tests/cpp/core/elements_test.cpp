// Vertices, faces and halfedges: they index arrays, and what takes one for another does not
// compile.
#include "girth/elements.h"

#include <gtest/gtest.h>

#include <concepts>
#include <vector>

#include "girth/girth_solver.h"
#include "girth/study/surface_changes.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"
#include "shapes.h"

namespace girth::test {
namespace {

template <class A, class B>
concept Compared = requires(A a, B b) {
  a == b;
};
template <class A, class B>
concept Ordered = requires(A a, B b) {
  a < b;
};
template <class T>
concept HasPosition = requires(const SurfaceMesh& mesh, T t) {
  mesh.position(t);
};
template <class T>
concept HasTwin = requires(const SurfaceMesh& mesh, T t) {
  mesh.twin(t);
};
template <class T>
concept HasArea = requires(const SurfaceMesh& mesh, T t) {
  mesh.area(t);
};
template <class T>
concept HasGirth = requires(GirthSolver& solver, T t) {
  solver.value(t);
};
template <class T>
concept IsPlace = requires(T t) {
  SurfacePoint::atVertex(t);
};
template <class T>
concept Bridged = requires(const SurfaceMesh& mesh, T t) {
  study::withBridge(mesh, t, t);
};
template <class T>
concept Indexes = requires(const std::vector<double>& values, T t) {
  values[t];
};

// A number becomes an element by name only, and never the element of another kind.
static_assert(std::constructible_from<Vertex, Index>);
static_assert(!std::convertible_to<Index, Vertex>);
static_assert(!std::constructible_from<Vertex, Face>);
static_assert(!std::constructible_from<Face, Halfedge>);
static_assert(!std::constructible_from<Halfedge, Vertex>);
static_assert(!std::is_assignable_v<Vertex&, Face>);
static_assert(!std::is_assignable_v<Vertex&, Index>);

// An element is a number where one is wanted.
static_assert(std::convertible_to<Vertex, Index>);
static_assert(Indexes<Vertex> && Indexes<Face> && Indexes<Halfedge>);

// Elements of one kind are compared, those of different kinds are not.
static_assert(Compared<Vertex, Vertex> && Ordered<Face, Face> && Compared<Vertex, Index>);
static_assert(!Compared<Vertex, Face> && !Compared<Halfedge, Vertex> && !Compared<Face, Halfedge>);
static_assert(!Ordered<Vertex, Face> && !Ordered<Halfedge, Face>);

// Each function takes the kind of element that it is about.
static_assert(HasPosition<Vertex> && !HasPosition<Face> && !HasPosition<Halfedge>);
static_assert(!HasPosition<Index>);
static_assert(HasTwin<Halfedge> && !HasTwin<Vertex> && !HasTwin<Face> && !HasTwin<Index>);
static_assert(HasArea<Face> && !HasArea<Vertex> && !HasArea<Halfedge>);
static_assert(HasGirth<Vertex> && HasGirth<SurfacePoint> && !HasGirth<Face> && !HasGirth<Index>);
static_assert(IsPlace<Vertex> && !IsPlace<Halfedge> && !IsPlace<Index>);
static_assert(Bridged<Face> && !Bridged<Vertex>);

TEST(Elements, AreGoneThroughInOrder) {
  const SurfaceMesh mesh = octasphere(1).mesh();
  Index count = 0;
  for (const Vertex v : mesh.vertices()) EXPECT_EQ(v, count++);
  EXPECT_EQ(count, mesh.vertexCount());
  EXPECT_EQ(mesh.faces().size(), mesh.faceCount());
  for (const Halfedge h : mesh.halfedges()) {
    EXPECT_EQ(SurfaceMesh::side(SurfaceMesh::faceOf(h), h % 3), h);
    EXPECT_EQ(mesh.twin(mesh.twin(h)), h);
  }
}

TEST(Elements, NoneIsNoElement) {
  EXPECT_EQ(Vertex::none, kNoIndex);
  EXPECT_EQ(Vertex(), Vertex::none);
  EXPECT_NE(Face(0), Face::none);
  const SurfacePoint point = SurfacePoint::onHalfedge(Halfedge(4), 0.5);
  EXPECT_EQ(point.halfedge(), Halfedge(4));
  EXPECT_EQ(point.vertex(), Vertex::none);
  EXPECT_EQ(point.face(), Face::none);
  EXPECT_EQ(numbersOf(std::vector<Vertex>{Vertex(3), Vertex(1)}), (std::vector<Index>{3, 1}));
}

}  // namespace
}  // namespace girth::test
