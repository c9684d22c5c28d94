// The girth command as a user runs it: what it prints, what it writes, and with which code it ends.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "command.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

TEST_F(Command, helpAndVersion) {
  const Outcome help = run({"--help"});
  EXPECT_EQ(help.exitCode, 0);
  for (const char* word : {"info", "igf", "loop", "Exit codes"}) {
    EXPECT_NE(help.output.find(word), std::string::npos) << word;
  }
  EXPECT_EQ(run({"igf", "--help"}).exitCode, 0);
  const Outcome version = run({"--version"});
  EXPECT_EQ(version.exitCode, 0);
  EXPECT_EQ(version.output.rfind("girth ", 0), 0u) << version.output;
}

TEST_F(Command, wrongUsageIsOneLineAndExitCodeOne) {
  const std::string prism = kData + "/prism.obj";
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"fly"},
                                                    {"igf"},
                                                    {"loop", prism},
                                                    {"loop", prism, "-3"},
                                                    {"loop", prism, "x"},
                                                    {"igf", prism, "--method", "guess"},
                                                    {"igf", prism, "--threads", "0"},
                                                    {"igf", prism, "-o", path("a.xyz")},
                                                    {"igf", prism, prism, "-o", path("a.csv")},
                                                    {"loop", prism, "3", "-o", path("a.ply")},
                                                    {"loop", prism, "44"},
                                                    {"loop", prism, "99999999999"},
                                                    {"loop", prism, "3", "--face", "3"},
                                                    {"loop", prism, "--face", "-1"},
                                                    {"loop", prism, "--face", "999"},
                                                    {"loop", prism, "--at", "1,0,0"},
                                                    {"loop", prism, "--face", "3", "--at", "1,0"},
                                                    {"loop", prism, "--face", "3", "--at", "1,0,x"},
                                                    {"loop", prism, "--face", "3", "--at", "1,1,0"},
                                                    {"info", prism, "--wings"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 1) << outcome.errors;
    EXPECT_EQ(linesOf(outcome.errors).size(), 1u) << outcome.errors;
    EXPECT_EQ(outcome.errors.rfind("girth: ", 0), 0u) << outcome.errors;
    EXPECT_EQ(outcome.output, "");
  }
}

TEST_F(Command, badInputIsOneLineAndExitCodeTwo) {
  struct Case {
    std::string file;
    const char* code;
    const char* words;
  };
  for (const Case& c : {Case{kData + "/bad/truncated.glb", "MALFORMED_FILE", "breaks off"},
                        Case{kData + "/bad/text.glb", "UNKNOWN_FORMAT", ".glb"},
                        Case{kData + "/bad/nan.obj", "NON_FINITE_POSITION", "line 2"},
                        Case{kData + "/bad/index.obj", "INDEX_OUT_OF_RANGE", "line 8"},
                        Case{kData + "/bad/empty.obj", "EMPTY_FILE", "empty"},
                        Case{path("nowhere.obj"), "FILE_NOT_FOUND", "no such file"},
                        Case{folder_.string(), "FILE_UNREADABLE", "folder"}}) {
    for (const char* command : {"info", "igf"}) {
      const Outcome outcome = run({command, c.file});
      EXPECT_EQ(outcome.exitCode, 2) << outcome.errors;
      ASSERT_EQ(linesOf(outcome.errors).size(), 1u) << outcome.errors;
      EXPECT_EQ(outcome.errors.rfind("girth: " + c.file + ": " + c.code + ": ", 0), 0u)
          << outcome.errors;
      EXPECT_NE(outcome.errors.find(c.words), std::string::npos) << outcome.errors;
      EXPECT_NE(outcome.errors.find("; "), std::string::npos) << outcome.errors;
    }
  }
}

TEST_F(Command, unwritableOutputIsFoundBeforeTheWork) {
  const Outcome outcome = run({"igf", kData + "/prism.obj", "-o", path("missing/a.csv")});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_NE(outcome.errors.find("FILE_UNWRITABLE"), std::string::npos) << outcome.errors;
}

