#include "picture/thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "picture/png.h"

namespace girth::io {
namespace {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

/// The axes of a symmetric matrix, as rows, that of the greatest value first (Jacobi's method).
Matrix principalAxes(Matrix a) {
  Matrix axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int sweep = 0; sweep < 30; ++sweep) {
    for (std::size_t p = 0; p < 2; ++p) {
      for (std::size_t q = p + 1; q < 3; ++q) {
        if (a[p][q] == 0) continue;
        const double angle = 0.5 * std::atan2(2 * a[p][q], a[q][q] - a[p][p]);
        const double c = std::cos(angle), s = std::sin(angle);
        for (std::size_t k = 0; k < 3; ++k) {
          const double x = a[k][p], y = a[k][q];
          a[k][p] = c * x - s * y;
          a[k][q] = s * x + c * y;
        }
        for (std::size_t k = 0; k < 3; ++k) {
          const double x = a[p][k], y = a[q][k];
          a[p][k] = c * x - s * y;
          a[q][k] = s * x + c * y;
          const double u = axes[p][k], v = axes[q][k];
          axes[p][k] = c * u - s * v;
          axes[q][k] = s * u + c * v;
        }
      }
    }
  }
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return a[i][i] > a[j][j]; });
  return {axes[order[0]], axes[order[1]], axes[order[2]]};
}

/// The vertices in the picture: x to the right, y down, in [0, 1]; z towards the viewer.
std::vector<Vector> projected(const SurfaceMesh& mesh) {
  const Index n = mesh.vertexCount();
  Vector low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  std::vector<Vector> points(n);
  for (Index v = 0; v < n; ++v) {
    const Vec3& p = mesh.position(Vertex(v));
    points[v] = {p.x, p.y, p.z};
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], points[v][k]);
      high[k] = std::max(high[k], points[v][k]);
    }
  }
  const double size = std::max(
      {high[0] - low[0], high[1] - low[1], high[2] - low[2], std::numeric_limits<double>::min()});
  Vector mean{};
  for (Vector& point : points) {
    for (std::size_t k = 0; k < 3; ++k) {
      point[k] = (point[k] - low[k]) / size;
      mean[k] += point[k] / n;
    }
  }
  Matrix moments{};
  for (const Vector& point : points) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        moments[i][j] += (point[i] - mean[i]) * (point[j] - mean[j]);
      }
    }
  }
  Matrix axes = principalAxes(moments);
  // Right, down and towards the viewer: a left-handed frame would show the mirror image.
  const Vector across{axes[0][1] * axes[1][2] - axes[0][2] * axes[1][1],
                      axes[0][2] * axes[1][0] - axes[0][0] * axes[1][2],
                      axes[0][0] * axes[1][1] - axes[0][1] * axes[1][0]};
  for (std::size_t k = 0; k < 3; ++k) axes[2][k] = -across[k];
  double reach = 0;
  for (Vector& point : points) {
    Vector moved{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) moved[i] += axes[i][k] * (point[k] - mean[k]);
    }
    point = moved;
    reach = std::max({reach, std::fabs(point[0]), std::fabs(point[1])});
  }
  for (Vector& point : points) {
    point[0] = 0.5 + 0.48 * point[0] / reach;
    point[1] = 0.5 + 0.48 * point[1] / reach;
    point[2] *= 0.48 / reach;
  }
  return points;
}

}  // namespace

std::string thumbnailPng(const SurfaceMesh& mesh, std::uint32_t size) {
  constexpr std::uint32_t kOversampling = 3;
  size = std::clamp<std::uint32_t>(size, 1, 4096);
  const std::uint32_t side = kOversampling * size;
  const std::vector<Vector> points = projected(mesh);
  std::vector<float> depth(std::size_t{side} * side, -std::numeric_limits<float>::infinity());
  std::vector<std::uint8_t> shade(depth.size(), 0);
  for (const Face f : mesh.faces()) {
    const auto [i, j, k] = mesh.faceVertices(f);
    const Vector &a = points[i], &b = points[j], &c = points[k];
    const Vector u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const Vector v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const Vector normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                        u[0] * v[1] - u[1] * v[0]};
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    if (!(length > 0) || normal[2] == 0) continue;
    const auto grey =
        static_cast<std::uint8_t>(60 + std::lround(170 * std::fabs(normal[2]) / length));
    const auto pixelOf = [&](double x) {
      return static_cast<std::int64_t>(std::clamp(x * side, 0.0, side - 1.0));
    };
    const auto [left, right] = std::minmax({a[0], b[0], c[0]});
    const auto [top, bottom] = std::minmax({a[1], b[1], c[1]});
    for (std::int64_t y = pixelOf(top); y <= pixelOf(bottom); ++y) {
      for (std::int64_t x = pixelOf(left); x <= pixelOf(right); ++x) {
        const double px = (static_cast<double>(x) + 0.5) / side - a[0];
        const double py = (static_cast<double>(y) + 0.5) / side - a[1];
        const double s = (px * v[1] - py * v[0]) / normal[2];
        const double t = (py * u[0] - px * u[1]) / normal[2];
        if (s < 0 || t < 0 || s + t > 1) continue;
        const auto z = static_cast<float>(a[2] + s * u[2] + t * v[2]);
        const std::size_t pixel = static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x);
        if (z <= depth[pixel]) continue;
        depth[pixel] = z;
        shade[pixel] = grey;
      }
    }
  }
  std::vector<std::uint8_t> picture;
  for (std::uint32_t y = 0; y < size; ++y) {
    for (std::uint32_t x = 0; x < size; ++x) {
      unsigned sum = 0, covered = 0;
      for (std::uint32_t s = 0; s < kOversampling * kOversampling; ++s) {
        const std::uint8_t grey = shade[std::size_t{y * kOversampling + s / kOversampling} * side +
                                        x * kOversampling + s % kOversampling];
        sum += grey;
        covered += grey > 0 ? 1 : 0;
      }
      picture.push_back(static_cast<std::uint8_t>(covered > 0 ? sum / covered : 0));
      picture.push_back(static_cast<std::uint8_t>(255 * covered / (kOversampling * kOversampling)));
    }
  }
  return greyPng(picture, size, size, 2);
}

}  // namespace girth::io
