// A matrix of distances as a grey picture.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace girth::cli {

/// Greys of distances, from 0, dark, to twice the mean; several models to a pixel where there are
/// more than fit.
class MatrixPicture {
 public:
  explicit MatrixPicture(std::size_t models);

  /// The distances of one model to all; NaN: none. Rows in any order.
  void add(std::size_t model, const std::vector<double>& row);

  /// The picture's file.
  std::string png() const;

 private:
  std::size_t models_, side_;
  std::vector<double> sums_, counts_;
};

}  // namespace girth::cli
