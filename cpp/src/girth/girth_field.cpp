#include "girth/girth_field.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>

#include "geodesic/fast_marching.h"
#include "geodesic/unfolding.h"
#include "girth/marched_girth.h"
#include "girth/naive_girth.h"
#include "mesh/space_filling_curve.h"
#include "parallel.h"

namespace girth {

namespace {

/// How often the calling thread reports.
constexpr auto kReportInterval = std::chrono::milliseconds(40);

/// What the threads share: they take vertices from `order` in turn and mark them done.
struct Work {
  const SurfaceMesh& mesh;
  GirthMethod method;
  const ExecutionContext& context;
  std::vector<Index> order;
  GirthField field;
  std::shared_ptr<const geodesic::Unfolding> unfolding;  // for the exact method
  std::optional<geodesic::MarchingStencils> stencils;    // for the marched one

  std::atomic<std::size_t> taken{0};
  std::atomic<std::size_t> done{0};
  std::mutex mutex;                         // of the statistics
  std::vector<std::atomic<bool>> finished;  // by place in `order`
};

/// The life of one thread: vertices, one after the other, until none are left; `afterEach` after
/// each.
template <class AfterEach>
void computeVertices(Work& work, AfterEach afterEach) {
  std::optional<GirthSolver> solver;
  std::optional<geodesic::FastMarching> march;
  if (work.method == GirthMethod::Exact) solver.emplace(work.unfolding);
  if (work.method == GirthMethod::Marched) march.emplace(*work.stencils);
  const auto compute = [&](Index v) -> Result<GirthValue> {
    if (solver) return solver->value(v, work.context);
    if (!march) return naiveGirth(work.mesh, v, work.context);
    const GirthValue value = marchedGirth(*march, work.mesh, v, work.context);
    if (work.context.cancelled()) return makeError(ErrorCode::Cancelled, v, "cancelled");
    return value;
  };
  SearchStatistics statistics;
  while (!work.context.cancelled()) {
    const std::size_t place = work.taken.fetch_add(1, std::memory_order_relaxed);
    if (place >= work.order.size()) break;
    const Index v = work.order[place];
    const auto girth = compute(v);
    if (!girth) break;  // cancelled: the vertices are in range
    work.field.values[v] = girth.value().length;
    work.field.kinds[v] = girth.value().kind;
    if (solver) statistics += solver->statistics();
    work.finished[place].store(true, std::memory_order_release);
    work.done.fetch_add(1, std::memory_order_relaxed);
    afterEach();
  }
  const std::lock_guard lock(work.mutex);
  work.field.statistics += statistics;
}

/// Hands on what was finished since the last time, in order; a vertex still in work does not hold
/// up those behind it.
class Reporter {
 public:
  Reporter(Work& work, const std::function<void(const GirthPartial&)>& onPartial)
      : work_(work), onPartial_(onPartial), reported_(work.order.size(), false) {}

  void report() {
    if (onPartial_) {
      vertices_.clear();
      values_.clear();
      kinds_.clear();
      const std::size_t end = std::min(work_.taken.load(), work_.order.size());
      for (std::size_t place = begin_; place < end; ++place) {
        if (reported_[place] || !work_.finished[place].load(std::memory_order_acquire)) continue;
        reported_[place] = true;
        vertices_.push_back(work_.order[place]);
        values_.push_back(work_.field.values[vertices_.back()]);
        kinds_.push_back(work_.field.kinds[vertices_.back()]);
      }
      while (begin_ < end && reported_[begin_]) ++begin_;
      if (!vertices_.empty()) onPartial_({vertices_, values_, kinds_});
    }
    const double fraction =
        static_cast<double>(work_.done.load()) / static_cast<double>(work_.order.size());
    if (work_.context.onProgress && fraction > fraction_) work_.context.onProgress(fraction);
    fraction_ = std::max(fraction_, fraction);
  }

