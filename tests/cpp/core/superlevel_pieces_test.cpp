// The rest of a face beside samples of the distance in that face.
#include "solver/persistence/superlevel_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "geodesic/locate.h"
#include "girth/barcode.h"
#include "girth/girth_solver.h"
#include "random_meshes.h"

namespace girth::test {
namespace {

using geodesic::Propagation;
using geodesic::Unfolding;
using geodesic::Vec2;

/// Lets a propagation go on to its end.
struct Everything {
  bool enough(double) const { return false; }
  bool interrupted() const { return false; }
  void restart() const {}
  void onCrossing(Index, std::uint32_t, const geodesic::CrossingResult&) const {}
  void onVertex(Index) const {}
  std::size_t effort() const { return 0; }
};

/// The distance at the points of a grid in a face, and which of them hang together above a height.
class Samples {
 public:
  Samples(const Propagation& propagation, Index face)
      : corners_(cornersOf(propagation.unfolding(), face)) {
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j) {
        values_[number(i, j)] = propagation.pathTo(3 * face, place(i, j)).distance;
      }
    }
    for (int k = 0; k < 3; ++k) {
      spacing_ = std::max(spacing_, norm(corners_[(k + 1) % 3] - corners_[k]) / kSteps);
    }
  }

  double spacing() const { return spacing_; }
  double least() const { return *std::min_element(values_.begin(), values_.begin() + count()); }
  double most() const { return *std::max_element(values_.begin(), values_.begin() + count()); }

  void joinAbove(double height) {
    std::iota(parent_.begin(), parent_.end(), 0);
    const auto join = [&](int a, int b) {
      if (values_[a] > height && values_[b] > height) parent_[find(a)] = find(b);
    };
    height_ = height;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j < kSteps; ++j) {
        join(number(i, j), number(i, j + 1));
        join(number(j, i), number(j + 1, i));
        join(number(i, j + 1), number(i + 1, j));
      }
    }
  }

  /// The sample nearest to the middle of a piece, of those on its side; -1: it is too low.
  int near(const SuperlevelPieces::Piece& piece, double length) {
    const int k = static_cast<int>(piece.halfedge % 3);
    const int at = static_cast<int>(std::lround((piece.begin + piece.end) / 2 / length * kSteps));
    const int there = kSteps - at;
    const int sample = k == 0 ? number(at, 0) : k == 1 ? number(there, at) : number(0, there);
    return values_[sample] > height_ ? find(sample) : -1;
  }

 private:
  static constexpr int kSteps = 24;
  static int count() { return (kSteps + 1) * (kSteps + 2) / 2; }
  static int number(int i, int j) {
    return i * (kSteps + 1) - i * (i - 1) / 2 + j;  // j goes from 0 to kSteps − i
  }
  Vec2 place(int i, int j) const {
    return corners_[0] +
           (1.0 / kSteps) * (i * (corners_[1] - corners_[0]) + j * (corners_[2] - corners_[0]));
  }
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  std::array<Vec2, 3> corners_;
  std::array<double, (kSteps + 1) * (kSteps + 2) / 2> values_{};
  std::array<int, (kSteps + 1) * (kSteps + 2) / 2> parent_{};
  double spacing_{0}, height_{0};
};

/// Compares the pieces of faces with samples, at certain heights.
class Comparison {
 public:
  explicit Comparison(const Propagation& propagation) : propagation_(&propagation) {}