TEST_F(Command, infoSaysWhatTheModelIs) {
  const Outcome text = run({"info", kData + "/prism.obj"});
  EXPECT_EQ(text.exitCode, 0) << text.errors;
  EXPECT_NE(text.output.find("closed surface, OBJ"), std::string::npos) << text.output;

  const Outcome outcome = run(
      {"info", kData + "/prism_seams.glb", kData + "/bad/nan.obj", kData + "/prism.obj", "--json"});
  EXPECT_EQ(outcome.exitCode, 2) << "one of them is bad";
  const auto lines = linesOf(outcome.output);
  ASSERT_EQ(lines.size(), 3u) << "the others are reported all the same";
  const Json info = Json::parse(lines[0]);
  EXPECT_EQ(info["format"], "GLB");
  EXPECT_EQ(info["unit"], "metre");
  EXPECT_EQ(info["report"]["inputVertices"], 168);
  EXPECT_EQ(info["vertices"], 44);
  EXPECT_EQ(info["report"]["weldedVertices"], 124);
  EXPECT_EQ(info["faces"], 84);
  EXPECT_EQ(info["genus"], Json::array({0}));
  EXPECT_DOUBLE_EQ(info["area"], 4 * 42.0);
  EXPECT_EQ(info["boundingBox"]["max"], Json::array({1, 1, 20}));
}

/// Two open strips of squares, the second one turned over at one face, and a vertex that is too
/// much.
const char* const kStrips =
    "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\n"
    "v 0 5 0\nv 1 5 0\nv 0 6 0\nv 1 6 0\nv 9 9 9\n"
    "f 1 2 5\nf 1 5 4\nf 2 3 6\nf 2 5 6\n"
    "f 7 8 10 9\n";

TEST_F(Command, infoSaysWhatWasDoneToTheFile) {
  const std::string model = write("strips.obj", kStrips);
  const Outcome text = run({"info", model});
  EXPECT_EQ(text.exitCode, 0) << text.errors;
  for (const char* line :
       {"open surface", "2 curves of 10 edges", "unit unknown", "1 face turned over",
        "1 vertex that no face uses", "0: 4 faces, area 2", "1: 2 faces, area 1"}) {
    EXPECT_NE(text.output.find(line), std::string::npos) << line << "\n" << text.output;
  }
  const Json info = Json::parse(run({"info", model, "--json", "--unit", "in"}).output);
  EXPECT_EQ(info["unit"], "inch");
  EXPECT_EQ(info["report"]["reorientedFaces"], 1);
  EXPECT_EQ(info["report"]["boundaryCurves"], 2);
  EXPECT_EQ(info["boundaries"], Json::array({1, 1}));
  EXPECT_EQ(info["byComponent"][1]["faces"], 2);
}

TEST_F(Command, componentsCanBeChosen) {
  const std::string model = write("strips.obj", kStrips);
  for (const char* largest : {"largest", "0"}) {
    const Json info = Json::parse(run({"info", model, "--json", "--component", largest}).output);
    EXPECT_EQ(info["faces"], 4);
    EXPECT_EQ(info["report"]["keptComponents"], 1);
  }
  EXPECT_EQ(Json::parse(run({"info", model, "--json", "--component", "1"}).output)["faces"], 2);
  EXPECT_EQ(
      Json::parse(
          run({"info", model, "--json", "--component", "1", "--component", "0"}).output)["faces"],
      6);
  for (const char* wrong : {"2", "-1", "x", ""}) {
    EXPECT_EQ(run({"info", model, "--component", wrong}).exitCode, 1) << wrong;
  }
}

TEST_F(Command, verticesCanBeWeldedWithinADistance) {
  // A square whose two triangles are a hair apart.
  const std::string model = write("hair.obj",
                                  "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0.001\nv 1 1 0.001\n"
                                  "v 0 1 0\nf 1 2 3\nf 4 5 6\n");
  EXPECT_EQ(Json::parse(run({"info", model, "--json"}).output)["components"], 2);
  EXPECT_EQ(Json::parse(run({"info", model, "--json", "--weld", "0.01"}).output)["components"], 1);
  EXPECT_EQ(
      Json::parse(
          run({"info", model, "--json", "--unit", "cm", "--weld", "0.1mm"}).output)["components"],
      1);
  EXPECT_EQ(run({"info", model, "--weld", "0.1mm"}).exitCode, 1) << "the unit is not known";
  EXPECT_EQ(run({"info", model, "--weld", "-1"}).exitCode, 1);
}

