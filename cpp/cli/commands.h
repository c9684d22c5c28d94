// The subcommands. Each returns the exit code: 0 done, 1 usage, 2 bad input, 3 limit or cancelled,
// 4 too thin to print.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "girth/girth_field.h"
#include "girth/remesh.h"
#include "model_options.h"
#include "retrieve_options.h"
#include "spectral_field.h"

namespace girth::cli {

struct InfoOptions {
  std::vector<std::string> models;
  ModelOptions preparing;
  bool json{false};
};

/// Says what a model is, and whether it is a surface.
int runInfo(const InfoOptions& options);

struct IgfOptions {
  std::vector<std::string> models;
  ModelOptions preparing;
  /// Empty: only a summary.
  std::string output;
  GirthMethod method{GirthMethod::Exact};
  /// By the study's naive method instead.
  bool naive{false};
  /// 0: on the surface as it is; else on one remeshed to so many faces, and carried back.
  std::uint32_t faces{0};
  unsigned threads{0};
  bool json{false};
  bool stats{false};
};

/// Computes the girth at all vertices.
int runIgf(const IgfOptions& options);

struct LoopOptions {
  std::string model;
  ModelOptions preparing;
  /// A vertex in the file's numbering, from 0, or else a point of a face.
  std::optional<std::int64_t> vertex;
  /// A triangle in the file's order, from 0; polygons count as the triangles they are cut into.
  std::optional<std::int64_t> face;
  /// The point's shares of the face's three vertices.
  std::array<double, 3> weights{1.0 / 3, 1.0 / 3, 1.0 / 3};
  std::string output;
  bool json{false};
};

/// Computes the loop at one point.
int runLoop(const LoopOptions& options);

struct RemeshOptions {
  std::string model;
  ModelOptions preparing;
  std::uint32_t faces{10'000};
  /// Even triangles, rather than those that keep the shape best.
  bool even{false};
  std::string output;
  /// Also compute the girth before and after, and tell how far apart they are.
  bool difference{false};
  unsigned threads{0};
  bool json{false};
};

/// Writes the surface with other triangles.
int runRemesh(const RemeshOptions& options);

/// The surface with other triangles, with progress and until it is interrupted.
Result<RemeshedSurface> remeshModel(const std::string& model, const SurfaceMesh& mesh,
                                    const girth::RemeshOptions& options);

struct FieldOptions {
  std::string model;
  ModelOptions preparing;
  /// "sdf", "geoaverage", "geofarthest", or a spectral one: "hks", "sihks" or "wks".
  std::string field;
  std::string output;
  unsigned threads{0};
  bool json{false};
  /// Of sdf.
  unsigned rays{30};
  double coneDegrees{120};
  /// Of geoaverage and geofarthest: by windows instead of fast marching.
  bool exactDistances{false};
  SpectralFieldOptions spectral;
  /// How many of the most persistent maxima to list.
  std::uint32_t maxima{0};
};

/// Computes another field than the girth at all vertices.
int runField(const FieldOptions& options);

struct TipsOptions {
  std::string model;
  ModelOptions preparing;
  std::string output;
  unsigned threads{0};
  bool stability{false};
  bool json{false};
};

/// Finds where the shape ends.
int runTips(const TipsOptions& options);

struct PartsOptions {
  std::string model;
  ModelOptions preparing;
  std::string output;
  unsigned threads{0};
  bool json{false};
  /// Lengths as typed, with or without a unit. Empty: found from the fields (thresholds), or not
  /// checked (limits).
  std::string girth, diameter, minTube, minWall;
  double smoothing{0};
};

/// Finds tubes, plates and body, or, with limits, the places that are too thin to print.
int runParts(const PartsOptions& options);

/// Finds out how well descriptors find shapes of the same class in a collection, and reports it.
int runRetrieve(const RetrieveOptions& options);

struct SignatureCommandOptions : ComparisonOptions {
  std::string model;
  std::string output;
};

/// Writes the histograms that a model is compared by.
int runSignature(const SignatureCommandOptions& options);

struct CompareOptions : ComparisonOptions {
  /// Among a few models the words are nearly as many as the features: by the nearest word alone all
  /// would be equally far apart.
  CompareOptions() { signatures.words = study::WordChoice::Soft; }
  std::vector<std::string> models;
  bool json{false};
};

/// Says how far models are apart.
int runCompare(const CompareOptions& options);

}  // namespace girth::cli
