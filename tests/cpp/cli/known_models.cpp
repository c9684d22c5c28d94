#include "known_models.h"

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

std::string frame() {
  std::string text;
  // Bottom and top, each with its outer and its inner corners.
  for (const char* z : {"0", "0.5"}) {
    for (const char* corner : {"0 0", "3 0", "3 3", "0 3", "1 1", "2 1", "2 2", "1 2"}) {
      text += std::string("v ") + corner + " " + z + "\n";
    }
  }
  const auto quad = [&](int a, int b, int c, int d) {
    for (const int v : {a, b, c, d}) text += (v == a ? "f " : " ") + std::to_string(v + 1);
    text += "\n";
  };
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    quad(i, i + 4, j + 4, j);
    quad(i + 8, j + 8, j + 12, i + 12);
    quad(i, j, j + 8, i + 8);
    quad(i + 4, i + 12, j + 12, j + 4);
  }
  return text;
}

}  // namespace girth::test
