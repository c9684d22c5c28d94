// Tips of the paper's own shapes (section 6.2).

#include <gtest/gtest.h>

#include "core/corpus.h"
#include "core/shapes.h"
#include "girth/girth_field.h"
#include "girth/tips.h"

namespace girth::test {
namespace {

Shape shapeOf(const SurfaceMesh& mesh) {
  Shape shape;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3& p = mesh.position(v);
    shape.add(p.x, p.y, p.z);
  }
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    const auto [a, b, c] = mesh.faceVertices(f);
    shape.face(a, b, c);
  }
  return shape;
}

std::size_t tipCount(const SurfaceMesh& mesh) {
  const auto tips = findTips(mesh, girthField(mesh).values);
  EXPECT_TRUE(tips.ok());
  if (!tips.ok()) return 0;
  for (const Tip& tip : tips.value().tips) {
    EXPECT_EQ(tip.contour.size(), 1u);
    EXPECT_TRUE(tip.contour[0].closed);
  }
  return tips.value().tips.size();
}

TEST(CorpusTips, AnOctopusHasEightArms) {
  if (!corpusIsThere()) GTEST_SKIP() << "no corpus";
  const SurfaceMesh mesh = corpusModel("octopus_14256f.off");
  EXPECT_EQ(tipCount(mesh), 8u);
  EXPECT_EQ(tipCount(subdivided(shapeOf(mesh)).mesh()), 8u);
}

TEST(CorpusTips, AHandHasFiveFingersAndAWrist) {
  if (!corpusIsThere()) GTEST_SKIP() << "no corpus";
  EXPECT_EQ(tipCount(corpusModel("hand_20686f.obj")), 6u);
}

TEST(CorpusTips, AHorseHasFourLegsAndTwoEars) {
  if (!corpusIsThere()) GTEST_SKIP() << "no corpus";
  const SurfaceMesh coarse = corpusModel("horse_1500f.off");
  EXPECT_EQ(tipCount(coarse), 6u);
  EXPECT_EQ(tipCount(subdivided(shapeOf(coarse)).mesh()), 6u);
  EXPECT_EQ(tipCount(corpusModel("horse_6000f.off")), 6u);
}

}  // namespace
}  // namespace girth::test
