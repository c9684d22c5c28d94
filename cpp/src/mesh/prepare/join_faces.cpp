#include "mesh/prepare/join_faces.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "mesh/angles.h"
#include "mesh/edge_groups.h"
#include "mesh/prepare/roots.h"
#include "mesh/sides.h"

namespace girth::prepare {

namespace {

class FaceJoiner {
 public:
  FaceJoiner(WorkingFaces& faces, PreparationReport& report) : faces_(faces), report_(report) {}

  JoinedFaces run() {
    findNeighbours();
    orient();
    joinAtCrowdedEdges();
    return std::move(joined_);
  }

 private:
  Index from(Index h) const { return faces_.triangles[h]; }
  Index to(Index h) const { return faces_.triangles[nextSide(h)]; }
  /// The place where a halfedge starts: it distinguishes the two ways along an edge.
  Index startOf(Index h) const { return placeOf(from(h)); }
  Index placeOf(Index v) const { return faces_.place.empty() ? v : faces_.place[v]; }

  void findNeighbours() {
    joined_.twin.assign(faces_.triangles.size(), kNoIndex);
    joined_.cutBegin.push_back(0);
    patch_.resize(faces_.faceCount());
    for (Index f = 0; f < patch_.size(); ++f) patch_[f] = f;
    cluster_ = patch_;
    if (faces_.place.empty()) {
      EdgeGroups(faces_.triangles, faces_.vertexCount()).forEach([&](const EdgeGroup& edge) {
        takeEdge(edge, false);
      });
      return;
    }
    // An edge is crowded by all faces at its place, though its vertices are joined to theirs or
    // not.
    std::vector<Index> sides;
    Index crowded = 0;
    EdgeGroups(faces_.cornerPlaces(), faces_.vertexCount()).forEach([&](const EdgeGroup& atPlace) {
      sides.clear();
      for (std::size_t i = 0; i < atPlace.size(); ++i) sides.push_back(atPlace[i]);
      const auto ends = [&](Index h) { return std::minmax({from(h), to(h)}); };
      std::sort(sides.begin(), sides.end(),
                [&](Index h, Index g) { return std::pair(ends(h), h) < std::pair(ends(g), g); });
      for (std::size_t i = 0, end; i < sides.size(); i = end) {
        for (end = i + 1; end < sides.size() && ends(sides[end]) == ends(sides[i]);) ++end;
        takeEdge(std::span<const Index>(&sides[i], end - i), sides.size() > 2);
      }
      for (; crowded + 1 < joined_.cutBegin.size(); ++crowded) {
        for (const Index h : sides) {
          if (joined_.twin[h] != kNoIndex) beside_.emplace_back(crowded, h);
        }
      }
    });
  }

  /// Takes the faces of an edge as neighbours, or as those of a crowded edge. At a crowded place
  /// those are neighbours that the file's own numbers make so.
  template <class Edge>
  void takeEdge(const Edge& edge, bool isCrowded) {
    const Index first = edge[0] / 3;
    for (std::size_t i = 1; i < edge.size(); ++i) unite(cluster_, first, edge[i] / 3);
    if (edge.size() == 1) {
      open_.push_back(first);
      return;
    }
    const auto isClosed = [&](Index v) { return !faces_.place.empty() && faces_.closedByFile[v]; };
    if (edge.size() == 2 && (!isCrowded || isClosed(from(edge[0])) || isClosed(to(edge[0])))) {
      join(edge[0], edge[1]);
      if (!isCrowded) unite(patch_, first, edge[1] / 3);
      return;
    }
    for (std::size_t i = 0; i < edge.size(); ++i) joined_.cut.push_back(edge[i]);
    joined_.cutBegin.push_back(static_cast<Index>(joined_.cut.size()));
    ++report_.nonManifoldEdges;
  }

  /// The sides of a face in an order that stays when the face is turned over: the flood of a
  /// one-sided surface then meets where it met before.
  std::array<Index, 3> sidesInOrder(Index f) const {
    const Index h = 3 * f;
    // Sides stand opposite to vertices: the order of those will do.
    std::array<Index, 3> sides{h, h + 1, h + 2};
    const auto before = [&](Index a, Index b) {
      return placeOf(faces_.triangles[previousSide(a)]) <
             placeOf(faces_.triangles[previousSide(b)]);
    };
    if (before(sides[1], sides[0])) std::swap(sides[0], sides[1]);
    if (before(sides[2], sides[1])) std::swap(sides[1], sides[2]);
    if (before(sides[1], sides[0])) std::swap(sides[0], sides[1]);
    return sides;
  }

