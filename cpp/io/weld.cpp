#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "girth/io/read_mesh.h"

namespace girth::io {
namespace {

/// What can be wrong with a soup that was not made by readModel.
std::optional<Error> checkArrays(const TriangleSoup& soup) {
  const std::size_t vertices = soup.positions.size() / 3;
  if (soup.positions.size() % 3 != 0 || soup.triangles.size() % 3 != 0 || soup.triangles.empty()) {
    return makeError(ErrorCode::EmptyMesh, -1, "the model has no triangles");
  }
  for (std::size_t i = 0; i < soup.positions.size(); ++i) {
    if (!std::isfinite(soup.positions[i])) {
      return makeError(
          ErrorCode::NonFinitePosition, static_cast<std::int64_t>(i / 3),
          "vertex " + std::to_string(i / 3) + " has a coordinate that is not a finite number");
    }
  }
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    if (soup.triangles[i] >= vertices) {
      return makeError(ErrorCode::IndexOutOfRange, static_cast<std::int64_t>(i / 3),
                       "face " + std::to_string(i / 3) + " names vertex " +
                           std::to_string(soup.triangles[i]) + " of " + std::to_string(vertices));
    }
  }
  return std::nullopt;
}

/// For each vertex the first one at its position (0 and -0 are the same place), kNoIndex for
/// vertices that no face uses. Sorting, and not hashing: no file can make it slow.
std::vector<Index> firstAtSamePlace(const TriangleSoup& soup) {
  const std::size_t vertices = soup.positions.size() / 3;
  std::vector<Index> first(vertices, kNoIndex);
  for (const Index v : soup.triangles) first[v] = v;
  std::vector<Index> order;
  for (Index v = 0; v < vertices; ++v) {
    if (first[v] != kNoIndex) order.push_back(v);
  }
  const auto place = [&](Index v) { return &soup.positions[3 * std::size_t{v}]; };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    for (int k = 0; k < 3; ++k) {
      if (place(a)[k] != place(b)[k]) return place(a)[k] < place(b)[k];
    }
    return a < b;
  });
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (std::equal(place(order[i]), place(order[i]) + 3, place(order[i - 1]))) {
      first[order[i]] = first[order[i - 1]];
    }
  }
  return first;
}

std::string edgeText(Index a, Index b) {
  return "edge " + std::to_string(a) + "-" + std::to_string(b);
}

std::string vertexText(Index v) { return "vertex " + std::to_string(v); }

/// How many edges have one face only.
std::size_t openEdges(std::span<const Index> triangles) {
  std::vector<std::pair<Index, Index>> edges;
  edges.reserve(triangles.size());
  for (std::size_t h = 0; h < triangles.size(); ++h) {
    const Index a = triangles[h], b = triangles[h % 3 == 2 ? h - 2 : h + 1];
    edges.emplace_back(std::min(a, b), std::max(a, b));
  }
  std::sort(edges.begin(), edges.end());
  std::size_t open = 0;
  for (std::size_t i = 0, end; i < edges.size(); i = end) {
    for (end = i + 1; end < edges.size() && edges[end] == edges[i];) ++end;
    if (end - i == 1) ++open;
  }
  return open;
}

/// Replaces the first `before` by `after`.
void replaceFirst(std::string& text, const std::string& before, const std::string& after) {
  if (const auto at = text.find(before); at != std::string::npos) {
    text.replace(at, before.size(), after);
  }
}

/// An error of SurfaceMesh::fromArrays, said in the file's own numbers. Faces have kept theirs.
/// `triangles` and `inputOfVertex` are the surface's.
Error inFileNumbers(Error error, const TriangleSoup& soup, std::span<const Index> triangles,
                    std::span<const Index> inputOfVertex) {
  if (error.element < 0) return error;
  const auto element = static_cast<std::size_t>(error.element);
  switch (error.code) {
    case ErrorCode::OpenEdge:
    case ErrorCode::NonManifoldEdge:
    case ErrorCode::InconsistentOrientation: {
      const std::size_t end = element % 3 == 2 ? element - 2 : element + 1;
      replaceFirst(error.message, edgeText(triangles[element], triangles[end]),
                   edgeText(soup.triangles[element], soup.triangles[end]));
      if (error.code == ErrorCode::OpenEdge) {
        const std::size_t open = openEdges(triangles);
        if (open > 1) error.message += " (one of " + std::to_string(open) + " such edges)";
      }
      return error;
    }
    case ErrorCode::DegenerateFace: {
      const Index* welded = &triangles[3 * element];
      const Index* written = &soup.triangles[3 * element];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        if (welded[k] != welded[next]) continue;
        if (written[k] == written[next]) {
          replaceFirst(error.message, vertexText(welded[k]), vertexText(written[k]));
        } else {
          error.message = "face " + std::to_string(element) + " has no area: its vertices " +
                          std::to_string(written[k]) + " and " + std::to_string(written[next]) +
                          " lie at the same point";
        }
        return error;
      }
      return error;
    }
    case ErrorCode::NonManifoldVertex: {
      const Index input = inputOfVertex[element];
      replaceFirst(error.message, vertexText(static_cast<Index>(element)), vertexText(input));
      error.element = input;
      return error;
    }
    default:
      return error;
  }
}

}  // namespace

Result<LoadedMesh> weld(TriangleSoup soup) {
  if (auto error = checkArrays(soup)) return *error;
  const std::vector<Index> first = firstAtSamePlace(soup);

  std::vector<Index> vertexOfInput(first.size(), kNoIndex);
  std::vector<Index> inputOfVertex;
  std::vector<double> positions;
  Index unreferenced = 0;
  for (Index v = 0; v < first.size(); ++v) {
    if (first[v] == kNoIndex) {
      ++unreferenced;
    } else if (first[v] == v) {
      vertexOfInput[v] = static_cast<Index>(inputOfVertex.size());
      inputOfVertex.push_back(v);
      for (std::size_t k = 0; k < 3; ++k)
        positions.push_back(soup.positions[3 * std::size_t{v} + k]);
    } else {
      // The first vertex at a place comes first in the file as well.
      vertexOfInput[v] = vertexOfInput[first[v]];
    }
  }
  std::vector<Index> triangles(soup.triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    triangles[i] = vertexOfInput[soup.triangles[i]];

  auto mesh = SurfaceMesh::fromArrays(positions, triangles);
  if (!mesh) return inFileNumbers(mesh.error(), soup, triangles, inputOfVertex);
  const auto welded = static_cast<Index>(first.size() - inputOfVertex.size() - unreferenced);
  return LoadedMesh{std::move(mesh).value(),
                    soup.format,
                    std::move(vertexOfInput),
                    std::move(inputOfVertex),
                    welded,
                    unreferenced,
                    soup.format == Format::Glb || soup.format == Format::Gltf ? "metre" : ""};
}

}  // namespace girth::io
