#include "model/model_file.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "archive/inflate.h"
#include "archive/zip.h"
#include "files/read_file.h"
#include "formats/foreign_formats.h"
#include "process/files.h"
#include "process/report.h"
#include "text/ending.h"

namespace girth::cli {
namespace {

bool isModelName(const std::string& name) {
  static constexpr std::array<std::string_view, 6> kEndings{".glb", ".gltf", ".obj",
                                                            ".off", ".ply",  ".stl"};
  return std::find(kEndings.begin(), kEndings.end(), io::endingOf(name)) != kEndings.end();
}

/// A zip with its directory, shared by what reads files of it.
struct Archive {
  std::vector<std::byte> bytes;
  std::vector<ZipEntry> entries;

  const ZipEntry* find(std::string_view path) const {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const ZipEntry& entry) { return entry.path == path; });
    return found == entries.end() ? nullptr : &*found;
  }

  /// The models, those in the fewest folders first.
  std::vector<const ZipEntry*> models() const {
    std::vector<const ZipEntry*> models;
    for (const ZipEntry& entry : entries) {
      if (isModelName(entry.path)) models.push_back(&entry);
    }
    const auto rank = [](const ZipEntry* entry) {
      return std::tuple(std::count(entry->path.begin(), entry->path.end(), '/'), entry->path);
    };
    std::sort(models.begin(), models.end(),
              [&](const ZipEntry* a, const ZipEntry* b) { return rank(a) < rank(b); });
    return models;
  }
};

/// "a.obj, b.obj, ..."
std::string namesOf(const std::vector<const ZipEntry*>& entries) {
  constexpr std::size_t kShown = 8;
  std::string names;
  for (std::size_t i = 0; i < std::min(kShown, entries.size()); ++i) {
    names += (i == 0 ? "" : ", ") + entries[i]->path;
  }
  return names + (entries.size() > kShown ? ", ..." : "");
}

/// The foreign model in an archive without models, where it is known: the largest file that may be
/// a model of another format.
std::optional<Error> foreignModelIn(const Archive& archive) {
  std::vector<ZipEntry> entries = archive.entries;
  std::stable_sort(entries.begin(), entries.end(),
                   [](const ZipEntry& a, const ZipEntry& b) { return a.size > b.size; });
  constexpr std::size_t kMostTried = 16;
  if (entries.size() > kMostTried) entries.resize(kMostTried);
  for (const ZipEntry& entry : entries) {
    const auto content = unzipped(archive.bytes, entry);
    if (!content) continue;
    auto error = io::foreignModel(
        {reinterpret_cast<const char*>(content.value().data()), content.value().size()});
    if (!error) continue;
    error->message = entry.path + " in the zip: " + error->message;
    return error;
  }
  return std::nullopt;
}

Result<const ZipEntry*> chosenEntry(const Archive& archive, const std::string& path,
                                    const std::string& wanted) {
  const auto models = archive.models();
  if (!wanted.empty()) {
    if (const ZipEntry* entry = archive.find(wanted)) return entry;
    Error error = makeError(ErrorCode::FileNotFound, -1, "there is no " + wanted + " in the zip");
    if (!models.empty()) error.hint = "choose one of: " + namesOf(models);
    return error;
  }
  if (models.empty()) {
    if (auto error = foreignModelIn(archive)) return *std::move(error);
    return makeError(ErrorCode::UnknownFormat, -1,
                     "none of the " + std::to_string(archive.entries.size()) +
                         " files in the zip has the name of a model");
  }
  if (models.size() > 1) {
    printNote(path, models[0]->path + " of " + std::to_string(models.size()) +
                        " models in the zip; choose another with --entry");
  }
  return models[0];
}

Result<ModelFile> openZip(std::vector<std::byte> bytes, const std::string& path,
                          const std::string& wanted) {
  const auto archive = std::make_shared<Archive>();
  archive->bytes = std::move(bytes);
  auto entries = zipEntries(archive->bytes);
  if (!entries) return entries.error();
  archive->entries = std::move(entries).value();
  const auto entry = chosenEntry(*archive, path, wanted);
  if (!entry) return entry.error();
  auto content = unzipped(archive->bytes, *entry.value());
  if (!content) return content.error();
  const std::string name = entry.value()->path;
  const std::size_t slash = name.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : name.substr(0, slash + 1);
  auto resources = [archive,
                    folder](std::string_view resource) -> std::optional<std::vector<std::byte>> {
    const ZipEntry* beside = archive->find(folder + std::string(resource));
    if (beside == nullptr) return std::nullopt;
    auto found = unzipped(archive->bytes, *beside);
    if (!found) return std::nullopt;
    return std::move(found).value();
  };
  return ModelFile{std::move(content).value(), name, std::move(resources)};
}

}  // namespace

Result<ModelFile> openModel(const std::string& path, const std::string& entry) {
  const bool isInput = path == "-";
  auto bytes = isInput ? readStandardInput() : io::readFile(path);
  if (!bytes) return bytes.error();
  if (isZip(bytes.value())) return openZip(std::move(bytes).value(), path, entry);
  if (!entry.empty()) {
    return usageError("it is no zip, of which --entry could name a file", "leave --entry out");
  }
  ModelFile file{std::move(bytes).value(), path, {}};
  if (!isInput) file.resources = io::resourcesBeside(path);
  if (isGzip(file.bytes)) {
    auto content = gunzip(file.bytes);
    if (!content) return content.error();
    file.bytes = std::move(content).value();
    if (io::endingOf(path) == ".gz") file.name.resize(file.name.size() - 3);
  }
  return file;
}

}  // namespace girth::cli