  /// Floods each piece from its first face, over edges of two faces.
  void orient() {
    constexpr std::uint8_t kUnknown = 2;
    std::vector<std::uint8_t> turned(faces_.faceCount(), kUnknown);
    std::vector<Index> front;  // all faces of the piece so far
    std::size_t crowdedEdges = joined_.cutBegin.size() - 1;
    for (Index seed = 0; seed < faces_.faceCount(); ++seed) {
      if (turned[seed] != kUnknown) continue;
      turned[seed] = 0;
      front.assign(1, seed);
      std::size_t turnedFaces = 0;
      for (std::size_t i = 0; i < front.size(); ++i) {
        const Index f = front[i];
        for (const Index h : sidesInOrder(f)) {
          const Index across = joined_.twin[h];
          if (across == kNoIndex) continue;
          const Index g = across / 3;
          const auto wanted =
              static_cast<std::uint8_t>(turned[f] ^ (from(h) == from(across) ? 1 : 0));
          if (turned[g] == kUnknown) {
            turned[g] = wanted;
            turnedFaces += wanted;
            front.push_back(g);
          } else if (turned[g] != wanted) {
            joined_.twin[h] = joined_.twin[across] = kNoIndex;
            joined_.cut.insert(joined_.cut.end(), {std::min(h, across), std::max(h, across)});
            joined_.cutBegin.push_back(static_cast<Index>(joined_.cut.size()));
            ++report_.oneSidedEdges;
          }
        }
      }
      if (2 * turnedFaces > front.size()) {
        for (const Index f : front) turned[f] ^= 1;
        turnedFaces = front.size() - turnedFaces;
      }
      report_.reorientedFaces += static_cast<Index>(turnedFaces);
    }
    turnOver(turned);
    crowdedEdges_ = crowdedEdges;
  }

  /// Turns faces; halfedge 3 f + k becomes 3 f + 2 − k.
  void turnOver(const std::vector<std::uint8_t>& turned) {
    if (report_.reorientedFaces == 0) return;
    const auto renumbered = [&](Index h) {
      return h == kNoIndex || turned[h / 3] == 0 ? h : 3 * (h / 3) + 2 - h % 3;
    };
    for (Index f = 0; f < faces_.faceCount(); ++f) {
      if (turned[f] == 0) continue;
      std::swap(faces_.triangles[3 * f + 1], faces_.triangles[3 * f + 2]);
      std::swap(joined_.twin[3 * f], joined_.twin[3 * f + 2]);
    }
    for (Index& h : joined_.twin) h = renumbered(h);
    for (Index& h : joined_.cut) h = renumbered(h);
    for (auto& entry : beside_) entry.second = renumbered(entry.second);
  }

  /// Clusters that have a boundary whatever is joined: an edge of one face, one that is cut, or one
  /// that more faces run along one way than the other.
  void findOpenClusters() {
    isOpen_.assign(cluster_.size(), false);
    for (const Index f : open_) isOpen_[rootOf(cluster_, f)] = true;
    for (std::size_t i = 0; i + 1 < joined_.cutBegin.size(); ++i) {
      std::ptrdiff_t forth = 0;
      for (Index j = joined_.cutBegin[i]; j < joined_.cutBegin[i + 1]; ++j) {
        const Index h = joined_.cut[j];
        forth += from(h) < to(h) ? 1 : -1;
      }
      if (forth != 0) isOpen_[rootOf(cluster_, joined_.cut[joined_.cutBegin[i]] / 3)] = true;
    }
  }

  void joinAtCrowdedEdges() {
    std::vector<Index> edge;
    auto beside = beside_.begin();
    if (crowdedEdges_ > 0) findOpenClusters();
    for (std::size_t i = 0; i < crowdedEdges_; ++i) {
      edge.assign(joined_.cut.begin() + joined_.cutBegin[i],
                  joined_.cut.begin() + joined_.cutBegin[i + 1]);
      for (; beside != beside_.end() && beside->first == i; ++beside) {
        edge.push_back(beside->second);
      }
      joinWithinPatches(edge);
      joinWedges(edge);
    }
  }

  /// Joins two faces, unless the file's own numbers have joined one of them.
  void join(Index h, Index g) {
    if (joined_.twin[h] != kNoIndex || joined_.twin[g] != kNoIndex) return;
    joined_.twin[h] = g;
    joined_.twin[g] = h;
  }

  /// Joins the two faces that a piece has at an edge, and takes them from the list.
  void joinWithinPatches(std::vector<Index>& edge) {
    const auto patchOf = [&](Index h) { return rootOf(patch_, h / 3); };
    std::sort(edge.begin(), edge.end(), [&](Index h, Index g) {
      return std::pair(patchOf(h), h) < std::pair(patchOf(g), g);
    });
    std::size_t left = 0;
    for (std::size_t i = 0, end; i < edge.size(); i = end) {
      for (end = i + 1; end < edge.size() && patchOf(edge[end]) == patchOf(edge[i]);) ++end;
      if (end - i == 2 && startOf(edge[i]) != startOf(edge[i + 1])) {
        join(edge[i], edge[i + 1]);
      } else {
        for (std::size_t j = i; j < end; ++j) edge[left++] = edge[j];
      }
    }
    edge.resize(left);
  }

