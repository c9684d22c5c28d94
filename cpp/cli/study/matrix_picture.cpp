#include "study/matrix_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "picture/png.h"

namespace girth::cli {

namespace {
/// Pixels along a side.
constexpr std::size_t kMost = 600;
}  // namespace

MatrixPicture::MatrixPicture(std::size_t models)
    : models_(models), side_(std::min(models, kMost)), sums_(side_ * side_), counts_(sums_) {}

void MatrixPicture::add(std::size_t model, const std::vector<double>& row) {
  const std::size_t y = model * side_ / models_;
  for (std::size_t i = 0; i < models_; ++i) {
    if (std::isnan(row[i])) continue;
    const std::size_t pixel = y * side_ + i * side_ / models_;
    sums_[pixel] += row[i];
    counts_[pixel] += 1;
  }
}

std::string MatrixPicture::png() const {
  constexpr double kLevels = 31;
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    sum += sums_[i];
    count += counts_[i];
  }
  const double white = sum > 0 ? 2 * sum / count : 1;
  std::vector<std::uint8_t> pixels;
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const double value = counts_[i] > 0 ? std::min(1.0, sums_[i] / counts_[i] / white) : 1;
    pixels.push_back(static_cast<std::uint8_t>(std::lround(value * kLevels) * 8));
  }
  const auto side = static_cast<std::uint32_t>(side_);
  return io::greyPng(pixels, side, side, 1);
}

}  // namespace girth::cli
