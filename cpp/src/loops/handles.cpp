#include "girth/handles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "girth/barcode.h"
#include "girth/girth_solver.h"
#include "girth/parallel.h"
#include "girth/solver_factory.h"
#include "girth/vertex_function.h"
#include "loops/homology.h"
#include "loops/loop_shape.h"
#include "loops/taut_loop.h"
#include "part_of_work.h"

namespace girth {
namespace {

using geodesic::Unfolding;
using loops::Homology;
using loops::HomologyClass;
using loops::IntegerMatrix;
using loops::TautLoop;
using loops::Tightened;

/// Loops to be joined into one of a wanted class, at most.
constexpr std::int64_t kMostJoined = 1000;

bool isZero(const HomologyClass& c) {
  return std::all_of(c.begin(), c.end(), [](std::int64_t x) { return x == 0; });
}

/// Classes modulo 2, of which no sum is 0.
class Independent {
 public:
  /// Adds a class if it is independent of those before.
  bool add(const HomologyClass& c) {
    std::vector<bool> bits(c.size());
    for (std::size_t i = 0; i < c.size(); ++i) bits[i] = c[i] % 2 != 0;
    for (const auto& [pivot, row] : rows_) {
      if (!bits[pivot]) continue;
      for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = bits[i] != row[i];
    }
    const auto one = std::find(bits.begin(), bits.end(), true);
    if (one == bits.end()) return false;
    rows_.emplace_back(one - bits.begin(), std::move(bits));
    return true;
  }
  std::size_t size() const { return rows_.size(); }

 private:
  std::vector<std::pair<std::ptrdiff_t, std::vector<bool>>> rows_;
};

/// Whole numbers by which rows of numbers sum up to 0: a basis of all such (Euclid's algorithm on
/// one column after the other).
std::vector<HomologyClass> relations(const std::vector<HomologyClass>& rows) {
  struct Row {
    HomologyClass value, of;
  };
  std::vector<std::pair<std::size_t, Row>> echelon;
  std::vector<HomologyClass> result;
  const auto subtract = [](Row& a, const Row& b, std::int64_t times) {
    for (std::size_t i = 0; i < a.value.size(); ++i) a.value[i] -= times * b.value[i];
    for (std::size_t i = 0; i < a.of.size(); ++i) a.of[i] -= times * b.of[i];
  };
  for (std::size_t r = 0; r < rows.size(); ++r) {
    Row row{rows[r], HomologyClass(rows.size(), 0)};
    row.of[r] = 1;
    for (;;) {
      std::size_t column = 0;
      while (column < row.value.size() && row.value[column] == 0) ++column;
      if (column == row.value.size()) {
        result.push_back(std::move(row.of));
        break;
      }
      const auto known = std::find_if(echelon.begin(), echelon.end(),
                                      [&](const auto& e) { return e.first == column; });
      if (known == echelon.end()) {
        echelon.emplace_back(column, std::move(row));
        break;
      }
      subtract(row, known->second, row.value[column] / known->second.value[column]);
      if (row.value[column] != 0) std::swap(row, known->second);
    }
  }
  return result;
}

/// A closed geodesic, none near it is shorter.
struct Candidate {
  double length{0};
  TautLoop loop;
  HomologyClass homology;
};

/// The loops at one point that generate all others there.
struct Bundle {
  std::vector<std::vector<SurfacePoint>> curves;
  std::vector<HomologyClass> classes;
};

/// The search on one component.
class HandleSearch {
 public:
  HandleSearch(const SurfaceMesh& mesh, const std::shared_ptr<const Unfolding>& unfolding,
               const Homology& homology, Index component)
      : unfolding_(unfolding), homology_(homology) {
    for (const Face f : mesh.faces()) {
      if (mesh.componentOf(mesh.faceVertices(f)[0]) == component) area_ += mesh.area(f);
    }
    for (const Vertex v : coarseToFineOrder(mesh)) {
      if (mesh.componentOf(v) == component) order_.push_back(v);
    }
  }

