// The wave kernel signature: how likely a quantum particle of some energy is met at a point.
#pragma once

#include "girth/error.h"
#include "girth/export.h"
#include "girth/spectrum.h"
#include "girth/vertex_signatures.h"

namespace girth {

/// Which energies, and how sharply they are distinguished.
struct WksOptions {
  /// Energies, 2 to 100,000.
  Index energies{100};
  /// Width σ of the energies' distributions, in steps from one energy to the next; above 0.
  double variance{6};
};

/// The wave kernel signature (Aubry, Schlickewei and Cremers 2011): for each vertex and each energy
/// e, Σ_k g(e − log λ_k) φ_k² / Σ_k g(e − log λ_k), g the Gaussian of width σ. The energies lie
/// evenly between log λ_1 and the log of the last value; as in the original authors' program the
/// last fiftieth is left out, here of the distance between the two logarithms, so that the result
/// does not depend on the surface's size. The eigenvalues 0 do not count.
///
/// Values are in 1 / squared model units; their mean over the surface, weighted by the areas, is 1
/// / area where it is connected. O(n · pairs · energies). Errors: INVALID_OPTION for options out of
/// range, and for a spectrum without two different values above 0; USAGE for one whose arrays do
/// not belong together.
GIRTH_EXPORT Result<VertexSignatures> waveKernelSignature(const Spectrum& spectrum,
                                                          const WksOptions& options = {});

}  // namespace girth
