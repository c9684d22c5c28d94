#include "girth/study/robustness.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "girth/field_difference.h"
#include "girth/girth_field.h"
#include "girth/remesh.h"
#include "girth/remove_handles.h"
#include "girth/vertex_areas.h"
#include "text/number_text.h"

namespace girth::study {

namespace {

/// A value that changed by no more than this share is the same.
constexpr double kUnchanged = 0.05;

struct Measured {
  SurfaceMesh mesh;
  std::vector<double> girth;
};

/// A row to be filled, and how the changed surface is made.
struct Plan {
  RobustnessRow row;
  /// About how many triangles there will be: what it costs.
  double faces{0};
  /// Compared with the model as it is, not with the even mesh.
  bool againstModel{false};
  /// Its vertices are those of the even mesh.
  bool sameVertices{false};
  std::function<Result<SurfaceMesh>(const SurfaceMesh& even, const ExecutionContext& context)> make;
};

Result<SurfaceMesh> remeshedBy(RemeshMethod method, const SurfaceMesh& mesh, Index faces,
                               const ExecutionContext& context) {
  auto remeshed = remesh(mesh, {faces, method}, context);
  if (!remeshed) return remeshed.error();
  return std::move(remeshed).value().mesh;
}

Result<SurfaceMesh> evenly(const SurfaceMesh& mesh, Index faces, const ExecutionContext& context) {
  return remeshedBy(RemeshMethod::Even, mesh, faces, context);
}

Result<SurfaceMesh> bridged(const SurfaceMesh& mesh, std::size_t count,
                            const ExecutionContext& context) {
  const auto places = facingPlaces(mesh, count, context);
  if (!places) return places.error();
  if (places.value().size() < count) {
    return makeError(ErrorCode::InvalidOption, -1,
                     "there are not so many places where parts face each other across a gap");
  }
  return withBridges(mesh, places.value());
}

double unchangedShare(const Measured& before, const Measured& after) {
  const std::vector<double> areas = vertexAreas(before.mesh);
  double same = 0, all = 0;
  for (std::size_t v = 0; v < areas.size(); ++v) {
    if (std::isnan(before.girth[v]) || std::isnan(after.girth[v])) continue;
    all += areas[v];
    if (std::fabs(after.girth[v] - before.girth[v]) <= kUnchanged * before.girth[v]) {
      same += areas[v];
    }
  }
  return same / all;
}

std::vector<Plan> plansFor(const SurfaceMesh& model, std::span<const NamedSurface> poses,
                           const RobustnessOptions& options) {
  std::vector<Plan> plans;
  const auto add = [&](const char* figure, std::string change, std::optional<double> paper,
                       double faces, auto make) -> Plan& {
    Plan plan;
    plan.row.figure = figure;
    plan.row.change = std::move(change);
    plan.row.paper = paper;
    plan.faces = faces;
    plan.make = make;
    plans.push_back(std::move(plan));
    return plans.back();
  };
  const double same = options.faces;
  for (const Index size : options.sizes) {
    add("7", "remeshed to " + std::to_string(size), 8.7e-3, size,
        [&model, size](const SurfaceMesh&, const ExecutionContext& context) {
          return remeshedBy(RemeshMethod::Fitting, model, size, context);
        })
        .againstModel = true;
  }
  add("8b", "uneven triangles", 7.7e-3, same,
      [&](const SurfaceMesh&, const ExecutionContext& context) {
        return remeshedUnevenly(model, options.faces, options.stretch, context);
      });
  add("8c", "twice as many triangles", 5.3e-3, 2 * same,
      [&](const SurfaceMesh&, const ExecutionContext& context) {
        return evenly(model, 2 * options.faces, context);
      });
  for (const double amount : options.noise) {
    add("8d", "noise of " + io::formatNumber(amount) + " mean edges", 1.2e-2, same,
        [&options, amount](const SurfaceMesh& even, const ExecutionContext&) {
          return withNoise(even, amount, options.seed);
        })
        .sameVertices = true;
  }
  add("8e", std::to_string(options.humps.humps) + " flat humps", 2.7e-2, same,
      [&](const SurfaceMesh& even, const ExecutionContext& context) {
        return withHumps(even, options.humps, context);
      })
      .sameVertices = true;
  add("8f", std::to_string(options.bridges) + " places grown together", 5.9e-2, same,
      [&](const SurfaceMesh& even, const ExecutionContext& context) {
        return bridged(even, options.bridges, context);
      })
      .sameVertices = true;
  for (const Index count : options.tinyHandles) {
    const std::string handles = "tiny handles: " + std::to_string(count);
    add("8f", handles, std::nullopt, same,
        [count](const SurfaceMesh& even, const ExecutionContext&) {
          return withTinyHandles(even, count);
        })
        .sameVertices = true;
    add("8f", handles + ", removed", std::nullopt, same,
        [count](const SurfaceMesh& even, const ExecutionContext& context) -> Result<SurfaceMesh> {
          const auto rough = withTinyHandles(even, count);
          if (!rough) return rough.error();
          auto removal =
              removeHandles(rough.value(), kTinyLoop * even.meanEdgeLength(), {}, context);
          if (!removal) return removal.error();
          return std::move(removal).value().mesh;
        });
  }
  for (const NamedSurface& pose : poses) {
    add("9", "pose " + pose.name, std::nullopt, same,
        [&](const SurfaceMesh&, const ExecutionContext& context) {
          return evenly(pose.mesh, options.faces, context);
        });
  }
  return plans;
}

/// Computes girths one after the other, with one progress for all.
class Run {
 public:
  Run(const ExecutionContext& context, double persistence, double total)
      : context_(context), persistence_(persistence), total_(total) {}

