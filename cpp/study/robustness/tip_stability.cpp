#include "girth/study/tip_stability.h"

#include <algorithm>
#include <array>
#include <utility>

#include "girth/girth_field.h"
#include "girth/study/surface_changes.h"

namespace girth::study {

namespace {

bool isInside(const Tip& tip, Vertex vertex) {
  return std::binary_search(tip.vertices.begin(), tip.vertices.end(), vertex);
}

/// The tips of a changed surface; its girth takes up the progress from `begin` to `end`.
Result<Tips> tipsOfChanged(const SurfaceMesh& changed, double persistence,
                           const ExecutionContext& context, double begin, double end) {
  ExecutionContext within = context;
  if (context.onProgress) {
    within.onProgress = [&](double done) { context.onProgress(begin + done * (end - begin)); };
  }
  const GirthField girth = girthField(changed, {GirthMethod::Exact, persistence}, within);
  if (!girth.complete()) return makeError(ErrorCode::Cancelled, -1, "cancelled");
  return findTips(changed, girth.values, context);
}

/// Compares tips with those of a changed surface. `near`: vertices of the unchanged surface that a
/// vertex of the changed one is, or lies between.
template <class Near>
void compare(std::span<const Tip> tips, const Tips& changed, Near near, TipTrial& trial) {
  trial.tips = static_cast<Index>(changed.tips.size());
  trial.arcs = static_cast<Index>(changed.arcs.size());
  for (const Tip& tip : tips) {
    trial.found.push_back(
        std::any_of(changed.tips.begin(), changed.tips.end(), [&](const Tip& other) {
          const std::array<Vertex, 2> around = near(other.apex);
          return isInside(other, tip.apex) &&
                 (isInside(tip, around[0]) || isInside(tip, around[1]));
        }));
  }
}

}  // namespace

Index TipTrial::foundAgain() const {
  return static_cast<Index>(std::count(found.begin(), found.end(), true));
}

Result<std::vector<TipTrial>> tipTrials(const SurfaceMesh& mesh, std::span<const Tip> tips,
                                        const TipTrialOptions& options,
                                        const ExecutionContext& context) {
  if (auto error = checkPersistence(options.persistence)) return *std::move(error);
  std::vector<TipTrial> trials;
  // Four times the faces take about eight times as long.
  constexpr double kFiner = 8;
  const double all = kFiner + static_cast<double>(options.noise.size());
  const auto finer = subdivided(mesh);
  TipTrial cut;
  if (finer) {
    const auto found =
        tipsOfChanged(finer.value().mesh, options.persistence, context, 0, kFiner / all);
    if (!found) return found.error();
    compare(
        tips, found.value(),
        [&](Vertex v) {
          return v < mesh.vertexCount() ? std::array<Vertex, 2>{v, v}
                                        : finer.value().between[v - mesh.vertexCount()];
        },
        cut);
  } else {
    cut.failed = finer.error();
  }
  trials.push_back(std::move(cut));
  for (std::size_t i = 0; i < options.noise.size(); ++i) {
    TipTrial trial;
    trial.noise = options.noise[i];
    const auto noisy = withNoise(mesh, options.noise[i], options.seed + i);
    if (noisy) {
      const double begin = kFiner + static_cast<double>(i);
      const auto found = tipsOfChanged(noisy.value(), options.persistence, context, begin / all,
                                       (begin + 1) / all);
      if (!found) return found.error();
      compare(
          tips, found.value(),
          [](Vertex v) {
            return std::array<Vertex, 2>{v, v};
          },
          trial);
    } else if (noisy.error().code == ErrorCode::InvalidOption) {
      return noisy.error();
    } else {
      trial.failed = noisy.error();
    }
    trials.push_back(std::move(trial));
  }
  return trials;
}

}  // namespace girth::study
