// From a soup of triangles to a surface, and back to the file's numbers.
#include "documents.h"

namespace girth::io::testing {
namespace {

TriangleSoup tetrahedronSoup() {
  TriangleSoup soup;
  soup.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  soup.triangles = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  return soup;
}

TEST(Weld, everyCornerItsOwnVertex) {
  const TriangleSoup shared = tetrahedronSoup();
  TriangleSoup soup;
  for (const Index v : shared.triangles) {
    for (std::size_t k = 0; k < 3; ++k) soup.positions.push_back(shared.positions[3 * v + k]);
    soup.triangles.push_back(static_cast<Index>(soup.triangles.size()));
  }
  const auto loaded = weld(soup);
  ASSERT_TRUE(loaded.ok()) << messageOf(loaded);
  EXPECT_EQ(loaded.value().mesh.vertexCount(), 4u);
  EXPECT_EQ(loaded.value().weldedVertices, 8u);
  EXPECT_EQ(loaded.value().inputOfVertex, (std::vector<Index>{0, 1, 2, 5}));
  EXPECT_EQ(loaded.value().vertexOfInput, (std::vector<Index>{0, 1, 2, 0, 2, 3, 0, 3, 1, 2, 1, 3}));
}

TEST(Weld, minusZeroIsZero) {
  TriangleSoup soup = tetrahedronSoup();
  soup.positions.insert(soup.positions.end(), {-0.0, 0.0, -0.0});
  soup.triangles[3] = 4;
  const auto loaded = weld(soup);
  ASSERT_TRUE(loaded.ok()) << messageOf(loaded);
  EXPECT_EQ(loaded.value().weldedVertices, 1u);
}

TEST(Weld, leavesOutWhatNoFaceUses) {
  TriangleSoup soup = tetrahedronSoup();
  // One at a place of its own, one where a used vertex is.
  soup.positions.insert(soup.positions.begin(), {9, 9, 9, 0, 0, 0});
  for (Index& v : soup.triangles) v += 2;
  const auto loaded = weld(soup);
  ASSERT_TRUE(loaded.ok()) << messageOf(loaded);
  EXPECT_EQ(loaded.value().unreferencedVertices, 2u);
  EXPECT_EQ(loaded.value().weldedVertices, 0u);
  EXPECT_EQ(loaded.value().vertexOfInput, (std::vector<Index>{kNoIndex, kNoIndex, 0, 1, 2, 3}));
}

TEST(Weld, errorsNameTheFilesVertices) {
  TriangleSoup soup = tetrahedronSoup();
  soup.positions.insert(soup.positions.begin(), {9, 9, 9});
  for (Index& v : soup.triangles) v += 1;
  soup.triangles.resize(9);
  const auto open = weld(soup);
  EXPECT_EQ(codeOf(open), "OPEN_EDGE");
  EXPECT_TRUE(contains(messageOf(open), "edge 3-2 of face 0")) << messageOf(open);
  EXPECT_TRUE(contains(messageOf(open), "one of 3")) << messageOf(open);

  soup = tetrahedronSoup();
  soup.positions.insert(soup.positions.end(), {0, 0, 0});
  soup.triangles.insert(soup.triangles.end(), {0, 4, 1});
  const auto collapsed = weld(soup);
  EXPECT_EQ(codeOf(collapsed), "DEGENERATE_FACE");
  EXPECT_EQ(collapsed.error().element, 4);
  EXPECT_TRUE(contains(messageOf(collapsed), "0 and 4")) << messageOf(collapsed);

  // Two tetrahedra that touch in one point.
  soup = tetrahedronSoup();
  soup.positions.insert(soup.positions.begin(), {9, 9, 9});
  for (Index& v : soup.triangles) v += 1;
  const auto first = soup.triangles;
  for (const Index v : first) soup.triangles.push_back(v + 4);
  soup.positions.insert(soup.positions.end(), {0, 0, 0, -1, 0, 0, 0, 0, -1, 0, -1, 0});
  const auto touching = weld(soup);
  EXPECT_EQ(codeOf(touching), "NON_MANIFOLD_VERTEX");
  EXPECT_EQ(touching.error().element, 1);
  EXPECT_TRUE(contains(messageOf(touching), "vertex 1 ")) << messageOf(touching);
}

TEST(Weld, checksWhatItIsGiven) {
  TriangleSoup soup = tetrahedronSoup();
  soup.triangles[5] = 77;
  EXPECT_EQ(codeOf(weld(soup)), "INDEX_OUT_OF_RANGE");
  soup = tetrahedronSoup();
  soup.positions[4] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(codeOf(weld(soup)), "NON_FINITE_POSITION");
  EXPECT_EQ(codeOf(weld(TriangleSoup())), "EMPTY_MESH");
}

}  // namespace
}  // namespace girth::io::testing
