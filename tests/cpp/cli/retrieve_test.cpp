// girth retrieve, signature, compare and study as a user runs them, on shapes written by the test.
#include <gtest/gtest.h>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "command.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

/// A box of a × b × c with each side cut into n × n squares, as OBJ.
std::string boxObj(double a, double b, double c, int n) {
  std::string vertices, faces;
  int count = 0;
  for (int side = 0; side < 6; ++side) {
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) {
        const double s = double(i) / n, t = double(j) / n, u = side % 2;
        const double p[3][3] = {{u, s, t}, {s, u, t}, {s, t, u}};
        const double* q = p[side / 2];
        vertices += "v " + std::to_string(a * q[0]) + " " + std::to_string(b * q[1]) + " " +
                    std::to_string(c * q[2]) + "\n";
      }
    }
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const int k = count + i * (n + 1) + j + 1;
        const bool turned = (side % 2 == 1) != (side / 2 == 1);
        const std::string o = std::to_string(k), r = std::to_string(k + 1),
                          d = std::to_string(k + n + 1), x = std::to_string(k + n + 2);
        faces += turned ? "f " + o + " " + d + " " + x + "\nf " + o + " " + x + " " + r + "\n"
                        : "f " + o + " " + x + " " + d + "\nf " + o + " " + r + " " + x + "\n";
      }
    }
    count += (n + 1) * (n + 1);
  }
  return vertices + faces;
}

/// Rods, plates and cubes, three of each, of slightly different proportions and quite different
/// sizes: any descriptor that is worth its name tells them apart.
class Retrieve : public Command {
 protected:
  Retrieve() {
    fs::create_directories(path("shapes/rod"));
    fs::create_directories(path("shapes/plate"));
    fs::create_directories(path("shapes/cube"));
    for (int i = 0; i < 3; ++i) {
      const std::string name = std::to_string(i) + ".obj";
      const double size = i + 1, more = 1 + 0.03 * i;
      write("shapes/rod/r" + name, boxObj(8 * size, more * size, size, 3));
      write("shapes/plate/p" + name, boxObj(6 * size, 6 * more * size, 0.5 * size, 3));
      write("shapes/cube/c" + name, boxObj(size, more * size, size, 3));
    }
  }

