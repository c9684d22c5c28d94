#include "hourglass.h"

#include <cmath>
#include <utility>

namespace girth::test {

std::string hourglass(double shift, int before) {
  constexpr int kCorners = 6;
  std::string text;
  for (const auto& [z, radius] : {std::pair{0, 2}, {3, 1}, {6, 2}}) {
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 2 * M_PI * i / kCorners;
      text += "v " + std::to_string(radius * std::cos(angle) + shift) + " " +
              std::to_string(radius * std::sin(angle)) + " " + std::to_string(z) + "\n";
    }
  }
  for (int ring = 0; ring < 2; ++ring) {
    for (int i = 0; i < kCorners; ++i) {
      const int a = before + 1 + ring * kCorners + i,
                b = before + 1 + ring * kCorners + (i + 1) % kCorners;
      text += "f " + std::to_string(a) + " " + std::to_string(b) + " " +
              std::to_string(b + kCorners) + " " + std::to_string(a + kCorners) + "\n";
    }
  }
  return text;
}

}  // namespace girth::test