TEST_F(Command, tipsPartsAndFieldsOfASurface) {
  const std::string model = kData + "/prism.obj";
  const Outcome tips = run({"tips", model, "-o", path("tips.json"), "--json"});
  EXPECT_EQ(tips.exitCode, 0) << tips.errors;
  EXPECT_TRUE(Json::parse(tips.output)["tips"].is_array());
  EXPECT_EQ(contentOf(path("tips.json")), tips.output);
  EXPECT_EQ(run({"tips", model, "-o", path("tips.csv")}).exitCode, 1);
  EXPECT_FALSE(Json::parse(tips.output).contains("trials"));
  const Json trials = Json::parse(run({"tips", model, "--stability", "--json"}).output)["trials"];
  ASSERT_EQ(trials.size(), 4u);
  EXPECT_EQ(trials[0]["change"], "subdivided");
  EXPECT_EQ(trials[3]["noise"], 0.25);
  EXPECT_TRUE(trials[3]["found"].is_array());
  EXPECT_NE(run({"tips", model, "--stability"}).output.find("not found again"), std::string::npos);

  const Outcome field = run({"field", model, "--field", "sdf", "-o", path("sdf.csv"), "--json"});
  EXPECT_EQ(field.exitCode, 0) << field.errors;
  EXPECT_EQ(linesOf(contentOf(path("sdf.csv"))).size(), 45u);
  EXPECT_EQ(linesOf(contentOf(path("sdf.csv")))[0], "vertex,sdf");
  // A square prism of sides 1, 20 long.
  const Json thickness =
      Json::parse(run({"field", model, "--field", "thickness", "--json"}).output);
  EXPECT_EQ(thickness["method"], "sharp below 75 degrees");
  EXPECT_NEAR(thickness["min"], 1, 1e-9);
  EXPECT_EQ(run({"field", model, "--field", "thickness", "--sharp", "90"}).exitCode, 1);
  EXPECT_EQ(run({"field", model, "--field", "geoaverage"}).exitCode, 0);
  EXPECT_EQ(run({"field", model, "--field", "nothing"}).exitCode, 1);
  EXPECT_EQ(run({"field", model}).exitCode, 1);

  // Spectral ones: several numbers a vertex, or one of them; maxima of a field.
  const std::string csv = path("sihks.csv"), npy = path("wks.npy");
  EXPECT_EQ(run({"field", model, "--field", "sihks", "-o", csv}).exitCode, 0);
  EXPECT_TRUE(linesOf(contentOf(csv))[0].starts_with("vertex,sihks_1,sihks_2,"));
  EXPECT_TRUE(linesOf(contentOf(csv))[0].ends_with(",sihks_19"));
  const Outcome whole = run({"field", model, "--field", "wks", "-o", npy});
  EXPECT_EQ(whole.exitCode, 1);
  EXPECT_NE(whole.errors.find("--only"), std::string::npos);
  EXPECT_EQ(run({"field", model, "--field", "wks", "--only", "100", "-o", npy}).exitCode, 0);
  EXPECT_EQ(run({"field", model, "--field", "wks", "--only", "101", "-o", npy}).exitCode, 1);
  EXPECT_EQ(run({"field", model, "--field", "hks", "--time", "nan"}).exitCode, 1);
  EXPECT_EQ(run({"field", model, "--field", "hks", "--time", "0.1,0.2", "--maxima", "3"}).exitCode,
            1);
  const Json heat = Json::parse(
      run({"field", model, "--field", "hks", "--time", "0.01", "--maxima", "2", "--json"}).output);
  ASSERT_EQ(heat["maxima"].size(), 2u);
  EXPECT_GE(heat["maxima"][0]["persistence"], heat["maxima"][1]["persistence"]);
  EXPECT_EQ(heat["maxima"][0]["value"], heat["max"]);
  EXPECT_EQ(heat["components"], 1);

  // A square prism of sides 1, 20 long: all tube, 4 / π across.
  const Json parts = Json::parse(run({"parts", model, "--json"}).output);
  EXPECT_EQ(parts["parts"][0]["kind"], "tube");
  EXPECT_EQ(Json::parse(run({"parts", model, "--json", "--girth", "1", "--shape-diameter", "0.01"})
                            .output)["parts"][0]["kind"],
            "body");
  EXPECT_EQ(run({"parts", model, "--girth", "wide"}).exitCode, 1);
}