  void compare(Index face, Samples& samples, double height) {
    rest_.find(*propagation_, face, height, height);
    const std::vector<SuperlevelPieces::Piece> pieces = rest_.pieces();
    const auto sample = [&](const SuperlevelPieces::Piece& piece) {
      const double length = propagation_->unfolding().crossing(piece.halfedge).length();
      return samples.near(piece, length);
    };
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const bool isOne = rest_.together(pieces[i].gap, pieces[j].gap);
        EXPECT_EQ(rest_.together(pieces[i], pieces[j]), isOne);
        samples.joinAbove(height + samples.spacing());
        const int a = sample(pieces[i]), b = sample(pieces[j]);
        if (a >= 0 && a == b) {
          EXPECT_TRUE(isOne);
          ++joined;
        }
        samples.joinAbove(height - 2 * samples.spacing());
        if (isOne) {
          EXPECT_EQ(sample(pieces[i]), sample(pieces[j]));
        } else {
          ++parted;
        }
      }
    }
  }

  int joined{0}, parted{0};  // pairs of pieces

 private:
  const Propagation* propagation_;
  SuperlevelPieces rest_;
};

// The distance changes by no more than the way. So what samples show to hang together by more than
// that hangs together, and the other way round.
TEST(SuperlevelPieces, HangsTogetherAsSamplesDo) {
  int joined = 0, parted = 0, partedAtSaddles = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SurfaceMesh mesh = randomMesh(seed, 0.02).shape.mesh(OpenEdges::Boundary);
    const Unfolding unfolding(mesh);
    Propagation propagation(unfolding);
    const Vertex vertex(static_cast<Index>(seed % 7));
    const auto source = geodesic::locate(unfolding, SurfacePoint::atVertex(vertex));
    ASSERT_TRUE(source);
    Everything everything;
    propagation.run(std::span(&source.value(), 1), geodesic::Keep::Everything, everything);
    Comparison inFaces(propagation);
    SuperlevelPieces rest;
    for (Index face = 0; face < mesh.faceCount(); ++face) {
      SCOPED_TRACE("face " + std::to_string(face));
      Samples samples(propagation, face);
      if (!std::isfinite(samples.most())) continue;
      for (const double share : {0.3, 0.6, 0.8, 0.9, 0.97}) {
        const double height = samples.least() + share * (samples.most() - samples.least());
        inFaces.compare(face, samples, height);
      }
    }
    // Just above a saddle its loop parts the face.
    const auto barcode = GirthSolver(mesh).barcode(vertex, {.loops = true});
    ASSERT_TRUE(barcode);
    for (const GirthLoop& loop : barcode.value().loops) {
      const auto midpoint = geodesic::locate(unfolding, loop.midpoint);
      ASSERT_TRUE(midpoint);
      if (midpoint.value().kind != SurfacePoint::Kind::InFace) continue;
      const Index face = midpoint.value().element;
      std::vector<Vec2> line;
      for (const SurfacePoint& point : loop.points) {
        const auto located = geodesic::locate(unfolding, point);
        ASSERT_TRUE(located);
        if (const auto place = unfolding.placeIn(3 * face, located.value())) line.push_back(*place);
      }
      if (line.size() != 2) continue;
      const auto corners = cornersOf(unfolding, face);
      const double height = loop.length / 2 / unfolding.unit() * (1 + 1e-9);
      rest.find(propagation, face, height, height);
      const std::vector<SuperlevelPieces::Piece> pieces = rest.pieces();
      const auto isLeft = [&](const SuperlevelPieces::Piece& piece) {
        const Vec2 from = corners[piece.halfedge % 3], to = corners[(piece.halfedge % 3 + 1) % 3];
        const double at = (piece.begin + piece.end) / 2 / norm(to - from);
        return cross(line[1] - line[0], from + at * (to - from) - line[0]) > 0;
      };
      for (const SuperlevelPieces::Piece& piece : pieces) {
        for (const SuperlevelPieces::Piece& other : pieces) {
          if (!isLeft(piece) || isLeft(other)) continue;
          EXPECT_FALSE(rest.together(piece, other));
          ++partedAtSaddles;
        }
      }
    }
    joined += inFaces.joined;
    parted += inFaces.parted;
  }
  EXPECT_GT(joined, 1000);
  EXPECT_GT(parted, 100);
  EXPECT_GT(partedAtSaddles, 20);
}

}  // namespace
}  // namespace girth::test
