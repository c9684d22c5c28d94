// girth retrieve: how well the descriptors find shapes of the same class in a collection.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <system_error>

#include "collection.h"
#include "commands.h"
#include "field_cache.h"
#include "files.h"
#include "girth/io/number_text.h"
#include "girth/io/png.h"
#include "girth/io/thumbnail.h"
#include "girth/io/write_study.h"
#include "girth/retrieval/descriptor_rows.h"
#include "girth/retrieval/measures.h"
#include "girth/retrieval/pair_distances.h"
#include "girth/retrieval/signatures.h"
#include "interrupt.h"
#include "model_fields.h"
#include "progress_line.h"
#include "report.h"

namespace girth::cli {
namespace {

namespace fs = std::filesystem;
using retrieval::Descriptor;
using retrieval::DescriptorRows;
using retrieval::MeanMeasures;
using retrieval::PairDistances;
using retrieval::RetrievalMeasures;
using retrieval::Signatures;
using retrieval::StudyFields;

Error usage(const std::string& what, const std::string& hint) {
  Error error = makeError(ErrorCode::Usage, -1, what);
  error.hint = hint;
  return error;
}

Error stopped() {
  return makeError(ErrorCode::Cancelled, -1,
                   "stopped; the fields computed so far are in the cache");
}

void say(const std::string& text) { std::fprintf(stderr, "girth: note: %s\n", text.c_str()); }

/// The paper's, its composite both ways, and what does best without training.
std::vector<std::string> defaultDescriptors() {
  return {"igf",
          "igf-ms",
          "sdf",
          "geoaverage",
          "geofarthest",
          "hks",
          "sihks",
          "wks",
          "igf-sdf",
          "igf+sdf",
          "log-igf",
          "log-sdf",
          "log-igf+log-sdf",
          "log-igf+log-sdf+sihks"};
}

/// "2/8": the third of eight shares, counted from 0.
struct Shard {
  std::size_t number{0}, count{1};
};

Result<Shard> parseShard(const std::string& text) {
  constexpr double kMost = 1e6;
  const auto wholeNumber = [](const std::string& digits) {
    const double value = io::parseNumber(digits).value_or(-1);
    return value >= 0 && value <= kMost && value == std::floor(value) ? value : -1;
  };
  const std::size_t slash = std::min(text.find('/'), text.size());
  const double number = wholeNumber(text.substr(0, slash));
  const double count = wholeNumber(slash < text.size() ? text.substr(slash + 1) : "");
  if (number < 0 || number >= count) {
    return usage("\"" + text + "\" is no share", "say --shard I/N with I from 0 to N - 1");
  }
  return Shard{static_cast<std::size_t>(number), static_cast<std::size_t>(count)};
}

/// The models that have fields, and what became of the others.
struct Loaded {
  std::vector<CollectionModel> models;
  std::vector<std::string> classes;
  std::vector<std::pair<std::string, std::string>> failed;
  std::vector<std::string> notes;
};

std::string reasonOf(const Error& error) {
  return std::string(toString(error.code)) + ": " + error.message;
}

/// Every content once: the models that have it.
struct Contents {
  std::vector<ModelFields::Work> works;
  std::vector<std::vector<std::size_t>> models;
};

Contents contentsOf(const Collection& collection, Loaded& loaded) {
  Contents contents;
  std::map<Digest, std::size_t> known;
  for (std::size_t m = 0; m < collection.models.size(); ++m) {
    const CollectionModel& model = collection.models[m];
    const auto content = contentOf(model.path);
    if (!content) {
      loaded.failed.emplace_back(model.name, reasonOf(content.error()));
      continue;
    }
    const auto [entry, added] = known.emplace(content.value(), contents.works.size());
    if (added) {
      contents.works.push_back({model.name, model.path, content.value()});
      contents.models.emplace_back();
    } else {
      loaded.notes.push_back(model.name + ": it is a copy of " +
                             contents.works[entry->second].name + "; both count");
    }
    contents.models[entry->second].push_back(m);
  }
  return contents;
}

/// Greys of distances, from 0, dark, to twice the mean; several models to a pixel where there are
/// more than fit.
class MatrixPicture {
 public:
  static constexpr std::size_t kMost = 600;
  explicit MatrixPicture(std::size_t models)
      : models_(models), side_(std::min(models, kMost)), sums_(side_ * side_), counts_(sums_) {}