  /// The cost of a field of so many faces, in the unit of `total`.
  static double costOf(double faces) { return faces * std::sqrt(faces); }

  /// Nothing where it was cancelled.
  std::optional<Measured> girthOf(SurfaceMesh mesh, double cost) {
    ExecutionContext inner;
    inner.threads = context_.threads;
    inner.cancel = context_.cancel;
    inner.onProgress = [&](double fraction) {
      if (context_.onProgress)
        context_.onProgress(std::min(1.0, (done_ + fraction * cost) / total_));
    };
    const double tau = persistence_ * std::sqrt(mesh.area());
    GirthField field = girthField(mesh, {GirthMethod::Exact, tau}, inner);
    done_ += cost;
    if (!field.complete()) return std::nullopt;
    return Measured{std::move(mesh), std::move(field.values)};
  }

  ExecutionContext quiet() const {
    ExecutionContext inner = context_;
    inner.onProgress = {};
    return inner;
  }

 private:
  const ExecutionContext& context_;
  double persistence_;  // over the square root of the area
  double total_, done_{0};
};

}  // namespace

Result<std::vector<RobustnessRow>> robustnessStudy(const SurfaceMesh& model,
                                                   std::span<const NamedSurface> poses,
                                                   const RobustnessOptions& options,
                                                   const ExecutionContext& context) {
  const Error cancelled = makeError(ErrorCode::Cancelled, -1, "cancelled");
  if (!(options.stretch >= 1 && options.stretch <= 100)) {
    return makeError(ErrorCode::InvalidOption, -1, "triangles can be drawn out 1 to 100 times");
  }
  if (auto error = checkPersistence(options.persistence)) return *std::move(error);
  std::vector<Plan> plans = plansFor(model, poses, options);
  double total = Run::costOf(model.faceCount()) + Run::costOf(options.faces);
  for (const Plan& plan : plans) total += Run::costOf(plan.faces);
  Run run(context, options.persistence, total);

  auto even = evenly(model, options.faces, run.quiet());
  if (!even) return even.error();
  const auto before = run.girthOf(model, Run::costOf(model.faceCount()));
  if (!before) return cancelled;
  const auto unchanged = run.girthOf(std::move(even).value(), Run::costOf(options.faces));
  if (!unchanged) return cancelled;

  std::vector<RobustnessRow> rows;
  for (Plan& plan : plans) {
    RobustnessRow row = std::move(plan.row);
    auto changed = plan.make(unchanged->mesh, run.quiet());
    if (context.cancelled()) return cancelled;
    if (!changed) {
      row.note = changed.error().message;
      rows.push_back(std::move(row));
      continue;
    }
    row.faces = changed.value().faceCount();
    const auto after = run.girthOf(std::move(changed).value(), Run::costOf(plan.faces));
    if (!after) return cancelled;
    const Measured& reference = plan.againstModel ? *before : *unchanged;
    row.difference = fieldDifference(reference.mesh, reference.girth, after->mesh, after->girth);
    if (plan.sameVertices) row.unchanged = unchangedShare(*unchanged, *after);
    rows.push_back(std::move(row));
  }
  if (context.onProgress) context.onProgress(1);
  return rows;
}

}  // namespace girth::study
