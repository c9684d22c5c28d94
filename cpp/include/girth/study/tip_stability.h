// How the tips of a surface change when its triangles do, and under noise.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"
#include "girth/tips.h"

namespace girth::study {

/// The tips that are found again on one changed surface.
struct GIRTH_EXPORT TipTrial {
  /// By how many mean edge lengths vertices moved at most (withNoise); none: each triangle was cut
  /// into four instead (subdivided), which leaves the surface as it is.
  std::optional<double> noise;
  /// Why there is no result: the change took a face's area away.
  std::optional<Error> failed;
  /// Tips of the changed surface.
  Index tips{0};
  /// Parts of its contour that are no tip's.
  Index arcs{0};
  /// For each tip of the unchanged surface whether it is found again: whether one of the changed
  /// surface's has its apex inside, and has its own apex inside this one.
  std::vector<bool> found;

  /// How many tips of the unchanged surface are found again.
  Index foundAgain() const;
};

/// Which trials are made.
struct TipTrialOptions {
  /// One trial each, beside that of smaller triangles.
  std::vector<double> noise{0.05, 0.1, 0.25};
  /// The seed of the noise; one seed always gives the same surfaces.
  std::uint64_t seed{1};
  /// tau of the girth that tips are found by, in model units (girth/barcode.h).
  double persistence{0};
};

/// Finds the tips of changed copies of a surface: first with each triangle cut into four, then with
/// noise. The paper (section 6.2) warns that small changes may move the contour much; this reports
/// which tips are reliable. `tips`: those of the surface. Time: that of the girth of one surface
/// with four times the faces and of as many others as there are amounts of noise. Any number of
/// threads gives the same bits. Errors: INVALID_OPTION (withNoise, checkPersistence); CANCELLED.
GIRTH_EXPORT Result<std::vector<TipTrial>> tipTrials(const SurfaceMesh& mesh,
                                                     std::span<const Tip> tips,
                                                     const TipTrialOptions& options = {},
                                                     const ExecutionContext& context = {});

}  // namespace girth::study
