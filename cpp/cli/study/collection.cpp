#include "study/collection.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>

#include "files/path_of.h"
#include "files/read_file.h"
#include "text/ending.h"

namespace girth::cli {
namespace {

namespace fs = std::filesystem;

/// A file of a class, as a list names it.
struct Listed {
  fs::path path;
  std::string name, ofClass;
};

struct Listing {
  std::vector<Listed> models;
  /// Also those without models.
  std::vector<std::string> classes;
  std::vector<std::string> notes;
};

bool isModelName(const fs::path& path) {
  constexpr std::array<std::string_view, 6> kEndings{".glb", ".gltf", ".obj",
                                                     ".ply", ".stl",  ".off"};
  return std::find(kEndings.begin(), kEndings.end(), io::endingOf(path.string())) != kEndings.end();
}

/// All models below a folder, in the order of their paths.
std::vector<fs::path> modelsBelow(const fs::path& folder) {
  std::vector<fs::path> models;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    // Also broken links: they are reported as absent later.
    if (!entry->is_directory(ignored) && isModelName(entry->path())) {
      models.push_back(entry->path());
    }
  }
  std::sort(models.begin(), models.end());
  return models;
}

Error malformed(const std::string& file, std::size_t line, const std::string& what) {
  Error error = makeError(ErrorCode::MalformedFile, static_cast<std::int64_t>(line),
                          file + ", line " + std::to_string(line) + ": " + what);
  error.hint = "a class file is a .csv with the columns file and class, or a .cla of PSB 1";
  return error;
}

Result<std::string> textOf(const std::string& path) {
  const auto bytes = io::readFile(path);
  if (!bytes) {
    Error error = bytes.error();
    error.message = path + ": " + error.message;
    return error;
  }
  std::string text(reinterpret_cast<const char*>(bytes.value().data()), bytes.value().size());
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (std::string_view(text).substr(0, kMark.size()) == kMark) text.erase(0, kMark.size());
  return text;
}

std::string trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return "";
  return std::string(text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1));
}

/// The fields of one line; quotes as RFC 4180 has them. Nothing where a quote is not closed.
std::optional<std::vector<std::string>> csvFields(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted) {
      if (c == '"' && i + 1 < line.size() && line[i + 1] == '"') {
        fields.back() += line[++i];
      } else if (c == '"') {
        quoted = false;
      } else {
        fields.back() += c;
      }
    } else if (c == '"') {
      quoted = true;
    } else if (c == ',') {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  if (quoted) return std::nullopt;
  for (std::string& field : fields) field = trimmed(field);
  return fields;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(trimmed(std::string_view(text).substr(at, end - at)));
    at = end + 1;
  }
  return lines;
}

Result<Listing> readCsv(const fs::path& folder, const std::string& file) {
  const auto text = textOf(file);
  if (!text) return text.error();
  const std::vector<std::string> lines = linesOf(text.value());
  std::optional<std::size_t> fileColumn, classColumn;
  Listing listing;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].empty()) continue;
    const auto fields = csvFields(lines[i]);
    if (!fields) return malformed(file, i + 1, "a quote is not closed");
    if (!fileColumn) {
      for (std::size_t column = 0; column < fields->size(); ++column) {
        if ((*fields)[column] == "file") fileColumn = column;
        if ((*fields)[column] == "class") classColumn = column;
      }
      if (!fileColumn || !classColumn) {
        return malformed(file, i + 1, "the header has no column file, or none named class");
      }
      continue;
    }
    const auto field = [&](std::size_t column) {
      return column < fields->size() ? (*fields)[column] : std::string();
    };
    const std::string name = field(*fileColumn), ofClass = field(*classColumn);
    if (name.empty() || ofClass.empty()) {
      listing.notes.push_back(file + ", line " + std::to_string(i + 1) + ": there is no " +
                              (name.empty() ? "file" : "class") + " in it; left out");
      if (!ofClass.empty()) listing.classes.push_back(ofClass);
      continue;
    }
    listing.classes.push_back(ofClass);
    listing.models.push_back({folder / io::pathOf(name), name, ofClass});
  }
  if (!fileColumn) return malformed(file, 1, "it is empty");
  return listing;
}

