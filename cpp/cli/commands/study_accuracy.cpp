// girth study accuracy: IGF-MS against the exact girth.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
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
namespace study_accuracy_command {
namespace {

struct Options {
  std::vector<std::string> models;
  ModelOptions preparing;
  Index faces{0};
  unsigned threads{0};
};

/// Processor time so far, of all threads, in seconds: what other programs do does not change it.
double processorSeconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

/// Relative errors at the vertices of one or more models, and what the two methods cost.
class Errors {
 public:
  void add(double marched, double exact) {
    if (!(exact > 0) || std::isnan(marched)) return;
    errors_.push_back(std::fabs(marched - exact) / exact);
  }
  void add(const Errors& other) {
    errors_.insert(errors_.end(), other.errors_.begin(), other.errors_.end());
    marchedSeconds_ += other.marchedSeconds_;
    exactSeconds_ += other.exactSeconds_;
  }
  void addTimes(double marched, double exact) {
    marchedSeconds_ += marched;
    exactSeconds_ += exact;
  }

  void print(const std::string& name) {
    if (errors_.empty()) return;
    constexpr double kFar = 0.02;
    std::sort(errors_.begin(), errors_.end());
    const auto far = errors_.end() - std::upper_bound(errors_.begin(), errors_.end(), kFar);
    const double n = static_cast<double>(errors_.size());
    std::printf("%10.0f %8.3f%% %8.3f%% %13.2f%% %10s %10s %9.2f  %s\n", n, 100 * at(0.5),
                100 * at(0.95), 100 * static_cast<double>(far) / n,
                readableTime(exactSeconds_).c_str(), readableTime(marchedSeconds_).c_str(),
                exactSeconds_ / marchedSeconds_, name.c_str());
    std::fflush(stdout);
  }

 private:
  double at(double share) const {
    return errors_[static_cast<std::size_t>(share * static_cast<double>(errors_.size() - 1))];
  }

  std::vector<double> errors_;
  double marchedSeconds_{0}, exactSeconds_{0};
};

int run(const Options& options) {
  std::printf("%10s %9s %9s %14s %10s %10s %9s\n", "vertices", "median", "95%", "off by over 2%",
              "exact", "ms", "exact/ms");
  Errors all;
  int exitCode = 0;
  for (const std::string& model : options.models) {
    ProgressLine progress(model);
    const ExecutionContext context = watched(options.threads, progress);
    const auto loaded = loadModel(model, options.preparing);
    if (!loaded) {
      exitCode = reportError(model, loaded.error());
      continue;
    }
    study::FieldParameters parameters;
    parameters.faces = options.faces;
    const auto surface = study::studySurface(loaded.value().mesh, parameters, context);
    if (!surface) {
      exitCode = reportError(model, surface.error());
      continue;
    }
    const double start = processorSeconds();
    const GirthField marched = girthField(surface.value(), GirthMethod::Marched, context);
    const double middle = processorSeconds();
    const GirthField exact = girthField(surface.value(), GirthMethod::Exact, context);
    const double end = processorSeconds();
    if (!marched.complete() || !exact.complete()) {
      return reportError(model,
                         makeError(ErrorCode::Cancelled, -1, "stopped before it was finished"));
    }
    Errors errors;
    errors.addTimes(middle - start, end - middle);
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

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  table.add("MODEL", options->models, "Models to read").required();
  table
      .add("--faces N", options->faces, "Remesh larger models to N triangles; 0, the default: none")
      .range(0, kMostFaces);
  addModelOptions(table, options->preparing);
  addThreadsOption(table, options->threads);
  table.note("Many models",
             "Both methods are timed, so models run one at a time, and there is no --jobs.");
  table.example("girth study accuracy model.off",
                "Median and 95th percentile of the error, and processor time of both methods.");
  table.example("girth study accuracy *.off --faces 5000",
                "Many models, larger ones remeshed to 5,000 triangles.");
  return [options] { return run(*options); };
}

}  // namespace
}  // namespace study_accuracy_command

const Command kStudyAccuracy{"accuracy", "How near the girth by fast marching is to the exact one",
                             study_accuracy_command::add};

}  // namespace girth::cli
