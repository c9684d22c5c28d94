#include "commands/igf/summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "girth/describe/refined_girth.h"
#include "girth/io/json_text.h"
#include "girth/parallel.h"
#include "model/persistence.h"
#include "process/report.h"

namespace girth::cli::igf_command {

namespace {

constexpr std::array kStates{GirthState::Proved, GirthState::Consistent, GirthState::Suspect};

/// The values of the vertices that were computed.
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

unsigned threadsOf(const Options& options) { return threadCount({options.threads}); }

/// Time of one thread for one window that crossed a face; 0 where none were counted.
double nanosecondsPerWindow(const GirthField& field, const Options& options, const Timing& timing) {
  if (field.statistics.windowsCrossed == 0) return 0;
  return 1e9 * timing.computing * threadsOf(options) /
         static_cast<double>(field.statistics.windowsCrossed);
}

void addRefined(const RefinedGirth& refined, io::JsonObject& json) {
  json.add("coarseFaces", refined.coarseFaces).add("leanFaces", refined.leanFaces);
  for (const GirthState state : kStates) json.add(toString(state), refined.count(state));
  io::JsonObject audit;
  visitMembers(refined.audit, [&](const char* name, const auto& value) { audit.add(name, value); });
  json.addJson("audit", audit.text());
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

}  // namespace

void printJson(const Work& work, const GirthField& field, const Options& options,
               const Timing& timing) {
  const Summary summary = summarize(field);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const bool isEmpty = summary.computed == 0;
  io::JsonObject json;
  json.add("file", work.model).add("field", "igf").add("method", methodText(options));
  if (work.fewerFaces != 0) json.add("fewerFaces", work.fewerFaces);
  json.add("persistence", work.persistence)
      .add("unit", work.loaded.unit)
      .add("vertices", field.values.size())
      .add("computed", summary.computed)
      .add("complete", field.complete())
      .add("min", isEmpty ? kNone : summary.least)
      .add("median", isEmpty ? kNone : summary.median)
      .add("max", isEmpty ? kNone : summary.greatest)
      .add("loop", summary.loops)
      .add("antipodal", summary.antipodal)
      .add("unresolved", summary.unresolved)
      .addJson("seconds", readable(timing.computing));
  if (work.refined != nullptr) addRefined(*work.refined, json);
  if (options.output.isWanted()) json.add("output", options.output.path);
  if (options.stats) {
    json.addJson("readingSeconds", readable(timing.reading))
        .add("sources", field.statistics.sources)
        .add("windowsCreated", field.statistics.windowsCreated)
        .add("windowsCrossed", field.statistics.windowsCrossed)
        .add("peakBytes", field.statistics.peakBytes)
        .addJson("nanosecondsPerWindow", readable(nanosecondsPerWindow(field, options, timing)));
  }
  std::puts(json.text().c_str());
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

}  // namespace girth::cli::igf_command