/// The number that a model's name ends with: 7 of T7.off and m007.off.
std::optional<std::uint64_t> numberOf(const fs::path& path) {
  const std::string stem = path.stem().string();
  std::size_t begin = stem.size();
  while (begin > 0 && stem[begin - 1] >= '0' && stem[begin - 1] <= '9') --begin;
  if (begin == stem.size() || stem.size() - begin > 18) return std::nullopt;
  return std::stoull(stem.substr(begin));
}

std::string nameBelow(const fs::path& path, const fs::path& folder) {
  return path.lexically_relative(folder).generic_string();
}

/// Words and the lines they stand on.
struct Word {
  std::string text;
  std::size_t line;
};

std::vector<Word> wordsOf(const std::string& text) {
  std::vector<Word> words;
  std::size_t line = 1;
  bool inside = false;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    if (!blank) {
      if (!inside) words.push_back({"", line});
      words.back().text += c;
    }
    inside = !blank;
    if (c == '\n') ++line;
  }
  return words;
}

std::optional<std::uint64_t> wholeNumber(const std::string& text) {
  if (text.empty() || text.size() > 18 ||
      !std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; })) {
    return std::nullopt;
  }
  return std::stoull(text);
}

/// "PSB 1", the numbers of classes and models, then for each class its name, its parent's name, its
/// number of models, and their numbers (Shilane et al. 2004).
Result<Listing> readCla(const fs::path& folder, const std::string& file) {
  const auto text = textOf(file);
  if (!text) return text.error();
  Listing listing;
  std::map<std::uint64_t, fs::path> byNumber;
  for (const fs::path& path : modelsBelow(folder)) {
    const auto number = numberOf(path);
    if (!number) continue;
    const auto [entry, added] = byNumber.emplace(*number, path);
    if (!added) {
      listing.notes.push_back(nameBelow(path, folder) + " has the same number as " +
                              nameBelow(entry->second, folder) + "; left out");
    }
  }
  const std::vector<Word> words = wordsOf(text.value());
  const auto lineAt = [&](std::size_t at) {
    return words.empty() ? 1 : words[std::min(at, words.size() - 1)].line;
  };
  if (words.size() < 4 || words[0].text != "PSB" || words[1].text != "1" ||
      !wholeNumber(words[2].text) || !wholeNumber(words[3].text)) {
    return malformed(file, 1, "it does not begin with PSB 1 and the numbers of classes and models");
  }
  std::set<std::string> parents, empty;
  for (std::size_t at = 4; at < words.size();) {
    if (at + 2 >= words.size()) return malformed(file, lineAt(at), "a class is cut off");
    const std::string& name = words[at].text;
    parents.insert(words[at + 1].text);
    const auto count = wholeNumber(words[at + 2].text);
    if (!count) return malformed(file, words[at + 2].line, "the class has no number of models");
    at += 3;
    if (*count > words.size() - at) return malformed(file, lineAt(at), "a class is cut off");
    if (*count == 0) empty.insert(name);
    for (std::uint64_t i = 0; i < *count; ++i, ++at) {
      const auto number = wholeNumber(words[at].text);
      if (!number) {
        return malformed(file, words[at].line, "\"" + words[at].text + "\" is no model's number");
      }
      const auto found = byNumber.find(*number);
      if (found == byNumber.end()) {
        listing.notes.push_back(file + ", line " + std::to_string(words[at].line) +
                                ": there is no model " + words[at].text + "; left out");
        continue;
      }
      listing.models.push_back({found->second, nameBelow(found->second, folder), name});
    }
    if (*count > 0) listing.classes.push_back(name);
  }
  for (const std::string& name : empty) {
    // A class of classes has no models of its own.
    if (parents.count(name) == 0) listing.classes.push_back(name);
  }
  return listing;
}

