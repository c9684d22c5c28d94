// A propagation that only goes as far as a given distance.
#pragma once

#include <functional>
#include <utility>

#include "geodesic/propagation.h"
#include "girth/execution.h"

namespace girth::geodesic {

/// A visitor of Propagation::run. It ends the run once the frontier has passed the distance that
/// `limit` returns. `limit` is called once a bucket. One type serves all limits, so that `run` is
/// compiled once.
class StopAtDistance {
 public:
  StopAtDistance(std::function<double()> limit, const ExecutionContext& context)
      : limit_(std::move(limit)), context_(context) {}

  bool enough(double frontier) { return interrupted() || frontier > limit_(); }
  bool interrupted() { return cancelled_ = context_.cancelled(); }
  void onCrossing(Index, std::uint32_t, const CrossingResult&) {}
  void onVertex(Index) {}
  void restart() {}
  std::size_t effort() const { return 0; }
  bool cancelled() const { return cancelled_; }

 private:
  std::function<double()> limit_;
  const ExecutionContext& context_;
  bool cancelled_{false};
};

}  // namespace girth::geodesic
