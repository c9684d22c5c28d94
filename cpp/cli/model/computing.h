// Fields and surfaces computed for a command, with progress on the terminal and until Ctrl-C.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "girth/fields.h"
#include "girth/girth_field.h"
#include "girth/print_check.h"
#include "girth/remesh.h"
#include "girth/tips.h"

namespace girth::cli {

/// Remedies of noteLargeSurface, for commands with `--faces` and without.
inline constexpr std::string_view kFewerFaces = "--faces 10000 takes seconds";
inline constexpr std::string_view kRemeshFirst = "girth remesh makes fewer of them";

/// Prints a note before the exact girth of a large surface is computed. `remedy`: what takes less.
void noteLargeSurface(const std::string& model, const SurfaceMesh& mesh, std::string_view remedy);

/// The girth at all vertices, I_tau for a persistence of more than 0. `model`: for the progress
/// line and the note. Errors: CANCELLED.
Result<GirthField> computeGirth(const std::string& model, const SurfaceMesh& mesh,
                                double persistence, unsigned threads,
                                std::string_view remedy = kFewerFaces);

/// The saddles of all vertices up to a persistence; 0: all that there are. Errors: CANCELLED.
Result<std::vector<Barcode>> computeBarcodes(const std::string& model, const SurfaceMesh& mesh,
                                             double persistence, unsigned threads);

/// The girth at all vertices, and the tips that it shows.
struct GirthAndTips {
  GirthField girth;
  Tips tips;
};

/// Errors: those of findTips, CANCELLED.
Result<GirthAndTips> computeTips(const std::string& model, const SurfaceMesh& mesh,
                                 double persistence, unsigned threads);

/// A field but a spectral one at all vertices (girth/fields.h). Errors: those of fieldValues.
/// Prints its note on standard error.
Result<FieldValues> computeField(const std::string& model, const SurfaceMesh& mesh,
                                 std::string_view name, const FieldOptions& options,
                                 unsigned threads);

/// All that does not meet the limits. Errors: those of checkPrint, CANCELLED.
Result<PrintCheck> computePrintCheck(const std::string& model, const SurfaceMesh& mesh,
                                     const PrintFields& fields, const PrintLimits& limits,
                                     unsigned threads);

/// The surface with at most so many other triangles, on all threads; nothing where it has no more
/// already, unless they are to be even: then it gets at most as many as it has. A note is printed
/// where the shape needs more. Errors: those of remesh, CANCELLED.
Result<std::optional<RemeshedSurface>> remeshModel(const std::string& model,
                                                   const SurfaceMesh& mesh,
                                                   const RemeshOptions& options);

}  // namespace girth::cli
