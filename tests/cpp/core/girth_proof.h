// A proof of one value of the girth function that uses nothing of the engine.
#pragma once

#include "girth/girth_solver.h"
#include "textbook_mmp.h"

namespace girth::test {

/// Fails the test unless `loop` is what it says:
///  - it is straight and as long as it says (loop_checks.h): there is such a loop;
///  - the distance of its midpoint, by the textbook method, is half of its length to 1e-9: both
///    halves are shortest;
///  - below half of its length the distance field has no saddle (first_saddle.h), as far as a
///    subdivision with sides of `share` times that half can tell: no loop is shorter;
///  - antipodal: no sample of the field lies beyond the midpoint.
/// True if the saddle that the loop passes was itself seen at its place; a cycle that is filled
/// again at once is too short-lived for that.
bool expectProven(const SurfaceMesh& mesh, TextbookMmp& textbook, const GirthLoop& loop,
                  double share = 0.02);

/// Fails the test if a sample of the distance field lies farther than half of the loop's length.
void expectNothingBeyond(const SurfaceMesh& mesh, TextbookMmp& textbook, const GirthLoop& loop);

}  // namespace girth::test
