// Which models a study is of, and which classes they are in.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "girth/error.h"

namespace girth::cli {

struct CollectionModel {
  /// As tables call it: its path below the folder.
  std::string name;
  /// Where it is read.
  std::string path;
  /// Its number in `classes`.
  std::uint32_t ofClass{0};
};

struct Collection {
  /// Ordered by class, then as they are listed.
  std::vector<CollectionModel> models;
  std::vector<std::string> classes;
  /// Faults and their consequences, one line each.
  std::vector<std::string> notes;
};

struct CollectionSource {
  std::string folder;
  /// A .csv with the columns `file` (relative to the folder) and `class`, or a .cla as the
  /// Princeton Shape Benchmark, SHREC'07, SHREC'11 and SHREC'15 are classified: its numbers are
  /// those that the models' names end with. Empty: the folder's classes.csv, or its only .cla, or
  /// otherwise every folder in it is a class, as in McGill's benchmark.
  std::string classes;
};

/// The models of all sources together; classes of the same name are one. Models that are listed but
/// absent, listed twice or without a class are left out and noted, and so are classes without
/// models. Errors: FILE_NOT_FOUND (also: no model at all), FILE_UNREADABLE, MALFORMED_FILE (line).
Result<Collection> findCollection(const std::vector<CollectionSource>& sources);

}  // namespace girth::cli
