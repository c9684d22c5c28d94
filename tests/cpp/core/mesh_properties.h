// Properties that must hold on any surface; checked on random ones.
#pragma once

#include <cstdint>

namespace girth::test {

/// Fails the test unless, on the surface of this seed (random_meshes.h):
///  - exact is naive at every vertex, in value to 1e-9 and in kind;
///  - the loops of some vertices, and of some points inside faces and on edges, are proven
///    (girth_proof.h), and those points have the value that they have as vertices;
///  - distances and paths from vertices and other points are those of the textbook method;
///  - scale, motion, reflection of a part, numbering and subdivision leave values as they are;
///  - the order in which vertices are asked for and the number of threads leave every bit as it is.
/// The failure names the seed, by which the case can be had again.
void expectProperties(std::uint64_t seed);

}  // namespace girth::test
