// girth: the intrinsic girth function on the command line.
#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "commands.h"
#include "girth/io/length_unit.h"
#include "report.h"
#include "study_options.h"
#include "text/number_text.h"

namespace {

using namespace girth;
using namespace girth::cli;

constexpr const char* kFooter =
    "Models are glTF, GLB, OBJ, PLY, STL or OFF files. Vertices and faces are numbered as in the\n"
    "file, from 0.\n"
    "Exit codes: 0 done, 1 wrong usage, 2 bad input, 3 a limit was met or the work was cancelled,\n"
    "4 something is too thin to print.";

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

/// Adds `--weld`, `--close-holes`, `--component` and `--unit` to a command.
void addModelOptions(CLI::App& command, ModelOptions& options) {
  command.add_option("--weld", options.weldDistance,
                     "Also join vertices no farther apart than this length, as in 0.01 or 0.1mm");
  command.add_flag("--close-holes", options.closeHoles, "Fill every hole with faces");
  command
      .add_option("--component", options.components,
                  "Keep this component only: its number in girth info, or largest; may be given "
                  "several times")
      ->type_name("N|largest")
      ->take_all();
  std::vector<std::string> units;
  for (const io::LengthUnit& unit : io::lengthUnits()) units.emplace_back(unit.symbol);
  command
      .add_option("--unit", options.unit,
                  "What the file's numbers are, where it does not say: um, mm, cm, m, km, in or ft")
      ->check(CLI::IsMember(units));
}

int run(int argc, char** argv) {
  CLI::App app{
      "The intrinsic girth function of surfaces: the length of the shortest loop that can "
      "be drawn tight around a surface through each of its points."};
  app.name("girth");
  app.footer(kFooter);
  app.set_version_flag("--version", std::string("girth ") + GIRTH_VERSION);
  app.require_subcommand(1);
  const auto threadsOption = [](CLI::App* command, unsigned& threads) {
    command->add_option("--threads", threads, "Threads; as many as there are cores by default")
        ->check(CLI::Range(1u, 1024u));
  };

  InfoOptions info;
  CLI::App* infoCommand = app.add_subcommand("info", "Say what a model is");
  infoCommand->add_option("MODEL", info.models, "Models to read")->required();
  addModelOptions(*infoCommand, info.preparing);
  infoCommand->add_flag("--json", info.json, "Print one JSON object for each model");

  IgfOptions igf;
  CLI::App* igfCommand = app.add_subcommand("igf", "Compute the girth at every vertex");
  igfCommand->add_option("MODEL", igf.models, "Models to read")->required();
  addModelOptions(*igfCommand, igf.preparing);
  igfCommand->add_option(
      "-o,--output", igf.output,
      "Write the values: .csv, .json or .npy (the file's vertices), .ply or .glb (the surface)");
  igfCommand
      ->add_option_function<std::string>(
          "--method",
          [&](const std::string& name) {
            igf.naive = name == "naive";
            igf.method = name == "ms" ? GirthMethod::Marched : GirthMethod::Exact;
          },
          "exact (the default), naive, the slow reference implementation, or ms, the fast-marching "
          "approximation")
      ->check(CLI::IsMember({"exact", "naive", "ms"}));
  threadsOption(igfCommand, igf.threads);
  const auto facesRange = CLI::Range(std::uint32_t{4}, std::uint32_t{100'000'000});
  igfCommand
      ->add_option("--faces", igf.faces,
                   "Compute on the surface remeshed to so many faces, and carry the values back")
      ->check(facesRange);
  igfCommand->add_flag("--json", igf.json, "Print the summary as one JSON object for each model");
  igfCommand->add_flag("--stats", igf.stats, "Print what the computation took");

  LoopOptions loop;
  CLI::App* loopCommand =
      app.add_subcommand("loop", "Compute the loop at one vertex or at a point of a face");
  loopCommand->add_option("MODEL", loop.model, "The model to read")->required();
  addModelOptions(*loopCommand, loop.preparing);
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

  cli::RemeshOptions remeshing;
  CLI::App* remeshCommand =
      app.add_subcommand("remesh", "Write the surface with other triangles, as many as wanted");
  remeshCommand->add_option("MODEL", remeshing.model, "The model to read")->required();
  remeshCommand->add_option("--faces", remeshing.faces, "Triangles wanted; 10000 by default")
      ->check(facesRange);
  remeshCommand->add_flag("--even", remeshing.even,
                          "Triangles of even size and shape, instead of those that keep the "
                          "surface's shape best");
  remeshCommand
      ->add_option("-o,--output", remeshing.output, "Write it: .obj, .ply, .stl, .off or .glb")
      ->required();
  addModelOptions(*remeshCommand, remeshing.preparing);
  remeshCommand->add_flag("--difference", remeshing.difference,
                          "Compute the girth before and after, and print how far apart their "
                          "distributions are (equation 1 of the paper)");
  threadsOption(remeshCommand, remeshing.threads);
  remeshCommand->add_flag("--json", remeshing.json, "Print the summary as JSON");

  FieldOptions field;
  CLI::App* fieldCommand =
      app.add_subcommand("field", "Compute another field: thickness, centricity, ...");
  fieldCommand->add_option("MODEL", field.model, "The model to read")->required();
  addModelOptions(*fieldCommand, field.preparing);
  fieldCommand
      ->add_option("--field", field.field,
                   "sdf (shape diameter), geoaverage or geofarthest (mean and greatest distance), "
                   "hks, sihks or wks (heat and wave kernel signatures)")
      ->required()
      ->check(CLI::IsMember({"sdf", "geoaverage", "geofarthest", "hks", "sihks", "wks"}));
  fieldCommand->add_option("-o,--output", field.output,
                           "Write the values: .csv, .json, .npy, .ply or .glb");
  fieldCommand->add_option("--rays", field.rays, "sdf: rays from each vertex; 30 by default")
      ->check(CLI::Range(1u, 10'000u));
  fieldCommand
      ->add_option("--cone", field.coneDegrees, "sdf: opening of the cone, 120 degrees by default")
      ->check(CLI::Range(1e-3, 179.999));
  fieldCommand->add_flag("--exact", field.exactDistances,
                         "geoaverage, geofarthest: exact distances, not by fast marching");
  addSpectralFieldOptions(*fieldCommand, field.spectral);
  fieldCommand
      ->add_option("--maxima", field.maxima,
                   "List so many of the field's maxima, those that rise highest above their "
                   "surroundings first; with hks: persistent heat maxima")
      ->check(CLI::Range(std::uint32_t{1}, std::uint32_t{1'000'000}));
  threadsOption(fieldCommand, field.threads);
  fieldCommand->add_flag("--json", field.json, "Print the summary as JSON");

  TipsOptions tips;
  CLI::App* tipsCommand = app.add_subcommand("tips", "Find where the shape ends");
  tipsCommand->add_option("MODEL", tips.model, "The model to read")->required();
  addModelOptions(*tipsCommand, tips.preparing);
  tipsCommand->add_option("-o,--output", tips.output,
                          "Write the tips: .json, or .obj (their contours)");
  threadsOption(tipsCommand, tips.threads);
  tipsCommand->add_flag(
      "--stability", tips.stability,
      "Also find the tips with each triangle cut into four, and with noise of 5, 10 "
      "and 25% of the mean edge length, and say which are found again; takes about "
      "twelve times as long");
  tipsCommand->add_flag("--json", tips.json, "Print everything as JSON");

  // An empty one is a slip, such as a variable of a script that is not set: not the same as none.
  const auto isGiven = [](const std::string& length) {
    return length.empty() ? "the length is missing" : "";
  };
  PartsOptions parts;
  CLI::App* partsCommand =
      app.add_subcommand("parts", "Find tubes and plates, or what is too thin to print");
  partsCommand->add_option("MODEL", parts.model, "The model to read")->required();
  addModelOptions(*partsCommand, parts.preparing);
  partsCommand->add_option("--girth", parts.girth, "Tubes have a girth below this length (tau 1)")
      ->check(isGiven);
  partsCommand
      ->add_option("--thickness", parts.diameter,
                   "Tubes and plates are thinner than this length (tau 2)")
      ->check(isGiven);
  partsCommand
      ->add_option("--smooth", parts.smoothing,
                   "What all neighbours of a vertex count against its own kind; 0 by default")
      ->check(CLI::Range(0.0, 1e6));
  partsCommand
      ->add_option("--min-tube", parts.minTube,
                   "List tubes thinner than this diameter, as in 3mm; ends with 4")
      ->check(isGiven);
  partsCommand
      ->add_option("--min-wall", parts.minWall,
                   "List walls thinner than this, as in 1mm; ends with 4")
      ->check(isGiven);
  partsCommand->add_option("-o,--output", parts.output,
                           "Write the answer: .json, or every vertex with its part: .csv, .ply");
  threadsOption(partsCommand, parts.threads);
  partsCommand->add_flag("--json", parts.json, "Print everything as JSON");

  RetrieveOptions retrieve;
  CLI::App* retrieveCommand = app.add_subcommand(
      "retrieve", "Measure how well descriptors find shapes of the same class in a collection");
  addRetrieveOptions(*retrieveCommand, retrieve);

  SignatureCommandOptions signature;
  CLI::App* signatureCommand =
      app.add_subcommand("signature", "Write the histograms that a model is compared by");
  signatureCommand->add_option("MODEL", signature.model, "The model to read")->required();
  signatureCommand->add_option("-o,--output", signature.output, "Write them: .csv or .json")
      ->required();
  addComparisonOptions(*signatureCommand, signature);

  CompareOptions compare;
  CLI::App* compareCommand = app.add_subcommand("compare", "Say how far models are apart");
  compareCommand->add_option("MODEL", compare.models, "Two models or more")->required();
  addComparisonOptions(*compareCommand, compare);
  compareCommand->add_flag("--json", compare.json, "Print the distances as JSON");

  StudyOptions study;
  CLI::App* studyCommand = app.add_subcommand("study", "Repeat one of the paper's studies");
  addStudyOptions(*studyCommand, study);

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
  if (remeshCommand->parsed()) return runRemesh(remeshing);
  if (fieldCommand->parsed()) return runField(field);
  if (tipsCommand->parsed()) return runTips(tips);
  if (partsCommand->parsed()) return runParts(parts);
  if (retrieveCommand->parsed()) return runRetrieve(retrieve);
  if (signatureCommand->parsed()) return runSignature(signature);
  if (compareCommand->parsed()) return runCompare(compare);
  if (studyCommand->parsed()) return runStudy(*studyCommand, study);
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
