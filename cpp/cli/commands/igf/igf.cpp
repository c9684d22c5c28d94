// girth igf: the girth at every vertex.
#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands/common_options.h"
#include "commands/igf/compute.h"
#include "commands/igf/content.h"
#include "commands/igf/options.h"
#include "commands/igf/stopped.h"
#include "commands/igf/summary.h"
#include "commands/table.h"
#include "model/computing.h"
#include "model/loading.h"
#include "model/persistence.h"
#include "process/files.h"
#include "process/jobs.h"
#include "process/report.h"

namespace girth::cli {
namespace igf_command {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

int runOne(const std::string& model, const Options& options) {
  Timing timing;
  const auto readingStart = Clock::now();
  const auto loaded = loadModel(model, options.preparing);
  if (!loaded) return reportError(model, loaded.error());
  const auto persistence = persistenceOf(options.persistence, loaded.value());
  if (!persistence) return reportError(model, persistence.error());
  Work work{model, loaded.value(), persistence.value()};
  timing.reading = secondsSince(readingStart);
  // Not only after everything is computed.
  if (const auto bases = basesOf(loaded.value(), options); !bases) {
    return reportError(model, bases.error());
  }

  const auto computingStart = Clock::now();
  std::optional<RemeshedSurface> remeshed;
  std::vector<Vertex> rows = work.loaded.vertexOfInput;
  if (options.faces > 0) {
    auto result = remeshModel(model, work.loaded.mesh, {options.faces});
    if (!result) return reportError(model, result.error());
    remeshed = std::move(result).value();
  }
  if (remeshed) {
    rows.clear();
    for (const Vertex v : remeshed->mesh.vertices()) rows.push_back(v);
    work.fewerFaces = remeshed->mesh.faceCount();
  }
  const SurfaceMesh& mesh = remeshed ? remeshed->mesh : work.loaded.mesh;
  const std::string method = particulars(options, work);
  const PartialField partial(options.output.path, model, mesh, rows, method);
  if (const auto error = clearPartial(model, partial, options)) {
    return reportError(options.output.path, *error);
  }
  std::vector<Barcode> barcodes;
  if (options.barcodes.isWanted()) {
    noteLargeSurface(model, mesh, kRemeshFirst);
    auto found = computeBarcodes(model, mesh, work.persistence, options.threads);
    if (!found) return reportError(model, found.error());
    barcodes = std::move(found).value();
  }
  std::optional<RefinedGirth> refined;
  if (options.refined) {
    auto result = computeRefined(model, mesh, options);
    if (!result) {
      Error error = result.error();
      if (error.code == ErrorCode::Cancelled) {
        error.message = "stopped; the refined method keeps nothing of a run that is stopped";
        error.hint = "";
      }
      return reportError(model, error);
    }
    refined = std::move(result).value();
    work.refined = &*refined;
  }
  // Bars leave out loops without any persistence, which the girth counts.
  const bool isRead = !barcodes.empty() && work.persistence > 0;
  auto computed = refined  ? std::move(refined->field)
                  : isRead ? girthOf(barcodes, work.persistence)
                           : computeAll(model, mesh, partial, options, work.persistence);
  if (!computed) return reportError(partial.path(), computed.error());
  GirthField& field = computed.value();
  if (!field.complete()) return reportStopped(model, field, partial, options);
  if (remeshed) field = fieldOnOriginal(field, remeshed->mesh, work.loaded.mesh);
  timing.computing = secondsSince(computingStart);

  if (options.output.isWanted()) {
    if (auto error = writeResult(options.output, contentFor(work, field, options))) {
      return reportError(options.output.path, *error);
    }
    if (options.output.isFile()) removeFile(partial.path());
  }
  if (options.barcodes.isWanted()) {
    if (auto error = writeResult(options.barcodes, barcodesFor(work, barcodes, options))) {
      return reportError(options.barcodes.path, *error);
    }
  }
  if (options.json) {
    printJson(work, field, options, timing);
  } else if (hasSummary()) {
    printText(work, field, options, timing);
  }
  return 0;
}

/// Checks what is asked for together.
std::optional<Error> checkPersistent(const Options& options) {
  const bool isExact = !options.naive && !options.refined && options.method == GirthMethod::Exact;
  if (!isExact && !(options.persistence.empty() && options.barcodes.path.empty())) {
    return usageError("only the exact method knows how long saddles last", "leave --method out");
  }
  if (!options.barcodes.isWanted()) return std::nullopt;
  if (options.models.size() > 1) {
    return usageError("the saddles of several models do not go into one file",
                      "compute them one by one");
  }
  if (options.barcodes.isStandardOutput()) {
    return usageError("--barcode writes a file", "name one that ends with .json, .csv or .npy");
  }
  if (options.output.isFile() && options.output.path == options.barcodes.path) {
    return usageError("-o and --barcode name the same file", "name two");
  }
  return checkOutput(options.barcodes, options.models, options.json);
}

/// The options for each of several models: its output is in the folder that -o names.
Result<std::vector<Options>> optionsOfEach(const Options& options) {
  std::vector<Options> all;
  const bool isFolder = options.output.isFolder();
  if (options.output.isWanted() && options.models.size() > 1 && !isFolder) {
    return usageError("the values of several models do not go into one file",
                      "name a folder, as in -o values/ --format csv");
  }
  std::map<std::string, std::string> modelOfOutput;
  for (const std::string& model : options.models) {
    Options one = options;
    one.threads = threadsOfJob(options.threads, options.jobs);
    if (isFolder) {
      if (options.output.format.empty()) {
        return usageError("the format of the files in the folder is missing",
                          "add --format csv, for instance");
      }
      one.output.path = pathInFolder(options.output.path, model, options.output.ending());
      const auto [other, isNew] = modelOfOutput.emplace(one.output.path, model);
      if (!isNew) {
        return usageError(other->second + " and " + model + " would both become " + one.output.path,
                          "compute them one by one");
      }
    }
    all.push_back(std::move(one));
  }
  return all;
}

/// Checks what the refined method does not go with.
std::optional<Error> checkRefined(const Options& options) {
  if (!options.refined) return std::nullopt;
  if (options.faces > 0) {
    return usageError("--method refined computes on all triangles, and --faces on fewer",
                      "leave one of them out");
  }
  if (options.resume) {
    return usageError("--method refined leaves nothing to go on from", "leave --resume out");
  }
  return std::nullopt;
}

int run(const Options& options) {
  if (const auto error = checkRefined(options)) return reportError(options.output.path, *error);
  if (const auto error = checkPersistent(options)) {
    return reportError(options.barcodes.path, *error);
  }
  const auto each = optionsOfEach(options);
  if (!each) return reportError(options.output.path, each.error());
  for (const Options& one : each.value()) {
    if (const auto error = checkOutput(one.output, options.models, options.json)) {
      return reportError(one.output.path, *error);
    }
    const bool hasLines = one.tips || !one.loops.empty();
    if (hasLines && one.output.ending() != ".glb") {
      return reportError(one.output.path, usageError("only .glb holds loops and tips",
                                                     "write -o figure.glb, or use girth loop and "
                                                     "girth tips for other files"));
    }
  }
  return forEachJob(options.models, options.jobs,
                    [&](std::size_t i) { return runOne(options.models[i], each.value()[i]); });
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->models, "Models to read").required();
  addOutputOptions(table, options->output, {".csv", ".json", ".npy", ".ply", ".glb"},
                   "Write the values: .csv, .json or .npy (the file's vertices), .ply or .glb (the "
                   "surface)");
  table
      .onValue(
          "--method METHOD",
          [options](const std::string& name) {
            options->naive = name == "naive";
            options->refined = name == "refined";
            options->method = name == "ms" ? GirthMethod::Marched : GirthMethod::Exact;
            return std::string();
          },
          "exact (the default), refined, for large surfaces, naive, the slow reference "
          "implementation, or ms, the fast-marching approximation")
      .oneOf({"exact", "refined", "naive", "ms"});
  table
      .add("--audit N", options->audit,
           "With --method refined: number of random vertices to compare with the exact method; " +
               std::to_string(options->audit) + " by default")
      .range(0, 1'000'000)
      .onlyFor("--method", {"refined"});
  table
      .add(
          "--faces N", options->faces,
          "Compute on at most N triangles: larger models are remeshed, and the values carried back")
      .range(4, kMostFaces);
  addSubdivideOption(table, options->preparing);
  addPersistenceOption(table, options->persistence);
  table
      .add("--barcode FILE", options->barcodes.path,
           "Also write the birth and death of every saddle of every vertex; with --persistence "
           "only the saddles that it needs: .json, .csv or .npy")
      .excludes("--faces");
  table
      .add("--resume", options->resume,
           "Continue a stopped run from FILE.partial.csv beside the output")
      .needs("--output")
      .excludes("--barcode");
  addPositionsOption(table, options->positions);
  table
      .add("--loops VERTICES", options->loops,
           "Write the loops at these vertices too, numbered as in the file from 0, with commas "
           "between; .glb only")
      .separated()
      .needs("--output");
  table.add("--tips", options->tips, "Write the tips too, where the shape ends; .glb only")
      .needs("--output");
  addModelOptions(table, options->preparing);
  addThreadsOption(table, options->threads);
  addJobsOption(table, options->jobs);
  table.add("--json", options->json, "Print the summary as one JSON object for each model");
  table.add("--stats", options->stats, "Print the time and memory of the computation");
  table.note(
      "Which method",
      "exact, the default: 0.3 to 3 s of one processor for 10,000 triangles, and more than in "
      "proportion for more. refined takes a fifth to two thirds of that for 20,000 to 50,000 "
      "triangles: each value is the length of a loop, but one in some hundreds is not the "
      "shortest; "
      "the column state and the audit say how sure they are. --faces 10000 is quicker still, for "
      "values off by 0.1% at the median. ms "
      "takes half to three quarters of the time of exact, for values off by 1.5% at the median, "
      "and by more than 46% at one vertex of 20 of a coarse model: for comparing with the "
      "paper. naive is for checking.");
  table.note(
      "Noise",
      "The girth is the first loop, however shallow the saddle that it lies on: on a rough "
      "scan that may be a wrinkle. --persistence passes over saddles that do not last. Start "
      "with the height of the noise; 2% of 10,000 triangles takes five times as long.");
  table.note(
      "Related commands",
      "girth field: thickness, shape diameter (sdf), centricity, angles and signatures. girth "
      "loop: one loop. girth parts: tubes and plates. girth tips: where the shape ends.");
  table.example("girth igf model.glb -o values.csv",
                "The girth at every vertex of the file: vertex, igf, kind.");
  table.example("girth igf model.glb -o model_girth.glb",
                "The same as a model that any viewer shows in colours.");
  table.example(
      "girth igf model.glb -o figure.glb --loops 12,88 --tips",
      "A figure for a page: the element shows it with two loops and the tips, and computes "
      "nothing.");
  table.example("girth igf *.off --jobs 4 --json -o values/ --format csv",
                "Many models, four at a time: values/NAME.csv, and a JSON object for each.");
  table.example("girth igf scan.ply --faces 10000 -o values.csv",
                "A large model: computed on 10,000 triangles, carried back to its vertices.");
  table.example("girth igf scan.ply --method refined -o values.csv",
                "A large model at all its vertices: vertex, igf, kind, state.");
  table.example("girth igf scan.ply --persistence 2% -o values.csv",
                "A rough model: loops round wrinkles and dents are left out.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace igf_command

const Command kIgf{"igf", "Compute the girth at every vertex", igf_command::add};

}  // namespace girth::cli
