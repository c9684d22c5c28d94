// Digests of computed values, which are the same bits on every machine; stated as x86-64 with GCC
// computes them.
// Surfaces are made without the C library's functions. Results made of the spectrum are left out
// (web/docs/decisions/exactness-to-the-bit.md).
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "girth/geodesic_extent.h"
#include "girth/girth_field.h"
#include "girth/girth_solver.h"
#include "girth/handles.h"
#include "girth/limbs.h"
#include "girth/necks.h"
#include "girth/refined_girth.h"
#include "girth/remesh.h"
#include "girth/shape_diameter.h"
#include "girth/smooth_surface.h"
#include "girth/thickness.h"
#include "girth/tips.h"
#include "girth/vertex_areas.h"
#include "shapes.h"

namespace girth {
namespace {

/// FNV-1a over the bits of numbers.
class BitDigest {
 public:
  BitDigest& add(double value) {
    std::uint64_t bits = std::bit_cast<std::uint64_t>(value == value ? value : 0x1p-1000);
    for (int byte = 0; byte < 8; ++byte, bits >>= 8) sum_ = (sum_ ^ (bits & 0xff)) * 0x100000001b3;
    return *this;
  }
  BitDigest& add(const Vec3& p) { return add(p.x).add(p.y).add(p.z); }
  BitDigest& add(std::span<const double> values) {
    for (const double value : values) add(value);
    return *this;
  }
  std::uint64_t sum() const { return sum_; }

 private:
  std::uint64_t sum_{0xcbf29ce484222325};
};

std::uint64_t digestOf(std::span<const double> values) { return BitDigest().add(values).sum(); }

/// A rough body with two holes, and a rough rod.
SurfaceMesh roughPlate() {
  return test::perturbed(test::subdivided(test::plate(1, 2)), 0.2, 1).mesh();
}
SurfaceMesh roughRod() { return test::perturbed(test::box(1, 1, 8, 3, 3, 24), 0.2, 2).mesh(); }

TEST(SameBits, girthAndItsLoops) {
  const SurfaceMesh plate = roughPlate(), rod = roughRod();
  EXPECT_EQ(digestOf(girthField(plate).values), 0xb141cded2f6a5bc8u);
  EXPECT_EQ(digestOf(girthField(rod).values), 0x1855f6f2e0269c64u);
  EXPECT_EQ(digestOf(girthField(rod, GirthMethod::Marched).values), 0xb6120a4b07340236u);
  EXPECT_EQ(digestOf(refinedGirth(plate).value().field.values), 0xb141cded2f6a5bc8u);
  GirthSolver solver(plate);
  BitDigest loops;
  for (Index v = 0; v < plate.vertexCount(); v += 7) {
    const auto loop = solver.loop(Vertex{v});
    ASSERT_TRUE(loop.ok());
    loops.add(loop.value().length).add(loop.value().angle);
    for (const Vec3& p : polyline(plate, loop.value())) loops.add(p);
  }
  EXPECT_EQ(loops.sum(), 0xe30c218be20ae9ccu);
}

TEST(SameBits, otherFields) {
  const SurfaceMesh plate = roughPlate(), rod = roughRod();
  EXPECT_EQ(digestOf(vertexAreas(plate)), 0xb94fa8c722aee475u);
  EXPECT_EQ(digestOf(shapeDiameter(plate).value().values), 0x8c19ca0417bd04b0u);
  EXPECT_EQ(digestOf(medialThickness(plate).value().values), 0x823a52e89e93a98bu);
  EXPECT_EQ(digestOf(geodesicExtent(rod, DistanceMethod::Exact).average), 0xe38bb672561c145du);
  EXPECT_EQ(digestOf(geodesicExtent(rod, DistanceMethod::FastMarching).farthest),
            0x62f9ef3ba3815365u);
}

TEST(SameBits, whatIsFoundOnASurface) {
  const SurfaceMesh plate = roughPlate(), rod = roughRod();
  const std::vector<double> girth = girthField(rod).values;
  BitDigest tips, limbs, necks, handles;
  const Tips found = findTips(rod, girth).value();
  for (const Tip& tip : found.tips) tips.add(tip.area).add(tip.apexDistance).add(tip.jump);
  EXPECT_EQ(tips.sum(), 0x4b9cd4c4a64f5cc7u);
  for (const Limb& limb : findLimbs(rod, girth, found.tips).value().limbs) {
    limbs.add(limb.length).add(limb.narrowest).add(limb.median).add(limb.base).add(limb.distances);
  }
  EXPECT_EQ(limbs.sum(), 0xd23ddd577ab68b00u);
  for (const Neck& neck : findNecks(rod, girth).value().necks) {
    necks.add(neck.length).add(neck.prominence).add(neck.centre).add(neck.normal).add(neck.radius);
  }
  EXPECT_EQ(necks.sum(), 0x2ed3a69f904e4392u);
  for (const Handle& handle : findHandles(plate).value().handles) {
    handles.add(handle.length).add(handle.centre).add(handle.area);
  }
  EXPECT_EQ(handles.sum(), 0xea1b68d630c02baau);
}

TEST(SameBits, otherSurfaces) {
  const SurfaceMesh plate = roughPlate();
  const auto digestOfSurface = [](const SurfaceMesh& mesh) {
    BitDigest digest;
    for (const Vertex v : mesh.vertices()) digest.add(mesh.position(v));
    return digest.sum();
  };
  for (const auto& [method, digest] :
       {std::pair{RemeshMethod::Fitting, std::uint64_t{0x7fd345b8f1465350u}},
        std::pair{RemeshMethod::Even, std::uint64_t{0x30b09448b8ae3d0bu}}}) {
    RemeshOptions options;
    options.faces = 300;
    options.method = method;
    EXPECT_EQ(digestOfSurface(remesh(plate, options).value().mesh), digest);
  }
  EXPECT_EQ(digestOfSurface(smoothSurface(plate, 3).value()), 0x0f2c8bcc679ee682u);
}

}  // namespace
}  // namespace girth
