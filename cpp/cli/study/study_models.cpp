#include "study/study_models.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <set>

#include "girth/study/descriptor_rows.h"
#include "process/progress_line.h"
#include "process/report.h"
#include "study/model_fields.h"

namespace girth::cli {
namespace {

using study::Descriptor;
using study::FieldGroup;
using study::PairDistances;
using study::Signatures;
using study::StudyFields;

std::string reasonOf(const Error& error) {
  return std::string(toString(error.code)) + ": " + error.message;
}

/// A share's contents, each once: what is to be computed, and the models that have it.
struct Contents {
  std::vector<ModelFields::Work> works;
  std::vector<std::vector<std::size_t>> models;
};

class StudyLoader {
 public:
  StudyLoader(const Collection& collection, const std::vector<Descriptor>& descriptors,
              const ModelOptions& preparing, const ComparisonOptions& options,
              const FieldCache& cache)
      : collection_(collection),
        descriptors_(descriptors),
        preparing_(preparing),
        options_(options),
        cache_(cache),
        groups_(study::groupsOf(descriptors)),
        signatures_(study::termsOf(descriptors), collection.models.size(), options.signatures) {}

  Result<StudyModels> load(const Shard& shard) {
    study_.notes = collection_.notes;
    const Contents contents = contentsOf(shard);
    study_.contents = contents.works.size();
    const bool whole = shard.count == 1;
    if (!computeFields(contents, whole)) return stopped();
    std::sort(study_.failed.begin(), study_.failed.end());
    for (const std::string& note : study_.notes) printNote("", note);
    for (const auto& [name, reason] : study_.failed) printNote("", name + ": left out: " + reason);
    if (!whole) return std::move(study_);
    if (!finishSignatures(contents)) return stopped();
    keepUsable();
    return std::move(study_);
  }

 private:
  static Error stopped() {
    return makeError(ErrorCode::Cancelled, -1,
                     "stopped; the fields computed so far are in the cache");
  }

  Contents contentsOf(const Shard& shard) {
    Contents contents;
    std::map<Digest, std::size_t> known;
    for (std::size_t m = 0; m < collection_.models.size(); ++m) {
      const CollectionModel& model = collection_.models[m];
      const auto content = contentOf(model.path, preparing_);
      if (!content) {
        study_.failed.emplace_back(model.name, reasonOf(content.error()));
        continue;
      }
      const auto [entry, added] = known.emplace(content.value(), contents.works.size());
      if (added) {
        contents.works.push_back({model.name, model.path, content.value()});
        contents.models.emplace_back();
      } else {
        study_.notes.push_back(model.name + ": it is a copy of " +
                               contents.works[entry->second].name + "; both count");
      }
      contents.models[entry->second].push_back(m);
    }
    Contents share;
    for (std::size_t w = 0; w < contents.works.size(); ++w) {
      if (!shard.has(w)) continue;
      share.works.push_back(std::move(contents.works[w]));
      share.models.push_back(std::move(contents.models[w]));
    }
    return share;
  }

  /// False if cancelled.
  bool computeFields(const Contents& contents, bool withSignatures) {
    const std::vector<ModelFields::Work>& works = contents.works;
    const std::vector<std::vector<std::size_t>>& models = contents.models;
    std::vector<std::string> reasons(works.size());
    ProgressLine progress("fields of " + std::to_string(works.size()) + " models");
    ModelFields fields(cache_, preparing_, options_.fields, groups_,
                       watched(options_.threads, progress));
    const bool done =
        fields.forEach(works, [&](std::size_t number, const Result<StudyFields>& computed) {
          if (!computed) {
            reasons[number] = reasonOf(computed.error());
          } else if (withSignatures) {
            for (const std::size_t model : models[number]) signatures_.add(model, computed.value());
          }
        });
    study_.computed = fields.computed();
    study_.taken = fields.taken();
    const auto notes = fields.notes();
    study_.notes.insert(study_.notes.end(), notes.begin(), notes.end());
    for (std::size_t w = 0; w < works.size(); ++w) {
      if (reasons[w].empty()) continue;
      for (const std::size_t model : models[w]) {
        study_.failed.emplace_back(collection_.models[model].name, reasons[w]);
      }
    }
    return done;
  }

  /// Words are chosen once all models are known; then every model is read once more. False if
  /// cancelled.
  bool finishSignatures(const Contents& contents) {
    ProgressLine progress("signatures");
    const ExecutionContext running = watched(options_.threads, progress);
    if (!signatures_.finish(running)) return false;
    if (!signatures_.needsWords()) return true;
    ModelFields again(cache_, preparing_, options_.fields, groups_, running);
    return again.forEach(contents.works,
                         [&](std::size_t number, const Result<StudyFields>& fields) {
                           if (!fields) return;
                           for (const std::size_t model : contents.models[number]) {
                             signatures_.addWords(model, fields.value());
                           }
                         });
  }

  /// Leaves out what failed, and classes that have nothing left.
  void keepUsable() {
    std::set<std::string> failed;
    for (const auto& [name, reason] : study_.failed) failed.insert(name);
    std::map<std::uint32_t, std::uint32_t> numbers;
    std::vector<std::size_t> originals;
    for (std::size_t m = 0; m < collection_.models.size(); ++m) {
      if (failed.count(collection_.models[m].name) > 0) continue;
      CollectionModel model = collection_.models[m];
      const auto [entry, added] =
          numbers.emplace(model.ofClass, static_cast<std::uint32_t>(study_.classes.size()));
      if (added) study_.classes.push_back(collection_.classes[model.ofClass]);
      model.ofClass = entry->second;
      study_.models.push_back(std::move(model));
      originals.push_back(m);
    }
    noteClasses(numbers);
    const auto shared = std::make_shared<Signatures>(std::move(signatures_));
    for (const std::string& name : study::termsOf(descriptors_)) {
      study_.distances.emplace(
          name, PairDistances(study_.models.size(),
                              [shared, name, originals](std::size_t a, std::size_t b) {
                                return shared->distance(name, originals[a], originals[b]);
                              }));
    }
  }

  /// Classes without models, and with one.
  void noteClasses(const std::map<std::uint32_t, std::uint32_t>& numbers) {
    const auto noteAndSay = [&](const std::string& note) {
      study_.notes.push_back(note);
      printNote("", note);
    };
    for (std::size_t c = 0; c < collection_.classes.size(); ++c) {
      if (numbers.count(static_cast<std::uint32_t>(c)) > 0) continue;
      noteAndSay("class " + collection_.classes[c] + ": none of its models could be used");
    }
    std::map<std::uint32_t, std::size_t> sizes;
    for (const CollectionModel& model : study_.models) ++sizes[model.ofClass];
    for (const auto& [number, size] : sizes) {
      if (size > 1) continue;
      noteAndSay("class " + study_.classes[number] +
                 ": it has one model only, which can be found by none and is not asked for");
    }
  }

  const Collection& collection_;
  const std::vector<Descriptor>& descriptors_;
  const ModelOptions& preparing_;
  const ComparisonOptions& options_;
  const FieldCache& cache_;
  std::vector<FieldGroup> groups_;
  Signatures signatures_;
  StudyModels study_;
};

}  // namespace

Result<StudyModels> loadStudyModels(const Collection& collection,
                                    const std::vector<Descriptor>& descriptors,
                                    const ModelOptions& preparing, const ComparisonOptions& options,
                                    const FieldCache& cache, const Shard& shard) {
  return StudyLoader(collection, descriptors, preparing, options, cache).load(shard);
}

}  // namespace girth::cli
