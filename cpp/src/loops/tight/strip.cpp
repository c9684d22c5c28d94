#include "loops/tight/strip.h"

#include <algorithm>
#include <deque>

namespace girth::loops {
namespace {

/// The vertex opposite a halfedge whose ends are known, on the side of its face.
Vec2 apexOver(const Unfolding& unfolding, Index halfedge, Vec2 from, Vec2 to) {
  const geodesic::Crossing crossing = unfolding.crossing(halfedge);
  const Vec2 along = (1 / crossing.length()) * (to - from);
  return from + geodesic::turned(crossing.apex(), along);
}

}  // namespace

Strip::Strip(const Unfolding& unfolding, const Run& run, bool closed) {
  const std::size_t size = run.size();
  if (size == 0) return;
  const auto first = unfolding.crossing(run[0]);
  start_ = first.apex();
  corners_.push_back({{first.length(), 0}, first.to(), 0, 0});
  corners_.push_back({{0, 0}, first.from(), 0, 0});
  left_.push_back(0);
  right_.push_back(1);
  for (std::size_t i = 0; i < size; ++i) {
    const Index entered = unfolding.twin(run[i]);
    const std::size_t l = left_.back(), r = right_.back();
    const Vec2 apex = apexOver(unfolding, entered, corners_[l].place, corners_[r].place);
    const Index vertex = unfolding.crossing(entered).apexVertex();
    if (i + 1 == size && !closed) {
      end_ = apex;
      break;
    }
    const Index left = run[(i + 1) % size];
    corners_.push_back({apex, vertex, i + 1, i + 1});
    const bool isLeft = left == Unfolding::next(entered);
    left_.push_back(isLeft ? corners_.size() - 1 : l);
    right_.push_back(isLeft ? r : corners_.size() - 1);
    corners_[left_.back()].lastPortal = corners_[right_.back()].lastPortal = i + 1;
  }
}

double Strip::share(std::size_t portal, Vec2 a, Vec2 b) const {
  const Vec2 right = corners_[right_[portal]].place, left = corners_[left_[portal]].place;
  const double r = geodesic::cross(b - a, right - a), l = geodesic::cross(b - a, left - a);
  return r == l ? 0.5 : r / (r - l);
}

std::vector<std::size_t> Strip::bends(Vec2 a, std::size_t first, Vec2 b, std::size_t last) const {
  // The funnel: from its left end over the apex to its right end. The path to each corner in it
  // goes over those between it and the apex, and from there over `parent`.
  constexpr std::size_t kStart = static_cast<std::size_t>(-1), kEnd = kStart - 1;
  const auto place = [&](std::size_t c) {
    return c == kStart ? a : c == kEnd ? b : corners_[c].place;
  };
  std::deque<std::size_t> funnel{left_[first], kStart, right_[first]};
  std::size_t apex = 1;
  std::vector<std::size_t> parent(corners_.size(), kStart);
  const auto insert = [&](std::size_t corner, bool isLeft) {
    const Vec2 p = place(corner);
    const double sign = isLeft ? 1 : -1;
    const auto at = [&](std::size_t i) {
      return place(isLeft ? funnel[i] : funnel[funnel.size() - 1 - i]);
    };
    while (funnel.size() > 1) {
      const std::size_t toApex = isLeft ? apex : funnel.size() - 1 - apex;
      const Vec2 q = at(0), r = at(1);
      const double turn =
          toApex > 0 ? geodesic::cross(q - r, p - q) : geodesic::cross(r - q, p - q);
      if (sign * turn >= 0) break;
      if (isLeft) {
        funnel.pop_front();
        if (apex > 0) --apex;
      } else {
        funnel.pop_back();
        apex = std::min(apex, funnel.size() - 1);
      }
    }
    const std::size_t tangent = isLeft ? funnel.front() : funnel.back();
    if (isLeft) {
      funnel.push_front(corner);
      ++apex;
    } else {
      funnel.push_back(corner);
    }
    return tangent;
  };
  for (std::size_t i = first + 1; i <= last; ++i) {
    if (left_[i] != left_[i - 1]) parent[left_[i]] = insert(left_[i], true);
    if (right_[i] != right_[i - 1]) parent[right_[i]] = insert(right_[i], false);
  }
  std::vector<std::size_t> path;
  for (std::size_t c = insert(kEnd, true); c != kStart; c = parent[c]) path.push_back(c);
  std::reverse(path.begin(), path.end());
  return path;
}

Run reversed(const Unfolding& unfolding, const Run& run) {
  Run back(run.rbegin(), run.rend());
  for (Index& halfedge : back) halfedge = unfolding.twin(halfedge);
  return back;
}

void cancelReturns(const Unfolding& unfolding, Run& run, bool closed) {
  Run kept;
  for (const Index halfedge : run) {
    if (!kept.empty() && kept.back() == unfolding.twin(halfedge)) {
      kept.pop_back();
    } else {
      kept.push_back(halfedge);
    }
  }
  std::size_t begin = 0, end = kept.size();
  while (closed && end - begin > 1 && kept[begin] == unfolding.twin(kept[end - 1])) {
    ++begin;
    --end;
  }
  run.assign(kept.begin() + static_cast<std::ptrdiff_t>(begin),
             kept.begin() + static_cast<std::ptrdiff_t>(end));
}

}  // namespace girth::loops
