// girth igf: the girth at every vertex.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "commands/common_options.h"
#include "commands/table.h"
#include "girth/girth_field.h"
#include "girth/girth_solver.h"
#include "girth/io/write_barcodes.h"
#include "girth/io/write_field.h"
#include "girth/parallel.h"
#include "girth/refined_girth.h"
#include "girth/study/naive_girth.h"
#include "girth/tips.h"
#include "girth/transfer.h"
#include "model/computing.h"
#include "model/loading.h"
#include "model/partial_field.h"
#include "model/persistence.h"
#include "process/files.h"
#include "process/interrupt.h"
#include "process/jobs.h"
#include "process/output.h"
#include "process/progress_line.h"
#include "process/report.h"
#include "text/json_text.h"
#include "text/number_text.h"

namespace girth::cli {
namespace igf_command {
namespace {

struct Options {
  std::vector<std::string> models;
  ModelOptions preparing;
  Output output;
  GirthMethod method{GirthMethod::Exact};
  /// By the study's naive method instead.
  bool naive{false};
  /// In bands round loops (girth/refined_girth.h) instead.
  bool refined{false};
  /// Vertices at which that is compared with the exact method.
  std::uint32_t audit{RefinedOptions{}.audit};
  /// 0: on the surface as it is; otherwise on one of at most so many faces, and carried back.
  std::uint32_t faces{0};
  unsigned threads{0};
  unsigned jobs{1};
  bool json{false};
  bool stats{false};
  /// Go on from what a stopped run has left beside the output.
  bool resume{false};
  bool positions{false};
  /// Vertices, in the file's numbering, whose loops are written beside the values.
  std::vector<std::uint32_t> loops;
  /// Write the tips beside the values.
  bool tips{false};
  /// As typed: a length or a share.
  std::string persistence;
  /// Where the saddles of all vertices go.
  Output barcodes{"", "", false, {".json", ".csv", ".npy"}};
};

using Clock = std::chrono::steady_clock;

constexpr std::array kStates{GirthState::Proved, GirthState::Consistent, GirthState::Suspect};

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What the values are like, over the vertices that were computed.
struct Summary {
  double least{0}, median{0}, greatest{0};
  std::size_t computed{0}, loops{0}, antipodal{0}, unresolved{0};
};

Summary summarize(const GirthField& field) {
  Summary summary;
  std::vector<double> values;
  for (std::size_t v = 0; v < field.values.size(); ++v) {
    if (std::isnan(field.values[v])) continue;
    values.push_back(field.values[v]);
    switch (field.kinds[v]) {
      case LoopKind::Loop:
        ++summary.loops;
        break;
      case LoopKind::Antipodal:
        ++summary.antipodal;
        break;
      case LoopKind::Unresolved:
        ++summary.unresolved;
        break;
    }
  }
  summary.computed = values.size();
  if (values.empty()) return summary;
  std::sort(values.begin(), values.end());
  summary.least = values.front();
  summary.greatest = values.back();
  const std::size_t middle = values.size() / 2;
  summary.median =
      values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
  return summary;
}

std::string methodText(const Options& options) {
  if (options.refined) return "refined";
  return options.naive ? "naive" : std::string(io::toString(options.method));
}

/// What the summary is about.
struct Work {
  const std::string& model;
  const io::LoadedMesh& loaded;
  /// In the model's unit.
  double persistence;
  /// What is known besides of values that were refined; null: they were not.
  const RefinedGirth* refined{nullptr};
  /// Triangles that it was computed on; 0: those of the file.
  Index fewerFaces{0};
};

/// The method with the triangles it was used on, where they are fewer, and its persistence: values
/// of equal texts belong together.
std::string particulars(const Options& options, const Work& work) {
  const bool isOther = options.naive || options.refined;
  std::string text =
      isOther ? methodText(options) : io::methodText({options.method, work.persistence});
  if (work.fewerFaces == 0) return text;
  return text.insert(std::min(text.find(','), text.size()),
                     " on " + std::to_string(work.fewerFaces) + " faces");
}

struct Timing {
  double reading{0}, computing{0};
};

unsigned threadsOf(const Options& options) { return threadCount({options.threads}); }

/// Time of one thread for one window that crossed a face; 0 where none were counted.
double nanosecondsPerWindow(const GirthField& field, const Options& options, const Timing& timing) {
  if (field.statistics.windowsCrossed == 0) return 0;
  return 1e9 * timing.computing * threadsOf(options) /
         static_cast<double>(field.statistics.windowsCrossed);
}

std::string refinedJson(const RefinedGirth& refined) {
  const GirthAudit& audit = refined.audit;
  std::string text = ",\"coarseFaces\":" + std::to_string(refined.coarseFaces) +
                     ",\"leanFaces\":" + std::to_string(refined.leanFaces);
  for (const GirthState state : kStates) {
    text += "," + io::jsonString(toString(state)) + ":" + std::to_string(refined.count(state));
  }
  return text + ",\"audit\":{\"vertices\":" + std::to_string(audit.vertices) +
         ",\"equal\":" + std::to_string(audit.equal) +
         ",\"atLeast\":" + io::formatNumber(audit.atLeast) +
         ",\"atMost\":" + io::formatNumber(audit.atMost) +
         ",\"median\":" + io::formatNumber(audit.median) +
         ",\"percentile95\":" + io::formatNumber(audit.percentile95) +
         ",\"greatest\":" + io::formatNumber(audit.greatest) + "}";
}

void printJson(const Work& work, const GirthField& field, const Options& options,
               const Timing& timing) {
  const Summary summary = summarize(field);
  const auto number = [&](double value) {
    return summary.computed > 0 ? io::formatNumber(value) : std::string("null");
  };
  std::string text =
      "{\"file\":" + io::jsonString(work.model) +
      ",\"field\":\"igf\",\"method\":" + io::jsonString(methodText(options)) +
      (work.fewerFaces == 0 ? "" : ",\"fewerFaces\":" + std::to_string(work.fewerFaces)) +
      ",\"persistence\":" + io::formatNumber(work.persistence) +
      ",\"unit\":" + io::jsonString(work.loaded.unit) +
      ",\"vertices\":" + std::to_string(field.values.size()) +
      ",\"computed\":" + std::to_string(summary.computed) +
      ",\"complete\":" + (field.complete() ? "true" : "false") +
      ",\"min\":" + number(summary.least) + ",\"median\":" + number(summary.median) +
      ",\"max\":" + number(summary.greatest) + ",\"loop\":" + std::to_string(summary.loops) +
      ",\"antipodal\":" + std::to_string(summary.antipodal) +
      ",\"unresolved\":" + std::to_string(summary.unresolved) +
      ",\"seconds\":" + readable(timing.computing);
  if (work.refined != nullptr) text += refinedJson(*work.refined);
  if (options.output.isWanted()) text += ",\"output\":" + io::jsonString(options.output.path);
  if (options.stats) {
    text += ",\"readingSeconds\":" + readable(timing.reading) +
            ",\"sources\":" + std::to_string(field.statistics.sources) +
            ",\"windowsCreated\":" + std::to_string(field.statistics.windowsCreated) +
            ",\"windowsCrossed\":" + std::to_string(field.statistics.windowsCrossed) +
            ",\"peakBytes\":" + std::to_string(field.statistics.peakBytes) +
            ",\"nanosecondsPerWindow\":" + readable(nanosecondsPerWindow(field, options, timing));
  }
  std::fputs((text + "}\n").c_str(), stdout);
}

void printRefined(const RefinedGirth& refined) {
  const GirthAudit& audit = refined.audit;
  const auto percent = [](double share) { return readable(100 * share) + "%"; };
  std::printf("  %u proved, %u consistent, %u suspect; from a surface of %u triangles\n",
              refined.count(GirthState::Proved), refined.count(GirthState::Consistent),
              refined.count(GirthState::Suspect), refined.coarseFaces);
  if (refined.leanFaces > 0) {
    std::printf("  without its flat vertices the surface has %u triangles\n", refined.leanFaces);
  }
  if (audit.vertices == 0) return;
  std::printf("  audit: %u of %u vertices drawn at random are exact, so %s to %s of all\n",
              audit.equal, audit.vertices, percent(audit.atLeast).c_str(),
              percent(audit.atMost).c_str());
  std::printf("  off by %s at the median, %s at one of 20, %s at most\n",
              percent(audit.median).c_str(), percent(audit.percentile95).c_str(),
              percent(audit.greatest).c_str());
}

void printText(const Work& work, const GirthField& field, const Options& options,
               const Timing& timing) {
  const Summary summary = summarize(field);
  const std::string unit = unitSuffix(work.loaded.unit);
  std::printf("%s: %u faces, girth at %zu of %zu vertices in %s%s\n", work.model.c_str(),
              work.loaded.mesh.faceCount(), summary.computed, field.values.size(),
              readableTime(timing.computing).c_str(),
              persistenceText(work.persistence, work.loaded).c_str());
  if (summary.computed > 0) {
    std::printf("  min %s, median %s, max %s%s\n", readable(summary.least).c_str(),
                readable(summary.median).c_str(), readable(summary.greatest).c_str(), unit.c_str());
    std::printf("  %zu loop, %zu antipodal\n", summary.loops, summary.antipodal);
    if (summary.unresolved > 0) {
      std::printf("  %zu unresolved: given up, the value is a lower bound\n", summary.unresolved);
    }
  }
  if (work.refined != nullptr) printRefined(*work.refined);
  if (options.stats) {
    const unsigned threads = threadsOf(options);
    const SearchStatistics& cost = field.statistics;
    const double vertices = static_cast<double>(std::max<std::size_t>(1, summary.computed));
    std::printf("  %s method, %u thread%s, read in %s\n", methodText(options).c_str(), threads,
                threads == 1 ? "" : "s", readableTime(timing.reading).c_str());
    std::printf("  %s ms a vertex\n", readable(1000 * timing.computing / vertices).c_str());
    if (cost.sources == 0) return;  // only the exact method counts
    const double sources = static_cast<double>(cost.sources);
    std::printf(
        "  %zu windows created, %s a source; %zu crossed a face, %s a source\n",
        cost.windowsCreated, readable(static_cast<double>(cost.windowsCreated) / sources).c_str(),
        cost.windowsCrossed, readable(static_cast<double>(cost.windowsCrossed) / sources).c_str());
    std::printf("  %s ns a window and thread; at most %s MB a thread\n",
                readable(nanosecondsPerWindow(field, options, timing)).c_str(),
                readable(static_cast<double>(cost.peakBytes) / 1e6).c_str());
  }
}

/// The vertices of the surface whose loops are wanted.
Result<std::vector<Vertex>> basesOf(const io::LoadedMesh& loaded, const Options& options) {
  std::vector<Vertex> bases;
  for (const std::uint32_t number : options.loops) {
    const auto vertex = surfaceVertex(loaded, number);
    if (!vertex) return vertex.error();
    bases.push_back(vertex.value());
  }
  return bases;
}

/// The surface with its values, loops and tips.
Result<std::string> figureContent(const Work& work, std::span<const io::VertexField> fields,
                                  const Options& options) {
  const io::LoadedMesh& loaded = work.loaded;
  const auto bases = basesOf(loaded, options);
  if (!bases) return bases.error();
  const ExecutionContext context{options.threads, &catchInterrupts(), {}};
  GirthSolver solver(loaded.mesh);
  solver.setPersistence(work.persistence);
  std::vector<GirthLoop> loops;
  for (const Vertex base : bases.value()) {
    auto loop = solver.loop(base, context);
    if (!loop) return loop.error();
    loops.push_back(std::move(loop).value());
  }
  std::optional<Tips> tips;
  if (options.tips) {
    auto found = findTips(loaded.mesh, fields[0].values, context);
    if (!found) return found.error();
    tips = std::move(found).value();
  }
  if (auto error = io::checkFields(loaded, fields)) return *std::move(error);
  return io::fieldGlb(loaded, fields, std::nullopt, {loops, tips ? &*tips : nullptr});
}

Result<std::string> contentFor(const Work& work, const GirthField& girth, const Options& options) {
  std::vector<io::VertexField> fields{
      io::girthVertexField(girth, options.method, work.loaded.unit)};
  fields[0].method = particulars(options, work);
  std::vector<double> states;
  // NumPy's files hold one field.
  if (work.refined != nullptr && options.output.ending() != ".npy") {
    for (const GirthState state : work.refined->states)
      states.push_back(static_cast<double>(state));
    fields.push_back(io::girthStateField(states, fields[0].method));
  }
  if (options.output.ending() == ".glb") return figureContent(work, fields, options);
  return io::fieldFile(work.loaded, fields, options.output.ending().substr(1), work.model,
                       columnsOf(options.positions));
}

std::string barcodesFor(const Work& work, std::span<const Barcode> barcodes,
                        const Options& options) {
  const std::string ending = options.barcodes.ending();
  if (ending == ".csv") return io::barcodesCsv(work.loaded, barcodes);
  if (ending == ".npy") return io::barcodesNpy(work.loaded, barcodes);
  return io::barcodesJson(work.loaded, barcodes, work.model);
}

/// The field of a remeshed surface at the vertices of the original.
GirthField fieldOnOriginal(const GirthField& field, const SurfaceMesh& remeshed,
                           const SurfaceMesh& original) {
  const std::vector<SurfacePoint> places = nearestPoints(remeshed, original);
  GirthField carried;
  carried.values = carriedBack(remeshed, field.values, original, places);
  for (const Index v : nearestVertices(remeshed, places)) carried.kinds.push_back(field.kinds[v]);
  carried.computed =
      static_cast<std::size_t>(std::count_if(carried.values.begin(), carried.values.end(),
                                             [](double value) { return !std::isnan(value); }));
  carried.statistics = field.statistics;
  return carried;
}

/// The function to compute, but for vertices whose values are known.
VertexFunction<GirthValue> withKnown(const GirthField& known,
                                     const VertexFunction<GirthValue>& function) {
  return {[&known, function](const ExecutionContext& context) -> VertexEvaluator<GirthValue> {
    return [&known, evaluate = function.evaluator(context)](Vertex v) -> Result<GirthValue> {
      if (!std::isnan(known.values[v])) return GirthValue{known.values[v], known.kinds[v]};
      return evaluate(v);
    };
  }};
}

/// The girth of a surface, going on from what a stopped run has left, where there is something.
Result<GirthField> compute(const std::string& model, const SurfaceMesh& mesh,
                           const PartialField& partial, const Options& options,
                           double persistence) {
  std::optional<GirthField> known;
  if (options.resume && isFile(partial.path())) {
    auto read = partial.read();
    if (!read) return read.error();
    known = std::move(read).value();
    printNote(model, "going on from " + std::to_string(known->computed) + " of " +
                         std::to_string(mesh.vertexCount()) + " vertices");
  }
  if (!options.naive && options.method == GirthMethod::Exact) {
    noteLargeSurface(
        model, mesh,
        std::string(kFewerFaces) + (persistence > 0 ? "" : ", and --method refined minutes"));
  }
  ProgressLine progress(model);
  const ExecutionContext context = watched(options.threads, progress);
  const GirthOptions girth{options.method, persistence};
  if (!known) {
    return options.naive ? study::naiveGirthField(mesh, context) : girthField(mesh, girth, context);
  }
  const auto function =
      options.naive ? study::naiveGirthFunction(mesh) : girthFunction(mesh, girth);
  return girthFieldOf(evaluateAll(mesh, withKnown(*known, function), context));
}

/// The same in bands round loops. A run that is stopped leaves nothing: no value counts before its
/// neighbours are known.
Result<RefinedGirth> computeRefined(const std::string& model, const SurfaceMesh& mesh,
                                    const Options& options) {
  ProgressLine progress(model);
  RefinedOptions refined;
  refined.audit = options.audit;
  return refinedGirth(mesh, refined, watched(options.threads, progress));
}

/// I_tau at all vertices, read off their barcodes.
GirthField girthOf(std::span<const Barcode> barcodes, double persistence) {
  VertexValues<GirthValue> girth;
  for (const Barcode& barcode : barcodes) girth.values.push_back(barcode.girth(persistence));
  girth.computed = barcodes.size();
  return girthFieldOf(girth);
}

/// Keeps what there is of a field whose computation was stopped.
int reportStopped(const std::string& model, const GirthField& field, const PartialField& partial,
                  const Options& options) {
  Error error = makeError(ErrorCode::Cancelled, -1,
                          "stopped after " + std::to_string(field.computed) + " of " +
                              std::to_string(field.values.size()) + " vertices");
  error.hint = "";
  if (options.output.isFile()) {
    if (const auto problem = partial.write(field)) return reportError(partial.path(), *problem);
    error.hint = "they are kept in " + partial.path() + ", from which --resume goes on";
  }
  return reportError(model, error);
}

/// A stopped run's file is resumed, or given up by the user's own words;
/// what another one has left is kept under another name.
std::optional<Error> clearPartial(const std::string& model, const PartialField& partial,
                                  const Options& options) {
  if (!options.output.isFile() || options.resume || options.output.force ||
      !isFile(partial.path())) {
    return std::nullopt;
  }
  const auto another = partial.ofAnother();
  if (!another) {
    return usageError("a stopped run has left " + partial.path(),
                      "go on from it with --resume, or begin again with --force");
  }
  const auto name = keepAside(partial.path());
  if (!name) {
    Error error = name.error();
    error.message = partial.path() + " " + *another + "; " + error.message;
    return error;
  }
  printNote(model, partial.path() + " " + *another + ". It is kept as " + name.value());
  return std::nullopt;
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
  // Of the loops that have no persistence at all, which I counts, bars know nothing.
  const bool isRead = !barcodes.empty() && work.persistence > 0;
  auto computed = refined  ? std::move(refined->field)
                  : isRead ? girthOf(barcodes, work.persistence)
                           : compute(model, mesh, partial, options, work.persistence);
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
        return usageError("it is not said what to write into the folder",
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
           "Of the refined method: compare with the exact one at so many vertices, drawn at "
           "random; " +
               std::to_string(options->audit) + " by default")
      .range(0, 1'000'000);
  table
      .add("--faces N", options->faces,
           "Compute on at most so many triangles: a larger model is remeshed to them, and the "
           "values are carried back")
      .range(4, kMostFaces);
  addRefineOption(table, options->preparing);
  addPersistenceOption(table, options->persistence);
  table
      .add("--barcode FILE", options->barcodes.path,
           "Also write every saddle of every vertex, where it is born and where it dies, as far as "
           "--persistence needs them, without it all: .json, .csv or .npy")
      .excludes("--faces");
  table
      .add("--resume", options->resume,
           "Go on from what a stopped run has left beside the output, FILE.partial.csv")
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
  table.add("--stats", options->stats, "Print what the computation took");
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
      "What else there is",
      "girth field has thickness (sdf), centricity, angles and signatures; girth loop the loop "
      "itself, girth parts tubes and plates, girth tips where the shape ends.");
  table.example("girth igf model.glb -o values.csv",
                "The girth at every vertex of the file: vertex, igf, kind.");
  table.example("girth igf model.glb -o model_girth.glb",
                "The same as a model that any viewer shows in colours.");
  table.example(
      "girth igf model.glb -o figure.glb --loops 12,88 --tips",
      "A figure for a page: the element shows it with two loops and the tips, and computes "
      "nothing.");
  table.example("girth igf *.off --jobs 4 --json -o values/ --format csv",
                "Of many models, four at a time: values/NAME.csv, and a JSON object for each.");
  table.example("girth igf scan.ply --faces 10000 -o values.csv",
                "Of a large model: computed on 10,000 triangles, carried back to its vertices.");
  table.example("girth igf scan.ply --method refined -o values.csv",
                "Of a large model at all its vertices: vertex, igf, kind, state.");
  table.example("girth igf scan.ply --persistence 2% -o values.csv",
                "Of a rough model: loops round wrinkles and dents are passed over.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace igf_command

const Command kIgf{"igf", "Compute the girth at every vertex", igf_command::add};

}  // namespace girth::cli
