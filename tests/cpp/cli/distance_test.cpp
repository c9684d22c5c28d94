// girth distance, on a box of known distances.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "command.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

/// A box of 2 by 3 by 4.
std::string measuredBox() {
  return "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nv 0 0 4\nv 2 0 4\nv 2 3 4\nv 0 3 4\n"
         "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}

TEST_F(Command, distancesBetweenPairsOfAFile) {
  const std::string model = write("box.obj", measuredBox());
  const std::string pairs = write("pairs.csv", "from,to\n0,6\n\n0:1,0,0,\"0:0,0,1\"\n");
  const Outcome outcome = run({"distance", model, "--between", pairs, "--unit", "cm", "--paths",
                               "-o", path("d.json"), "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(contentOf(path("d.json")), outcome.output);
  const Json all = Json::parse(outcome.output);
  ASSERT_EQ(all["distances"].size(), 2u);
  EXPECT_NEAR(all["distances"][0]["length"].get<double>(), std::sqrt(41.0), 1e-12);
  EXPECT_EQ(all["distances"][0]["start"]["vertices"], Json({0}));
  EXPECT_EQ(all["distances"][0]["end"]["vertices"], Json({6}));
  EXPECT_EQ(all["distances"][0]["points"].front(), all["distances"][0]["start"]);
  ASSERT_EQ(run({"distance", model, "--between", pairs, "-o", path("d.csv")}).exitCode, 0);
  const auto rows = linesOf(contentOf(path("d.csv")));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0], "number,x,y,z,endX,endY,endZ,length,straight,unit");
  EXPECT_EQ(rows[1].rfind("0,0,0,0,2,3,4,6.40312", 0), 0u) << rows[1];
  EXPECT_TRUE(contains(run({"distance", model, "--between", pairs}).output, "2 distances\n"));
}

TEST_F(Command, pairsThatAreNoneAreRefused) {
  const std::string model = write("box.obj", measuredBox());
  const auto refusal = [&](const std::string& content) {
    return run({"distance", model, "--between", write("pairs.csv", content)}).errors;
  };
  EXPECT_TRUE(contains(refusal("0,6,7\n"), "a row of 3 points"));
  EXPECT_TRUE(contains(refusal("0,6\n1,x\n"), "row 2"));
  EXPECT_TRUE(contains(refusal("0,99\n"), "99"));
  EXPECT_NE(run({"distance", model, "--between", path("none.csv")}).exitCode, 0);
}

}  // namespace
}  // namespace girth::test
