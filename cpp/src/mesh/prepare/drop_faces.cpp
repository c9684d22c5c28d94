#include "mesh/prepare/drop_faces.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <queue>
#include <utility>

#include "mesh/edge_groups.h"
#include "mesh/prepare/roots.h"
#include "mesh/sides.h"

namespace girth::prepare {

namespace {

/// The vertex of a halfedge's face that is not on the halfedge.
Index oppositeOf(const std::vector<Index>& triangles, Index halfedge) {
  return triangles[previousSide(halfedge)];
}

}  // namespace

// --- Collapsed faces -----------------------------------------------------------------------------

void dropCollapsedFaces(WorkingFaces& faces, std::vector<Index>& first, PreparationReport& report) {
  // Joining vertices moves other faces' corners by next to nothing; a chain of ever smaller ones
  // ends after a few rounds.
  constexpr int kMostRounds = 16;
  for (int round = 0; round < kMostRounds; ++round) {
    const Index before = faces.faceCount();
    faces.filter([&](Index f) {
      const Index* v = &faces.triangles[3 * std::size_t{f}];
      return v[0] != v[1] && v[1] != v[2] && v[2] != v[0];
    });
    report.degenerateFaces += before - faces.faceCount();

    bool joined = false;
    for (Index f = 0; f < faces.faceCount(); ++f) {
      const FaceShape shape = faces.shape(f);
      if (shape.hasArea()) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        if (shape.length[k] > 2 * kFlattestFace * shape.longest()) continue;
        const Index a = rootOf(first, faces.triangles[3 * std::size_t{f} + k]);
        const Index b = rootOf(first, faces.triangles[3 * std::size_t{f} + (k + 1) % 3]);
        if (a == b) continue;
        first[std::max(a, b)] = std::min(a, b);
        ++report.weldedVertices;
        joined = true;
      }
    }
    if (!joined) return;
    for (Index& v : faces.triangles) v = rootOf(first, v);
  }
}

// --- Duplicates ----------------------------------------------------------------------------------

namespace {

/// Copies of one face, ascending.
using Copies = std::vector<Index>;

std::vector<Copies> findCopies(const WorkingFaces& faces, const EdgeGroups& edges) {
  std::vector<Copies> found;
  std::vector<std::pair<Index, Index>> byThird;  // third vertex and face
  edges.forEach([&](const EdgeGroup& edge) {
    if (edge.size() < 2) return;
    // Each face is looked at once: at the edge of its two lowest vertices.
    const Index a = faces.triangles[edge[0]], b = faces.triangles[nextSide(edge[0])];
    byThird.clear();
    for (std::size_t i = 0; i < edge.size(); ++i) {
      const Index third = oppositeOf(faces.triangles, edge[i]);
      if (third > std::max(a, b)) byThird.emplace_back(third, edge[i] / 3);
    }
    std::sort(byThird.begin(), byThird.end());
    for (std::size_t i = 0, end; i < byThird.size(); i = end) {
      for (end = i + 1; end < byThird.size() && byThird[end].first == byThird[i].first;) ++end;
      if (end - i < 2) continue;
      found.emplace_back();
      for (std::size_t j = i; j < end; ++j) found.back().push_back(byThird[j].second);
    }
  });
  return found;
}

/// Whether two faces of the same vertices are turned the same way.
bool turnedAlike(const WorkingFaces& faces, Index f, Index g) {
  const Index* a = &faces.triangles[3 * std::size_t{f}];
  const Index* b = &faces.triangles[3 * std::size_t{g}];
  std::size_t k = 0;
  while (b[k] != a[0]) ++k;
  return b[(k + 1) % 3] == a[1];
}

}  // namespace

namespace {

/// Drops copies once; with `keepPartitions`, not those that separate two
/// solids. Returns whether any was dropped.
bool dropCopies(WorkingFaces& faces, bool keepPartitions, PreparationReport& report) {
  const std::vector<Copies> copies =
      findCopies(faces, EdgeGroups(faces.triangles, faces.vertexCount()));
  if (copies.empty()) return false;

  // Patches of doubled faces, joined over edges that have no other faces; and whether a patch is a
  // partition between solids, by the edges of its rim that have others.
  std::vector<Index> doubledOf(faces.faceCount(), kNoIndex);  // index into `copies`
  for (Index i = 0; i < copies.size(); ++i) {
    for (const Index f : copies[i]) doubledOf[f] = i;
  }
  std::vector<Index> patch(copies.size());
  for (Index i = 0; i < patch.size(); ++i) patch[i] = i;
  std::vector<std::pair<Index, bool>> rim;  // a doubled face, and whether the others are even
  const std::vector<Index> places = faces.cornerPlaces();
  const EdgeGroups edges(places, faces.vertexCount());
  for (const Copies& copy : copies) {
    for (Index k = 0; k < 3; ++k) {
      const Index h = 3 * copy[0] + k;
      const EdgeGroup edge = edges.between(places[h], places[nextSide(h)]);
      std::size_t others = 0;
      for (std::size_t i = 0; i < edge.size(); ++i) {
        if (doubledOf[edge[i] / 3] == kNoIndex) ++others;
      }
      const Index own = doubledOf[copy[0]];
      if (others > 0) {
        rim.emplace_back(own, others % 2 == 0);
      } else {
        // The first face of the edge joins all of them, each from its own turn in this loop.
        unite(patch, own, doubledOf[edge[0] / 3]);
      }
    }
  }
  std::vector<std::uint8_t> hasRim(patch.size(), 0), isPartition(patch.size(), 1);
  for (const auto& [face, even] : rim) {
    const Index p = rootOf(patch, face);
    hasRim[p] = 1;
    if (!even) isPartition[p] = 0;
  }

  std::vector<bool> dropped(faces.faceCount(), false);
  for (Index i = 0; i < copies.size(); ++i) {
    const Index p = rootOf(patch, i);
    Index second = kNoIndex;
    if (keepPartitions && hasRim[p] != 0 && isPartition[p] != 0) {
      second = copies[i][1];
      for (const Index f : copies[i]) {
        if (turnedAlike(faces, copies[i][0], f)) continue;
        second = f;
        break;
      }
    }
    for (const Index f : copies[i]) dropped[f] = f != copies[i][0] && f != second;
  }
  const Index before = faces.faceCount();
  faces.filter([&](Index f) { return !dropped[f]; });
  report.duplicateFaces += before - faces.faceCount();
  return faces.faceCount() < before;
}

}  // namespace

