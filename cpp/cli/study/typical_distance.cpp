#include "study/typical_distance.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace girth::cli {
namespace {

struct Measured {
  std::string_view descriptor;
  TypicalDistance distance;
};

/// Distances of all 600 models of SHREC'11 with 500 faces each, in 30 classes of 20 poses.
constexpr std::array kMeasured{
    Measured{"igf", {0.018, 0.13}},          Measured{"sdf", {0.0037, 0.064}},
    Measured{"geoaverage", {0.0080, 0.058}}, Measured{"geofarthest", {0.024, 0.18}},
    Measured{"igf-ms", {0.021, 0.13}},       Measured{"log-igf", {0.034, 0.30}},
    Measured{"log-sdf", {0.030, 0.48}}};

}  // namespace

std::optional<TypicalDistance> typicalDistance(const std::string& descriptor,
                                               const ComparisonOptions& options) {
  const bool isAsMeasured = options.fields.unitArea && options.fields.persistence == 0 &&
                            options.fields.smoothing == 0 && options.signatures.bins == 0 &&
                            options.signatures.scale == study::ValueScale::AsIs;
  const auto found =
      std::find_if(kMeasured.begin(), kMeasured.end(),
                   [&](const Measured& measured) { return measured.descriptor == descriptor; });
  if (!isAsMeasured || found == kMeasured.end()) return std::nullopt;
  return found->distance;
}

}  // namespace girth::cli
