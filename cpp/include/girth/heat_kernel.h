// Heat kernel signatures: how much of the heat put on a point is still there some time later.
#pragma once

#include <span>

#include "girth/error.h"
#include "girth/export.h"
#include "girth/spectrum.h"
#include "girth/vertex_signatures.h"

namespace girth {

/// The heat kernel's diagonal (Sun, Ovsjanikov and Guibas 2009): for each vertex and each time t,
/// Σ_k exp(−λ_k t) φ_k². Times are in squared model units, the values in 1 / squared model units. A
/// spectrum cut off at λ gives about a exp(−λ t)-th too little. O(n · pairs · times). Errors:
/// INVALID_OPTION for no times, or some that are negative or not finite; USAGE for a spectrum whose
/// arrays do not belong together.
GIRTH_EXPORT Result<VertexSignatures> heatKernelSignature(const Spectrum& spectrum,
                                                          std::span<const double> times);

/// Times are base^τ, τ running from `first` to `last` by `step`, of a surface with the area
/// `referenceArea`; for other surfaces they are longer or shorter as their area is. The defaults
/// are the paper's (section 6.1) and those of the original authors' program, which was made for
/// models some 200 units tall: hence the area.
struct SihksOptions {
  /// The base whose powers are the times; above 1.
  double base{2};
  /// The first exponent.
  double first{1};
  /// The last exponent, if steps lead to it.
  double last{20};
  /// From one exponent to the next; above 0.
  double step{0.2};
  /// How many frequencies are kept.
  Index frequencies{19};
  /// The first of them; 0 would be the mean.
  Index lowestFrequency{1};
  /// How many of the spectrum's pairs are used; 0: all.
  Index eigenfunctions{0};
  /// The area that the times are made for, in squared model units.
  double referenceArea{16384};
};

/// The scale-invariant heat kernel signature (Bronstein and Kokkinos 2010): the logarithm of the
/// heat kernel signature at times that grow as powers, differences from each to the next, and the
/// magnitudes of their discrete Fourier transform at the lowest frequencies. Numbers without unit,
/// which do not change with the surface's size.
///
/// The paper states that the 'number of eigenfunctions is 19'; the original work takes the 19
/// lowest frequencies. Either can be chosen. O(n · pairs · times). Errors: INVALID_OPTION for
/// options out of range (times: 2 to 100,000 of them, frequencies: below their number); USAGE as
/// above.
GIRTH_EXPORT Result<VertexSignatures> scaleInvariantHeatKernelSignature(
    const Spectrum& spectrum, const SihksOptions& options = {});

}  // namespace girth
