#include "girth/vertex_function.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <thread>

#include "mesh/space_filling_curve.h"
#include "parallel.h"

namespace girth {

namespace {

/// How often the calling thread reports.
constexpr auto kReportInterval = std::chrono::milliseconds(40);

/// What the threads share: they take vertices from `order` in turn and mark them done.
struct Work {
  const VertexFunction& function;
  const ExecutionContext& context;
  std::vector<Index> order;
  VertexValues field;

  std::atomic<std::size_t> taken{0};
  std::atomic<std::size_t> done{0};
  std::vector<std::atomic<bool>> finished;  // by place in `order`
};

/// The life of one thread: vertices, one after the other, until none are left; `afterEach` after
/// each.
template <class AfterEach>
void computeVertices(Work& work, AfterEach afterEach) {
  const VertexEvaluator evaluate = work.function.evaluator(work.context);
  while (!work.context.cancelled()) {
    const std::size_t place = work.taken.fetch_add(1, std::memory_order_relaxed);
    if (place >= work.order.size()) break;
    const Index v = work.order[place];
    const auto value = evaluate(v);
    if (!value) break;  // cancelled: the vertices are in range
    work.field.values[v] = value.value().value;
    work.field.kinds[v] = value.value().kind;
    work.finished[place].store(true, std::memory_order_release);
    work.done.fetch_add(1, std::memory_order_relaxed);
    afterEach();
  }
}

/// Hands on what was finished since the last time, in order; a vertex still in work does not hold
/// up those behind it.
class Reporter {
 public:
  Reporter(Work& work, const std::function<void(const VertexPartial&)>& onPartial)
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
  const std::function<void(const VertexPartial&)>& onPartial_;
  std::vector<bool> reported_;
  std::size_t begin_{0};  // everything before has been reported
  double fraction_{0};
  std::vector<Index> vertices_;
  std::vector<double> values_;
  std::vector<LoopKind> kinds_;
};

}  // namespace

VertexValues evaluateAll(const SurfaceMesh& mesh, const VertexFunction& function,
                         const ExecutionContext& context,
                         const std::function<void(const VertexPartial&)>& onPartial) {
  Work work{function,
            context,
            coarseToFineOrder(mesh),
            {},
            {},
            {},
            std::vector<std::atomic<bool>>(mesh.vertexCount())};
  work.field.values.assign(mesh.vertexCount(), std::numeric_limits<double>::quiet_NaN());
  work.field.kinds.assign(mesh.vertexCount(), LoopKind::Loop);

  const unsigned threads = std::min(threadsOf(context), mesh.vertexCount());
  std::vector<std::thread> others;
  for (unsigned i = 1; i < threads; ++i) {
    others.emplace_back([&] { computeVertices(work, [] {}); });
  }
  // The calling thread computes too, and reports between two vertices: so callbacks come from it
  // alone, and where there are no threads it needs none. One that only waited would be woken a
  // thousand times a second as WebAssembly, and take the others' place each time.
  Reporter reporter(work, onPartial);
  auto last = std::chrono::steady_clock::now();
  computeVertices(work, [&] {
    const auto now = std::chrono::steady_clock::now();
    if (now - last < kReportInterval) return;
    last = now;
    reporter.report();
  });
  for (std::thread& other : others) other.join();
  reporter.report();
  work.field.computed = work.done.load();
  return std::move(work.field);
}

std::string budgetNote(Index withoutValue, Index vertices) {
  if (withoutValue == 0) return "";
  return std::to_string(withoutValue) + " of " + std::to_string(vertices) +
         " vertices have no value: they would take more than 67 million windows";
}

std::vector<Index> coarseToFineOrder(const SurfaceMesh& mesh, std::size_t run) {
  // Neighbours on a space-filling curve are neighbours in space: the curve is cut into runs, and
  // the runs taken in bit-reversed order, which spreads every prefix evenly over the curve.
  std::vector<Vec3> points(mesh.vertexCount());
  for (Index v = 0; v < mesh.vertexCount(); ++v) points[v] = mesh.position(v);
  const std::vector<Index> curve = alongCurve(points);
  const std::size_t runs = (curve.size() + run - 1) / run;

  unsigned bits = 0;
  while ((std::size_t{1} << bits) < runs) ++bits;
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < std::size_t{1} << bits; ++i) {
    std::size_t reversed = 0;
    for (unsigned b = 0; b < bits; ++b) reversed |= (i >> b & 1) << (bits - 1 - b);
    if (reversed < runs) starts.push_back(reversed * run);
  }
  std::vector<Index> order;
  order.reserve(curve.size());
  for (const std::size_t start : starts) order.push_back(curve[start]);
  for (const std::size_t start : starts) {
    for (std::size_t i = start + 1; i < std::min(start + run, curve.size()); ++i) {
      order.push_back(curve[i]);
    }
  }
  return order;
}

}  // namespace girth
