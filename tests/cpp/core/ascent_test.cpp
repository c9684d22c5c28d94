// The two sides of saddles as they are seen, beside the barcode, which knows from all maxima when
// they die.
#include "solver/persistence/ascent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "geodesic/locate.h"
#include "girth/barcode.h"
#include "girth/girth_solver.h"
#include "shapes.h"
#include "solver/search/loop_search.h"

namespace girth::test {
namespace {

using geodesic::Propagation;
using geodesic::Unfolding;
using geodesic::Vec2;

/// Notes the saddles up to a distance. Faces that are nearer as a whole than another one are
/// forgotten, though saddles may be lower.
class SaddlesUpTo {
 public:
  SaddlesUpTo(Propagation& propagation, double kept, double end)
      : propagation_(&propagation), search_(propagation), kept_(kept), end_(end) {
    search_.start(nullptr);
  }

  bool enough(double frontier) {
    while (search_.enough(frontier)) {
      if (loops.empty()) propagation_->keepBeyond(search_.best().length / 2);
      loops.push_back(search_.best());
    }
    if (frontier > kept_) propagation_->keepBeyond(kept_);
    return frontier > end_;
  }
  bool interrupted() const { return false; }
  void restart() { FAIL(); }
  void onCrossing(Index halfedge, std::uint32_t first, const geodesic::CrossingResult& result) {
    search_.onCrossing(halfedge, first, result);
  }
  void onVertex(Index vertex) { search_.onVertex(vertex); }
  std::size_t effort() const { return search_.effort(); }

  std::vector<LoopCandidate> loops;

 private:
  Propagation* propagation_;
  LoopSearch search_;
  double kept_, end_;
};

/// The two sides of a saddle inside a face.
std::array<SaddleSide, 2> sidesOf(const Unfolding& unfolding, const LoopCandidate& loop) {
  std::array<Vec2, 2> roots;
  for (const std::size_t k : {0, 1}) {
    const geodesic::Bundle& bundle = (k == 0 ? loop.there : loop.back).bundle;
    roots[k] = unfolding.toFrame(bundle.halfedge, loop.halfedge, bundle.root);
  }
  const Vec2 line = roots[1] - roots[0];
  return {SaddleSide{loop.halfedge, loop.midpoint, roots, {-line.y, line.x}},
          SaddleSide{loop.halfedge, loop.midpoint, roots, {line.y, -line.x}}};
}

/// Asks for the sides of saddles at heights below and above that at which they die.
class Comparison {
 public:
  explicit Comparison(const Unfolding& unfolding) : unfolding_(&unfolding) {}

  /// Compares the saddles up to a distance, with faces forgotten up to `kept`.
  void compare(const SurfacePoint& source, const std::vector<SaddleBar>& bars, double kept,
               double last) {
    Propagation propagation(*unfolding_);
    SaddlesUpTo saddles(propagation, kept, last);
    propagation.run(std::span(&source, 1), geodesic::Keep::Front, saddles);
    Ascent ascent(propagation);
    for (const LoopCandidate& loop : saddles.loops) {
      if (loop.there.bundle.halfedge == kNoIndex || loop.back.bundle.halfedge == kNoIndex) continue;
      const double height = loop.length / 2;
      const auto isOfLoop = [&](const SaddleBar& bar) {
        return std::fabs(bar.birth / unfolding_->unit() - height) < 1e-6 * height;
      };
      const auto bar = std::find_if(bars.begin(), bars.end(), isOfLoop);
      if (bar == bars.end() || std::count_if(bars.begin(), bars.end(), isOfLoop) > 1) continue;
      const double death = bar->death / unfolding_->unit();
      for (const double share : {0.2, 0.5, 0.9, 0.99, 1.01, 1.1, 2.0, 5.0}) {
        const double end = height + share * (std::isinf(death) ? 0.1 : death - height);
        if (end < last) compareSides(ascent, loop, end, death);
      }
    }
  }

  int filled{0}, lasting{0};

 private:
  void compareSides(Ascent& ascent, const LoopCandidate& loop, double end, double death) {
    const double height = loop.length / 2;
    bool lasts = true;
    for (const SaddleSide& side : sidesOf(*unfolding_, loop)) {
      if (ascent.isFilled(side, height, end)) {
        EXPECT_LT(death, end);
        ++filled;
      }
      lasts = ascent.leads(side, height, end) && lasts;
    }
    if (!lasts) return;
    EXPECT_GT(death, end);
    ++lasting;
  }

  const Unfolding* unfolding_;
};

// However much has been forgotten.
TEST(Ascent, NeverSaysWhatTheMaximaRefute) {
  const SurfaceMesh mesh = bumpyRod(40, 120, 9).mesh();
  const Unfolding unfolding(mesh);
  GirthSolver solver(mesh);
  Comparison comparison(unfolding);
  for (Index v = 0; v < mesh.vertexCount(); v += 61) {
    SCOPED_TRACE("vertex " + std::to_string(v));
    const auto barcode = solver.barcode(Vertex(v), {.maxPersistence = 1});
    ASSERT_TRUE(barcode);
    const auto& bars = barcode.value().bars;
    if (bars.empty()) continue;
    const auto source = geodesic::locate(unfolding, SurfacePoint::atVertex(Vertex(v)));
    ASSERT_TRUE(source);
    for (const double beyond : {0.0, 0.05, 0.2}) {
      const double first = bars.front().birth;
      comparison.compare(source.value(), bars, (first + beyond) / unfolding.unit(),
                         (first + 0.8) / unfolding.unit());
    }
  }
  EXPECT_GT(comparison.filled, 100);
  EXPECT_GT(comparison.lasting, 300);
}

}  // namespace
}  // namespace girth::test
