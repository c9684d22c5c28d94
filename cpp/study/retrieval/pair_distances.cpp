#include "girth/study/pair_distances.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "girth/parallel.h"

namespace girth::study {

namespace {

constexpr std::size_t kSampledRows = 64;
/// Distances computed by one thread at a stretch.
constexpr std::size_t kPairsAtATime = 64;

struct Mean {
  double sum{0};
  std::size_t count{0};
  void add(double value) {
    if (std::isnan(value)) return;
    sum += value;
    ++count;
  }
  double value() const { return count == 0 ? 0 : sum / static_cast<double>(count); }
};

}  // namespace

PairDistances::PairDistances(std::size_t models, Distance distance, std::size_t kept)
    : models_(models), distance_(std::move(distance)), keeps_(models <= kept) {
  if (keeps_ && models > 1) pairs_.resize(models * (models - 1) / 2);
}

bool PairDistances::prepare(const ExecutionContext& context) {
  Mean mean;
  if (keeps_) {
    // Rows grow: a row from the front and one from the back make work of equal size.
    const std::size_t halves = (models_ + 1) / 2;
    const bool done = parallelFor(halves, 1, context, [&](std::size_t begin, std::size_t end) {
      const auto fill = [&](std::size_t i) {
        for (std::size_t j = 0; j < i && !context.cancelled(); ++j) {
          pairs_[i * (i - 1) / 2 + j] = distance_(j, i);
        }
      };
      for (std::size_t half = begin; half < end; ++half) {
        fill(half);
        if (const std::size_t other = models_ - 1 - half; other != half) fill(other);
      }
    });
    if (!done || context.cancelled()) return false;
    for (const double distance : pairs_) mean.add(distance);
  } else {
    const std::size_t rows = std::min(models_, kSampledRows);
    std::vector<Mean> means(rows);
    const bool done = parallelFor(rows, 1, context, [&](std::size_t begin, std::size_t end) {
      for (std::size_t r = begin; r < end; ++r) {
        const std::size_t model = (2 * r + 1) * models_ / (2 * rows);
        for (std::size_t j = 0; j < models_ && !context.cancelled(); ++j) {
          if (j != model) means[r].add(distance_(j, model));
        }
      }
    });
    if (!done || context.cancelled()) return false;
    for (const Mean& part : means) {
      mean.sum += part.sum;
      mean.count += part.count;
    }
  }
  mean_ = mean.value();
  return true;
}

bool PairDistances::row(std::size_t model, std::span<double> row,
                        const ExecutionContext& context) const {
  if (keeps_) {
    for (std::size_t j = 0; j < models_; ++j) {
      const std::size_t high = std::max(model, j), low = std::min(model, j);
      row[j] = high == low ? 0 : pairs_[high * (high - 1) / 2 + low];
    }
    return true;
  }
  return parallelFor(models_, kPairsAtATime, context, [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end && !context.cancelled(); ++j) {
      row[j] = j == model ? 0 : distance_(j, model);
    }
  });
}

}  // namespace girth::study
