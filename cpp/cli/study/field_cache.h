// Computed fields kept in files, so that work that was stopped goes on, and several machines can
// share it through one folder.
#pragma once

#include <optional>
#include <string>

#include "girth/error.h"
#include "girth/study/study_fields.h"
#include "process/sha256.h"

namespace girth::cli {

/// A folder with one file for each entry, named by its key. Threads, processes and machines may use
/// it at once: an entry appears as a whole or not at all.
class FieldCache {
 public:
  explicit FieldCache(std::string folder) : folder_(std::move(folder)) {}

  /// Makes the folder. Error: FILE_UNWRITABLE.
  std::optional<Error> open() const;

  /// The key of a group's fields: of a model's content and of all parameters.
  static Digest keyOf(const Digest& content, study::FieldGroup group,
                      const study::FieldParameters& parameters);

  struct Found {
    /// Nothing where there is no entry, or one that cannot be used.
    std::optional<study::StudyFields> fields;
    /// There is an entry, but its checksum does not match its content.
    bool damaged{false};
  };
  Found find(const Digest& key) const;

  /// Error: FILE_UNWRITABLE.
  std::optional<Error> store(const Digest& key, const study::StudyFields& fields) const;

 private:
  std::string pathOf(const Digest& key) const;

  std::string folder_;
};

}  // namespace girth::cli
