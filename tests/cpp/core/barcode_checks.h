// Barcodes against persistence that is computed another way.
#pragma once

#include "girth/barcode.h"
#include "textbook_mmp.h"

namespace girth::test {

/// Fails the test unless a whole barcode (maxPersistence infinite) is that of the distance field as
/// the textbook method and samples of it show: persistent homology of sublevel sets over triangles
/// with sides up to `spacing`, by union-find (first_saddle.h). Every bar of either that lasts
/// longer than twice the error of the samples must be matched with one of the other, both of whose
/// ends lie no farther off than that error (stability of persistence, Cohen-Steiner et al. 2007).
/// Returns how many bars were so long.
int expectSampledBarcode(const SurfaceMesh& mesh, TextbookMmp& textbook, const SurfacePoint& point,
                         const Barcode& barcode, double spacing);

/// Checks barcodes at every step-th vertex, with samples as far apart as a share of the greatest
/// distance. Bars that were long enough.
int expectSampledBarcodes(const SurfaceMesh& mesh, Index first, Index step, double share);

/// Checks barcodes on the random surface of a seed, at so many of its vertices, spread over it, 0
/// for all.
int expectSampledBarcodes(std::uint64_t seed, Index vertices, double share);

/// Checks on the random surface of a seed, at every vertex, that the persistent girth is to the bit
/// what the whole barcode says, for which all maxima were looked for; also for tau just below and
/// above how long a saddle lasts.
void expectPersistentGirths(std::uint64_t seed);

}  // namespace girth::test
