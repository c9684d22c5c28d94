// The barcodes of all vertices as a file's content: JSON, CSV or NPY.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "girth/barcode.h"
#include "girth/export.h"
#include "girth/io/read_mesh.h"

namespace girth::io {

/// One JSON object: `file`, `unit`, `maxPersistence` (null: there is no bound), `vertices` (how
/// many the file has), and an array for every vertex of the *file*, in its order: `bars`, pairs
/// [birth, death], the death null where it is infinite; `rest`, the length that I_tau has where no
/// bar lasts longer than tau; and `restKind`. Null where a vertex is not on the surface.
/// `barcodes`: one for each vertex of the surface, all of the same `maxPersistence`.
GIRTH_EXPORT std::string barcodesJson(const LoadedMesh& loaded, std::span<const Barcode> barcodes,
                                      std::string_view file);

/// `vertex,birth,death` and a row for each bar, in the order of the file's vertices; the death is
/// empty where it is infinite.
GIRTH_EXPORT std::string barcodesCsv(const LoadedMesh& loaded, std::span<const Barcode> barcodes);

/// These rows as NumPy reads them: dtype '<f8', shape (bars, 3).
GIRTH_EXPORT std::string barcodesNpy(const LoadedMesh& loaded, std::span<const Barcode> barcodes);

}  // namespace girth::io
