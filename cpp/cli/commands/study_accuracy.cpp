// girth study accuracy: IGF-MS against the exact girth.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "commands/common_options.h"
#include "commands/table.h"
#include "girth/girth_field.h"
#include "girth/study/study_fields.h"
#include "model/loading.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace {

struct Options {
  std::vector<std::string> models;
  Index faces{0};
  unsigned threads{0};
};

/// Relative errors at the vertices of one or more models.
class Errors {
 public:
  void add(double marched, double exact) {
    if (!(exact > 0) || std::isnan(marched)) return;
    errors_.push_back(std::fabs(marched - exact) / exact);
  }
  void add(const Errors& other) {
    errors_.insert(errors_.end(), other.errors_.begin(), other.errors_.end());
  }

  void print(const std::string& name) {
    if (errors_.empty()) return;
    constexpr double kFar = 0.02;
    std::sort(errors_.begin(), errors_.end());
    const auto far = errors_.end() - std::upper_bound(errors_.begin(), errors_.end(), kFar);
    const double n = static_cast<double>(errors_.size());
    std::printf("%10.0f %8.3f%% %8.3f%% %13.2f%%  %s\n", n, 100 * at(0.5), 100 * at(0.95),
                100 * static_cast<double>(far) / n, name.c_str());
  }

 private:
  double at(double share) const {
    return errors_[static_cast<std::size_t>(share * static_cast<double>(errors_.size() - 1))];
  }

  std::vector<double> errors_;
};

int run(const Options& options) {
  std::printf("%10s %9s %9s %14s\n", "vertices", "median", "95%", "off by over 2%");
  Errors all;
  int exitCode = 0;
  for (const std::string& model : options.models) {
    ProgressLine progress(model);
    const ExecutionContext context = watched(options.threads, progress);
    const auto mesh = readSurface(model);
    if (!mesh) {
      exitCode = reportError(model, mesh.error());
      continue;
    }
    study::FieldParameters parameters;
    parameters.faces = options.faces;
    const auto surface = study::studySurface(mesh.value(), parameters, context);
    if (!surface) {
      exitCode = reportError(model, surface.error());
      continue;
    }
    const GirthField marched = girthField(surface.value(), GirthMethod::Marched, context);
    const GirthField exact = girthField(surface.value(), GirthMethod::Exact, context);
    if (!marched.complete() || !exact.complete()) {
      return reportError(model,
                         makeError(ErrorCode::Cancelled, -1, "stopped before it was finished"));
    }
    Errors errors;
    for (std::size_t v = 0; v < exact.values.size(); ++v) {
      // Where the loop is unresolved there is nothing to compare with.
      if (exact.kinds[v] != LoopKind::Unresolved) errors.add(marched.values[v], exact.values[v]);
    }
    errors.print(model);
    all.add(errors);
  }
  if (options.models.size() > 1) all.print("all");
  return exitCode;
}

Run add(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("MODEL", options->models, "Models to read")->required();
  app.add_option("--faces", options->faces,
                 "Remesh larger models to so many triangles; 0, the default: leave all as they "
                 "are")
      ->check(CLI::Range(std::uint32_t{0}, kMostFaces));
  addThreadsOption(app, options->threads);
  return [options] { return run(*options); };
}

}  // namespace

const Command kStudyAccuracy{"accuracy", "How near the girth by fast marching is to the exact one",
                             add};

}  // namespace girth::cli
