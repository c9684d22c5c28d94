// IGF-MS: the girth by fast marching and the saddles of the discrete distance field.
#pragma once

#include "geodesic/fast_marching.h"
#include "girth/girth_solver.h"

namespace girth {

/// The approximation of the paper's section 6.1: twice the distance, by fast marching, of the
/// nearest saddle of the distance field; where there is none, twice the greatest distance. A vertex
/// is a saddle where its neighbours nearer than it form two or more groups around it (Morse theory
/// on meshes, Banchoff 1970); the march stops there. It sees saddles at vertices only, and takes
/// small ones that the triangulation makes for true ones.
GirthValue marchedGirth(geodesic::FastMarching& march, const SurfaceMesh& mesh, Index vertex,
                        const ExecutionContext& context);

}  // namespace girth
