// The frame of a command that measures one model: from the file to the result in its forms.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "girth/error.h"
#include "girth/io/read_mesh.h"
#include "model/loading.h"
#include "model/model_options.h"
#include "process/hand_over.h"
#include "process/output.h"
#include "process/report.h"

namespace girth::cli {

/// The options of every command that measures one model.
struct MeasuringOptions {
  std::string model;
  ModelOptions preparing;
  Output output;
  unsigned threads{0};
  bool json{false};
};

/// The forms of a result of type T.
template <class T>
struct Writers {
  using File = std::function<Result<std::string>(const io::LoadedMesh&, const T&)>;

  /// The content of a file, by the ending of its name. JSON is written by `json`.
  std::vector<std::pair<std::string, File>> files;
  std::function<std::string(const io::LoadedMesh&, const T&)> json;
  /// Prints the result in words.
  std::function<void(const io::LoadedMesh&, const T&)> text;

  /// All endings that can be written.
  std::vector<std::string> endings() const {
    std::vector<std::string> all{".json"};
    for (const auto& [ending, file] : files) all.push_back(ending);
    return all;
  }
  Result<std::string> contentFor(const std::string& wanted, const io::LoadedMesh& loaded,
                                 const T& result) const {
    for (const auto& [ending, file] : files) {
      if (ending == wanted) return file(loaded, result);
    }
    return json(loaded, result);
  }
};

/// Loads the model, computes and writes. `compute(loaded)` returns a Result<T>. Returns the exit
/// code.
template <class T, class Compute>
int measure(const MeasuringOptions& options, const Compute& compute, const Writers<T>& writers) {
  if (const auto error = checkOutput(options.output, std::span(&options.model, 1), options.json)) {
    return reportError(options.output.path, *error);
  }
  const auto loaded = loadModel(options.model, options.preparing);
  if (!loaded) return reportError(options.model, loaded.error());
  const Result<T> result = compute(loaded.value());
  if (!result) return reportError(options.model, result.error());
  return handOver(
      options.output, options.json,
      [&](const std::string& ending) {
        return writers.contentFor(ending, loaded.value(), result.value());
      },
      [&] { return writers.json(loaded.value(), result.value()); },
      [&] { writers.text(loaded.value(), result.value()); });
}

}  // namespace girth::cli
