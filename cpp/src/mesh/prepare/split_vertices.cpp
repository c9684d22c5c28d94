#include "mesh/prepare/split_vertices.h"
#include "mesh/sides.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace girth::prepare {

namespace {

class VertexSplitter {
 public:
  VertexSplitter(const WorkingFaces& faces, JoinedFaces& joined) : faces_(faces), joined_(joined) {}

  SplitVertices run(const std::vector<Index>& inputOfCorner, PreparationReport& report) {
    // Cutting only makes more copies, and so ends; only then is clear which cuts separate nothing.
    do {
      findFans();
    } while (visitDoubleEdges(&VertexSplitter::separate));
    visitDoubleEdges(&VertexSplitter::joinAgain);
    SplitVertices result = numbered(report);
    if (!inputOfCorner.empty()) sortByPlace(inputOfCorner, result);
    return result;
  }

 private:
  static Index next(Index halfedge) { return nextSide(halfedge); }
  static Index previous(Index halfedge) { return previousSide(halfedge); }

  /// Numbers the fans of each vertex in the order of their first corners.
  void findFans() {
    const auto corners = static_cast<Index>(faces_.triangles.size());
    fan_.assign(corners, kNoIndex);
    fans_.assign(faces_.vertexCount(), 0);
    for (Index corner = 0; corner < corners; ++corner) {
      if (fan_[corner] != kNoIndex) continue;
      const Index number = fans_[faces_.triangles[corner]]++;
      // Clockwise to its beginning, if it has one, and then counter-clockwise.
      Index begin = corner;
      while (joined_.twin[begin] != kNoIndex) {
        begin = next(joined_.twin[begin]);
        if (begin == corner) break;
      }
      for (Index h = begin; h != kNoIndex && fan_[h] == kNoIndex;) {
        fan_[h] = number;
        h = joined_.twin[previous(h)];
      }
    }
  }

  /// An edge of copies: fans at its lower and higher vertex, and one of its halfedges.
  struct EdgeOfCopies {
    Index lowFan, highFan, halfedge;
    bool sameEdge(const EdgeOfCopies& other) const {
      return lowFan == other.lowFan && highFan == other.highFan;
    }
  };

  using Visit = bool (VertexSplitter::*)(const EdgeOfCopies* edges, std::size_t count);

  /// Visits cut edges whose halfedges still run between the same two copies.
  bool visitDoubleEdges(Visit visit) {
    bool changed = false;
    std::vector<EdgeOfCopies> edges;
    for (std::size_t i = 0; i + 1 < joined_.cutBegin.size(); ++i) {
      edges.clear();
      for (Index j = joined_.cutBegin[i]; j < joined_.cutBegin[i + 1]; ++j) {
        const Index h = joined_.cut[j];
        const bool up = faces_.triangles[h] < faces_.triangles[next(h)];
        edges.push_back({fan_[up ? h : next(h)], fan_[up ? next(h) : h], h});
      }
      std::sort(edges.begin(), edges.end(), [](const EdgeOfCopies& a, const EdgeOfCopies& b) {
        if (a.lowFan != b.lowFan) return a.lowFan < b.lowFan;
        return a.highFan != b.highFan ? a.highFan < b.highFan : a.halfedge < b.halfedge;
      });
      for (std::size_t j = 0, end; j < edges.size(); j = end) {
        for (end = j + 1; end < edges.size() && edges[end].sameEdge(edges[j]);) ++end;
        if (end - j > 1 && (this->*visit)(&edges[j], end - j)) changed = true;
      }
    }
    return changed;
  }

  /// Whether there are two sides that can be one edge.
  bool isOneEdge(const EdgeOfCopies* edges, std::size_t count) const {
    return count == 2 && faces_.triangles[edges[0].halfedge] != faces_.triangles[edges[1].halfedge];
  }

  /// The two sides of a cut that separates nothing.
  bool joinAgain(const EdgeOfCopies* edges, std::size_t count) {
    if (!isOneEdge(edges, count)) return false;
    joined_.twin[edges[0].halfedge] = edges[1].halfedge;
    joined_.twin[edges[1].halfedge] = edges[0].halfedge;
    return true;
  }

  /// Two edges between the same two copies could not be distinguished. All but one are separated:
  /// their faces get a copy of their own at one end.
  bool separate(const EdgeOfCopies* edges, std::size_t count) {
    if (isOneEdge(edges, count)) return false;
    const Index first = edges[0].halfedge;
    const Index partner = joined_.twin[first];
    for (std::size_t i = 0; i < count; ++i) {
      const Index h = edges[i].halfedge;
      if (h == first || h == partner) continue;
      unjoin(h);
      unjoin(previous(h));
    }
    return true;
  }

  void unjoin(Index h) {
    if (joined_.twin[h] == kNoIndex) return;
    joined_.twin[joined_.twin[h]] = kNoIndex;
    joined_.twin[h] = kNoIndex;
  }

  SplitVertices numbered(PreparationReport& report) {
    std::vector<bool> onCut(faces_.vertexCount(), false);
    for (const Index h : joined_.cut) {
      onCut[faces_.triangles[h]] = true;
      onCut[faces_.triangles[next(h)]] = true;
    }
    SplitVertices result;
    // From the number of fans of each vertex to the number of its first copy.
    for (Index v = 0; v < fans_.size(); ++v) {
      const Index fans = fans_[v];
      fans_[v] = static_cast<Index>(result.inputOfVertex.size());
      result.inputOfVertex.insert(result.inputOfVertex.end(), fans, v);
      if (fans < 2) continue;
      report.addedVertices += fans - 1;
      if (!onCut[v]) ++report.nonManifoldVertices;
    }
    for (std::size_t corner = 0; corner < fan_.size(); ++corner) {
      fan_[corner] += fans_[faces_.triangles[corner]];
    }
    result.vertexOfCorner = std::move(fan_);
    return result;
  }

  /// Puts vertices at one place together, though the file keeps them apart.
  void sortByPlace(const std::vector<Index>& inputOfCorner, SplitVertices& split) const {
    struct Copy {
      Index place, firstCorner, input{kNoIndex}, number;
      bool operator<(const Copy& other) const {
        return place != other.place ? place < other.place : firstCorner < other.firstCorner;
      }
    };
    std::vector<Copy> copies(split.inputOfVertex.size());
    for (auto corner = static_cast<Index>(inputOfCorner.size()); corner-- > 0;) {
      const Index v = split.vertexOfCorner[corner];
      copies[v] = {faces_.place[inputOfCorner[corner]], corner,
                   std::min(copies[v].input, inputOfCorner[corner]), v};
    }
    std::sort(copies.begin(), copies.end());
    std::vector<Index> number(copies.size());
    for (Index i = 0; i < copies.size(); ++i) {
      number[copies[i].number] = i;
      split.inputOfVertex[i] = copies[i].input;
    }
    for (Index& v : split.vertexOfCorner) v = number[v];
  }

  const WorkingFaces& faces_;
  JoinedFaces& joined_;
  std::vector<Index> fan_;   ///< by corner, among the fans of its vertex
  std::vector<Index> fans_;  ///< by vertex: how many fans
};

}  // namespace

SplitVertices splitVertices(const WorkingFaces& faces, JoinedFaces& joined,
                            const std::vector<Index>& inputOfCorner, PreparationReport& report) {
  return VertexSplitter(faces, joined).run(inputOfCorner, report);
}

}  // namespace girth::prepare
