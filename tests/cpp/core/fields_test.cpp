// The table of fields: each name leads to its own function, unit and note.
#include "girth/fields.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "girth/heat_kernel.h"
#include "girth/wave_kernel.h"
#include "shapes.h"

namespace girth {
namespace {

const SurfaceMesh& slab() {
  static const SurfaceMesh mesh = test::box(4, 3, 1, 4, 3, 1).mesh();
  return mesh;
}

std::vector<double> namedValues(const std::string& name, const FieldOptions& options = {}) {
  return fieldValues(slab(), name, options).value().values;
}

TEST(Fields, valuesAreThoseOfTheFieldsOwnFunctions) {
  EXPECT_EQ(namedValues("igf"), girthField(slab()).values);
  EXPECT_EQ(namedValues("sdf"), shapeDiameter(slab()).value().values);
  EXPECT_EQ(namedValues("thickness"), medialThickness(slab()).value().values);
  const GeodesicExtent extent = geodesicExtent(slab(), DistanceMethod::FastMarching);
  EXPECT_EQ(namedValues("geoaverage"), extent.average);
  EXPECT_EQ(namedValues("geofarthest"), extent.farthest);
  EXPECT_EQ(namedValues("angle"), evaluateAll(slab(), loopAngleFunction(slab())).values);
}

TEST(Fields, optionsReachTheFieldsOwnFunctions) {
  FieldOptions options;
  options.sdf.rays = 3;
  options.thickness.sharpRadians = 0.5;
  options.distances = DistanceMethod::Exact;
  options.persistence = 0.1;
  EXPECT_EQ(namedValues("sdf", options), shapeDiameter(slab(), options.sdf).value().values);
  EXPECT_EQ(namedValues("thickness", options),
            medialThickness(slab(), options.thickness).value().values);
  EXPECT_EQ(namedValues("geofarthest", options),
            geodesicExtent(slab(), DistanceMethod::Exact).farthest);
  EXPECT_EQ(namedValues("igf", options), girthField(slab(), {GirthMethod::Exact, 0.1}).values);
  options.sdf.rays = 0;
  EXPECT_EQ(fieldValues(slab(), "sdf", options).error().code, ErrorCode::Usage);
  options.persistence = -1;
  EXPECT_EQ(fieldValues(slab(), "angle", options).error().code, ErrorCode::InvalidOption);
}

TEST(Fields, signaturesAreThoseOfTheSpectrum) {
  const Spectrum spectrum = laplaceSpectrum(slab(), {10}).value();
  const std::vector<double> times{0.1, 0.2};
  EXPECT_EQ(fieldSignature(spectrum, "hks", times).value().values,
            heatKernelSignature(spectrum, times).value().values);
  EXPECT_EQ(fieldSignature(spectrum, "wks", {}).value().values,
            waveKernelSignature(spectrum).value().values);
  EXPECT_EQ(fieldSignature(spectrum, "sihks", {}).value().values,
            scaleInvariantHeatKernelSignature(spectrum).value().values);
  EXPECT_EQ(fieldSignature(spectrum, "sdf", {}).error().code, ErrorCode::Usage);
}

TEST(Fields, eachHasAUnit) {
  const auto unitOf = [](const char* name) { return unitText(findField(name)->unit, "metre"); };
  EXPECT_EQ(unitOf("igf"), "metre");
  EXPECT_EQ(unitOf("angle"), "radian");
  EXPECT_EQ(unitOf("hks"), "metre^-2");
  EXPECT_EQ(unitOf("sihks"), "");
  EXPECT_EQ(unitText(FieldUnit::PerArea, ""), "");
  EXPECT_EQ(unitText(FieldUnit::Radian, ""), "radian");
}

TEST(Fields, aNameThatIsNoneIsRefused) {
  EXPECT_EQ(findField("girth"), nullptr);
  EXPECT_EQ(fieldValues(slab(), "girth").error().code, ErrorCode::Usage);
  // Its values come of the spectrum.
  EXPECT_EQ(fieldFunction(slab(), "hks").error().code, ErrorCode::Usage);
}

TEST(Fields, notesNameTheVerticesWithoutValue) {
  EXPECT_EQ(fieldNote(slab(), "sdf", 0), "");
  EXPECT_EQ(fieldNote(slab(), "sdf", 2), shapeDiameterNote(false, 2, slab().vertexCount()));
  EXPECT_EQ(fieldNote(slab(), "igf", 2), budgetNote(2, slab().vertexCount()));
}

}  // namespace
}  // namespace girth