Listing readFolders(const fs::path& folder) {
  Listing listing;
  std::error_code error;
  std::vector<fs::path> folders;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_directory(ignored)) {
      folders.push_back(entry->path());
    } else if (isModelName(entry->path())) {
      listing.notes.push_back(entry->path().filename().string() +
                              ": it is in no class's folder; left out");
    }
  }
  std::sort(folders.begin(), folders.end());
  std::sort(listing.notes.begin(), listing.notes.end());
  for (const fs::path& path : folders) {
    const std::string name = path.filename().string();
    listing.classes.push_back(name);
    for (const fs::path& model : modelsBelow(path)) {
      listing.models.push_back({model, nameBelow(model, folder), name});
    }
  }
  return listing;
}

/// The class file of a folder for which none is named; empty where there is none.
std::string classFileOf(const fs::path& folder) {
  std::error_code ignored;
  if (fs::exists(folder / "classes.csv", ignored)) return (folder / "classes.csv").string();
  std::vector<fs::path> found;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (io::endingOf(entry->path().string()) == ".cla") found.push_back(entry->path());
  }
  return found.size() == 1 ? found.front().string() : "";
}

Result<Listing> listingOf(const CollectionSource& source) {
  std::error_code ignored;
  if (!fs::is_directory(io::pathOf(source.folder), ignored)) {
    return makeError(ErrorCode::FileNotFound, -1, "there is no folder " + source.folder);
  }
  const std::string file =
      source.classes.empty() ? classFileOf(io::pathOf(source.folder)) : source.classes;
  if (file.empty()) return readFolders(io::pathOf(source.folder));
  return io::endingOf(file) == ".cla" ? readCla(io::pathOf(source.folder), file)
                                      : readCsv(io::pathOf(source.folder), file);
}

}  // namespace

Result<Collection> findCollection(const std::vector<CollectionSource>& sources) {
  std::map<std::string, std::vector<CollectionModel>> byClass;
  std::map<std::string, std::string> classOfPath;
  Collection collection;
  for (const CollectionSource& source : sources) {
    auto listing = listingOf(source);
    if (!listing) return listing.error();
    auto& notes = listing.value().notes;
    collection.notes.insert(collection.notes.end(), notes.begin(), notes.end());
    for (const std::string& name : listing.value().classes) byClass[name];
    for (Listed& model : listing.value().models) {
      std::error_code error;
      const fs::path canonical = fs::canonical(model.path, error);
      if (error || !fs::is_regular_file(canonical, error)) {
        collection.notes.push_back(model.name + ": there is no such file; left out");
        continue;
      }
      const auto [entry, added] = classOfPath.emplace(canonical.string(), model.ofClass);
      if (!added) {
        collection.notes.push_back(model.name + ": it is listed twice" +
                                   (entry->second == model.ofClass
                                        ? "; counted once"
                                        : ", in " + entry->second + " and in " + model.ofClass +
                                              "; only the first counts"));
        continue;
      }
      // Names from several folders are distinguished by the folder.
      const std::string name =
          sources.size() == 1
              ? model.name
              : (io::pathOf(source.folder).lexically_normal().filename() / io::pathOf(model.name))
                    .generic_string();
      byClass[model.ofClass].push_back({name, model.path.string(), 0});
    }
  }
  for (auto& [name, models] : byClass) {
    if (models.empty()) {
      collection.notes.push_back("class " + name + ": it has no models; left out");
      continue;
    }
    const auto number = static_cast<std::uint32_t>(collection.classes.size());
    collection.classes.push_back(name);
    for (CollectionModel& model : models) {
      model.ofClass = number;
      collection.models.push_back(std::move(model));
    }
  }
  if (collection.models.empty()) {
    Error error = makeError(ErrorCode::FileNotFound, -1, "there is no model in a class");
    error.hint = "name a folder whose folders are classes, or use --classes FILE";
    return error;
  }
  return collection;
}

}  // namespace girth::cli
