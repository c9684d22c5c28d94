#include "mesh/remesh/changing_mesh.h"

namespace girth::remeshing {

ChangingMesh::ChangingMesh(const SurfaceMesh& mesh)
    : positions_(mesh.vertexCount()),
      from_(mesh.halfedgeCount()),
      twin_(mesh.halfedgeCount()),
      outgoing_(mesh.vertexCount()),
      component_(mesh.vertexCount()),
      line_(mesh.halfedgeCount(), 0),
      faces_(mesh.faceCount()) {
  for (const Vertex v : mesh.vertices()) {
    positions_[v] = mesh.position(v);
    outgoing_[v] = mesh.outgoing(v);
    component_[v] = mesh.componentOf(v);
  }
  for (const Halfedge h : mesh.halfedges()) {
    from_[h] = mesh.from(h);
    twin_[h] = mesh.twin(h);
  }
}

void ChangingMesh::setLine(Index h, bool line) {
  line_[h] = line ? 1 : 0;
  if (twin_[h] != kNoIndex) line_[twin_[h]] = line_[h];
}

Index ChangingMesh::firstOutgoing(Index vertex) const {
  const Index begin = outgoing_[vertex];
  Index h = begin;
  while (twin_[h] != kNoIndex) {
    h = next(twin_[h]);
    if (h == begin) break;
  }
  return h;
}

Index ChangingMesh::valence(Index vertex) const {
  Index count = 0;
  forEachNeighbour(vertex, [&](Index, bool) { ++count; });
  return count;
}

bool ChangingMesh::areNeighbours(Index a, Index b) const {
  bool found = false;
  forEachNeighbour(a, [&](Index v, bool) { found = found || v == b; });
  return found;
}

Index ChangingMesh::linesAt(Index vertex) const {
  Index count = 0;
  forEachNeighbour(vertex, [&](Index, bool line) { count += line ? 1 : 0; });
  return count;
}

Index ChangingMesh::addFace(Index a, Index b, Index c) {
  const auto first = static_cast<Index>(from_.size());
  from_.insert(from_.end(), {a, b, c});
  twin_.insert(twin_.end(), 3, kNoIndex);
  line_.insert(line_.end(), 3, 0);
  ++faces_;
  return first;
}

void ChangingMesh::join(Index h, Index g) {
  if (h != kNoIndex) twin_[h] = g;
  if (g != kNoIndex) twin_[g] = h;
}

Index ChangingMesh::split(Index h, const Vec3& position) {
  const auto m = static_cast<Index>(positions_.size());
  positions_.push_back(position);
  outgoing_.push_back(kNoIndex);
  component_.push_back(component_[from_[h]]);
  // The face (a, b, c) becomes (a, m, c) and (m, b, c); the one beyond, (b, a, d), becomes
  // (m, a, d) and (b, m, d).
  const Index b = to(h), c = apex(h), t = twin_[h], n = next(h);
  const Index f = addFace(m, b, c);
  join(f + 1, twin_[n]);
  line_[f + 1] = line_[n];
  from_[n] = m;
  join(n, f + 2);
  line_[n] = 0;
  line_[f] = line_[h];
  outgoing_[m] = f;
  outgoing_[b] = f + 1;
  if (t != kNoIndex) {
    const Index d = apex(t), p = previous(t);
    const Index g = addFace(b, m, d);
    join(g + 2, twin_[p]);
    line_[g + 2] = line_[p];
    from_[t] = m;
    join(p, g + 1);
    line_[p] = 0;
    line_[g] = line_[h];
    join(f, g);
  }
  return m;
}

bool ChangingMesh::canCollapse(Index h) const {
  const Index a = from(h), b = to(h), t = twin_[h];
  // A face that would have nothing left on one of its sides stays.
  const auto sidesGoOn = [&](Index side) {
    return twin_[next(side)] != kNoIndex || twin_[previous(side)] != kNoIndex;
  };
  if (!sidesGoOn(h) || (t != kNoIndex && !sidesGoOn(t))) return false;
  if (t != kNoIndex && isBoundary(a) && isBoundary(b)) return false;
  // The link condition: the only common neighbours are opposite to the edge.
  Index common = 0;
  forEachNeighbour(a, [&](Index v, bool) { common += areNeighbours(v, b) ? 1 : 0; });
  if (common != (t == kNoIndex ? 1u : 2u)) return false;
  const auto keepsFaces = [&](Index v) { return valence(v) > (isBoundary(v) ? 2u : 3u); };
  return keepsFaces(apex(h)) && (t == kNoIndex || keepsFaces(apex(t)));
}

Index ChangingMesh::collapse(Index h, const Vec3& position) {
  const Index a = from(h), b = to(h), t = twin_[h];
  std::vector<Index> around;
  forEachOutgoing(a, [&](Index out) { around.push_back(out); });
  for (const Index out : around) from_[out] = b;
  // A face goes, and its other two sides become one.
  const auto close = [&](Index side) {
    const Index right = twin_[next(side)], left = twin_[previous(side)];
    const std::uint8_t line = line_[next(side)] | line_[previous(side)];
    const Index c = apex(side);
    // `right` runs from c, `left` to c; each may be missing at a boundary.
    join(right, left);
    if (right != kNoIndex) line_[right] = line;
    if (left != kNoIndex) line_[left] = line;
    const Index kept = right != kNoIndex ? right : left;
    outgoing_[right != kNoIndex ? c : from_[left]] = kept;
    outgoing_[right != kNoIndex ? to(right) : c] = next(kept);
    for (Index k = 0; k < 3; ++k) {
      const Index gone = 3 * (side / 3) + k;
      from_[gone] = twin_[gone] = kNoIndex;
    }
    --faces_;
  };
  close(h);
  if (t != kNoIndex) close(t);
  outgoing_[a] = kNoIndex;
  positions_[b] = position;
  return b;
}

bool ChangingMesh::canFlip(Index h) const {
  const Index t = twin_[h];
  if (isLine(h)) return false;
  const Index c = apex(h), d = apex(t);
  if (c == d || areNeighbours(c, d)) return false;
  const auto keepsFaces = [&](Index v) { return valence(v) > (isBoundary(v) ? 2u : 3u); };
  return keepsFaces(from(h)) && keepsFaces(to(h));
}

void ChangingMesh::flip(Index h) {
  // The faces (a, b, c) and (b, a, d) become (d, b, c) and (c, a, d).
  const Index t = twin_[h], a = from(h), b = to(h), c = apex(h), d = apex(t);
  const Index f = 3 * (h / 3), g = 3 * (t / 3);
  const std::array<Index, 4> old{previous(t), next(h), previous(h), next(t)};
  std::array<Index, 4> twins;
  std::array<std::uint8_t, 4> lines;
  for (std::size_t i = 0; i < 4; ++i) {
    twins[i] = twin_[old[i]];
    lines[i] = line_[old[i]];
  }
  const std::array<Index, 4> sides{f, f + 1, g, g + 1};  // d → b, b → c, c → a, a → d
  from_[f] = d;
  from_[f + 1] = b;
  from_[f + 2] = c;
  from_[g] = c;
  from_[g + 1] = a;
  from_[g + 2] = d;
  for (std::size_t i = 0; i < 4; ++i) {
    // The neighbours are beyond these two faces: they have but this edge in common.
    join(sides[i], twins[i]);
    line_[sides[i]] = lines[i];
  }
  join(f + 2, g + 2);
  line_[f + 2] = line_[g + 2] = 0;
  outgoing_[a] = g + 1;
  outgoing_[b] = f + 1;
  outgoing_[c] = g;
  outgoing_[d] = f;
}

}  // namespace girth::remeshing
