// The fields of many models, computed or taken from the cache, on all threads.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "girth/execution.h"
#include "girth/study/study_fields.h"
#include "model/model_options.h"
#include "study/collection.h"
#include "study/field_cache.h"

namespace girth::cli {

/// The digest of a file, of the files that it refers to, and of what is asked of its preparation.
/// Errors: those of reading.
Result<Digest> contentOf(const std::string& path, const ModelOptions& preparing);

class ModelFields {
 public:
  ModelFields(const FieldCache& cache, ModelOptions preparing, study::FieldParameters parameters,
              std::vector<study::FieldGroup> groups, ExecutionContext context)
      : cache_(cache),
        preparing_(std::move(preparing)),
        parameters_(parameters),
        groups_(std::move(groups)),
        context_(std::move(context)) {}

  struct Work {
    std::string name, path;
    Digest content{};
  };
  /// Called with the number of the work and its fields, or why there are none; by several threads
  /// at once.
  using Use = std::function<void(std::size_t number, const Result<study::StudyFields>& fields)>;

  /// All fields of all models. Small files are taken several at a time; large ones one after
  /// another, each on all threads. False if cancelled.
  bool forEach(const std::vector<Work>& works, const Use& use);

  /// Entries that were computed, and taken from the cache; for people.
  std::size_t computed() const { return computed_; }
  std::size_t taken() const { return taken_; }
  /// Damaged entries, and those that could not be written: one line each, in alphabetical order.
  std::vector<std::string> notes() const;

 private:
  Result<study::StudyFields> fieldsOf(const Work& work, const ExecutionContext& context);
  void note(const std::string& text);

  const FieldCache& cache_;
  ModelOptions preparing_;
  study::FieldParameters parameters_;
  std::vector<study::FieldGroup> groups_;
  ExecutionContext context_;
  std::atomic<std::size_t> computed_{0}, taken_{0};
  std::mutex mutex_;
  std::vector<std::string> notes_;
};

}  // namespace girth::cli