TEST_F(Command, partsEndsWithFourWhereSomethingIsTooThin) {
  const std::string model = kData + "/prism.obj";
  // A body that cannot be checked does not pass.
  write("sheet.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Outcome sheet = run({"parts", path("sheet.obj"), "--min-wall", "0.1"});
  EXPECT_EQ(sheet.exitCode, 2);
  EXPECT_NE(sheet.errors.find("NO_THICKNESS"), std::string::npos) << sheet.errors;
  const Outcome passes = run({"parts", model, "--unit", "mm", "--min-tube", "0.5mm"});
  EXPECT_EQ(passes.exitCode, 0) << passes.output << passes.errors;
  EXPECT_NE(passes.output.find("passes"), std::string::npos);
  const Outcome fails =
      run({"parts", model, "--unit", "mm", "--min-tube", "0.2cm", "--min-wall", "0.5", "--json"});
  EXPECT_EQ(fails.exitCode, 4) << fails.errors;
  const Json report = Json::parse(fails.output);
  EXPECT_EQ(report["passes"], false);
  EXPECT_EQ(report["limits"]["tubeDiameter"], 2);
  EXPECT_EQ(report["places"][0]["kind"], "tube");
  EXPECT_EQ(run({"parts", model, "--min-tube", "2mm"}).exitCode, 1) << "the unit is not known";
  const std::string glb = path("prism.glb"), ply = path("prism.ply");
  ASSERT_EQ(run({"remesh", model, "-o", glb}).exitCode, 0);
  EXPECT_EQ(run({"parts", glb, "--min-tube", "2mm"}).exitCode, 1) << "nor is it in a copy";
  ASSERT_EQ(run({"remesh", model, "--unit", "mm", "-o", ply}).exitCode, 0);
  EXPECT_EQ(run({"parts", ply, "--min-tube", "2mm"}).exitCode, 4);

  // From which scale it passes, by trying.
  EXPECT_GT(report["failingShare"], 0.5);
  const double scale = report["passingScale"];
  EXPECT_GT(scale, 1);
  for (const auto& [factor, exitCode] : {std::pair{1.001, 0}, std::pair{0.999, 4}}) {
    EXPECT_EQ(run({"parts", model, "--unit", "mm", "--min-tube", "2", "--min-wall", "0.5",
                   "--scale", std::to_string(factor * scale)})
                  .exitCode,
              exitCode);
  }
  const Outcome words = run({"parts", model, "--min-tube", "2"});
  EXPECT_NE(words.output.find("of the surface; passes from "), std::string::npos) << words.output;
}

TEST_F(Command, creasesFailWhereTheyAreToCount) {
  // A bar of three sides of 10: its edges have 60°.
  const std::string bar =
      write("bar.obj",
            "v 0 0 0\nv 10 0 0\nv 5 8.66 0\nv 0 0 40\nv 10 0 40\nv 5 8.66 40\nf 1 3 2\nf 4 5 6\n"
            "f 1 2 5\nf 1 5 4\nf 2 3 6\nf 2 6 5\nf 3 1 4\nf 3 4 6\n");
  const Outcome passes = run({"parts", bar, "--min-wall", "0.8"});
  EXPECT_EQ(passes.exitCode, 0);
  EXPECT_NE(passes.output.find("; 1 crease;"), std::string::npos) << passes.output;
  const Outcome counted = run({"parts", bar, "--min-wall", "0.8", "--creases", "--json"});
  EXPECT_EQ(counted.exitCode, 4);
  const Json report = Json::parse(counted.output);
  EXPECT_EQ(report["passes"], true);
  EXPECT_EQ(report["creases"][0]["kind"], "crease");
  EXPECT_NEAR(report["creases"][0]["length"].get<double>(), 120, 1e-9);
}

TEST_F(Command, scaleHeightAndUnits) {
  const std::string model = kData + "/prism.obj", glb = kData + "/prism_seams.glb";
  const auto info = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "info");
    arguments.emplace_back("--json");
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    return Json::parse(outcome.output);
  };
  const double area = info({model})["area"], metres = info({glb})["area"];
  EXPECT_EQ(info({model, "--scale", "2"})["area"], 4 * area);
  const Json box = info({model, "--height", "900mm", "--up", "x"});
  EXPECT_EQ(box["unit"], "millimetre") << "the height states it";
  const double low = box["boundingBox"]["min"][0], high = box["boundingBox"]["max"][0];
  EXPECT_NEAR(high - low, 900, 1e-9);
  EXPECT_EQ(info({model, "--unit", "cm", "--height", "0.2m", "--up", "x"})["unit"], "centimetre");

  // Numbers for people have no exponent, however large or small they are.
  for (const char* scale : {"0.00001", "10000000"}) {
    const Outcome text = run({"info", model, "--scale", scale});
    EXPECT_EQ(text.output.find("e-"), std::string::npos) << text.output;
    EXPECT_EQ(text.output.find("e+"), std::string::npos) << text.output;
  }

  // The unit that the file states, and the one that is shown.
  const Json shown = info({glb, "--in", "mm"});
  EXPECT_EQ(shown["unit"], "millimetre");
  EXPECT_NEAR(shown["area"].get<double>(), 1e6 * metres, 1e-6 * 1e6 * metres);
  const Outcome stated = run({"info", glb, "--unit", "mm", "--json"});
  EXPECT_NE(stated.errors.find("the file states metre"), std::string::npos) << stated.errors;
  EXPECT_EQ(Json::parse(stated.output)["area"], metres);
  EXPECT_EQ(run({"info", glb, "--unit", "m"}).errors, "");

  // Which way is up is asked where the format does not say it.
  const std::string off = write("flat.off",
                                "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 3\n3 0 2 1\n"
                                "3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  EXPECT_NE(run({"info", off, "--height", "6"}).errors.find("give it with --up"),
            std::string::npos);
  EXPECT_NEAR(info({off, "--height", "6", "--up", "z"})["boundingBox"]["max"][1], 2, 1e-12);

  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--scale", "0"},
                                                {"--scale", "-1"},
                                                {"--height", "0"},
                                                {"--height", "tall"},
                                                {"--height", "3 parsec"},
                                                {"--height", "1", "--scale", "2"},
                                                {"--in", "mm"},
                                                {"--up", "w", "--height", "1"}}) {
    std::vector<std::string> arguments{"info", model};
    arguments.insert(arguments.end(), wrong.begin(), wrong.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 1) << wrong[0] << " " << outcome.output;
    EXPECT_EQ(linesOf(outcome.errors).size(), 1u) << outcome.errors;
  }
}