  void add(std::size_t model, const std::vector<double>& row) {
    const std::size_t y = model * side_ / models_;
    for (std::size_t i = 0; i < models_; ++i) {
      if (std::isnan(row[i])) continue;
      const std::size_t pixel = y * side_ + i * side_ / models_;
      sums_[pixel] += row[i];
      counts_[pixel] += 1;
    }
  }

  std::string png() const {
    constexpr double kLevels = 31;
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      sum += sums_[i];
      count += counts_[i];
    }
    const double white = sum > 0 ? 2 * sum / count : 1;
    std::vector<std::uint8_t> pixels;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      const double value = counts_[i] > 0 ? std::min(1.0, sums_[i] / counts_[i] / white) : 1;
      pixels.push_back(static_cast<std::uint8_t>(std::lround(value * kLevels) * 8));
    }
    const auto side = static_cast<std::uint32_t>(side_);
    return io::greyPng(pixels, side, side, 1);
  }

 private:
  std::size_t models_, side_;
  std::vector<double> sums_, counts_;
};

std::string csvName(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// A file's name for a descriptor.
std::string fileNameOf(const std::string& descriptor) {
  std::string name = descriptor;
  std::replace(name.begin(), name.end(), '*', 'x');
  return name;
}

/// The whole of `girth retrieve` after the options.
class Retrieval {
 public:
  Retrieval(const RetrieveOptions& options, std::vector<Descriptor> descriptors, Shard shard)
      : options_(options),
        descriptors_(std::move(descriptors)),
        shard_(shard),
        interrupted_(catchInterrupts()),
        cache_(options.cache.empty() ? (fs::path(options.output) / "cache").string()
                                     : options.cache) {}

  int run() {
    if (auto error = prepareFolders()) return reportError(options_.output, *error);
    auto collection = findCollection(sources());
    if (!collection) return reportError("", collection.error());
    const auto found = loadAll(collection.value());
    if (!found) return reportError("", found.error());
    if (shard_.count > 1) {
      std::printf("share %zu of %zu: %zu models, %zu fields computed, %zu were there\n",
                  shard_.number, shard_.count, shardModels_, computed_, taken_);
      return 0;
    }
    if (loaded_.models.size() < 2) {
      return reportError(
          "", makeError(ErrorCode::EmptyMesh, -1, "fewer than two models are left to compare"));
    }
    if (const auto error = compare()) return reportError(options_.output, *error);
    print();
    return 0;
  }

 private:
  std::vector<CollectionSource> sources() const {
    std::vector<CollectionSource> all;
    for (std::size_t i = 0; i < options_.folders.size(); ++i) {
      all.push_back({options_.folders[i], i < options_.classes.size() ? options_.classes[i] : ""});
    }
    return all;
  }

  std::optional<Error> prepareFolders() const {
    std::error_code error;
    fs::create_directories(fs::path(options_.output) / "distances", error);
    if (error) {
      return makeError(ErrorCode::FileUnwritable, -1, "it cannot be made: " + error.message());
    }
    if (auto problem = checkWritable((fs::path(options_.output) / "index.html").string())) {
      return problem;
    }
    return cache_.open();
  }

  ExecutionContext context(ProgressLine& progress) const {
    ExecutionContext context;
    context.threads = options_.threads;
    context.cancel = &interrupted_;
    context.onProgress = [&progress](double fraction) { progress.show(fraction); };
    return context;
  }

  /// Computes the fields of all models of this share, and their signatures.
  Result<bool> loadAll(const Collection& collection) {
    loaded_.notes = collection.notes;
    Contents contents = contentsOf(collection, loaded_);
    const std::vector<retrieval::FieldGroup> groups = retrieval::groupsOf(descriptors_);
    Signatures signatures(retrieval::termsOf(descriptors_), collection.models.size(),
                          options_.signatures);
    std::vector<ModelFields::Work> works;
    std::vector<std::vector<std::size_t>> models;
    for (std::size_t w = 0; w < contents.works.size(); ++w) {
      if (w % shard_.count != shard_.number) continue;
      works.push_back(std::move(contents.works[w]));
      models.push_back(std::move(contents.models[w]));
    }
    shardModels_ = works.size();
    std::vector<std::string> reasons(works.size());
    {
      ProgressLine progress("fields of " + std::to_string(works.size()) + " models");
      ModelFields fields(cache_, options_.fields, groups, context(progress));
      const bool done =
          fields.forEach(works, [&](std::size_t number, const Result<StudyFields>& computed) {
            if (!computed) {
              reasons[number] = reasonOf(computed.error());
              return;
            }
            if (shard_.count > 1) return;
            for (const std::size_t model : models[number]) signatures.add(model, computed.value());
          });
      if (!done) return stopped();
      computed_ = fields.computed();
      taken_ = fields.taken();
      const auto notes = fields.notes();
      loaded_.notes.insert(loaded_.notes.end(), notes.begin(), notes.end());
    }
    std::set<std::size_t> failed;
    for (std::size_t w = 0; w < works.size(); ++w) {
      if (reasons[w].empty()) continue;
      for (const std::size_t model : models[w]) {
        loaded_.failed.emplace_back(collection.models[model].name, reasons[w]);
      }
    }
    std::sort(loaded_.failed.begin(), loaded_.failed.end());
    for (const std::string& note : loaded_.notes) say(note);
    for (const auto& [name, reason] : loaded_.failed) say(name + ": left out: " + reason);
    if (shard_.count > 1) return true;
    if (auto finished = finishSignatures(signatures, works, models, groups); !finished) {
      return finished;
    }
    keep(collection, signatures);
    return true;
  }

  /// Words are chosen once all models are known; then every model is read once more.
  Result<bool> finishSignatures(Signatures& signatures, const std::vector<ModelFields::Work>& works,
                                const std::vector<std::vector<std::size_t>>& models,
                                const std::vector<retrieval::FieldGroup>& groups) {
    ProgressLine progress("signatures");
    const ExecutionContext running = context(progress);
    if (auto finished = signatures.finish(running); !finished) return finished;
    if (!signatures.needsWords()) return true;
    ModelFields again(cache_, options_.fields, groups, running);
    const bool done =
        again.forEach(works, [&](std::size_t number, const Result<StudyFields>& fields) {
          if (!fields) return;
          for (const std::size_t model : models[number]) signatures.addWords(model, fields.value());
        });
    if (!done) return stopped();
    return true;
  }

  /// Leaves out what failed, and classes that have nothing left.
  void keep(const Collection& collection, Signatures& signatures) {
    std::set<std::string> failed;
    for (const auto& [name, reason] : loaded_.failed) failed.insert(name);
    std::map<std::uint32_t, std::uint32_t> numbers;
    std::vector<std::size_t> originals;
    for (std::size_t m = 0; m < collection.models.size(); ++m) {
      if (failed.count(collection.models[m].name) > 0) continue;
      CollectionModel model = collection.models[m];
      const auto [entry, added] =
          numbers.emplace(model.ofClass, static_cast<std::uint32_t>(loaded_.classes.size()));
      if (added) loaded_.classes.push_back(collection.classes[model.ofClass]);
      model.ofClass = entry->second;
      loaded_.models.push_back(std::move(model));
      originals.push_back(m);
    }
    for (std::size_t c = 0; c < collection.classes.size(); ++c) {
      if (numbers.count(static_cast<std::uint32_t>(c)) > 0) continue;
      noteAndSay("class " + collection.classes[c] + ": none of its models could be used");
    }
    std::map<std::uint32_t, std::size_t> sizes;
    for (const CollectionModel& model : loaded_.models) ++sizes[model.ofClass];
    for (const auto& [number, size] : sizes) {
      if (size > 1) continue;
      noteAndSay("class " + loaded_.classes[number] +
                 ": it has one model only, which can be found by none and is not asked for");
    }
    auto shared = std::make_shared<Signatures>(std::move(signatures));
    for (const std::string& name : retrieval::termsOf(descriptors_)) {
      bases_.emplace(name, PairDistances(loaded_.models.size(), [shared, name, originals](
                                                                    std::size_t a, std::size_t b) {
                       return shared->distance(name, originals[a], originals[b]);
                     }));
    }
  }

  void noteAndSay(const std::string& note) {
    loaded_.notes.push_back(note);
    say(note);
  }

  std::optional<Error> compare() {
    for (auto& [name, base] : bases_) {
      ProgressLine progress("distances by " + name);
      if (!base.prepare(context(progress))) return stopped();
    }
    study_.title = options_.title.empty() ? "Shape retrieval" : options_.title;
    study_.settings = settings();
    study_.classes = loaded_.classes;
    for (const CollectionModel& model : loaded_.models) {
      study_.models.push_back({model.name, model.ofClass});
    }
    for (const Descriptor& descriptor : descriptors_) {
      if (auto error = measure(descriptor)) return error;
    }
    study_.failed = loaded_.failed;
    study_.notes = loaded_.notes;
    drawThumbnails();
    return write();
  }

  /// Goes through the rows of one descriptor: the table, the distances, the answers.
  std::optional<Error> measure(const Descriptor& descriptor) {
    const std::size_t n = loaded_.models.size();
    std::vector<std::uint32_t> classes;
    for (const CollectionModel& model : loaded_.models) classes.push_back(model.ofClass);
    MeanMeasures mean(classes);
    MatrixPicture matrix(n);
    DescriptorRows rows(descriptor, bases_, n);
    std::vector<double> row(n);
    const bool shown = study_.descriptors.empty();
    if (shown) study_.shownDescriptor = descriptor.name;
    const std::vector<std::size_t> queries = shown ? shownQueries() : std::vector<std::size_t>{};
    const std::string path =
        (fs::path(options_.output) / "distances" / (fileNameOf(descriptor.name) + ".csv")).string();
    // Written row by row: of many models the whole would not fit into memory.
    std::ofstream file(path + ".part", std::ios::binary);
    file << "file";
    for (const CollectionModel& model : loaded_.models) file << ',' << csvName(model.name);
    file << '\n';
    ProgressLine progress("measures by " + descriptor.name);
    ExecutionContext running = context(progress);
    running.onProgress = {};  // told by rows
    for (std::size_t query = 0; query < n; ++query) {
      if (interrupted_ || !rows.row(query, row, running)) return stopped();
      const RetrievalMeasures measures = mean.add(query, row);
      matrix.add(query, row);
      std::string line = csvName(loaded_.models[query].name);
      for (const double distance : row) line += "," + readable(distance);
      file << line << '\n';
      noteQuery(descriptor.name, query, measures, mean.counts(query));
      if (std::find(queries.begin(), queries.end(), query) != queries.end()) {
        auto ranking = retrieval::rankingOf(query, row, classes);
        ranking.resize(std::min<std::size_t>(ranking.size(), kAnswers));
        study_.shown.push_back({static_cast<std::uint32_t>(query), std::move(ranking)});
      }
      progress.show(static_cast<double>(query + 1) / static_cast<double>(n));
    }
    file.close();
    std::error_code error;
    if (file) fs::rename(path + ".part", path, error);
    if (!file || error) {
      return makeError(ErrorCode::FileUnwritable, -1, path + ": it cannot be written");
    }
    study_.descriptors.push_back({descriptor.name, mean.mean(), mean.queries(), matrix.png()});
    return std::nullopt;
  }

  void noteQuery(const std::string& descriptor, std::size_t query, const RetrievalMeasures& m,
                 bool counts) {
    if (!counts) return;
    const CollectionModel& model = loaded_.models[query];
    queries_ += csvName(descriptor) + "," + csvName(model.name) + "," +
                csvName(loaded_.classes[model.ofClass]);
    for (const double value : {m.nearestNeighbour, m.firstTier, m.secondTier, m.eMeasure,
                               m.eMeasureWithQuery, m.discountedGain}) {
      queries_ += "," + io::formatNumber(value);
    }
    queries_ += "\n";
  }

  /// The first model of each class that can be asked for, of evenly spread classes where there are
  /// too many.
  std::vector<std::size_t> shownQueries() const {
    std::map<std::uint32_t, std::vector<std::size_t>> members;
    for (std::size_t m = 0; m < loaded_.models.size(); ++m) {
      members[loaded_.models[m].ofClass].push_back(m);
    }
    std::vector<std::size_t> firsts;
    for (const auto& [number, models] : members) {
      if (models.size() > 1) firsts.push_back(models.front());
    }
    std::vector<std::size_t> queries;
    const std::size_t count = std::min(kQueries, firsts.size());
    for (std::size_t i = 0; i < count; ++i) queries.push_back(firsts[i * firsts.size() / count]);
    return queries;
  }

  void drawThumbnails() {
    constexpr std::uint32_t kSize = 72;
    std::set<std::uint32_t> shown;
    for (const io::StudyAnswers& row : study_.shown) {
      shown.insert(row.query);
      shown.insert(row.answers.begin(), row.answers.end());
    }
    study_.thumbnails.resize(loaded_.models.size());
    for (const std::uint32_t model : shown) {
      const auto mesh = readSurface(loaded_.models[model].path);
      if (mesh) study_.thumbnails[model] = io::thumbnailPng(mesh.value(), kSize);
    }
  }

  std::vector<std::pair<std::string, std::string>> settings() const {
    const retrieval::FieldParameters& fields = options_.fields;
    const retrieval::SignatureOptions& signatures = options_.signatures;
    constexpr std::array<const char*, 3> kScales{"as they are", "greatest value 1",
                                                 "least value 0, greatest 1"};
    return {
        {"girth", GIRTH_VERSION},
        {"Triangles", fields.faces == 0
                          ? "as in the files"
                          : "at most " + std::to_string(fields.faces) + ", remeshed if more"},
        {"Size", fields.unitArea ? "scaled to area 1" : "as in the files"},
        {"One-dimensional fields",
         std::string(kScales[static_cast<std::size_t>(signatures.scale)]) +
             (signatures.bins == 0 ? ", exact distance of the distributions"
                                   : ", " + std::to_string(signatures.bins) + " bins") +
             (signatures.axis < 1
                  ? ", the greatest " + readable(100 * (1 - signatures.axis)) + "% counting alike"
                  : "")},
        {"Joint histograms", std::to_string(signatures.jointBins) + " × " +
                                 std::to_string(signatures.jointBins) + " cells"},
        {"Words", std::to_string(signatures.vocabulary.words) +
                      (signatures.words == retrieval::WordChoice::Soft ? ", soft" : ", nearest") +
                      ", seed " + std::to_string(signatures.vocabulary.seed)},
        {"Sums", "each distance divided by its mean over all pairs; no classes are used"}};
  }

  std::optional<Error> write() const {
    const fs::path folder(options_.output);
    const auto put = [&](const char* name, const std::string& content) {
      auto error = writeFile((folder / name).string(), content);
      if (error) error->message = std::string(name) + ": " + error->message;
      return error;
    };
    if (auto error = put("measures.csv", io::measuresCsv(study_))) return error;
    if (auto error = put("precision_recall.csv", io::precisionRecallCsv(study_))) return error;
    const std::string header =
        "descriptor,file,class,nn,first_tier,second_tier,e_measure,e_measure_with_query,dcg\n";
    if (auto error = put("queries.csv", header + queries_)) return error;
    if (auto error = put("study.json", io::studyJson(study_))) return error;
    return put("index.html", io::studyHtml(study_));
  }

  void print() const {
    std::printf("%zu models in %zu classes; %zu fields computed, %zu from the cache\n",
                loaded_.models.size(), loaded_.classes.size(), computed_, taken_);
    std::size_t width = 10;
    for (const io::StudyDescriptor& d : study_.descriptors) width = std::max(width, d.name.size());
    const auto w = static_cast<int>(width);
    std::printf("%-*s %8s %8s %8s %8s %8s %8s\n", w, "", "nearest", "tier 1", "tier 2", "E",
                "E+query", "DCG");
    for (const io::StudyDescriptor& d : study_.descriptors) {
      std::printf("%-*s %7.2f%% %7.2f%% %7.2f%% %7.2f%% %7.2f%% %7.2f%%\n", w, d.name.c_str(),
                  100 * d.mean.nearestNeighbour, 100 * d.mean.firstTier, 100 * d.mean.secondTier,
                  100 * d.mean.eMeasure, 100 * d.mean.eMeasureWithQuery,
                  100 * d.mean.discountedGain);
    }
    std::printf("%s\n", (fs::path(options_.output) / "index.html").string().c_str());
  }

  static constexpr std::size_t kQueries = 10, kAnswers = 9;

  const RetrieveOptions& options_;
  std::vector<Descriptor> descriptors_;
  Shard shard_;
  const std::atomic<bool>& interrupted_;
  FieldCache cache_;
  Loaded loaded_;
  std::map<std::string, PairDistances> bases_;
  io::Study study_;
  std::string queries_;
  std::size_t shardModels_{0}, computed_{0}, taken_{0};
};

}  // namespace

int runRetrieve(const RetrieveOptions& options) {
  std::vector<Descriptor> descriptors;
  for (const std::string& name :
       options.descriptors.empty() ? defaultDescriptors() : options.descriptors) {
    auto descriptor = retrieval::parseDescriptor(name);
    if (!descriptor) return reportError("", descriptor.error());
    descriptors.push_back(std::move(descriptor).value());
  }
  const auto shard = parseShard(options.shard.empty() ? "0/1" : options.shard);
  if (!shard) return reportError("", shard.error());
  if (options.classes.size() > options.folders.size()) {
    return reportError("", usage("there are more class files than folders",
                                 "give each folder its own --classes, in the same order"));
  }
  return Retrieval(options, std::move(descriptors), shard.value()).run();
}

}  // namespace girth::cli
