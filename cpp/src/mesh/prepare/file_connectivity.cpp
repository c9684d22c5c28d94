#include "mesh/prepare/file_connectivity.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "mesh/edge_groups.h"
#include "mesh/prepare/roots.h"
#include "mesh/sides.h"

namespace girth::prepare {

namespace {

class FileConnectivity {
 public:
  FileConnectivity(std::span<const Index> triangles, const std::vector<Index>& place)
      : triangles_(triangles), place_(place), joinable_(place.size(), false) {}

  std::vector<bool> run() {
    findComponents();
    findOpenEdges();
    findCopies();
    std::vector<bool> closed(place_.size());
    for (Index v = 0; v < place_.size(); ++v) closed[v] = place_[v] != kNoIndex && !joinable_[v];
    return closed;
  }

 private:
  Index faceCount() const { return static_cast<Index>(triangles_.size() / 3); }
  Index component(Index face) { return rootOf(component_, triangles_[3 * std::size_t{face}]); }

  /// Vertices that faces connect, whatever their positions.
  void findComponents() {
    component_.resize(place_.size());
    for (Index v = 0; v < component_.size(); ++v) component_[v] = v;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      unite(component_, triangles_[i], triangles_[i - i % 3]);
    }
    facesOf_.assign(place_.size(), 0);
    for (Index f = 0; f < faceCount(); ++f) ++facesOf_[component(f)];
  }

  void findOpenEdges() {
    isOpen_.assign(place_.size(), 0);
    // A face that repeats a vertex has two sides on one edge, and is no neighbour there.
    std::vector<Index> whole;
    whole.reserve(triangles_.size());
    for (std::size_t i = 0; i < triangles_.size(); i += 3) {
      const auto corner = triangles_.subspan(i, 3);
      if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
      whole.insert(whole.end(), corner.begin(), corner.end());
    }
    EdgeGroups(whole, place_.size()).forEach([&](const EdgeGroup& edge) {
      if (edge.size() == 2) return;
      for (const Index v : {whole[edge[0]], whole[nextSide(edge[0])]}) {
        joinable_[v] = true;
        if (edge.size() == 1) isOpen_[rootOf(component_, v)] = 1;
      }
    });
  }

  /// Faces that coincide with others: of an open sheet, of a component that is there twice, or of
  /// one that is two sheets on each other.
  void findCopies() {
    // Faces by their three places.
    struct PlacedFace {
      std::array<Index, 3> places;
      Index face;
      bool operator<(const PlacedFace& other) const {
        return places != other.places ? places < other.places : face < other.face;
      }
    };
    std::vector<PlacedFace> faces;
    faces.reserve(faceCount());
    for (Index f = 0; f < faceCount(); ++f) {
      std::array<Index, 3> at{};
      for (std::size_t k = 0; k < 3; ++k) at[k] = place_[triangles_[3 * std::size_t{f} + k]];
      std::sort(at.begin(), at.end());
      if (at[0] != at[1] && at[1] != at[2]) faces.push_back({at, f});
    }
    std::sort(faces.begin(), faces.end());
    const auto forEachGroup = [&](auto&& visit) {
      for (std::size_t i = 0, end; i < faces.size(); i = end) {
        for (end = i + 1; end < faces.size() && faces[end].places == faces[i].places;) ++end;
        if (end - i > 1) visit(i, end);
      }
    };

    // The faces of each component that coincide with others of one component: another or its own.
    std::vector<Index> other(place_.size(), kNoIndex), coincident(place_.size(), 0);
    forEachGroup([&](std::size_t begin, std::size_t end) {
      Index lowest = component(faces[begin].face), ofLowest = 0;
      for (std::size_t i = begin; i < end; ++i) {
        const Index own = component(faces[i].face);
        if (own < lowest) ofLowest = 0;
        lowest = std::min(lowest, own);
        if (own == lowest) ++ofLowest;
      }
      for (std::size_t i = begin; i < end; ++i) {
        const Index own = component(faces[i].face);
        if (own == lowest && ofLowest < 2) continue;
        if (other[own] == kNoIndex) other[own] = lowest;
        if (other[own] == lowest) ++coincident[own];
      }
    });
    const auto isCopy = [&](Index c) {
      return other[c] != kNoIndex && coincident[c] == facesOf_[c] &&
             facesOf_[c] == facesOf_[other[c]];
    };
    forEachGroup([&](std::size_t begin, std::size_t end) {
      bool isJoined = false;
      for (std::size_t i = begin; i < end; ++i) {
        const Index c = component(faces[i].face);
        isJoined = isJoined || isOpen_[c] != 0 || isCopy(c);
      }
      if (!isJoined) return;
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          joinable_[triangles_[3 * std::size_t{faces[i].face} + k]] = true;
        }
      }
    });
  }

  std::span<const Index> triangles_;
  const std::vector<Index>& place_;
  std::vector<bool> joinable_;
  std::vector<Index> component_;  ///< for each vertex, on the way to the one that names it
  std::vector<Index> facesOf_;
  std::vector<std::uint8_t> isOpen_;
};

}  // namespace

std::vector<bool> closedByTheFile(std::span<const Index> triangles,
                                  const std::vector<Index>& place) {
  return FileConnectivity(triangles, place).run();
}

}  // namespace girth::prepare