TEST_F(Command, igfWritesARowForEveryVertexOfTheFile) {
  const Outcome outcome =
      run({"igf", kData + "/prism.obj", "-o", path("prism.csv"), "--threads", "2", "--stats"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "") << "no progress where standard error is no terminal";
  const auto rows = linesOf(contentOf(path("prism.csv")));
  ASSERT_EQ(rows.size(), 45u);
  EXPECT_EQ(rows[0], "vertex,igf,kind");
  for (std::size_t v = 0; v < 44; ++v) {
    EXPECT_EQ(rows[v + 1].rfind(std::to_string(v) + ",", 0), 0u) << rows[v + 1];
  }
  // Half-way along, the shortest loop is the cross-section.
  const std::string middle = rows[1 + 21];
  EXPECT_NEAR(std::strtod(middle.c_str() + middle.find(',') + 1, nullptr), 4.0, 1e-9) << middle;
  EXPECT_NE(middle.find(",loop"), std::string::npos) << middle;
}

TEST_F(Command, weldedVerticesShareTheirValue) {
  ASSERT_EQ(run({"igf", kData + "/prism.obj", "-o", path("a.json")}).exitCode, 0);
  ASSERT_EQ(run({"igf", kData + "/prism_seams.glb", "-o", path("b.json")}).exitCode, 0);
  const Json plain = Json::parse(contentOf(path("a.json")));
  const Json seams = Json::parse(contentOf(path("b.json")));
  EXPECT_EQ(plain["igf"].size(), 44u);
  EXPECT_EQ(seams["igf"].size(), 168u);
  EXPECT_TRUE(seams["complete"]);
  // The second quadrilateral's first corner is the first one's second; the GLB is twice as large.
  EXPECT_EQ(seams["igf"][1], seams["igf"][4]);
  EXPECT_NEAR(seams["igf"][4].get<double>(), 2 * plain["igf"][1].get<double>(), 1e-9);
}

TEST_F(Command, sameFileForAnyNumberOfThreads) {
  ASSERT_EQ(run({"igf", kData + "/prism.obj", "-o", path("1.ply"), "--threads", "1"}).exitCode, 0);
  ASSERT_EQ(run({"igf", kData + "/prism.obj", "-o", path("3.ply"), "--threads", "3"}).exitCode, 0);
  EXPECT_EQ(contentOf(path("1.ply")), contentOf(path("3.ply")));
  EXPECT_EQ(contentOf(path("1.ply")).rfind("ply\n", 0), 0u);
}

TEST_F(Command, naiveAgrees) {
  const Json exact = Json::parse(run({"igf", kData + "/prism.obj", "--json"}).output);
  const Json naive =
      Json::parse(run({"igf", kData + "/prism.obj", "--json", "--method", "naive"}).output);
  EXPECT_EQ(naive["method"], "naive");
  for (const char* key : {"min", "median", "max"}) {
    EXPECT_NEAR(naive[key].get<double>(), exact[key].get<double>(), 1e-9) << key;
  }
}

TEST_F(Command, remeshWritesAsManyFacesAsWanted) {
  const std::string prism = kData + "/prism.obj";
  for (const char* ending : {"obj", "ply", "stl", "off", "glb"}) {
    const std::string written = path(std::string("out.") + ending);
    const Outcome outcome = run({"remesh", prism, "--subdivide", "2000", "--faces", "1000",
                                 "--even", "-o", written, "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    const Json summary = Json::parse(outcome.output);
    EXPECT_EQ(summary["facesBefore"], 84);
    const Json info = Json::parse(run({"info", written, "--json"}).output);
    EXPECT_EQ(info["faces"], summary["faces"]);
    EXPECT_LE(info["faces"], 1000) << "at most so many";
    EXPECT_GE(info["faces"], 960);
    EXPECT_EQ(info["report"]["boundaryCurves"], 0) << ending;
    EXPECT_EQ(info["genus"], Json::array({0}));
    EXPECT_NEAR(info["area"].get<double>(), 42, 1e-5) << "its edges are sharp, and so stay";
  }
  // Fewer: those that fit best lie beside the surface, even ones on it, and on its sharp edges.
  const auto areaOf = [&](std::vector<std::string> options) {
    std::vector<std::string> arguments{"remesh", path("out.ply"), "-o", path("few.ply"), "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return Json::parse(run(arguments).output)["area"].get<double>();
  };
  const double fitting = areaOf({"--faces", "60"});
  EXPECT_NEAR(fitting, 42, 0.1);
  EXPECT_GT(std::fabs(fitting - 42), 1e-3);
  EXPECT_NEAR(areaOf({"--faces", "60", "--even"}), 42, 1e-5);
  const Json compared = Json::parse(run({"remesh", path("out.ply"), "--faces", "900", "-o",
                                         path("a.obj"), "--difference", "--json"})
                                        .output);
  EXPECT_GE(compared["difference"].get<double>(), 0);
  EXPECT_LT(compared["difference"].get<double>(), 0.05);
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"remesh", prism},
        {"remesh", prism, "-o", path("a.csv")},
        {"remesh", prism, "-o", path("a.obj"), "--faces", "3"},
        {"igf", prism, "--faces", "x"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 1) << outcome.errors;
    EXPECT_EQ(linesOf(outcome.errors).size(), 1u) << outcome.errors;
  }
}

TEST_F(Command, remeshSmoothsWhatIsRough) {
  const std::string prism = kData + "/prism.obj";
  ASSERT_EQ(run({"remesh", prism, "--subdivide", "20000", "-o", path("fine.ply"), "-q"}).exitCode,
            0);
  const auto smooth = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"remesh", path("fine.ply"), "-o",      path("smooth.ply"),
                                       "--json", "--force",        "--smooth"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    return Json::parse(outcome.output);
  };
  // Its edges are rounded off, its triangles are as many as before.
  const Json whole = smooth({"3"});
  EXPECT_EQ(whole["faces"], whole["facesBefore"]);
  EXPECT_GT(whole["faces"], 10'000) << "no fewer unless asked for";
  EXPECT_LT(whole["area"].get<double>(), 0.999 * whole["areaBefore"].get<double>());
  EXPECT_GT(whole["area"].get<double>(), 0.98 * whole["areaBefore"].get<double>());
  EXPECT_LE(smooth({"3", "--faces", "500"})["faces"], 500);
  const Outcome refused =
      run({"remesh", prism, "-o", path("smooth.ply"), "--force", "--smooth", "101"});
  EXPECT_EQ(refused.exitCode, 1);
  EXPECT_EQ(linesOf(refused.errors).size(), 1u) << refused.errors;
}

TEST_F(Command, facesAreAtMostAndRefiningIsAtLeastSoMany) {
  const std::string prism = kData + "/prism.obj";
  const auto facesOf = [&](std::vector<std::string> options) {
    std::vector<std::string> arguments{"remesh", prism, "-o", path("out.off"), "-q"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    return Json::parse(run({"info", path("out.off"), "--json"}).output)["faces"].get<int>();
  };
  EXPECT_EQ(facesOf({"--faces", "1000"}), 84);
  EXPECT_EQ(facesOf({}), 84);
  EXPECT_LE(facesOf({"--even"}), 84);
  EXPECT_LE(facesOf({"--faces", "60"}), 60);
  EXPECT_EQ(facesOf({"--subdivide", "80"}), 84);
  for (const int faces : {114, 3000, 20000}) {
    const int made = facesOf({"--subdivide", std::to_string(faces)});
    EXPECT_TRUE(made == faces || made == faces + 1) << made;
  }
  // The surface is the same one, and so are its values; those of the file's vertices come first.
  ASSERT_EQ(run({"igf", prism, "-o", path("a.json")}).exitCode, 0);
  ASSERT_EQ(run({"igf", prism, "--faces", "1000", "-o", path("b.json")}).exitCode, 0);
  EXPECT_EQ(contentOf(path("a.json")), contentOf(path("b.json"))) << "it has fewer anyway";
  ASSERT_EQ(run({"igf", prism, "--subdivide", "300", "-o", path("c.json")}).exitCode, 0);
  const Json before = Json::parse(contentOf(path("a.json")))["igf"];
  const Json after = Json::parse(contentOf(path("c.json")))["igf"];
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t v = 0; v < before.size(); ++v) {
    EXPECT_NEAR(before[v].get<double>(), after[v].get<double>(), 1e-9);
  }
}

TEST_F(Command, modelsAreComparedAsTheyAreRead) {
  // Two prisms in one file: one of them is chosen, in every command.
  const std::string prism = kData + "/prism.obj";
  std::string two = contentOf(prism);
  std::string second;
  for (const std::string& line : linesOf(two)) {
    if (line.rfind("v ", 0) != 0) continue;
    std::istringstream numbers(line.substr(2));
    double x = 0, y = 0, z = 0;
    numbers >> x >> y >> z;
    second +=
        "v " + std::to_string(x + 20) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
  }
  for (const std::string& line : linesOf(two)) {
    if (line.rfind("f ", 0) != 0) continue;
    std::istringstream words(line.substr(2));
    second += "f";
    for (std::string word; words >> word;) {
      second += " " + std::to_string(std::stoi(word) + 44);
    }
    second += "\n";
  }
  const std::string both = write("both.obj", two + second);
  const Json compared = Json::parse(
      run({"compare", both, prism, "--descriptors", "igf", "--component", "0", "--json"}).output);
  EXPECT_NEAR(compared["descriptors"][0]["distances"][0][1].get<double>(), 0, 1e-9);
  ASSERT_EQ(run({"signature", both, "--component", "1", "--own-size", "--unit", "mm", "-o",
                 path("s.json")})
                .exitCode,
            0);
  EXPECT_EQ(Json::parse(contentOf(path("s.json")))["unit"], "millimetre");
}

TEST_F(Command, igfOnARemeshedSurfaceComesBack) {
  const std::string prism = kData + "/prism.obj";
  ASSERT_EQ(run({"igf", prism, "-o", path("a.json")}).exitCode, 0);
  const Outcome outcome =
      run({"igf", prism, "--subdivide", "3000", "--faces", "2000", "-o", path("b.json")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const Json there = Json::parse(contentOf(path("a.json")));
  const Json back = Json::parse(contentOf(path("b.json")));
  ASSERT_EQ(back["igf"].size(), 44u) << "one for each vertex of the file";
  // Its sides are flat and its edges stay: the same surface, away from its ends.
  EXPECT_NEAR(back["igf"][21].get<double>(), there["igf"][21].get<double>(), 1e-6);
  EXPECT_EQ(back["kind"][21], "loop");
}

TEST_F(Command, loopAtAVertex) {
  const Outcome outcome = run({"loop", kData + "/prism.obj", "21", "--json", "-o", path("l.json")});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  const Json summary = Json::parse(outcome.output);
  EXPECT_EQ(summary["vertex"], 21);
  EXPECT_EQ(summary["kind"], "loop");
  EXPECT_NEAR(summary["length"].get<double>(), 4.0, 1e-9);
  const Json loop = Json::parse(contentOf(path("l.json")));
  EXPECT_EQ(loop["points"].front()["position"], loop["points"].back()["position"]);
  EXPECT_EQ(loop["points"].front()["vertices"], Json::array({21}));

  EXPECT_EQ(run({"loop", kData + "/prism.obj", "21", "-o", path("l.obj")}).exitCode, 0);
  EXPECT_NE(contentOf(path("l.obj")).find("\nl 1 2"), std::string::npos);
  EXPECT_EQ(run({"loop", kData + "/prism.obj", "21", "-o", path("l.csv")}).exitCode, 0);
  EXPECT_EQ(contentOf(path("l.csv")).rfind("x,y,z\n", 0), 0u);
}

TEST_F(Command, loopInAFace) {
  const std::string prism = kData + "/prism.obj";
  const Outcome corner = run({"loop", prism, "--face", "30", "--at", "0,1,0", "--json"});
  EXPECT_EQ(corner.exitCode, 0) << corner.errors;
  const Json atCorner = Json::parse(corner.output);
  const std::string vertex = std::to_string(atCorner["vertex"].get<int>());
  const Json atVertex = Json::parse(run({"loop", prism, vertex, "--json"}).output);
  EXPECT_EQ(atCorner, atVertex);

  const Outcome inside = run({"loop", prism, "--face", "30", "--at", "0.2,0.5,0.3", "--json"});
  EXPECT_EQ(inside.exitCode, 0) << inside.errors;
  const Json summary = Json::parse(inside.output);
  EXPECT_EQ(summary["vertex"], nullptr);
  EXPECT_EQ(summary["base"]["vertices"].size(), 3u);
  EXPECT_EQ(summary["base"]["vertices"][1], atCorner["vertex"]);
  EXPECT_EQ(summary["base"]["weights"], Json::array({0.2, 0.5, 0.3}));
  EXPECT_NEAR(summary["length"].get<double>(), 4.0, 1e-9);
  const Json middle = Json::parse(run({"loop", prism, "--face", "30", "--json"}).output);
  for (const Json& weight : middle["base"]["weights"])
    EXPECT_NEAR(weight.get<double>(), 1.0 / 3, 1e-15);
}

TEST_F(Command, facesKeepTheirNumbersAndCornersWhenTheyAreTurnedOver) {
  // Face 3 is the one that is turned over; its corners are vertices 1, 4 and 5 of the file.
  const std::string model = write("strips.obj", kStrips);
  const Json loop =
      Json::parse(run({"loop", model, "--face", "3", "--at", "0.2,0.3,0.5", "--json"}).output);
  const Json position = loop["base"]["position"];
  EXPECT_NEAR(position[0].get<double>(), 0.2 * 1 + 0.3 * 1 + 0.5 * 2, 1e-12);
  EXPECT_NEAR(position[1].get<double>(), 0.3 + 0.5, 1e-12);
  EXPECT_EQ(run({"loop", model, "--face", "6"}).exitCode, 1);
  EXPECT_EQ(run({"loop", model, "10"}).exitCode, 1) << "no face uses it";
}

TEST_F(Command, readsFilesBesideTheModelOnly) {
  fs::create_directory(folder_ / "models");
  write("secret.bin", "secret");
  fs::create_symlink(folder_ / "secret.bin", folder_ / "models" / "link.bin");
  for (const char* uri : {"../secret.bin", "link.bin", "/etc/passwd"}) {
    const std::string model = write(
        "models/a.gltf",
        R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":")" + std::string(uri) +
            R"("}],"bufferViews":[{"buffer":0,"byteLength":4}],"accessors":[{"bufferView":0,)"
            R"("componentType":5126,"count":1,"type":"VEC3"}],"meshes":[{"primitives":[{)"
            R"("attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}]})");
    const Outcome outcome = run({"info", model});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_NE(outcome.errors.find("MISSING_RESOURCE"), std::string::npos) << outcome.errors;
  }
}

}  // namespace
}  // namespace girth::test
