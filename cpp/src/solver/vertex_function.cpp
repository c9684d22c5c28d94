#include "girth/vertex_function.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <utility>

#include "girth/parallel.h"
#include "mesh/space_filling_curve.h"
#include "threads.h"

namespace girth {

namespace {

/// How often the calling thread reports.
constexpr auto kReportInterval = std::chrono::milliseconds(40);

/// The work that the threads share: they take vertices from `order` one by one and mark them
/// finished.
struct Work {
  std::vector<Vertex> order;
  std::atomic<std::size_t> taken{0};
  std::atomic<std::size_t> done{0};
  std::vector<std::atomic<bool>> finished;  // by place in `order`

  explicit Work(std::vector<Vertex> vertices)
      : order(std::move(vertices)), finished(order.size()) {}
};

/// Reports what was finished since the last time, in order; a vertex still in work does not hold up
/// those behind it.
class Reporter {
 public:
  Reporter(const Work& work, const ExecutionContext& context,
           const std::function<void(std::span<const Vertex>)>& onFinished)
      : work_(work),
        context_(context),
        onFinished_(onFinished),
        reported_(work.order.size(), false) {}

  void report() {
    if (onFinished_) {
      vertices_.clear();
      const std::size_t end = std::min(work_.taken.load(), work_.order.size());
      for (std::size_t place = begin_; place < end; ++place) {
        if (reported_[place] || !work_.finished[place].load(std::memory_order_acquire)) continue;
        reported_[place] = true;
        vertices_.push_back(work_.order[place]);
      }
      while (begin_ < end && reported_[begin_]) ++begin_;
      if (!vertices_.empty()) onFinished_(vertices_);
    }
    const double fraction =
        static_cast<double>(work_.done.load()) / static_cast<double>(work_.order.size());
    if (context_.onProgress && fraction > fraction_) context_.onProgress(fraction);
    fraction_ = std::max(fraction_, fraction);
  }

 private:
  const Work& work_;
  const ExecutionContext& context_;
  const std::function<void(std::span<const Vertex>)>& onFinished_;
  std::vector<bool> reported_;
  std::size_t begin_{0};  // everything before has been reported
  double fraction_{0};
  std::vector<Vertex> vertices_;
};

}  // namespace

std::size_t forEachVertex(std::vector<Vertex> vertices, const ExecutionContext& context,
                          const std::function<std::function<bool(Vertex vertex)>()>& startThread,
                          const std::function<void(std::span<const Vertex> vertices)>& onFinished) {
  if (vertices.empty()) return 0;
  Work work(std::move(vertices));
  // The calling thread computes too, and reports between two vertices: so callbacks come from it
  // alone, and it works without threads too. One that only waited would be woken a
  // thousand times a second as WebAssembly, and take the others' place each time.
  Reporter reporter(work, context, onFinished);
  auto last = std::chrono::steady_clock::now();
  const unsigned threads =
      static_cast<unsigned>(std::min<std::size_t>(threadCount(context), work.order.size()));
  onThreads(threads, [&](bool calling, const std::atomic<bool>& failed) {
    const std::function<bool(Vertex)> compute = startThread();
    while (!context.cancelled() && !failed) {
      const std::size_t place = work.taken.fetch_add(1, std::memory_order_relaxed);
      if (place >= work.order.size() || !compute(work.order[place])) break;
      work.finished[place].store(true, std::memory_order_release);
      work.done.fetch_add(1, std::memory_order_relaxed);
      if (!calling) continue;
      const auto now = std::chrono::steady_clock::now();
      if (now - last < kReportInterval) continue;
      last = now;
      reporter.report();
    }
  });
  reporter.report();
  return work.done.load();
}

std::size_t forEachVertex(const SurfaceMesh& mesh, const ExecutionContext& context,
                          const std::function<std::function<bool(Vertex vertex)>()>& startThread,
                          const std::function<void(std::span<const Vertex> vertices)>& onFinished) {
  return forEachVertex(coarseToFineOrder(mesh), context, startThread, onFinished);
}

std::string budgetNote(Index withoutValue, Index vertices) {
  if (withoutValue == 0) return "";
  return std::to_string(withoutValue) + " of " + std::to_string(vertices) +
         " vertices have no value: they would take more than 67 million windows";
}

std::vector<Vertex> coarseToFineOrder(const SurfaceMesh& mesh, std::size_t run) {
  // Neighbours on a space-filling curve are neighbours in space: the curve is cut into runs, and
  // the runs taken in bit-reversed order, which spreads every prefix evenly over the curve.
  std::vector<Vec3> points(mesh.vertexCount());
  for (const Vertex v : mesh.vertices()) points[v] = mesh.position(v);
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
  std::vector<Vertex> order;
  order.reserve(curve.size());
  for (const std::size_t start : starts) order.emplace_back(curve[start]);
  for (const std::size_t start : starts) {
    for (std::size_t i = start + 1; i < std::min(start + run, curve.size()); ++i) {
      order.emplace_back(curve[i]);
    }
  }
  return order;
}

}  // namespace girth