  std::vector<std::string> arguments(const std::string& report,
                                     const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"retrieve",
                                 path("shapes"),
                                 "-o",
                                 path(report),
                                 "--descriptors",
                                 "igf,sdf,igf-sdf,igf+sdf",
                                 "--threads",
                                 "2"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  Json study(const std::string& report) const {
    return Json::parse(contentOf(path(report + "/study.json")));
  }

  static bool says(const Outcome& outcome, const std::string& text) {
    return outcome.errors.find(text) != std::string::npos;
  }

  std::vector<fs::path> cacheEntries(const std::string& folder) const {
    std::vector<fs::path> entries;
    for (const auto& entry : fs::recursive_directory_iterator(path(folder))) {
      if (entry.is_regular_file()) entries.push_back(entry.path());
    }
    return entries;
  }
};

TEST_F(Retrieve, foldersAreClassesAndTheReportIsComplete) {
  const Outcome outcome = run(arguments("report"));
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const Json result = study("report");
  EXPECT_EQ(result["models"].size(), 9u);
  EXPECT_EQ(result["classes"], (std::vector<std::string>{"cube", "plate", "rod"}));
  ASSERT_EQ(result["descriptors"].size(), 4u);
  for (const Json& descriptor : result["descriptors"]) {
    EXPECT_EQ(descriptor["queries"], 9);
    EXPECT_EQ(descriptor["firstTier"], 1.0) << descriptor["name"];
    EXPECT_EQ(descriptor["discountedGain"], 1.0);
    EXPECT_EQ(descriptor["precision"].size(), 20u);
  }
  EXPECT_EQ(linesOf(contentOf(path("report/measures.csv"))).size(), 5u);
  EXPECT_EQ(linesOf(contentOf(path("report/precision_recall.csv"))).size(), 81u);
  EXPECT_EQ(linesOf(contentOf(path("report/queries.csv"))).size(), 37u);
  EXPECT_EQ(linesOf(contentOf(path("report/distances/igf+sdf.csv"))).size(), 10u);
  const std::string page = contentOf(path("report/index.html"));
  EXPECT_NE(page.find("data:image/png;base64,"), std::string::npos);
  EXPECT_EQ(page.find("http"), std::string::npos) << "needs no network";
  EXPECT_EQ(page.find("<script"), std::string::npos);
}

TEST_F(Retrieve, aSecondRunTakesAllFieldsFromTheCacheAndSaysTheSame) {
  ASSERT_EQ(run(arguments("one")).exitCode, 0);
  const Outcome again = run(arguments("two", {"--cache", path("one/cache")}));
  ASSERT_EQ(again.exitCode, 0);
  EXPECT_NE(again.output.find("0 fields computed, 18 from the cache"), std::string::npos)
      << again.output;
  EXPECT_EQ(contentOf(path("one/measures.csv")), contentOf(path("two/measures.csv")));
  EXPECT_EQ(contentOf(path("one/distances/igf.csv")), contentOf(path("two/distances/igf.csv")));
}

TEST_F(Retrieve, otherParametersAreOtherEntries) {
  ASSERT_EQ(run(arguments("one")).exitCode, 0);
  const Outcome other = run(arguments("two", {"--cache", path("one/cache"), "--own-size"}));
  ASSERT_EQ(other.exitCode, 0);
  EXPECT_NE(other.output.find("18 fields computed"), std::string::npos) << other.output;
}

TEST_F(Retrieve, modelsArePreparedAsAsked) {
  ASSERT_EQ(run(arguments("clean")).exitCode, 0);
  // Each model gets a pedestal that is not joined to it, and smaller.
  for (const auto& entry : fs::recursive_directory_iterator(path("shapes"))) {
    if (!entry.is_regular_file()) continue;
    std::ofstream(entry.path(), std::ios::app)
        << "v 99 0 0\nv 99.1 0 0\nv 99 0.1 0\nv 99 0 0.1\nf -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\n"
           "f -3 -2 -1\n";
  }
  const std::vector<std::string> cache{"--cache", path("clean/cache")};
  ASSERT_EQ(run(arguments("whole", cache)).exitCode, 0);
  EXPECT_NE(contentOf(path("whole/distances/igf.csv")), contentOf(path("clean/distances/igf.csv")));
  const Outcome largest = run(arguments(
      "largest", {"--cache", path("clean/cache"), "--component", "largest", "--unit", "mm"}));
  ASSERT_EQ(largest.exitCode, 0) << largest.errors;
  EXPECT_NE(largest.output.find("18 fields computed, 0 from the cache"), std::string::npos)
      << "not those of the whole models: " << largest.output;
  EXPECT_EQ(contentOf(path("largest/distances/igf.csv")),
            contentOf(path("clean/distances/igf.csv")));
  EXPECT_NE(contentOf(path("largest/index.html")).find("--component largest --unit mm"),
            std::string::npos);
}

TEST_F(Retrieve, roughModelsAreSmoothedAsAsked) {
  const auto distances = [&](const std::vector<std::string>& options) {
    EXPECT_EQ(run(arguments("report", options)).exitCode, 0);
    return contentOf(path("report/distances/igf.csv"));
  };
  const std::string asTheyAre = distances({});
  EXPECT_EQ(distances({"--smooth", "0"}), asTheyAre);
  EXPECT_NE(distances({"--smooth", "2"}), asTheyAre) << "of its own in the cache";
  const Outcome refused = run(arguments("report", {"--smooth", "101"}));
  EXPECT_EQ(refused.exitCode, 1);
  EXPECT_EQ(linesOf(refused.errors).size(), 1u) << refused.errors;

  // Distances are not those that typical ones were measured with.
  const std::string model = path("shapes/rod/r0.obj");
  const Json compared =
      Json::parse(run({"compare", model, model, "--smooth", "2", "--json"}).output);
  EXPECT_TRUE(compared["descriptors"][0]["typical"].is_null());
}

TEST_F(Retrieve, aDamagedCacheIsComputedAgainAndSaidSo) {
  ASSERT_EQ(run(arguments("one")).exitCode, 0);
  const std::string before = contentOf(path("one/distances/igf-sdf.csv"));
  const std::vector<fs::path> entries = cacheEntries("one/cache");
  ASSERT_EQ(entries.size(), 18u);
  // One byte in the middle of one, the second half of another lost, a third one emptied.
  {
    std::fstream file(entries[0], std::ios::in | std::ios::out | std::ios::binary);
    const auto middle = static_cast<std::streamoff>(fs::file_size(entries[0]) / 2);
    file.seekg(middle);
    const char byte = static_cast<char>(file.get() ^ 1);
    file.seekp(middle);
    file.put(byte);
  }
  fs::resize_file(entries[1], fs::file_size(entries[1]) / 2);
  fs::resize_file(entries[2], 0);
  const Outcome again = run(arguments("one"));
  ASSERT_EQ(again.exitCode, 0);
  EXPECT_NE(again.output.find("3 fields computed, 15 from the cache"), std::string::npos)
      << again.output;
  EXPECT_TRUE(says(again, "is damaged; computed again")) << again.errors;
  EXPECT_EQ(contentOf(path("one/distances/igf-sdf.csv")), before);
  EXPECT_NE(run(arguments("one")).output.find("0 fields computed"), std::string::npos);
}

TEST_F(Retrieve, aRunThatIsStoppedGoesOnWhereItWas) {
  for (int i = 0; i < 12; ++i) {
    write("shapes/rod/more" + std::to_string(i) + ".obj", boxObj(9, 1 + 0.01 * i, 1, 10));
  }
  const Process child = start(arguments("report"));
  // Until something is in the cache.
  for (int i = 0;
       i < 6000 && (!fs::exists(path("report/cache")) || cacheEntries("report/cache").empty());
       ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ASSERT_TRUE(interrupt(child));
  const Outcome stopped = wait(child);
  // A very fast machine may have finished.
  ASSERT_TRUE(stopped.exitCode == 3 || stopped.exitCode == 0) << stopped.errors;
  if (stopped.exitCode == 3) {
    EXPECT_TRUE(says(stopped, "CANCELLED")) << stopped.errors;
    EXPECT_FALSE(fs::exists(path("report/study.json")));
  }
  const std::size_t kept = cacheEntries("report/cache").size();
  EXPECT_GT(kept, 0u);
  const Outcome again = run(arguments("report"));
  ASSERT_EQ(again.exitCode, 0) << again.errors;
  EXPECT_NE(again.output.find(std::to_string(42 - kept) + " fields computed, " +
                              std::to_string(kept) + " from the cache"),
            std::string::npos)
      << again.output;
}

TEST_F(Retrieve, twoProcessesFillOneCache) {
  const std::vector<std::string> shared{"--cache", path("shared")};
  const auto shardArguments = [&](const std::string& shard) {
    return arguments("report", {"--cache", path("shared"), "--shard", shard});
  };
  // Both at once, as on two machines.
  const Process first = start(shardArguments("0/2"));
  const Process second = start(shardArguments("1/2"));
  EXPECT_EQ(wait(first).exitCode, 0);
  EXPECT_EQ(wait(second).exitCode, 0);
  EXPECT_FALSE(fs::exists(path("report/study.json"))) << "a share makes no report";
  EXPECT_EQ(cacheEntries("shared").size(), 18u);
  const Outcome whole = run(arguments("report", shared));
  ASSERT_EQ(whole.exitCode, 0);
  EXPECT_NE(whole.output.find("0 fields computed, 18 from the cache"), std::string::npos)
      << whole.output;
  ASSERT_EQ(run(arguments("alone")).exitCode, 0);
  EXPECT_EQ(contentOf(path("report/distances/igf-sdf.csv")),
            contentOf(path("alone/distances/igf-sdf.csv")));
}

TEST_F(Retrieve, absentUnreadableDuplicateAndLonelyModelsAreSaidAndTheRestGoesOn) {
  write("shapes/broken.obj", "this is no model");
  write("shapes/copy.obj", contentOf(path("shapes/rod/r0.obj")));
  write("shapes/classes.csv",
        "file,class\n"
        "rod/r0.obj,rod\nrod/r1.obj,rod\nrod/r2.obj,rod\n"
        "rod/r1.obj,rod\n"    // twice
        "rod/r2.obj,plate\n"  // in two classes
        "plate/p0.obj,plate\nplate/p1.obj,plate\n"
        "nowhere.obj,plate\n"  // absent
        "broken.obj,plate\n"   // unreadable
        "copy.obj,rod\n"       // the content of another
        "cube/c0.obj,\"a cube, alone\"\n"
        "cube/c1.obj,\n"       // no class
        "gone1.obj,ghost\n");  // its class is left empty
  const Outcome outcome = run(arguments("report"));
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_TRUE(says(outcome, "rod/r1.obj: it is listed twice; counted once"));
  EXPECT_TRUE(says(outcome, "rod/r2.obj: it is listed twice, in rod and in plate"));
  EXPECT_TRUE(says(outcome, "nowhere.obj: there is no such file; left out"));
  EXPECT_TRUE(says(outcome, "broken.obj: left out: "));
  EXPECT_TRUE(says(outcome, "copy.obj: it is a copy of rod/r0.obj; both count") ||
              says(outcome, "rod/r0.obj: it is a copy of copy.obj; both count"));
  EXPECT_TRUE(says(outcome, "class a cube, alone: it has one model only"));
  EXPECT_TRUE(says(outcome, "line 13: there is no class in it; left out")) << outcome.errors;
  EXPECT_TRUE(says(outcome, "class ghost: it has no models; left out"));
  const Json result = study("report");
  EXPECT_EQ(result["models"].size(), 7u);
  EXPECT_EQ(result["descriptors"][0]["queries"], 6) << "the lonely cube is not asked for";
  ASSERT_EQ(result["failed"].size(), 1u);
  EXPECT_EQ(result["failed"][0]["file"], "broken.obj");
}

TEST_F(Retrieve, aClassWhoseModelsAllFailIsSaid) {
  fs::create_directories(path("shapes/bad"));
  fs::create_directories(path("shapes/nothing"));
  write("shapes/bad/x.off", "OFF\n1 0 0\n0 0 0\n");
  fs::create_symlink(path("gone.obj"), path("shapes/rod/link.obj"));
  const Outcome outcome = run(arguments("report"));
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_TRUE(says(outcome, "class bad: none of its models could be used")) << outcome.errors;
  EXPECT_TRUE(says(outcome, "class nothing: it has no models; left out")) << outcome.errors;
  EXPECT_TRUE(says(outcome, "rod/link.obj: there is no such file; left out")) << outcome.errors;
}

TEST_F(Retrieve, readsTheClassFilesOfThePrincetonShapeBenchmark) {
  fs::create_directories(path("psb/db/0"));
  for (int i = 0; i < 3; ++i) {
    const std::string number = std::to_string(i);
    fs::copy(path("shapes/rod/r" + number + ".obj"), path("psb/db/0/m" + number + ".obj"));
    fs::copy(path("shapes/cube/c" + number + ".obj"), path("psb/db/T1" + number + ".obj"));
  }
  write("psb/test.cla",
        "PSB 1\n4 6\n\nthings 0 0\n\nrod things 3\n0\n1\n2\n\ncube things 3\n10\n11\n77\n"
        "hollow things 0\n");
  const Outcome outcome =
      run({"retrieve", path("psb"), "-o", path("report"), "--descriptors", "igf"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(study("report")["models"].size(), 5u);
  EXPECT_EQ(study("report")["classes"], (std::vector<std::string>{"cube", "rod"}));
  EXPECT_TRUE(says(outcome, "there is no model 77; left out")) << outcome.errors;
  EXPECT_TRUE(says(outcome, "class hollow: it has no models")) << outcome.errors;
  EXPECT_FALSE(says(outcome, "class things")) << "a class of classes is not empty";
  write("psb/test.cla", "PSB 1\n2 3\nrod 0 3\n0\n1\n");
  const Outcome cut = run({"retrieve", path("psb"), "-o", path("report")});
  EXPECT_EQ(cut.exitCode, 2);
  EXPECT_TRUE(says(cut, "MALFORMED_FILE")) << cut.errors;
}

TEST_F(Retrieve, wrongUsageIsOneLine) {
  const std::string shapes = path("shapes");
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"retrieve", shapes},
        {"retrieve", shapes, "-o", path("r"), "--descriptors", "ifg"},
        {"retrieve", shapes, "-o", path("r"), "--descriptors", "igf+"},
        {"retrieve", shapes, "-o", path("r"), "--descriptors", "-1*igf"},
        {"retrieve", shapes, "-o", path("r"), "--shard", "2/2"},
        {"retrieve", shapes, "-o", path("r"), "--shard", "1"},
        {"retrieve", shapes, "-o", path("r"), "--shard", "a/b"},
        {"retrieve", shapes, "-o", path("r"), "--classes", "a.csv", "--classes", "b.csv"},
        {"compare", shapes + "/rod/r0.obj"},
        {"compare", shapes + "/rod/r0.obj", shapes + "/rod/r1.obj", "--descriptors", "igf+sdf"},
        {"signature", shapes + "/rod/r0.obj", "-o", path("s.txt")},
        {"signature", shapes + "/rod/r0.obj", "-o", path("s.csv"), "--descriptors", "igf-sdf"},
        {"study"}}) {
    const Outcome outcome = run(wrong);
    EXPECT_EQ(outcome.exitCode, 1) << outcome.errors;
    EXPECT_EQ(linesOf(outcome.errors).size(), 1u) << outcome.errors;
  }
  EXPECT_EQ(run({"retrieve", path("nowhere"), "-o", path("r")}).exitCode, 2);
  write("shapes/classes.csv", "name,kind\na,b\n");
  EXPECT_EQ(run(arguments("r")).exitCode, 2);
  write("file", "");
  EXPECT_EQ(run(arguments("file")).exitCode, 2) << "the report's folder is a file";
}

TEST_F(Retrieve, signatureIsAHistogramThatAddsUpToOne) {
  const Outcome outcome = run({"signature", path("shapes/rod/r0.obj"), "--descriptors",
                               "igf,log-sdf", "-o", path("s.json")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const Json signature = Json::parse(contentOf(path("s.json")));
  ASSERT_EQ(signature["signatures"].size(), 2u);
  for (const Json& one : signature["signatures"]) {
    EXPECT_EQ(one["shares"].size(), 512u);
    double sum = 0;
    for (const Json& share : one["shares"]) sum += share.get<double>();
    EXPECT_NEAR(sum, 1, 1e-12);
  }
  ASSERT_EQ(
      run({"signature", path("shapes/rod/r0.obj"), "--bins", "8", "-o", path("s.csv")}).exitCode,
      0);
  EXPECT_EQ(linesOf(contentOf(path("s.csv"))).size(), 9u);
}

TEST_F(Retrieve, compareDoesNotCareForSizeAndIsSymmetric) {
  write("small.obj", boxObj(8, 1, 1, 4));
  write("large.obj", boxObj(128, 16, 16, 4));  // without rounding
  const Outcome outcome = run(
      {"compare", path("small.obj"), path("large.obj"), path("shapes/cube/c0.obj"), "--descriptors",
       "igf,igf-ms,sdf,geoaverage,geofarthest,hks,sihks,wks,igf-sdf", "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const Json result = Json::parse(outcome.output);
  EXPECT_EQ(result["models"].size(), 3u);
  ASSERT_EQ(result["descriptors"].size(), 9u);
  for (const Json& descriptor : result["descriptors"]) {
    const Json& d = descriptor["distances"];
    EXPECT_LT(d[0][1].get<double>(), 1e-6) << descriptor["name"];
    EXPECT_GT(d[0][2].get<double>(), 1e-3) << descriptor["name"];
    EXPECT_EQ(d[0][2], d[2][0]);
    EXPECT_EQ(d[1][1], 0);
  }
}

TEST_F(Retrieve, compareCountsFeaturesSoftlyUnlessToldOtherwise) {
  const auto hks = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments{"compare",
                                       path("shapes/rod/r0.obj"),
                                       path("shapes/rod/r1.obj"),
                                       path("shapes/cube/c0.obj"),
                                       "--descriptors",
                                       "hks",
                                       "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    return outcome.output;
  };
  EXPECT_EQ(hks({}), hks({"--soft-words"}));
  EXPECT_NE(hks({}), hks({"--nearest-words"}));
}

TEST_F(Retrieve, accuracyOfTheMarchedGirth) {
  const Outcome outcome =
      run({"study", "accuracy", path("shapes/rod/r0.obj"), path("shapes/rod/r1.obj")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(linesOf(outcome.output).size(), 4u) << "a header, two models, and all";
}

}  // namespace
}  // namespace girth::test
