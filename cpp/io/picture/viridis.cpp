#include "picture/viridis.h"

#include <algorithm>
#include <cmath>

namespace girth::io {
namespace {

/// Evenly spaced stops; straight between them it is within 2/255 of the whole map on a screen.
constexpr std::array<LinearColour, 33> kStops{{
    {3788, 20, 5810},     {4126, 262, 7655},    {4247, 596, 9434},    {4247, 1091, 11426},
    {4129, 1711, 12952},  {3900, 2477, 14387},  {3570, 3341, 15576},  {3179, 4340, 16394},
    {2866, 5495, 16920},  {2504, 6812, 17380},  {2170, 8123, 17456},  {1888, 9570, 17727},
    {1651, 10950, 17727}, {1453, 12663, 17727}, {1270, 14523, 17727}, {1101, 16272, 17727},
    {997, 18416, 17321},  {898, 20420, 16920},  {898, 22859, 16135},  {1017, 25126, 15371},
    {1352, 27518, 14296}, {2039, 30410, 12902}, {3120, 32957, 11380}, {4808, 35470, 9773},
    {7093, 37958, 8134},  {10305, 40545, 6363}, {14523, 42775, 4816}, {19832, 45002, 3328},
    {26473, 46903, 2071}, {34620, 48359, 1202}, {43693, 49841, 674},  {53954, 51349, 678},
    {64372, 52369, 1212},
}};

}  // namespace

LinearColour viridis(double fraction) {
  const double at = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(kStops.size() - 1);
  const auto stop = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const double share = at - static_cast<double>(stop);
  LinearColour colour{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double from = kStops[stop][k], to = kStops[stop + 1][k];
    colour[k] = static_cast<std::uint16_t>(std::floor(from + share * (to - from) + 0.5));
  }
  return colour;
}

}  // namespace girth::io
