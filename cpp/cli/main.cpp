// girth: the intrinsic girth function on the command line.
#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <exception>
#include <map>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "commands.h"
#include "girth/io/number_text.h"
#include "report.h"

namespace {

using namespace girth;
using namespace girth::cli;

constexpr const char* kFooter =
    "Models are GLB, glTF or OBJ files and must be closed surfaces. Vertices are numbered as in "
    "the\n"
    "file, from 0.\n"
    "Exit codes: 0 done, 1 wrong usage, 2 bad input, 3 a limit was met or the work was cancelled.";

/// Not read by CLI11, which rounds twice.
std::array<double, 3> weightsOf(const std::vector<std::string>& texts) {
  std::array<double, 3> weights{};
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const std::optional<double> weight = io::parseNumber(texts[i]);
    if (!weight) throw CLI::ConversionError(texts[i], "--at");
    weights[i] = *weight;
  }
  return weights;
}

int run(int argc, char** argv) {
  CLI::App app{
      "The intrinsic girth function of surfaces: the length of the shortest loop that can "
      "be drawn tight around a surface through each of its points."};
  app.name("girth");
  app.footer(kFooter);
  app.set_version_flag("--version", std::string("girth ") + GIRTH_VERSION);
  app.require_subcommand(1);

  InfoOptions info;
  CLI::App* infoCommand = app.add_subcommand("info", "Say what a model is");
  infoCommand->add_option("MODEL", info.models, "Models to read")->required();
  infoCommand->add_flag("--json", info.json, "Print one JSON object for each model");

  IgfOptions igf;
  const std::map<std::string, GirthMethod> methods{{"exact", GirthMethod::Exact},
                                                   {"naive", GirthMethod::Naive}};
  CLI::App* igfCommand = app.add_subcommand("igf", "Compute the girth at every vertex");
  igfCommand->add_option("MODEL", igf.models, "Models to read")->required();
  igfCommand->add_option(
      "-o,--output", igf.output,
      "Write the values: .csv, .json or .npy (the file's vertices), .ply or .glb (the surface)");
  igfCommand
      ->add_option_function<std::string>(
          "--method", [&](const std::string& name) { igf.method = methods.at(name); },
          "exact (the default) or naive, the slow yardstick")
      ->check(CLI::IsMember({"exact", "naive"}));
  igfCommand->add_option("--threads", igf.threads, "Threads; as many as there are cores by default")
      ->check(CLI::Range(1u, 1024u));
  igfCommand->add_flag("--json", igf.json, "Print the summary as one JSON object for each model");
  igfCommand->add_flag("--stats", igf.stats, "Print what the computation took");

  LoopOptions loop;
  CLI::App* loopCommand =
      app.add_subcommand("loop", "Compute the loop at one vertex or at a point of a face");
  loopCommand->add_option("MODEL", loop.model, "The model to read")->required();
  auto* vertex =
      loopCommand->add_option("VERTEX", loop.vertex, "A vertex, numbered as in the file from 0");
  auto* face = loopCommand
                   ->add_option("--face", loop.face,
                                "A face instead, numbered from 0; polygons count as the triangles "
                                "they are cut into")
                   ->excludes(vertex);
  loopCommand
      ->add_option_function<std::vector<std::string>>(
          "--at", [&](const std::vector<std::string>& texts) { loop.weights = weightsOf(texts); },
          "Where in the face: the shares of its three vertices, A,B,C; its middle by default")
      ->delimiter(',')
      ->expected(3)
      ->type_name("A,B,C")
      ->needs(face);
  loopCommand->add_option("-o,--output", loop.output,
                          "Write the loop: .json, .obj or .glb (a polyline) or .csv (x,y,z)");
  loopCommand->add_flag("--json", loop.json, "Print the summary as JSON");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help and version come this way too.
    if (error.get_exit_code() == 0) return app.exit(error);
    const bool unknownCommand = argc > 1 && argv[1][0] != '-' && app.get_subcommands().empty();
    return reportError("", makeError(ErrorCode::Usage, -1,
                                     unknownCommand ? "there is no command " + std::string(argv[1])
                                                    : std::string(error.what())));
  }
  if (infoCommand->parsed()) return runInfo(info);
  if (igfCommand->parsed()) return runIgf(igf);
  return runLoop(loop);
}

}  // namespace

int main(int argc, char** argv) {
  int exitCode = 0;
  try {
    exitCode = run(argc, argv);
  } catch (const std::bad_alloc&) {
    exitCode = reportError("", makeError(ErrorCode::OutOfMemory, -1, "there is not enough memory"));
  } catch (const std::exception& error) {
    exitCode = reportError("", makeError(ErrorCode::Internal, -1, error.what()));
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    const int unwritable = reportError(
        "standard output", makeError(ErrorCode::FileUnwritable, -1, "it cannot be written"));
    if (exitCode == 0) exitCode = unwritable;
  }
  return exitCode;
}
