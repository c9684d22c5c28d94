#include "study/retrieval.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <system_error>

#include "files/path_of.h"
#include "files/write_file.h"
#include "girth/study/descriptor_rows.h"
#include "girth/study/measures.h"
#include "girth/study/signatures.h"
#include "girth/study/write_study.h"
#include "girth/version.h"
#include "model/loading.h"
#include "picture/thumbnail.h"
#include "process/interrupt.h"
#include "process/progress_line.h"
#include "process/report.h"
#include "study/collection.h"
#include "study/field_cache.h"
#include "study/matrix_picture.h"
#include "study/study_models.h"
#include "text/number_text.h"

namespace girth::cli {
namespace {

namespace fs = std::filesystem;
using study::Descriptor;
using study::DescriptorRows;
using study::MeanMeasures;
using study::RetrievalMeasures;

Error stopped() {
  return makeError(ErrorCode::Cancelled, -1, "stopped; the fields are in the cache");
}

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

/// One study, from the folders to the report.
class Retrieval {
 public:
  Retrieval(const RetrievalOptions& options, std::vector<Descriptor> descriptors, Shard shard)
      : options_(options),
        descriptors_(std::move(descriptors)),
        shard_(shard),
        cache_(options.cache.empty() ? (io::pathOf(options.output) / "cache").string()
                                     : options.cache) {}

