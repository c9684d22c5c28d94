// The engine by itself: what may differ inside must not show outside.

#include "geodesic/propagation.h"
#include "geodesic/corridor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <new>

#include "geodesic/crossing_kernel.h"
#include "geodesic/goal.h"
#include "shapes.h"
#include "solver/search/farthest_point.h"
#include "solver/search/loop_search.h"

namespace {

std::atomic<std::size_t> allocations{0};

}  // namespace

// Counted for the whole program; only differences are looked at. (Inlined, GCC 12 takes new and
// delete for mismatched.)
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto step = static_cast<std::size_t>(alignment);
#ifdef _WIN32
  if (void* memory = _aligned_malloc(size, step)) return memory;
#else
  if (void* memory = std::aligned_alloc(step, (size + step - 1) / step * step)) return memory;
#endif
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
#ifdef _WIN32
  _aligned_free(memory);
#else
  std::free(memory);
#endif
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t,
                                       std::align_val_t alignment) noexcept {
  operator delete(memory, alignment);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace girth::test {
namespace {

using geodesic::CrossingBatch;
using geodesic::CrossingResult;
using geodesic::Keep;
using geodesic::Propagation;
using geodesic::Unfolding;
using geodesic::WindowList;
using geodesic::WindowPool;
using geodesic::WindowRun;
using geodesic::WindowTable;

/// I(p) from the engine's parts.
double valueBy(Propagation& propagation, LoopSearch& search, Index vertex, Keep keep) {
  const SurfacePoint source = SurfacePoint::atVertex(Vertex(vertex));
  search.start(nullptr);
  propagation.run(std::span(&source, 1), keep, search);
  return search.found() ? search.best().length : 2 * farthestPoint(propagation).distance;
}

std::vector<Shape> someShapes() {
  return {perturbed(plate(2), 0.2, 3), perturbed(torus(2, 0.7, 24, 16), 0.3, 4),
          perturbed(box(1, 1, 3, 4, 4, 12), 0.1, 5), octasphere(3),
          prism(regularPolygon(4, 1, 3), 3, 9)};
}

TEST(Propagation, TheWidthOfTheBucketsDoesNotShow) {
  for (const Shape& shape : someShapes()) {
    const SurfaceMesh mesh = shape.mesh();
    const Unfolding unfolding(mesh);
    Propagation fine(unfolding, 0.01), usual(unfolding), coarse(unfolding, 3);
    LoopSearch inFine(fine), inUsual(usual), inCoarse(coarse);
    for (const Vertex v : mesh.vertices()) {
      const double value = valueBy(usual, inUsual, v, Keep::Front);
      // Equal paths past flat vertices may be found in another order, with another last bit.
      EXPECT_NEAR(valueBy(fine, inFine, v, Keep::Front) / value, 1, 1e-14) << v;
      EXPECT_NEAR(valueBy(coarse, inCoarse, v, Keep::Front) / value, 1, 1e-14) << v;
    }
  }
}

TEST(Propagation, WhatIsForgottenDoesNotShow) {
  // Large enough that windows are forgotten on the way.
  for (const Shape& shape :
       {perturbed(torus(2, 0.9, 96, 48), 0.3, 6), perturbed(subdivided(octasphere(4)), 0.3, 7)}) {
    const SurfaceMesh mesh = shape.mesh();
    const Unfolding unfolding(mesh);
    Propagation front(unfolding), all(unfolding);
    LoopSearch inFront(front), inAll(all);
    bool forgotten = false;
    for (Index v = 0; v < mesh.vertexCount(); v += mesh.vertexCount() / 12) {
      EXPECT_EQ(valueBy(front, inFront, v, Keep::Front), valueBy(all, inAll, v, Keep::Everything));
      EXPECT_EQ(front.windowsCrossed(), all.windowsCrossed());
      for (const Face f : mesh.faces()) forgotten = forgotten || front.forgotten(f);
    }
    EXPECT_TRUE(forgotten);
  }
}

TEST(Propagation, AGoalIsReachedByLess) {
  struct Ignoring {
    bool enough(double) { return false; }
    bool interrupted() { return false; }
    void restart() {}
    void onCrossing(Index, std::uint32_t, const CrossingResult&) {}
    void onVertex(Index) {}
    std::size_t effort() { return 0; }
  } visitor;
  std::size_t windows = 0, towards = 0, along = 0;
  for (const Shape& shape : someShapes()) {
    const SurfaceMesh mesh = shape.mesh();
    const Unfolding unfolding(mesh);
    Propagation all(unfolding), some(unfolding), back(unfolding);
    const SurfacePoint source = SurfacePoint::atVertex(Vertex(0));
    all.run(std::span(&source, 1), Keep::Nothing, visitor);
    windows += mesh.vertexCount() * all.windowsCreated();
    for (Index to = 0; to < mesh.vertexCount(); ++to) {
      const double distance = all.distance(to);
      const Vec3& place = mesh.position(Vertex(unfolding.vertexInMesh(to)));
      const geodesic::Goal goal(unfolding, place, distance);
      some.run(std::span(&source, 1), Keep::Nothing, visitor, &goal);
      EXPECT_NEAR(some.distance(to), distance, 1e-14 * distance) << to;
      towards += some.windowsCreated();
      // Vertices out of reach are reached, if at all, by paths that are real.
      for (Index v = 0; v < mesh.vertexCount(); ++v) {
        EXPECT_GE(some.distance(v), all.distance(v) * (1 - 1e-14)) << v;
      }
      // The ways over the surface are better bounds than those through space.
      const SurfacePoint end = SurfacePoint::atVertex(Vertex(to));
      const auto better = geodesic::corridor(back, source, end, distance, {});
      ASSERT_TRUE(better);
      some.run(std::span(&source, 1), Keep::Nothing, visitor, &*better);
      EXPECT_NEAR(some.distance(to), distance, 1e-14 * distance) << to;
      along += some.windowsCreated();
    }
  }
  EXPECT_LT(3 * towards, windows);
  EXPECT_LT(along, towards);
}

TEST(Propagation, NoMemoryIsTakenOnceItHasRun) {
  const SurfaceMesh mesh = perturbed(torus(2, 0.8, 60, 30), 0.3, 8).mesh();
  const Unfolding unfolding(mesh);
  Propagation propagation(unfolding);
  LoopSearch search(propagation);
  for (Index v = 0; v < 50; ++v) valueBy(propagation, search, v, Keep::Front);
  const std::size_t before = allocations;
  for (Index v = 0; v < 50; ++v) valueBy(propagation, search, v, Keep::Front);
  EXPECT_EQ(allocations, before);
}

TEST(WindowPool, RunsStayUntilTheyArePassed) {
  using Side = WindowPool::Side;
  WindowPool pool;
  Random random(11);
  struct Kept {
    WindowRun* run;
    double mark;
  };
  std::deque<Kept> kept;  // in the order of their coming; the first `entered` have crossed
  std::size_t entered = 0;
  const auto intact = [](const Kept& k) {
    for (Index field = 0; field < WindowRun::kFields; ++field) {
      for (Index i = 0; i < k.run->count; ++i) {
        if (k.run->fields()[field * k.run->stride + i] != k.mark + 10.0 * i + field) return false;
      }
    }
    return true;
  };
  for (int round = 0; round < 20000; ++round) {
    // Seldom larger than a block, and then mostly not filled.
    const std::uint32_t room = 1 + random.below(random() < 0.01 ? 3000 : 30);
    const Side side = random() < 0.5 ? Side::Left : Side::Right;
    WindowRun* run = pool.reserve(side, room);
    if (random() < 0.2) continue;  // nothing came of it
    const std::uint32_t count = 1 + random.below(random() < 0.5 ? room : 1 + room / 8);
    const double mark = random();
    for (Index field = 0; field < WindowRun::kFields; ++field) {
      for (Index i = 0; i < count; ++i) {
        run->fields()[field * run->stride + i] = mark + 10.0 * i + field;
      }
    }
    pool.commit(side, run, count, random() < 0.7);
    kept.push_back({run, mark});
    if (kept.size() < 300) continue;
    // Each is passed only after it is looked at.
    WindowPool::crossed(kept[entered++].run, static_cast<float>(round + 200));
    if (entered < 100) continue;
    ASSERT_TRUE(intact(kept.front())) << round;
    kept.pop_front();
    --entered;
    if (pool.grown()) pool.forget(static_cast<float>(round));
  }
  EXPECT_TRUE(std::all_of(kept.begin(), kept.end(), intact));
  EXPECT_LT(pool.memoryBytes(), 3000000u);
}

TEST(WindowTable, KnowsWhatAListForEachWouldKnow) {
  // Halfedges are opened, filled, crossed and passed at random, beside a list for each of them.
  constexpr Index kHalfedges = 20000;
  WindowTable table(kHalfedges);
  Random random(12);
  std::size_t afterFirst = 0;
  for (int source = 0; source < 6; ++source) {
    std::vector<WindowList> lists(kHalfedges);
    float passed = 0;
    // Farther is what has a higher number, and of that the front takes the next 500.
    for (Index round = 0; round < kHalfedges - 500; ++round) {
      const auto cross = [&](Index h) {
        if (lists[h].count == 0 || table[h].farthest < passed) return;
        for (WindowList* one : {&table.opened(h), &lists[h]}) {
          one->entered = one->count;
          one->farthest = static_cast<float>(h);
        }
      };
      const Index h = round + random.below(500);
      if (!(table[h].farthest < passed)) {
        ASSERT_EQ(table.open(h).count, lists[h].count);
        for (WindowList* one : {&table.opened(h), &lists[h]}) ++one->count;
        if (random() < 0.7) {
          cross(h);
        } else if (random() < 0.1) {
          table.close(h);
          lists[h] = WindowList{};
        }
      }
      cross(round);
      if (round % 16 == 0) {
        passed = static_cast<float>(round) - 10;
        table.forget(passed);
      }
      const Index other = random.below(kHalfedges);
      const bool isPassed = lists[other].farthest < passed;
      ASSERT_EQ(table[other].farthest < passed, isPassed);
      if (!isPassed) {
        ASSERT_EQ(table[other].count, lists[other].count);
        ASSERT_EQ(table[other].entered, lists[other].entered);
      }
    }
    table.clear();
    for (Index h = 0; h < kHalfedges; ++h) ASSERT_EQ(table[h].count, 0u);
    if (source == 0) afterFirst = table.memoryBytes();
  }
  // In proportion to the front, and no more from source to source.
  EXPECT_LT(table.memoryBytes(), kHalfedges * sizeof(WindowList) / 2);
  EXPECT_LE(table.memoryBytes(), afterFirst + afterFirst / 4);
}

TEST(CrossingKernel, GivesTheSameBitsOnEveryProcessor) {
  const SurfaceMesh mesh = perturbed(torus(2, 0.7, 9, 7), 0.3, 9).mesh();
  const Unfolding unfolding(mesh);
  Random random(10);
  using Side = WindowPool::Side;
  WindowPool pool;
  for (int round = 0; round < 20000; ++round) {
    const Index h = random.below(unfolding.halfedgeCount());
    const geodesic::Crossing c = unfolding.crossing(h);
    const double far = std::pow(10, 3 * random() - 1);
    pool.reset();
    WindowRun* newest = nullptr;
    std::uint32_t count = 0;
    for (Index runs = 1 + random.below(3); runs > 0; --runs) {
      const std::uint32_t windows = 1 + random.below(11);
      WindowRun* run = pool.reserve(Side::Left, windows + random.below(20));
      run->older = newest;
      run->begin = count;
      run->count = windows;
      count += run->count;
      newest = run;
      double* field = run->fields();
      const std::size_t stride = run->stride;
      for (Index i = 0; i < run->count; ++i) {
        field[i] = c.length() * (3 * random() - 1);
        field[stride + i] = -far * random();
        field[2 * stride + i] = random() < 0.3 ? 0 : 10 * random();
        const double a = random() < 0.3 ? 0 : random(), b = random() < 0.3 ? 0 : random();
        field[3 * stride + i] = c.length() * std::min(a, 1 - b);
        field[4 * stride + i] = c.length() * std::min(b, 1 - a);
      }
      pool.commit(Side::Left, run, windows, random() < 0.5);
    }
    const auto corner = [&] { return random() < 0.2 ? INFINITY : 10 + far * random(); };
    const CrossingBatch batch{c, newest, 0, count, corner(), corner(), corner()};
    WindowRun* left = pool.reserve(Side::Left, count);
    WindowRun* right = pool.reserve(Side::Right, count);
    const CrossingResult a = geodesic::crossingKernels().back()(batch, left, right);
    pool.commit(Side::Left, left, std::max(a.leftCount, 1u), false);
    pool.commit(Side::Right, right, std::max(a.rightCount, 1u), false);
    const auto same = [](const WindowRun& p, const WindowRun& q, std::uint32_t windows) {
      for (std::size_t field = 0; field < WindowRun::kFields; ++field) {
        if (std::memcmp(p.fields() + field * p.stride, q.fields() + field * q.stride,
                        windows * sizeof(double)) != 0) {
          return false;
        }
      }
      return true;
    };
    for (const geodesic::CrossingKernel kernel : geodesic::crossingKernels()) {
      WindowRun* otherLeft = pool.reserve(Side::Left, count);
      WindowRun* otherRight = pool.reserve(Side::Right, count);
      const CrossingResult b = kernel(batch, otherLeft, otherRight);
      ASSERT_EQ(a.leftCount, b.leftCount);
      ASSERT_EQ(a.rightCount, b.rightCount);
      ASSERT_EQ(a.leftNearest, b.leftNearest);
      ASSERT_EQ(a.rightNearest, b.rightNearest);
      ASSERT_EQ(a.distanceApex, b.distanceApex);
      ASSERT_EQ(a.apexWindow, b.apexWindow);
      ASSERT_EQ(a.apexBegin, b.apexBegin);
      ASSERT_EQ(a.apexEnd, b.apexEnd);
      ASSERT_EQ(a.towardsLeft, b.towardsLeft);
      ASSERT_EQ(a.towardsRight, b.towardsRight);
      ASSERT_TRUE(same(*left, *otherLeft, a.leftCount));
      ASSERT_TRUE(same(*right, *otherRight, a.rightCount));
    }
  }
}

}  // namespace
}  // namespace girth::test
