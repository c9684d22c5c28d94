// The options of `girth igf`, and the names of its methods.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "girth/girth_field.h"
#include "girth/io/read_mesh.h"
#include "girth/io/write_field.h"
#include "girth/refined_girth.h"
#include "model/model_options.h"
#include "process/output.h"

namespace girth::cli::igf_command {

struct Options {
  std::vector<std::string> models;
  ModelOptions preparing;
  Output output;
  GirthMethod method{GirthMethod::Exact};
  /// By the study's naive method instead.
  bool naive{false};
  /// In bands round loops (girth/refined_girth.h) instead.
  bool refined{false};
  /// Vertices at which that is compared with the exact method.
  std::uint32_t audit{RefinedOptions{}.audit};
  /// 0: on the surface as it is; otherwise on one of at most so many faces, and carried back.
  std::uint32_t faces{0};
  unsigned threads{0};
  unsigned jobs{1};
  bool json{false};
  bool stats{false};
  /// Go on from what a stopped run has left beside the output.
  bool resume{false};
  bool positions{false};
  /// Vertices, in the file's numbering, whose loops are written beside the values.
  std::vector<std::uint32_t> loops;
  /// Write the tips beside the values.
  bool tips{false};
  /// As typed: a length or a share.
  std::string persistence;
  /// Where the saddles of all vertices go.
  Output barcodes{"", "", false, {".json", ".csv", ".npy"}};
};

inline std::string methodText(const Options& options) {
  if (options.refined) return "refined";
  return options.naive ? "naive" : std::string(io::toString(options.method));
}

/// A model that is measured, and how.
struct Work {
  const std::string& model;
  const io::LoadedMesh& loaded;
  /// In the model's unit.
  double persistence;
  /// The states and the audit of refined values; null: the values were not refined.
  const RefinedGirth* refined{nullptr};
  /// Triangles that it was computed on; 0: those of the file.
  Index fewerFaces{0};
};

/// The method with the triangles it was used on, where they are fewer, and its persistence: values
/// of equal texts belong together.
inline std::string particulars(const Options& options, const Work& work) {
  const bool isOther = options.naive || options.refined;
  std::string text =
      isOther ? methodText(options) : io::methodText({options.method, work.persistence});
  if (work.fewerFaces == 0) return text;
  return text.insert(std::min(text.find(','), text.size()),
                     " on " + std::to_string(work.fewerFaces) + " faces");
}

}  // namespace girth::cli::igf_command
