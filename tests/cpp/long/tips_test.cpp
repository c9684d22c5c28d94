// Tips of the paper's own shapes (section 6.2).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "core/corpus.h"
#include "girth/girth_field.h"
#include "girth/study/tip_stability.h"
#include "girth/tips.h"
#include "mesh/vector.h"

namespace girth::test {
namespace {

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
  // Tips stay in smaller triangles; noise of up to a quarter of an edge may hide one, which is
  // told.
  const auto tips = findTips(mesh, girthField(mesh).values);
  ASSERT_TRUE(tips.ok());
  const auto trials = study::tipTrials(mesh, tips.value().tips);
  ASSERT_TRUE(trials.ok());
  EXPECT_EQ(trials.value()[0].foundAgain(), 8u);
  EXPECT_EQ(trials.value()[0].tips, 8u);
  for (const study::TipTrial& trial : trials.value()) EXPECT_GE(trial.foundAgain(), 7u);
}

TEST(CorpusTips, AHandHasFiveFingersAndAWrist) {
  if (!corpusIsThere()) GTEST_SKIP() << "no corpus";
  EXPECT_EQ(tipCount(corpusModel("hand_20686f.obj")), 6u);
}

TEST(CorpusTips, AHorseEndsInFourHoovesAndItsMuzzle) {
  // Its tail is a tuft that hangs close to the legs, and its ears have few triangles: there the
  // contour stays open.
  if (!corpusIsThere()) GTEST_SKIP() << "no corpus";
  EXPECT_EQ(tipCount(corpusModel("horse_6000f.off")), 5u);
}

/// Extremities that an animal of the TOSCA models reaches out: up is z, it looks along −y, and x is
/// across.
struct Extremities {
  std::map<std::string, Index> vertices;

  explicit Extremities(const SurfaceMesh& mesh) {
    double middle[2] = {0, 0};
    for (const Vertex v : mesh.vertices()) {
      middle[0] += mesh.position(v).x / mesh.vertexCount();
      middle[1] += mesh.position(v).y / mesh.vertexCount();
    }
    const auto reach = [&](const std::string& name, Index v, double height) {
      const auto [found, first] = vertices.emplace(name, v);
      if (first || height > heights_[name]) {
        found->second = v;
        heights_[name] = height;
      }
    };
    for (const Vertex v : mesh.vertices()) {
      const Vec3& p = mesh.position(v);
      const std::string side = p.x < middle[0] ? "left" : "right";
      reach((p.y < middle[1] ? "fore foot " : "hind foot ") + side, v, -p.z);
      reach("ear " + side, v, p.z);
      reach("tail", v, p.y);
    }
  }

 private:
  std::map<std::string, double> heights_;
};

TEST(CorpusTips, FourLeggedAnimalsHaveLegsEarsAndATail) {
  if (!corpusIsThere()) GTEST_SKIP() << "no corpus";
  for (const char* animal : {"cat0", "dog0", "horse0"}) {
    const SurfaceMesh mesh =
        corpusModel("../retrieval/tosca_iso_5k/" + std::string(animal) + ".off");
    const auto tips = findTips(mesh, girthField(mesh).values);
    ASSERT_TRUE(tips.ok());
    for (const auto& [name, vertex] : Extremities(mesh).vertices) {
      const auto& found = tips.value().tips;
      // Its outermost vertex lies in the tip, or next to its apex: a twentieth of the root of the
      // area is less than the height of a cat's ear.
      const auto tip = std::find_if(found.begin(), found.end(), [&, v = vertex](const Tip& t) {
        return std::binary_search(t.vertices.begin(), t.vertices.end(), v) ||
               norm(mesh.position(Vertex(t.apex)) - mesh.position(Vertex(v))) <
                   0.05 * std::sqrt(mesh.area());
      });
      ASSERT_NE(tip, found.end()) << animal << ": " << name;
      // Legs and tail stand out: the five largest jumps.
      if (!name.starts_with("ear")) {
        EXPECT_LT(tip - found.begin(), 5) << animal << ": " << name;
      }
      EXPECT_EQ(tip->contour.size(), 1u) << animal << ": " << name;
    }
  }
}

}  // namespace
}  // namespace girth::test
