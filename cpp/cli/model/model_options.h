// How a model is prepared: the options that most commands share.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "options/option_table.h"

namespace girth::cli {

struct ModelOptions {
  /// A length, with or without a unit: vertices no farther apart are also welded. Empty: none.
  std::string weldDistance;
  bool closeHoles{false};
  /// Cut into so many triangles, if there are fewer; 0: as they are.
  std::uint32_t subdivide{0};
  /// Remeshed to at most so many triangles; 0: as it is.
  std::uint32_t faces{0};
  /// Which file of a zip; empty: the first model.
  std::string entry;
  /// Components to keep, by their numbers in `girth info`, or "largest"; empty: all.
  std::vector<std::string> components;
  /// Components of a smaller share of the largest one's area are left out; 0: none.
  double minComponent{0};
  /// The unit of the file's numbers, as a symbol such as "mm". Empty: the one the file states.
  std::string unit;
  /// The unit that lengths come out in. Empty: that of the file's numbers.
  std::string shownUnit;
  /// Multiplies all positions.
  double scale{1};
  /// The wished extent of the whole model along `up`, a length with or without a unit. Empty: as in
  /// the file.
  std::string height;
  /// "x", "y" or "z"; empty: by the format.
  std::string up;
};

/// Adds `--weld`, `--close-holes`, `--component`, `--min-component`, `--unit`, `--in`, `--scale`,
/// `--height`,
/// `--up` and `--entry`.
void addModelOptions(OptionTable& table, ModelOptions& options);

/// The options that were given, as they could be typed: "--weld 0.1mm --close-holes"; empty without
/// any. Models of one file with equal text are the same surface.
std::string preparationText(const ModelOptions& options);

/// The most faces that can be asked for.
constexpr std::uint32_t kMostFaces = 100'000'000;

/// Adds `--subdivide`.
void addSubdivideOption(OptionTable& table, ModelOptions& options);

/// Adds `--faces`, for commands that measure.
void addFacesOption(OptionTable& table, ModelOptions& options);

}  // namespace girth::cli
