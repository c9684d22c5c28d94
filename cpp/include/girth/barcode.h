// How long the saddles of the distance from a point last: the girth that noise cannot break
// (web/docs/definitions.md, section 2).
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "girth/error.h"
#include "girth/export.h"
#include "girth/girth_solver.h"

namespace girth {

/// A saddle of the distance from p: where the growing disk touches itself, and what it cuts off
/// begins to be filled.
struct SaddleBar {
  /// Its distance from p, in model units: half the length of its loop.
  double birth{0};
  /// The distance at which one of the two parts that the loop cuts off is filled, in model units,
  /// by the elder rule; infinite where the loop cuts nothing off, or neither part is filled up to
  /// `birth + maxPersistence`.
  double death{std::numeric_limits<double>::infinity()};

  /// How long it lasts.
  double persistence() const { return death - birth; }
};

/// The saddles of the distance from a point, by their distance.
struct Barcode {
  /// In the order of their births. The last one may last longer than `maxPersistence`: then it is
  /// the first that does, and none beyond it is listed. Saddles that last no longer than rounding
  /// can tell, a share of 4e-9, are left out.
  std::vector<SaddleBar> bars;
  /// The loop of each bar, where loops were asked for; otherwise empty.
  std::vector<GirthLoop> loops;
  /// Persistence is known up to this, in model units.
  double maxPersistence{0};
  /// I_tau where no bar lasts longer than tau: twice the greatest distance, antipodal, if all
  /// saddles are listed; otherwise unresolved, and no I_tau of that kind is less than its length.
  GirthValue rest{0, LoopKind::Unresolved};

  /// I_tau(p) for a persistence of at least 0, read off the bars; `Unresolved`, with a lower bound,
  /// where they do not tell.
  GIRTH_EXPORT GirthValue girth(double persistence) const;
};

/// The wanted part of a barcode.
struct BarcodeOptions {
  /// Up to which persistence it is wanted, in model units. The less, the sooner it is there.
  double maxPersistence{std::numeric_limits<double>::infinity()};
  /// No more bars than these, the first ones.
  std::size_t maxSaddles{std::numeric_limits<std::size_t>::max()};
  /// With the loop of each.
  bool loops{false};
};

/// Whether a number can be a persistence: INVALID_OPTION where it is negative, infinite or NaN.
GIRTH_EXPORT std::optional<Error> checkPersistence(double persistence);

}  // namespace girth
