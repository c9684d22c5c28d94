#include "model_fields.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include "files.h"
#include "girth/io/read_mesh.h"

namespace girth::cli {
namespace {

using study::FieldGroup;
using study::StudyField;
using study::StudyFields;

/// Files above this are worked on one at a time.
constexpr std::uintmax_t kLargeFile = 4u << 20;

bool isLarge(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  return !error && size > kLargeFile;
}

unsigned threadsOf(const ExecutionContext& context) {
  return context.threads > 0 ? context.threads : std::max(1u, std::thread::hardware_concurrency());
}

void append(StudyFields& all, StudyFields&& some) {
  all.weights = std::move(some.weights);
  for (StudyField& field : some.fields) all.fields.push_back(std::move(field));
}

}  // namespace

Result<SurfaceMesh> readSurface(const std::string& path) {
  const auto bytes = readFile(path);
  if (!bytes) return bytes.error();
  auto loaded = io::readMesh(bytes.value(), path, resourcesBeside(path));
  if (!loaded) return loaded.error();
  return std::move(loaded.value().mesh);
}

Result<Digest> contentOf(const std::string& path) {
  const auto bytes = readFile(path);
  if (!bytes) return bytes.error();
  Sha256 sum;
  sum.add(bytes.value());
  if (extensionOf(path) == ".gltf") {
    const auto beside = resourcesBeside(path);
    const auto model = io::readModel(bytes.value(), path, [&](std::string_view name) {
      auto resource = beside(name);
      sum.add(name);
      if (resource) sum.add(*resource);
      return resource;
    });
    if (!model) return model.error();
  }
  return sum.finish();
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
  const auto mesh = readSurface(work.path);
  if (!mesh) return mesh.error();
  const auto surface = study::studySurface(mesh.value(), parameters_, context);
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
  std::atomic<std::size_t> next{0}, done{0};
  const auto workOn = [&](std::size_t number, const ExecutionContext& context) {
    std::optional<Result<StudyFields>> fields;
    try {
      fields = fieldsOf(works[number], context);
    } catch (const std::bad_alloc&) {
      fields =
          Result<StudyFields>(makeError(ErrorCode::OutOfMemory, -1, "there is not enough memory"));
    }
    if (!context.cancelled()) use(number, *fields);
    ++done;
  };
  const auto report = [&] {
    if (context_.onProgress && !works.empty()) {
      context_.onProgress(static_cast<double>(done) / static_cast<double>(works.size()));
    }
  };
  const ExecutionContext alone{1, context_.cancel, {}};
  const auto take = [&](bool reports) {
    for (std::size_t i = next++; i < small.size() && !context_.cancelled(); i = next++) {
      workOn(small[i], alone);
      if (reports) report();
    }
  };
  const auto threads = static_cast<unsigned>(
      std::min<std::size_t>(threadsOf(context_), std::max<std::size_t>(1, small.size())));
  std::vector<std::thread> others;
  for (unsigned i = 1; i < threads; ++i) others.emplace_back([&] { take(false); });
  take(true);
  for (std::thread& other : others) other.join();
  const ExecutionContext together{context_.threads, context_.cancel, {}};
  for (const std::size_t number : large) {
    if (context_.cancelled()) break;
    workOn(number, together);
    report();
  }
  return !context_.cancelled();
}

}  // namespace girth::cli
