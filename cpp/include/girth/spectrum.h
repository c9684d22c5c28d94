// The vibrations of a surface: eigenvalues and eigenfunctions of its Laplace operator.
#pragma once

#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"

namespace girth {

/// How much of the spectrum is wanted.
struct SpectrumOptions {
  /// Pairs wanted, from 1 on, the lowest ones; where there are fewer vertices, as many as those.
  Index pairs{300};
};

/// Eigenvalues and eigenfunctions, k from 0.
struct Spectrum {
  /// The eigenvalues, rising, in 1 / squared model units. Every component of the surface has one
  /// that is exactly 0; all others are above 0.
  std::vector<double> values;
  /// The eigenfunctions φ, in 1 / model units: `vectors[k * vertices + v]` is φ_k at v. Orthonormal
  /// with respect to the areas: Σ_v areas[v] φ_j(v) φ_k(v) is 1 for j = k, otherwise 0. Each is 0
  /// outside its component, and positive at the vertex where its magnitude is largest (the first of
  /// those within a millionth of that).
  std::vector<double> vectors;
  /// The area of each vertex, in squared model units: its mixed Voronoi area in the triangles
  /// that the operator is made of. They add up to the surface's area.
  std::vector<double> areas;
};

/// The lowest eigenpairs of L φ = λ M φ: L the cotangent Laplacian (Pinkall and Polthier 1993), M
/// the mixed Voronoi areas (Meyer, Desbrun, Schröder and Barr 2003). web/docs/definitions.md,
/// section 4. At the boundary the normal derivative is 0 (Neumann).
///
/// Both matrices are made of the surface's intrinsic Delaunay triangulation (Bobenko and Springborn
/// 2007), found by flipping edges: the surface is the same, the triangles are as good as its
/// vertices allow, and no weight inside the surface is negative. Where a face is so flat that its
/// longest side takes up all but a 1e-8 part of the sum of the others, all edges are first made
/// longer by the least length that mends it ('intrinsic mollification', Sharp and Crane 2020).
///
/// The solver is Lanczos' method with shift and inversion and implicit restarts (Spectra), each
/// component by itself. Sylvester's law of inertia checks that none is missing, copies of multiple
/// values among them. Values are those of the matrices to about 1e-10 relative; within the
/// space of a multiple value the basis is arbitrary.
///
/// One input always gives the same bits, on any number of threads (it uses one); another
/// compiler or WebAssembly may differ by rounding. Time about O(n · pairs²); 10,000 faces and 300
/// pairs take a few seconds. Memory: 3 numbers for each vertex and pair. Cancelling takes up to a
/// second.
///
/// Errors: INVALID_OPTION (pairs), CANCELLED, OUT_OF_MEMORY, INTERNAL where the pairs do not come
/// out complete.
GIRTH_EXPORT Result<Spectrum> laplaceSpectrum(const SurfaceMesh& mesh,
                                              const SpectrumOptions& options = {},
                                              const ExecutionContext& context = {});

}  // namespace girth