void dropDuplicateFaces(WorkingFaces& faces, PreparationReport& report) {
  // A patch that became single may change the answer for its neighbours; a few rounds settle that.
  constexpr int kMostRounds = 8;
  for (int round = 1; dropCopies(faces, round < kMostRounds, report);) ++round;
}

// --- Faces without area --------------------------------------------------------------------------

namespace {

/// Flips the longest sides of flat faces, longest first, so that rows of them along one line come
/// apart.
class FlatFaces {
 public:
  FlatFaces(WorkingFaces& faces, PreparationReport& report) : faces_(faces), report_(report) {
    for (Index f = 0; f < faces.faceCount(); ++f) push(f);
  }

  bool dropAll() {
    if (queue_.empty()) return false;
    const EdgeGroups edges(faces_.triangles, faces_.vertexCount());
    edges_ = &edges;
    dropped_.assign(faces_.faceCount(), false);
    version_.assign(faces_.faceCount(), 0);
    // Each flip leaves one flat face less, or shorter ones; rounding could make that go on.
    std::size_t flipsLeft = 16 * queue_.size() + 64;
    while (!queue_.empty()) {
      const Entry entry = queue_.top();
      queue_.pop();
      if (dropped_[entry.face] || version_[entry.face] != entry.version) continue;
      if (flipsLeft > 0 && flip(entry.face)) {
        --flipsLeft;
      } else {
        dropped_[entry.face] = true;
        removeFromEdges(entry.face);
        ++report_.degenerateFaces;
      }
    }
    faces_.filter([&](Index f) { return !dropped_[f]; });
    return true;
  }

 private:
  struct Entry {
    double length;
    Index face, version;
    bool operator<(const Entry& other) const {
      if (length != other.length) return length < other.length;
      return face > other.face;
    }
  };

  Index& corner(Index face, std::size_t k) { return faces_.triangles[3 * std::size_t{face} + k]; }

  void push(Index face) {
    const FaceShape shape = faces_.shape(face);
    if (shape.hasArea()) return;
    queue_.push({shape.longest(), face, version_.empty() ? 0 : version_[face]});
  }

  /// The faces of an edge as they are now.
  std::vector<Index>& facesAt(Index a, Index b) {
    const std::uint64_t key = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    const auto [entry, isNew] = facesOfEdge_.try_emplace(key);
    if (isNew) {
      const EdgeGroup edge = edges_->between(a, b);
      for (std::size_t i = 0; i < edge.size(); ++i) entry->second.push_back(edge[i] / 3);
    }
    return entry->second;
  }

  void removeFromEdges(Index face) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<Index>& others = facesAt(corner(face, k), corner(face, (k + 1) % 3));
      others.erase(std::find(others.begin(), others.end(), face));
    }
  }

  void addToEdges(Index face) {
    for (std::size_t k = 0; k < 3; ++k) {
      facesAt(corner(face, k), corner(face, (k + 1) % 3)).push_back(face);
    }
  }

  bool flip(Index face) {
    const FaceShape shape = faces_.shape(face);
    std::size_t k = 0;
    for (std::size_t j = 1; j < 3; ++j) {
      if (shape.length[j] > shape.length[k]) k = j;
    }
    const Index a = corner(face, k), c = corner(face, (k + 1) % 3), b = corner(face, (k + 2) % 3);
    const std::vector<Index>& across = facesAt(a, c);
    if (across.size() != 2) return false;
    if (facesAt(a, b).size() < 2 && facesAt(b, c).size() < 2) return false;
    const Index neighbour = across[0] == face ? across[1] : across[0];
    for (std::size_t j = 0; j < 3; ++j) {
      if (corner(neighbour, j) == b) return false;
    }
    removeFromEdges(face);
    removeFromEdges(neighbour);
    for (std::size_t j = 0; j < 3; ++j) {
      const Index v = corner(neighbour, j);
      corner(face, j) = v == a ? b : v;
      corner(neighbour, j) = v == c ? b : v;
    }
    faces_.inputOfFace[face] = faces_.inputOfFace[neighbour];
    for (const Index f : {face, neighbour}) {
      addToEdges(f);
      ++version_[f];
      push(f);
    }
    ++report_.flippedFaces;
    return true;
  }

  WorkingFaces& faces_;
  PreparationReport& report_;
  const EdgeGroups* edges_{nullptr};
  std::priority_queue<Entry> queue_;
  std::vector<bool> dropped_;
  std::vector<Index> version_;
  std::map<std::uint64_t, std::vector<Index>>
      facesOfEdge_;  // faces by edge, for edges that were asked for
};

}  // namespace

bool dropFlatFaces(WorkingFaces& faces, PreparationReport& report) {
  return FlatFaces(faces, report).dropAll();
}

}  // namespace girth::prepare
