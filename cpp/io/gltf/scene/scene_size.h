// How large a document says that its scene is, before anything of it is read.
#pragma once

#include <cstdint>
#include <vector>

#include "gltf/document/document.h"

namespace girth::io {

/// Counts of what a scene says it holds; far too large a count stays at the largest number.
struct SceneSize {
  /// Triangles, each as often as nodes and instances place it.
  std::uint64_t triangles{0};
  /// Elements of accessors that have to be read for that: vertices, corners, joints, weights; and
  /// the nodes that are visited.
  std::uint64_t elements{0};
};

/// The size of the part of the scene that lies below these nodes, and of one placement of each mesh
/// that it places. Faults of the document count as nothing: whoever reads it reports it. O(nodes +
/// primitives), however often nodes are shared.
struct SceneSizes {
  SceneSize placed;
  SceneSize once;
};
SceneSizes sceneSizes(const GltfDocument& document, const std::vector<int>& roots);

}  // namespace girth::io