  /// A face at an edge, seen along the edge.
  struct Leaf {
    double angle;  ///< counter-clockwise round the edge
    bool enters;   ///< turning counter-clockwise, one enters the solid that it bounds
    Index halfedge;
  };

  /// Joins faces that bound wedges of solid: where they enter and leave by turns.
  void joinWedges(const std::vector<Index>& edge) {
    if (edge.size() < 2 || edge.size() % 2 != 0) return;
    std::vector<Leaf> leaves = leavesOf(edge);
    // Among leaves at one angle, the order that lets both alternate with the leaf before; where
    // none stands alone, they leave first, so that the two sides of a doubled sheet keep together
    // each.
    std::size_t begin = 0;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      const std::size_t before = (i + leaves.size() - 1) % leaves.size();
      const std::size_t after = (i + 1) % leaves.size();
      if (leaves[i].angle != leaves[before].angle && leaves[i].angle != leaves[after].angle) {
        begin = i;
        break;
      }
    }
    std::rotate(leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(begin), leaves.end());
    bool inside = begin == 0 && leaves[0].angle == leaves[1].angle;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      if (i + 1 < leaves.size() && leaves[i].angle == leaves[i + 1].angle &&
          leaves[i].enters == inside && leaves[i + 1].enters != inside) {
        std::swap(leaves[i], leaves[i + 1]);
      }
      inside = leaves[i].enters;
    }
    bool alternate = true;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      alternate = alternate && leaves[i].enters != leaves[(i + 1) % leaves.size()].enters;
    }
    if (!alternate) {
      // Solids that cross. Where nothing else is open, they are not opened here.
      if (isOpen_[rootOf(cluster_, edge[0] / 3)]) return;
      leaves.erase(
          std::remove_if(leaves.begin(), leaves.end(),
                         [&](const Leaf& leaf) { return joined_.twin[leaf.halfedge] != kNoIndex; }),
          leaves.end());
    }
    joinNested(leaves);
  }

  /// Joins every face that leaves a solid to the last one before it that enters one and is free, as
  /// brackets are; if there are as many of both.
  void joinNested(const std::vector<Leaf>& leaves) {
    std::ptrdiff_t depth = 0;
    for (const Leaf& leaf : leaves) depth += leaf.enters ? 1 : -1;
    if (depth != 0) return;
    std::vector<Index> entered;
    for (std::size_t i = 0; i < 2 * leaves.size(); ++i) {
      const Leaf& leaf = leaves[i % leaves.size()];
      if (leaf.enters) {
        if (i < leaves.size()) entered.push_back(leaf.halfedge);
      } else if (!entered.empty() &&
                 (i < leaves.size() || joined_.twin[leaf.halfedge] == kNoIndex)) {
        join(entered.back(), leaf.halfedge);
        entered.pop_back();
      }
    }
  }

  /// The faces in the order of their angles; at one angle, in that of their numbers.
  std::vector<Leaf> leavesOf(const std::vector<Index>& edge) const {
    const Index low = std::min(startOf(edge[0]), startOf(nextSide(edge[0])));
    const Index high = std::max(startOf(edge[0]), startOf(nextSide(edge[0])));
    const Vec3 axis = faces_.scaledPosition(high) - faces_.scaledPosition(low);
    const auto across = [&](Index h) {
      const Vec3 w = faces_.scaledPosition(from(previousSide(h))) - faces_.scaledPosition(low);
      return w - dot(w, axis) / dot(axis, axis) * axis;
    };
    // The first face gives the direction of angle 0.
    const Vec3 x = across(edge[0]), y = 1 / norm(axis) * cross(axis, x);
    std::vector<Leaf> leaves;
    for (const Index h : edge) {
      const Vec3 w = across(h);
      const double along = dot(w, x), up = dot(w, y);
      // By the same steps for all, so that faces on one another have exactly one angle.
      const double angle = along == 0 && up == 0 ? 0 : fullAngleOf(along, up);
      leaves.push_back({angle, startOf(h) == high, h});
    }
    std::sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) {
      return a.angle != b.angle ? a.angle < b.angle : a.halfedge < b.halfedge;
    });
    return leaves;
  }

  WorkingFaces& faces_;
  PreparationReport& report_;
  JoinedFaces joined_;
  std::vector<Index> patch_;  ///< by face, on the way to the first of its patch
  std::vector<Index>
      cluster_;               ///< by face, on the way to the first of those that any edge connects
  std::vector<Index> open_;   ///< faces with an edge of their own
  std::vector<bool> isOpen_;  ///< by cluster
  /// Faces at crowded edges, ascending, at the place that the file's own numbers have joined.
  std::vector<std::pair<Index, Index>> beside_;
  std::size_t crowdedEdges_{0};
};

}  // namespace

JoinedFaces joinFaces(WorkingFaces& faces, PreparationReport& report) {
  return FaceJoiner(faces, report).run();
}

}  // namespace girth::prepare
