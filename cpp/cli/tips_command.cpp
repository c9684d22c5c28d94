#include <cstdio>

#include "commands.h"
#include "compute.h"
#include "files.h"
#include "girth/io/write_tips.h"
#include "girth/tips.h"
#include "interrupt.h"
#include "report.h"

namespace girth::cli {
namespace {

void printText(const std::string& model, const io::LoadedMesh& loaded, const Tips& tips) {
  const std::string unit = unitSuffix(loaded.unit);
  std::printf("%s: %zu tip%s, %zu open arc%s\n", model.c_str(), tips.tips.size(),
              tips.tips.size() == 1 ? "" : "s", tips.arcs.size(), tips.arcs.size() == 1 ? "" : "s");
  if (!tips.tips.empty()) {
    std::printf("  %4s %12s %12s %12s %12s  %s\n", "tip", "jump", "area", "boundary", "to apex",
                "apex vertex");
  }
  for (std::size_t i = 0; i < tips.tips.size(); ++i) {
    const Tip& tip = tips.tips[i];
    const Index apex = loaded.inputOfVertex[tip.apex];
    std::printf("  %4zu %12s %12s %12s %12s  %s\n", i + 1, readable(tip.jump).c_str(),
                readable(tip.area).c_str(), readable(tip.boundaryLength).c_str(),
                readable(tip.apexDistance).c_str(),
                apex == kNoIndex ? "(made here)" : std::to_string(apex).c_str());
  }
  if (!unit.empty() && !tips.tips.empty()) std::printf("  lengths in%s\n", unit.c_str());
  if (!tips.arcs.empty()) {
    std::printf("  the arcs cut nothing off; the longest is %s%s long\n",
                readable(tips.arcs[0].length).c_str(), unit.c_str());
  }
}

}  // namespace

int runTips(const TipsOptions& options) {
  const std::string extension = extensionOf(options.output);
  if (!options.output.empty()) {
    if (extension != ".json" && extension != ".obj") {
      Error error = makeError(ErrorCode::Usage, -1, "the output's name has no known ending");
      error.hint = "use .json or .obj";
      return reportError(options.output, error);
    }
    if (auto error = checkWritable(options.output)) return reportError(options.output, *error);
  }
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());
  const SurfaceMesh& mesh = loaded.value().mesh;
  const auto girth = computeGirth(options.model, mesh, options.threads);
  if (!girth) return reportError(options.model, girth.error());
  const auto tips = findTips(mesh, girth.value().values, {0, &catchInterrupts(), {}});
  if (!tips) return reportError(options.model, tips.error());

  const auto json = [&] { return io::tipsJson(loaded.value(), tips.value(), options.model); };
  if (!options.output.empty()) {
    if (auto error =
            writeFile(options.output,
                      extension == ".json" ? json() : io::tipsObj(loaded.value(), tips.value()))) {
      return reportError(options.output, *error);
    }
  }
  if (options.json) {
    std::fputs(json().c_str(), stdout);
  } else {
    printText(options.model, loaded.value(), tips.value());
  }
  return 0;
}

}  // namespace girth::cli
