#include "working.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <thread>
#include <vector>

namespace py = pybind11;

namespace girth::python {
namespace {

using std::chrono::milliseconds;

/// How often the waiting thread looks after signals and progress.
constexpr milliseconds kTick{20};
/// How long cancelled work is waited for: Ctrl-C is answered within 200 ms, though some
/// computations (of spectra) stop later.
constexpr milliseconds kPatience{100};

/// The state that the working and the waiting thread share.
struct Job {
  std::function<void(const ExecutionContext&)> work;
  std::atomic<bool> cancel{false};
  std::atomic<double> fraction{0};
  std::mutex mutex;
  std::condition_variable ended;
  bool isDone{false};
  std::exception_ptr failure;

  bool waitFor(milliseconds time) {
    std::unique_lock lock(mutex);
    return ended.wait_for(lock, time, [this] { return isDone; });
  }
};

void work(Job& job, unsigned threads) {
  ExecutionContext context{threads, &job.cancel, {}};
  context.onProgress = [&job](double fraction) { job.fraction = fraction; };
  std::exception_ptr failure;
  try {
    job.work(context);
  } catch (const std::bad_alloc&) {
    failure = std::make_exception_ptr(
        ThrownError(makeError(ErrorCode::OutOfMemory, -1, "there is not enough memory")));
  } catch (...) {
    failure = std::current_exception();
  }
  // Objects that the work owns go with its own thread, before it counts as done.
  job.work = {};
  const std::lock_guard lock(job.mutex);
  job.failure = failure;
  job.isDone = true;
  job.ended.notify_all();
}

struct Abandoned {
  std::shared_ptr<Job> job;
  std::thread thread;
};

/// Guarded by the interpreter's lock.
std::vector<Abandoned>& abandoned() {
  static std::vector<Abandoned> all;
  return all;
}

/// Cancels the work and waits for it, but not for long.
void stop(const std::shared_ptr<Job>& job, std::thread thread) {
  job->cancel = true;
  bool isDone = false;
  {
    const py::gil_scoped_release released;
    isDone = job->waitFor(kPatience);
    if (isDone) thread.join();
  }
  if (!isDone) abandoned().push_back({job, std::move(thread)});
}

}  // namespace

void runWork(const Running& running, std::function<void(const ExecutionContext&)> work) {
  const auto job = std::make_shared<Job>();
  job->work = std::move(work);
  std::thread thread([job, threads = running.threads] { python::work(*job, threads); });
  const bool reports = !running.progress.is_none();
  double reported = -1;
  bool isDone = false;
  try {
    while (!isDone) {
      {
        const py::gil_scoped_release released;
        isDone = job->waitFor(kTick);
      }
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      const double fraction = isDone && !job->failure ? 1 : job->fraction.load();
      if (reports && fraction > reported) {
        running.progress(fraction);
        reported = fraction;
      }
    }
  } catch (...) {
    stop(job, std::move(thread));
    throw;
  }
  thread.join();
  if (job->failure) std::rethrow_exception(job->failure);
}

void waitForAbandoned() {
  std::vector<Abandoned> all = std::move(abandoned());
  abandoned().clear();
  const py::gil_scoped_release released;
  for (Abandoned& one : all) one.thread.join();
}

}  // namespace girth::python
