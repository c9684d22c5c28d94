// Results as CSV: what has a cell, and how cells are named.
#include "girth/io/result_csv.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "girth/io/load_mesh.h"
#include "girth/io/result_json.h"

namespace girth::io {

struct Measured {
  double length{0};
  bool closed{false};
  Vertex apex;
  Vec3 centre;
  Vec3 normal;
  std::vector<Vertex> vertices;
  Index count{0};
};

constexpr auto describe(Members<Measured>) {
  return described<Measured>(
      member("length", &Measured::length), member("closed", &Measured::closed),
      member("apex", &Measured::apex), member("centre", &Measured::centre),
      member("normal", &Measured::normal), member("vertices", &Measured::vertices),
      member("count", &Measured::count));
}

struct AllMeasured {
  std::vector<Measured> all;
};

constexpr auto describe(Members<AllMeasured>) {
  return described<AllMeasured>(member("all", &AllMeasured::all));
}

namespace {

/// A tetrahedron whose first vertex the preparation made.
LoadedMesh tetrahedron() {
  const std::vector<double> positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::vector<Index> triangles{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  auto mesh = SurfaceMesh::fromArrays(positions, triangles);
  EXPECT_TRUE(mesh);
  LoadedMesh loaded{
      {std::move(mesh).value(), {}, {kNoIndex, 0, 1, 2}, {}, {}, {}}, Format::Obj, "metre", {}};
  return loaded;
}

TEST(ResultCsv, numbersWordsAndPlacesHaveCells) {
  const LoadedMesh loaded = tetrahedron();
  ResultCsv<Measured> csv(loaded, "number");
  EXPECT_EQ(csv.text(), "number,length,closed,apex,x,y,z,normalX,normalY,normalZ,count,unit\n");
  csv.add({0.5, true, Vertex(2), {1, 2, 3}, {0, 0, 1}, {Vertex(1)}, 7}, "1");
  const double infinite = std::numeric_limits<double>::infinity();
  csv.add({infinite, false, Vertex(0), {}, {}, {}, 0}, "2");
  csv.add({infinite, false, Vertex::none, {}, {}, {}, 0}, "3");
  EXPECT_EQ(csv.text(),
            "number,length,closed,apex,x,y,z,normalX,normalY,normalZ,count,unit\n"
            "1,0.5,true,1,1,2,3,0,0,1,7,metre\n"
            "2,,false,,0,0,0,0,0,0,0,metre\n"
            "3,,false,,0,0,0,0,0,0,0,metre\n");
}

TEST(ResultCsv, theListOfAResultIsNumberedFromZero) {
  const AllMeasured found{{{0.5, true, Vertex(2), {}, {}, {}, 7}, {}}};
  EXPECT_EQ(resultCsv(tetrahedron(), found),
            "number,length,closed,apex,x,y,z,normalX,normalY,normalZ,count,unit\n"
            "0,0.5,true,1,0,0,0,0,0,0,7,metre\n"
            "1,0,false,,0,0,0,0,0,0,0,metre\n");
}

TEST(ResultJson, aStructOfOnesOwnIsWrittenAsTheCommandWritesOthers) {
  const Measured result{0.5, true, Vertex::none, {1, 2, 3}, {0, 0, 1}, {Vertex(0), Vertex(3)}, 7};
  EXPECT_EQ(resultJson(tetrahedron(), result, "a.obj"),
            "{\"file\":\"a.obj\",\"unit\":\"metre\",\"length\":0.5,\"closed\":true,\"apex\":null,"
            "\"centre\":[1,2,3],\"normal\":[0,0,1],\"vertices\":[2],\"count\":7}\n");
}

}  // namespace
}  // namespace girth::io