  /// False: cancelled.
  bool run(std::size_t basePoints, const ExecutionContext& context) {
    const auto linking = homology_.linking({context.threads, context.cancel, {}});
    if (!linking) return false;
    projection_ = linking.value();
    const bool isAll = basePoints >= order_.size();
    const std::size_t most = std::min(basePoints, order_.size());
    const std::size_t spread = isAll ? most : (most + 1) / 2;
    std::vector<Vertex> bases(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(spread));
    addBasis();
    while (!bases.empty()) {
      if (!addLoopsAt(bases, most, context)) return false;
      if (!complete(context)) return false;
      bases = nextBases(most);
    }
    return true;
  }

  /// The loops found, by kinds, and what they are short of.
  struct Found {
    HandleKind kind;
    const Candidate* candidate;
  };
  std::vector<Found> found() const {
    std::vector<Found> all;
    if (!projection_) return chosen(HandleKind::Unknown);
    for (const HandleKind kind : {HandleKind::Handle, HandleKind::Tunnel}) {
      const std::vector<Found> some = chosen(kind);
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }

 private:
  bool isOf(HandleKind kind, const HomologyClass& c) const {
    if (kind == HandleKind::Unknown) return true;
    const HomologyClass image = loops::product(c, *projection_);
    return kind == HandleKind::Handle ? isZero(image) : image == c;
  }

  std::vector<Found> chosen(HandleKind kind) const {
    Independent independent;
    std::vector<Found> result;
    for (const Candidate& candidate : candidates_) {
      if (isOf(kind, candidate.homology) && independent.add(candidate.homology)) {
        result.push_back({kind, &candidate});
      }
    }
    return result;
  }

  /// Draws a curve tight, and on to a neck.
  std::optional<Candidate> tightened(std::span<const SurfacePoint> points) const {
    std::optional<TautLoop> loop = loops::looseLoop(*unfolding_, points);
    double last = std::numeric_limits<double>::infinity();
    while (loop && loops::tighten(*unfolding_, *loop) == Tightened::Geodesic) {
      const double length = loops::lengthOf(*unfolding_, *loop);
      if (!(length < last)) break;  // rounding alone leads on
      last = length;
      loops::Band band = loops::bandOf(*unfolding_, *loop, area_);
      if (band.shorter) {
        loop = std::move(band.shorter);
        continue;
      }
      TautLoop tight = loops::canonical(*unfolding_, *loop);
      HomologyClass homology = homology_.classOf(*unfolding_, tight);
      if (isZero(homology)) break;
      return Candidate{loops::lengthOf(*unfolding_, tight), std::move(tight), std::move(homology)};
    }
    return std::nullopt;
  }

  void add(Candidate candidate) { candidates_.insert(std::move(candidate)); }

  /// The basis curves, all through one vertex.
  void addBasis() {
    Bundle bundle;
    for (std::size_t k = 0; k < homology_.rank(); ++k) {
      bundle.curves.push_back(homology_.basisCurve(k));
      HomologyClass c(homology_.rank(), 0);
      c[k] = 1;
      bundle.classes.push_back(std::move(c));
      if (auto candidate = tightened(bundle.curves.back())) add(*std::move(candidate));
    }
    bundles_.push_back(std::move(bundle));
  }

  /// The shortest loops at a base point that generate all others there: nothing if cancelled.
  std::optional<Bundle> bundleAt(GirthSolver& solver, Vertex base,
                                 const ExecutionContext& context) const {
    BarcodeOptions options;
    options.loops = true;
    const auto barcode = solver.barcode(base, options, context);
    if (!barcode) return std::nullopt;
    Bundle bundle;
    Independent independent;
    for (const GirthLoop& loop : barcode.value().loops) {
      if (independent.size() == homology_.rank()) break;
      take(loop, independent, bundle);
    }
    return bundle;
  }

  void take(const GirthLoop& loop, Independent& independent, Bundle& bundle) const {
    const auto loose = loops::looseLoop(*unfolding_, loop.points);
    if (!loose) return;
    HomologyClass c = homology_.classOf(*unfolding_, *loose);
    if (!independent.add(c)) return;
    bundle.curves.push_back(loop.points);
    bundle.classes.push_back(std::move(c));
  }

  /// At the first of some points, up to `most` in all, all their loops; at the others the girth's.
  bool addLoopsAt(const std::vector<Vertex>& bases, std::size_t most,
                  const ExecutionContext& context) {
    const std::size_t whole = std::min(bases.size(), most - std::min(most, used_));
    std::vector<Bundle> bundles(bases.size());
    std::vector<std::vector<Candidate>> tight(bases.size());
    std::mutex mutex;
    std::vector<std::unique_ptr<GirthSolver>> idle;
    ExecutionContext part{context.threads, context.cancel, {}};
    if (context.onProgress) {
      part.onProgress = [&](double share) {
        context.onProgress((static_cast<double>(used_) + share * static_cast<double>(whole)) /
                           static_cast<double>(most));
      };
    }
    const auto work = [&](std::size_t i, std::size_t) {
      std::unique_ptr<GirthSolver> solver;
      {
        const std::lock_guard lock(mutex);
        if (!idle.empty()) {
          solver = std::move(idle.back());
          idle.pop_back();
        }
      }
      if (!solver) solver = std::make_unique<GirthSolver>(SolverFactory::onUnfolding(unfolding_));
      if (i < whole) {
        if (auto bundle = bundleAt(*solver, bases[i], context.ofOneThread())) {
          bundles[i] = *std::move(bundle);
        }
      } else if (const auto loop = solver->loop(bases[i], context.ofOneThread());
                 loop && loop.value().kind == LoopKind::Loop) {
        Independent independent;
        take(loop.value(), independent, bundles[i]);
      }
      for (const auto& curve : bundles[i].curves) {
        if (auto candidate = tightened(curve)) tight[i].push_back(*std::move(candidate));
      }
      const std::lock_guard lock(mutex);
      idle.push_back(std::move(solver));
    };
    if (!parallelFor(bases.size(), 1, part, work) || context.cancelled()) return false;
    for (std::size_t i = 0; i < bases.size(); ++i) {
      for (Candidate& candidate : tight[i]) add(std::move(candidate));
      if (bundles[i].curves.size() == homology_.rank()) bundles_.push_back(std::move(bundles[i]));
      done_.insert(bases[i]);
    }
    used_ += whole;
    return true;
  }

  /// Where loops of a kind are short of g, joins loops through one point into such.
  bool complete(const ExecutionContext& context) {
    if (!projection_) return true;
    for (const HandleKind kind : {HandleKind::Handle, HandleKind::Tunnel}) {
      for (auto bundle = bundles_.rbegin();
           bundle != bundles_.rend() && 2 * chosen(kind).size() < homology_.rank(); ++bundle) {
        std::vector<HomologyClass> rows;
        for (const HomologyClass& c : bundle->classes) {
          HomologyClass image = loops::product(c, *projection_);
          if (kind == HandleKind::Tunnel) {
            for (std::size_t k = 0; k < c.size(); ++k) image[k] -= c[k];
          }
          rows.push_back(std::move(image));
        }
        for (const HomologyClass& relation : relations(rows)) {
          if (context.cancelled()) return false;
          if (auto candidate = joined(*bundle, relation)) add(*std::move(candidate));
        }
      }
    }
    return true;
  }

  /// The loops of a bundle one behind the other, each so many times.
  std::optional<Candidate> joined(const Bundle& bundle, const HomologyClass& times) const {
    std::int64_t count = 0;
    for (const std::int64_t t : times) count += std::abs(t);
    if (count > kMostJoined) return std::nullopt;
    std::vector<SurfacePoint> points;
    for (std::size_t k = 0; k < times.size(); ++k) {
      std::vector<SurfacePoint> curve = bundle.curves[k];
      if (times[k] < 0) std::reverse(curve.begin(), curve.end());
      for (std::int64_t i = 0; i < std::abs(times[k]); ++i) {
        if (!points.empty()) points.pop_back();
        points.insert(points.end(), curve.begin(), curve.end());
      }
    }
    return tightened(points);
  }

  /// Points on the loops found so far that have not been base points.
  std::vector<Vertex> nextBases(std::size_t most) const {
    std::vector<Vertex> bases;
    std::set<Vertex> taken = done_;
    if (most >= order_.size()) return bases;
    for (const Found& loop : found()) {
      const std::vector<Index>& vertices = loop.candidate->loop.vertices;
      const std::size_t step = (vertices.size() + kPerLoop - 1) / kPerLoop;
      for (std::size_t i = 0; i < vertices.size(); i += step) {
        const Vertex vertex(unfolding_->vertexInMesh(vertices[i]));
        if (taken.insert(vertex).second) bases.push_back(vertex);
      }
    }
    return bases;
  }

  /// Base points on one loop.
  static constexpr std::size_t kPerLoop = 4;

  /// The shortest first.
  struct ByLength {
    bool operator()(const Candidate& a, const Candidate& b) const {
      if (a.length != b.length) return a.length < b.length;
      return a.loop.vertices != b.loop.vertices ? a.loop.vertices < b.loop.vertices
                                                : a.loop.runs < b.loop.runs;
    }
  };

  std::shared_ptr<const Unfolding> unfolding_;
  const Homology& homology_;
  double area_{0};
  std::vector<Vertex> order_;
  std::optional<IntegerMatrix> projection_;
  std::set<Candidate, ByLength> candidates_;
  std::vector<Bundle> bundles_;
  std::set<Vertex> done_;
  std::size_t used_{0};
};

}  // namespace

std::string_view toString(HandleKind kind) {
  switch (kind) {
    case HandleKind::Handle:
      return "handle";
    case HandleKind::Tunnel:
      return "tunnel";
    default:
      return "unknown";
  }
}

Result<Handles> findHandles(const SurfaceMesh& mesh, const HandleOptions& options,
                            const ExecutionContext& context) {
  if (options.basePoints == 0) {
    return makeError(ErrorCode::InvalidOption, -1, "there is at least one base point");
  }
  std::vector<Index> components;
  for (Index c = 0; c < mesh.componentCount(); ++c) {
    if (mesh.genus(c) > 0) components.push_back(c);
  }
  Handles result;
  const loops::ClosedSurface closed(mesh);
  const auto unfolding = std::make_shared<const Unfolding>(mesh);
  for (std::size_t i = 0; i < components.size(); ++i) {
    const Homology homology(mesh, closed, components[i]);
    HandleSearch search(mesh, unfolding, homology, components[i]);
    const ExecutionContext part =
        partOf(context, static_cast<double>(i) / static_cast<double>(components.size()),
               static_cast<double>(i + 1) / static_cast<double>(components.size()));
    if (!search.run(options.basePoints, part)) {
      return makeError(ErrorCode::Cancelled, -1, "the search for handles was cancelled");
    }
    const auto found = search.found();
    result.unresolved += static_cast<Index>(homology.rank() - found.size());
    for (const auto& [kind, candidate] : found) {
      Handle handle;
      handle.length = candidate->length;
      handle.kind = kind;
      handle.component = components[i];
      handle.points = loops::bandOf(*unfolding, candidate->loop, mesh.area()).middle;
      const loops::LoopShape shape = loops::shapeOf(loops::placesOf(mesh, handle.points));
      handle.centre = shape.centre;
      handle.area = shape.area;
      result.handles.push_back(std::move(handle));
    }
  }
  std::stable_sort(result.handles.begin(), result.handles.end(),
                   [](const Handle& a, const Handle& b) { return a.length < b.length; });
  if (context.onProgress) context.onProgress(1);
  return result;
}

}  // namespace girth