 private:
  Work& work_;
  const std::function<void(const GirthPartial&)>& onPartial_;
  std::vector<bool> reported_;
  std::size_t begin_{0};  // everything before has been reported
  double fraction_{0};
  std::vector<Index> vertices_;
  std::vector<double> values_;
  std::vector<LoopKind> kinds_;
};

/// The calling thread only reports, so that callbacks come from it alone.
void runThreads(Work& work, unsigned threads, Reporter& reporter) {
  std::mutex mutex;
  std::condition_variable ended;
  unsigned running = threads;
  std::vector<std::thread> workers;
  for (unsigned i = 0; i < threads; ++i) {
    workers.emplace_back([&] {
      computeVertices(work, [] {});
      const std::lock_guard lock(mutex);
      if (--running == 0) ended.notify_one();
    });
  }
  {
    std::unique_lock lock(mutex);
    while (!ended.wait_for(lock, kReportInterval, [&] { return running == 0; })) {
      lock.unlock();
      reporter.report();
      lock.lock();
    }
  }
  for (std::thread& worker : workers) worker.join();
}

}  // namespace

GirthField girthField(const SurfaceMesh& mesh, GirthMethod method, const ExecutionContext& context,
                      const std::function<void(const GirthPartial&)>& onPartial) {
  Work work{mesh,
            method,
            context,
            coarseToFineOrder(mesh),
            {},
            {},
            {},
            {},
            {},
            {},
            std::vector<std::atomic<bool>>(mesh.vertexCount())};
  work.field.values.assign(mesh.vertexCount(), std::numeric_limits<double>::quiet_NaN());
  work.field.kinds.assign(mesh.vertexCount(), LoopKind::Loop);

  if (method == GirthMethod::Exact) {
    work.unfolding = std::make_shared<const geodesic::Unfolding>(mesh);
  } else if (method == GirthMethod::Marched) {
    work.stencils.emplace(mesh);
  }
  const unsigned threads = std::min(threadsOf(context), mesh.vertexCount());
  Reporter reporter(work, onPartial);
  if (threads == 1) {
    // No thread of its own: so it runs where there are none, as in the single-threaded WebAssembly
    // module.
    auto last = std::chrono::steady_clock::now();
    computeVertices(work, [&] {
      const auto now = std::chrono::steady_clock::now();
      if (now - last < kReportInterval) return;
      last = now;
      reporter.report();
    });
  } else {
    runThreads(work, threads, reporter);
  }
  reporter.report();
  work.field.computed = work.done.load();
  return std::move(work.field);
}

std::vector<Index> coarseToFineOrder(const SurfaceMesh& mesh) {
  // Neighbours on a space-filling curve are neighbours in space: the curve is cut into short runs,
  // and the runs taken in bit-reversed order, which spreads every prefix evenly over the curve.
  // First comes one vertex of each run; then the runs are filled, one after the other, since
  // neighbours find the surface around them still in the processor's cache.
  constexpr std::size_t kRun = 8;
  std::vector<Vec3> points(mesh.vertexCount());
  for (Index v = 0; v < mesh.vertexCount(); ++v) points[v] = mesh.position(v);
  const std::vector<Index> curve = alongCurve(points);
  const std::size_t runs = (curve.size() + kRun - 1) / kRun;

  unsigned bits = 0;
  while ((std::size_t{1} << bits) < runs) ++bits;
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < std::size_t{1} << bits; ++i) {
    std::size_t reversed = 0;
    for (unsigned b = 0; b < bits; ++b) reversed |= (i >> b & 1) << (bits - 1 - b);
    if (reversed < runs) starts.push_back(reversed * kRun);
  }
  std::vector<Index> order;
  order.reserve(curve.size());
  for (const std::size_t start : starts) order.push_back(curve[start]);
  for (const std::size_t start : starts) {
    for (std::size_t i = start + 1; i < std::min(start + kRun, curve.size()); ++i) {
      order.push_back(curve[i]);
    }
  }
  return order;
}

}  // namespace girth
