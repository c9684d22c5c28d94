#include "study/model_fields.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include "files/path_of.h"
#include "files/read_file.h"
#include "girth/io/read_mesh.h"
#include "girth/parallel.h"
#include "model/loading.h"
#include "text/ending.h"

namespace girth::cli {
namespace {

using study::FieldGroup;
using study::StudyField;
using study::StudyFields;

/// Files above this are worked on one at a time.
constexpr std::uintmax_t kLargeFile = 4u << 20;

bool isLarge(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(io::pathOf(path), error);
  return !error && size > kLargeFile;
}

void append(StudyFields& all, StudyFields&& some) {
  all.weights = std::move(some.weights);
  for (StudyField& field : some.fields) all.fields.push_back(std::move(field));
}

}  // namespace

Result<Digest> contentOf(const std::string& path, const ModelOptions& preparing) {
  const auto bytes = io::readFile(path);
  if (!bytes) return bytes.error();
  Sha256 sum;
  sum.add(bytes.value());
  if (io::endingOf(path) == ".gltf") {
    const auto beside = io::resourcesBeside(path);
    const auto model = io::readModel(bytes.value(), path, [&](std::string_view name) {
      auto resource = beside(name);
      sum.add(name);
      if (resource) sum.add(*resource);
      return resource;
    });
    if (!model) return model.error();
  }
  const Digest content = sum.finish();
  const std::string preparation = preparationText(preparing);
  if (preparation.empty()) return content;
  return Sha256().add(std::as_bytes(std::span(content))).add(preparation).finish();
}

void ModelFields::note(const std::string& text) {
  const std::lock_guard lock(mutex_);
  notes_.push_back(text);
}

std::vector<std::string> ModelFields::notes() const {
  std::vector<std::string> sorted = notes_;
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

Result<StudyFields> ModelFields::fieldsOf(const Work& work, const ExecutionContext& context) {
  StudyFields all;
  std::vector<FieldGroup> missing;
  for (const FieldGroup group : groups_) {
    const Digest key = FieldCache::keyOf(work.content, group, parameters_);
    FieldCache::Found found = cache_.find(key);
    if (found.fields) {
      append(all, std::move(*found.fields));
      ++taken_;
      continue;
    }
    if (found.damaged) {
      note(work.name + ": the cache entry of " + std::string(toString(group)) +
           " is damaged; computed again");
    }
    missing.push_back(group);
  }
  if (missing.empty()) return all;
  const auto loaded = loadModel(work.path, preparing_);
  if (!loaded) return loaded.error();
  const auto surface = study::studySurface(loaded.value().mesh, parameters_, context);
  if (!surface) return surface.error();
  for (const FieldGroup group : missing) {
    auto fields = study::studyFields(surface.value(), group, parameters_, context);
    if (!fields) return fields.error();
    ++computed_;
    const Digest key = FieldCache::keyOf(work.content, group, parameters_);
    if (const auto problem = cache_.store(key, fields.value())) {
      note(work.name + ": its " + std::string(toString(group)) +
           " could not be kept: " + problem->message);
    }
    append(all, std::move(fields).value());
  }
  return all;
}

bool ModelFields::forEach(const std::vector<Work>& works, const Use& use) {
  std::vector<std::size_t> small, large;
  for (std::size_t i = 0; i < works.size(); ++i) {
    (isLarge(works[i].path) ? large : small).push_back(i);
  }
  const auto workOn = [&](std::size_t number, const ExecutionContext& context) {
    std::optional<Result<StudyFields>> fields;
    try {
      fields = fieldsOf(works[number], context);
    } catch (const std::bad_alloc&) {
      fields =
          Result<StudyFields>(makeError(ErrorCode::OutOfMemory, -1, "there is not enough memory"));
    }
    if (!context.cancelled()) use(number, *fields);
  };
  const auto report = [&](double done) {
    if (context_.onProgress) context_.onProgress(done / static_cast<double>(works.size()));
  };
  const ExecutionContext alone{1, context_.cancel, {}};
  const auto smallCount = static_cast<double>(small.size());
  const ExecutionContext several{context_.threads, context_.cancel,
                                 [&](double fraction) { report(fraction * smallCount); }};
  if (!small.empty()) {
    parallelFor(small.size(), 1, several, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) workOn(small[i], alone);
    });
  }
  const ExecutionContext together{context_.threads, context_.cancel, {}};
  double done = smallCount;
  for (const std::size_t number : large) {
    if (context_.cancelled()) break;
    workOn(number, together);
    report(++done);
  }
  return !context_.cancelled();
}

}  // namespace girth::cli
