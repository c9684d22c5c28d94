// Checks that a change of a mesh neither turns faces over nor makes needles of them.
#pragma once

#include "mesh/remesh/cancellation_poll.h"
#include "mesh/remesh/changing_mesh.h"

namespace girth::remeshing {

/// Whether a triangle has an area that a face of a surface may have.
bool hasArea(const Vec3& a, const Vec3& b, const Vec3& c);

/// Whether a triangle faces as one of this area vector did and has area; a thin one must have more.
bool facesAs(const Vec3& before, const Vec3& a, const Vec3& b, const Vec3& c);

/// Whether the faces of a vertex keep their side, and have area, when it moves to `place`; those
/// that also have the vertex `other` do not count. A thin face may only become better.
bool keepsFacing(const ChangingMesh& mesh, Index vertex, const Vec3& place, Index other);

/// Whether the two faces that a flip makes face as the two before did, within an angle of the given
/// cosine, and are no needles.
bool flipsSmoothly(const ChangingMesh& mesh, Index h, double cosine);

/// Flips edges where that makes the smallest of six angles larger, and faces as before within
/// `cosine`. Flips that are left undone when it is stopped do no harm.
void widenAngles(ChangingMesh& mesh, double cosine, CancellationPoll& poll);

}  // namespace girth::remeshing
