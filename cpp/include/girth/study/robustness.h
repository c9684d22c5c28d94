// How little the girth's distribution changes with a surface's triangles, noise and pose: the
// paper's Figures 7, 8 and 9.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/study/surface_changes.h"
#include "girth/surface_mesh.h"

namespace girth::study {

/// The extent of the study.
struct RobustnessOptions {
  /// Triangles of the even mesh that changes are made to, and of all that are compared with it.
  Index faces{10'000};
  /// Triangles of the meshes that are compared with the model as it is (RemeshMethod::Fitting: as
  /// one would remesh it).
  std::vector<Index> sizes{2'000, 5'000, 10'000, 20'000, 50'000};
  /// How uneven the uneven triangles are (surface_changes.h).
  double stretch{4};
  /// How strong the noise of Figure 8d is, a row for each, in mean edge lengths (withNoise).
  std::vector<double> noise{0.25, 0.5};
  /// tau of all girths over the square root of each surface's area (girth/barcode.h); 0: the girth
  /// itself.
  double persistence{0};
  /// The seed of the random noise; one seed always gives the same surfaces.
  std::uint64_t seed{1};
  /// The humps of Figure 8e.
  HumpOptions humps;
  /// Changes of topology: places that have grown together.
  Index bridges{2};
  /// How many tiny handles (withTinyHandles): two rows for each number, with them, and after
  /// removeHandles has taken away those shorter than kTinyLoop.
  std::vector<Index> tinyHandles;
};

/// One change of the surface, and what came of the girth.
struct RobustnessRow {
  /// The figure of the paper: "7", "8b", ... "9".
  std::string figure;
  /// The change of the surface.
  std::string change;
  /// Triangles of the changed surface.
  Index faces{0};
  /// Equation (1) against the unchanged surface, each scaled to area 1; NaN where the change could
  /// not be made.
  double difference{std::numeric_limits<double>::quiet_NaN()};
  /// Where vertices are still the same ones: the share of the area whose girth, as it stands in the
  /// model, changed by at most 5%.
  std::optional<double> unchanged;
  /// The paper's result for its own models. It does not state how strong its changes were.
  std::optional<double> paper;
  /// Why there is no value.
  std::string note;
};

/// A surface and what tables call it.
struct NamedSurface {
  std::string name;  ///< for tables
  SurfaceMesh mesh;  ///< the surface
};

/// Computes the exact girth of the model, and of a dozen changes of it, and compares the
/// distributions. `poses`: the same thing in other poses. Time: that of as many girth fields. Any
/// number of threads gives the same bits. Errors: those of remesh for the even mesh; INVALID_OPTION
/// (stretch, noise, persistence); CANCELLED.
GIRTH_EXPORT Result<std::vector<RobustnessRow>> robustnessStudy(
    const SurfaceMesh& model, std::span<const NamedSurface> poses,
    const RobustnessOptions& options = {}, const ExecutionContext& context = {});

}  // namespace girth::study
