// The fields that shapes are compared by, computed as the paper's section 6.1 does.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/geodesic_extent.h"
#include "girth/heat_kernel.h"
#include "girth/shape_diameter.h"
#include "girth/spectrum.h"
#include "girth/surface_mesh.h"
#include "girth/wave_kernel.h"

namespace girth::study {

/// Fields that come out of one computation.
enum class FieldGroup : std::uint8_t {
  Girth,         ///< igf: the exact girth
  MarchedGirth,  ///< igf-ms: the girth by fast marching
  Diameter,      ///< sdf: the shape diameter
  Extent,        ///< geoaverage and geofarthest
  Spectral,      ///< hks, sihks and wks: many numbers for each vertex
};

/// All of them.
inline constexpr FieldGroup kFieldGroups[] = {FieldGroup::Girth, FieldGroup::MarchedGirth,
                                              FieldGroup::Diameter, FieldGroup::Extent,
                                              FieldGroup::Spectral};

/// "igf", "igf-ms", "sdf", "extent" or "spectral".
GIRTH_EXPORT std::string_view toString(FieldGroup group);

/// The paper's parameters are the defaults.
struct FieldParameters {
  /// Surfaces of more triangles are remeshed to so many; 0: all are taken as they are.
  Index faces{10'000};
  /// Whether surfaces are scaled to area 1.
  bool unitArea{true};
  /// Every vertex is moved by up to so many mean edge lengths (withNoise), once the surface has
  /// been remeshed: how well shapes are found again in rough scans.
  double noise{0};
  /// Steps of smoothing (smoothSurface), once there are the triangles and the noise: rough scans
  /// are found again better so.
  Index smoothing{0};
  /// For igf: tau over the square root of the area (girth/barcode.h); 0: the girth itself.
  double persistence{0};
  /// Options of the shape diameter.
  ShapeDiameterOptions diameter;
  /// The distances of geoaverage and geofarthest.
  DistanceMethod distances{DistanceMethod::FastMarching};
  /// Never more than one pair for 5 vertices (but 10): faster waves describe the triangles, not the
  /// shape, and spoil wks.
  SpectrumOptions spectrum;
  /// Options of sihks.
  SihksOptions sihks;
  /// Options of wks.
  WksOptions wks;
};

/// A field with one or more numbers for every vertex.
struct StudyField {
  /// As descriptors call it: "igf".
  std::string name;
  /// Numbers of each vertex.
  std::size_t dimensions{1};
  /// The numbers of vertex v are values[v · dimensions + d]; NaN where there is none.
  std::vector<double> values;
};

/// Fields and how much each vertex counts: its share of the area.
struct GIRTH_EXPORT StudyFields {
  /// The weight of each vertex; they add up to 1.
  std::vector<double> weights;
  /// On the same vertices.
  std::vector<StudyField> fields;

  /// Null where there is no field of that name.
  const StudyField* find(std::string_view name) const;
};

/// The surface on which the fields are computed: remeshed, smoothed and scaled by the parameters.
/// Errors: those of remesh, withNoise and smoothSurface; LIMIT_EXCEEDED where the area is no number
/// that can be scaled.
GIRTH_EXPORT Result<SurfaceMesh> studySurface(const SurfaceMesh& mesh,
                                              const FieldParameters& parameters,
                                              const ExecutionContext& context = {});

/// A group's fields on such a surface. hks is the heat kernel signature at 16 times, from 4 ln 10 /
/// (4π · 300) to 4 ln 10 / 4π times the area in equal ratios: what Sun et al. 2009 choose, with the
/// eigenvalues 1 and 300 that a surface of that area has on average (Weyl's law); at each time it
/// is divided by its mean over the surface, so that all times count alike. Costs and errors: those
/// of the fields; INVALID_OPTION (checkPersistence); CANCELLED.
GIRTH_EXPORT Result<StudyFields> studyFields(const SurfaceMesh& surface, FieldGroup group,
                                             const FieldParameters& parameters,
                                             const ExecutionContext& context = {});

/// All parameters that a group's values depend on, and the version of what computes them: equal
/// texts mean equal fields of equal surfaces.
GIRTH_EXPORT std::string parametersText(FieldGroup group, const FieldParameters& parameters);

}  // namespace girth::study
