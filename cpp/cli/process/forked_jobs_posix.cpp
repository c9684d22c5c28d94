#include "process/forked_jobs.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <vector>

#include "girth/error.h"
#include "process/exit_codes.h"
#include "process/interrupt.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using TemporaryFile = std::unique_ptr<std::FILE, CloseFile>;

/// A process that works on one item, and what it prints.
struct Job {
  pid_t process{0};
  TemporaryFile output{std::tmpfile()}, errors{std::tmpfile()};
  std::optional<int> exitCode{};
};

void copyTo(std::FILE* from, std::FILE* to) {
  std::rewind(from);
  std::array<char, 4096> block;
  for (std::size_t got; (got = std::fread(block.data(), 1, block.size(), from)) > 0;) {
    std::fwrite(block.data(), 1, got, to);
  }
  std::fflush(to);
}

class Jobs {
 public:
  Jobs(std::span<const std::string> items, const std::function<int(std::size_t)>& work)
      : items_(items), work_(work) {}

  int run(unsigned atOnce) {
    const std::atomic<bool>& interrupted = catchInterrupts();
    ProgressLine progress(std::to_string(items_.size()) + " models");
    std::size_t working = 0;
    while (printed_ < items_.size()) {
      while (!interrupted && working < atOnce && jobs_.size() < items_.size() && start()) {
        ++working;
      }
      if (interrupted) stopAll();
      if (working == 0) break;
      if (waitForOne()) --working;
      print();
      progress.show(static_cast<double>(printed_) / static_cast<double>(items_.size()));
    }
    if (interrupted && printed_ < items_.size()) greatest_ = std::max(greatest_, 3);
    return greatest_;
  }

 private:
  bool start() {
    Job job;
    std::fflush(stdout);
    if (!job.output || !job.errors || (job.process = fork()) < 0) {
      // Running jobs go on; the others start when there is room for them again.
      greatest_ = std::max(greatest_, reportError(items_[jobs_.size()], noProcess()));
      job.exitCode = exitCodeOf(ErrorCode::OutOfMemory);
      job.process = 0;
      if (!job.output || !job.errors) return false;
    } else if (job.process == 0) {
      // Ctrl-C reaches the first process only, which stops the others, each once.
      setpgid(0, 0);
      dup2(fileno(job.output.get()), STDOUT_FILENO);
      dup2(fileno(job.errors.get()), STDERR_FILENO);
      const int exitCode = work_(jobs_.size());
      std::fflush(stdout);
      std::fflush(stderr);
      _exit(exitCode);
    }
    jobs_.push_back(std::move(job));
    return jobs_.back().process > 0;
  }

  static Error noProcess() {
    return makeError(ErrorCode::OutOfMemory, -1, "no process could be started for it");
  }

  /// Waits until one of the processes has ended, or a signal has come.
  bool waitForOne() {
    int status = 0;
    const pid_t ended = waitpid(-1, &status, 0);
    const auto job = std::find_if(jobs_.begin(), jobs_.end(), [&](const Job& one) {
      return one.process == ended && !one.exitCode;
    });
    if (ended <= 0 || job == jobs_.end()) return false;
    if (WIFEXITED(status)) {
      job->exitCode = WEXITSTATUS(status);
    } else {
      const Error killed =
          makeError(ErrorCode::Internal, -1,
                    "its process was ended by signal " + std::to_string(WTERMSIG(status)));
      job->exitCode = reportError(items_[static_cast<std::size_t>(job - jobs_.begin())], killed);
    }
    return true;
  }

  /// Prints the output of the jobs that are next in order and have ended.
  void print() {
    for (; printed_ < jobs_.size() && jobs_[printed_].exitCode; ++printed_) {
      Job& job = jobs_[printed_];
      copyTo(job.output.get(), stdout);
      copyTo(job.errors.get(), stderr);
      greatest_ = std::max(greatest_, *job.exitCode);
      job.output.reset();
      job.errors.reset();
    }
  }

  void stopAll() {
    if (isStopped_) return;
    isStopped_ = true;
    for (const Job& job : jobs_) {
      if (job.process > 0 && !job.exitCode) kill(job.process, SIGINT);
    }
  }

  std::span<const std::string> items_;
  const std::function<int(std::size_t)>& work_;
  std::vector<Job> jobs_;
  std::size_t printed_{0};
  bool isStopped_{false};
  int greatest_{0};
};

}  // namespace

int forkedJobs(std::span<const std::string> items, unsigned jobs,
               const std::function<int(std::size_t item)>& work) {
  return Jobs(items, work).run(jobs);
}

}  // namespace girth::cli