  int run() {
    if (auto error = prepareFolders()) return reportError(options_.output, *error);
    const auto collection = findCollection(sources());
    if (!collection) return reportError("", collection.error());
    auto loaded = loadStudyModels(collection.value(), descriptors_, options_.preparing, options_,
                                  cache_, shard_);
    if (!loaded) return reportError("", loaded.error());
    loaded_ = std::move(loaded).value();
    if (shard_.count > 1) {
      std::printf("share %zu of %zu: %zu models, %zu fields computed, %zu were there\n",
                  shard_.number, shard_.count, loaded_.contents, loaded_.computed, loaded_.taken);
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
    fs::create_directories(io::pathOf(options_.output) / "distances", error);
    if (error) {
      return makeError(ErrorCode::FileUnwritable, -1, "it cannot be made: " + error.message());
    }
    if (auto problem = io::checkWritable((io::pathOf(options_.output) / "index.html").string())) {
      return problem;
    }
    return cache_.open();
  }

  std::optional<Error> compare() {
    for (auto& [name, base] : loaded_.distances) {
      ProgressLine progress("distances by " + name);
      if (!base.prepare(watched(options_.threads, progress))) return stopped();
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
    DescriptorRows rows(descriptor, loaded_.distances, n);
    std::vector<double> row(n);
    const bool shown = study_.descriptors.empty();
    if (shown) study_.shownDescriptor = descriptor.name;
    const std::vector<std::size_t> queries = shown ? shownQueries() : std::vector<std::size_t>{};
    const std::string path = (io::pathOf(options_.output) / "distances" /
                              io::pathOf(fileNameOf(descriptor.name) + ".csv"))
                                 .string();
    // Written row by row: of many models the whole would not fit into memory.
    std::ofstream file(io::pathOf(path + ".part"), std::ios::binary);
    file << "file";
    for (const CollectionModel& model : loaded_.models) file << ',' << csvName(model.name);
    file << '\n';
    ProgressLine progress("measures by " + descriptor.name);
    ExecutionContext running = watched(options_.threads, progress);
    running.onProgress = {};  // progress is counted in rows
    for (std::size_t query = 0; query < n; ++query) {
      if (catchInterrupts() || !rows.row(query, row, running)) return stopped();
      const RetrievalMeasures measures = mean.add(query, row);
      matrix.add(query, row);
      std::string line = csvName(loaded_.models[query].name);
      for (const double distance : row) line += "," + readable(distance);
      file << line << '\n';
      noteQuery(descriptor.name, query, measures, mean.counts(query));
      if (std::find(queries.begin(), queries.end(), query) != queries.end()) {
        auto ranking = study::rankingOf(query, row, classes);
        ranking.resize(std::min<std::size_t>(ranking.size(), kAnswers));
        study_.shown.push_back({static_cast<std::uint32_t>(query), std::move(ranking)});
      }
      progress.show(static_cast<double>(query + 1) / static_cast<double>(n));
    }
    file.close();
    std::error_code error;
    if (file) fs::rename(io::pathOf(path + ".part"), io::pathOf(path), error);
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
    for (const study::StudyAnswers& row : study_.shown) {
      shown.insert(row.query);
      shown.insert(row.answers.begin(), row.answers.end());
    }
    study_.thumbnails.resize(loaded_.models.size());
    for (const std::uint32_t model : shown) {
      const auto read = loadModel(loaded_.models[model].path, options_.preparing);
      if (read) study_.thumbnails[model] = io::thumbnailPng(read.value().mesh, kSize);
    }
  }

  std::vector<std::pair<std::string, std::string>> settings() const {
    const study::FieldParameters& fields = options_.fields;
    const study::SignatureOptions& signatures = options_.signatures;
    constexpr std::array<const char*, 3> kScales{"as they are", "greatest value 1",
                                                 "least value 0, greatest 1"};
    const std::string preparation = preparationText(options_.preparing);
    return {{"girth", GIRTH_VERSION},
            {"Models", preparation.empty() ? "as in the files" : preparation},
            {"Triangles", fields.faces == 0
                              ? "as in the files"
                              : "at most " + std::to_string(fields.faces) + ", remeshed if more"},
            {"Size", fields.unitArea ? "scaled to area 1" : "as in the files"},
            {"One-dimensional fields",
             std::string(kScales[static_cast<std::size_t>(signatures.scale)]) +
                 (signatures.bins == 0 ? ", exact distance of the distributions"
                                       : ", " + std::to_string(signatures.bins) + " bins") +
                 (signatures.axis < 1 ? ", the greatest " + readable(100 * (1 - signatures.axis)) +
                                            "% counting alike"
                                      : "")},
            {"Joint histograms", std::to_string(signatures.jointBins) + " × " +
                                     std::to_string(signatures.jointBins) + " cells"},
            {"Words", std::to_string(signatures.vocabulary.words) +
                          (signatures.words == study::WordChoice::Soft ? ", soft" : ", nearest") +
                          ", seed " + std::to_string(signatures.vocabulary.seed)},
            {"Sums", "each distance divided by its mean over all pairs; no classes are used"}};
  }

  std::optional<Error> write() const {
    const fs::path folder = io::pathOf(options_.output);
    const auto put = [&](const char* name, const std::string& content) {
      auto error = io::writeFile((folder / name).string(), content);
      if (error) error->message = std::string(name) + ": " + error->message;
      return error;
    };
    if (auto error = put("measures.csv", study::measuresCsv(study_))) return error;
    if (auto error = put("precision_recall.csv", study::precisionRecallCsv(study_))) return error;
    const std::string header =
        "descriptor,file,class,nn,first_tier,second_tier,e_measure,e_measure_with_query,dcg\n";
    if (auto error = put("queries.csv", header + queries_)) return error;
    if (auto error = put("study.json", study::studyJson(study_))) return error;
    return put("index.html", study::studyHtml(study_));
  }

  void print() const {
    std::printf("%zu models in %zu classes; %zu fields computed, %zu from the cache\n",
                loaded_.models.size(), loaded_.classes.size(), loaded_.computed, loaded_.taken);
    std::size_t width = 10;
    for (const study::StudyDescriptor& d : study_.descriptors)
      width = std::max(width, d.name.size());
    const auto w = static_cast<int>(width);
    std::printf("%-*s %8s %8s %8s %8s %8s %8s\n", w, "", "nearest", "tier 1", "tier 2", "E",
                "E+query", "DCG");
    for (const study::StudyDescriptor& d : study_.descriptors) {
      std::printf("%-*s %7.2f%% %7.2f%% %7.2f%% %7.2f%% %7.2f%% %7.2f%%\n", w, d.name.c_str(),
                  100 * d.mean.nearestNeighbour, 100 * d.mean.firstTier, 100 * d.mean.secondTier,
                  100 * d.mean.eMeasure, 100 * d.mean.eMeasureWithQuery,
                  100 * d.mean.discountedGain);
    }
    std::printf("%s\n", (io::pathOf(options_.output) / "index.html").string().c_str());
  }

  static constexpr std::size_t kQueries = 10, kAnswers = 9;

  const RetrievalOptions& options_;
  std::vector<Descriptor> descriptors_;
  Shard shard_;
  FieldCache cache_;
  StudyModels loaded_;
  study::RetrievalStudy study_;
  std::string queries_;
};

}  // namespace

int runRetrieval(const RetrievalOptions& options, std::vector<study::Descriptor> descriptors,
                 const Shard& shard) {
  return Retrieval(options, std::move(descriptors), shard).run();
}

}  // namespace girth::cli
