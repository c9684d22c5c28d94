// The fields by their names: a number at each vertex, of one table (`fields.def`).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/fields.def"  // the headers of the fields
#include "girth/spectrum.h"
#include "girth/surface_mesh.h"
#include "girth/vertex_function.h"
#include "girth/vertex_signatures.h"

namespace girth {

/// The kind of unit of a field's values.
enum class FieldUnit : std::uint8_t {
  Length,   ///< in model units
  Radian,   ///< angles
  PerArea,  ///< in 1 / squared model units
  Number,   ///< without a unit
};

/// An entry of the table of fields.
struct FieldInfo {
  std::string_view name;     ///< "sdf"
  std::string_view title;    ///< "Shape diameter"
  std::string_view meaning;  ///< words for a value, as the middle of a sentence
  FieldUnit unit;            ///< unit of its values
  bool isSpectral;           ///< made of the spectrum (`fieldSignature`), not vertex by vertex
};

/// All fields, in the order in which they are listed.
GIRTH_EXPORT std::span<const FieldInfo> fields();

/// The field with that name; null where there is none.
GIRTH_EXPORT const FieldInfo* findField(std::string_view name);

/// The unit of values where that of lengths is `length` ("metre"; empty: not known): "metre",
/// "radian", "metre^-2", or "".
GIRTH_EXPORT std::string unitText(FieldUnit unit, std::string_view length);

/// Parameters of fields. Each field reads its own.
struct FieldOptions {
  /// Tau of 'igf' and 'angle', in model units, at least 0 and finite. Loops whose saddles last no
  /// longer are passed over, as noise makes them (girth/barcode.h).
  double persistence{0};
  /// Options of 'sdf'.
  ShapeDiameterOptions sdf;
  /// Options of 'thickness'.
  ThicknessOptions thickness;
  /// How 'geoaverage' and 'geofarthest' measure distances.
  DistanceMethod distances{DistanceMethod::FastMarching};
  /// Options of 'distance'.
  DistanceFieldOptions distance;
};

/// A field vertex by vertex: numbers, or the girth with its kinds.
using FieldFunction = std::variant<VertexFunction<double>, VertexFunction<GirthValue>>;

/// A field of that name, unless it is spectral. Errors: USAGE where there is none; those of the
/// field's own function.
GIRTH_EXPORT Result<FieldFunction> fieldFunction(const SurfaceMesh& mesh, std::string_view name,
                                                 const FieldOptions& options = {});
/// The mesh must outlive the function: keep it in a variable.
Result<FieldFunction> fieldFunction(const SurfaceMesh&&, std::string_view name,
                                    const FieldOptions& options = {}) = delete;

/// A remark for people on a field's values, in sentences, of which `withoutValue` are missing;
/// empty where there is nothing to say.
GIRTH_EXPORT std::string fieldNote(const SurfaceMesh& mesh, std::string_view name,
                                   Index withoutValue);

/// The values of a field at all vertices.
struct FieldValues {
  /// One for each vertex; NaN where there is none.
  std::vector<double> values;
  /// As of `fieldNote`.
  std::string note;
};

/// `fieldFunction` at all vertices. Any number of threads gives the same bits. Errors: the same,
/// and CANCELLED.
///
/// \code
/// girth::FieldOptions options;
/// options.sdf.rays = 60;
/// std::cout << girth::fieldValues(mesh, "sdf", options).value().values[0] << '\n';
/// \endcode
GIRTH_EXPORT Result<FieldValues> fieldValues(const SurfaceMesh& mesh, std::string_view name,
                                             const FieldOptions& options = {},
                                             const ExecutionContext& context = {});

/// All numbers of a spectral field. `times`: of hks, in squared model units. Errors: USAGE where
/// there is none of that name; those of heat_kernel.h and wave_kernel.h.
GIRTH_EXPORT Result<VertexSignatures> fieldSignature(const Spectrum& spectrum,
                                                     std::string_view name,
                                                     std::span<const double> times);

}  // namespace girth
