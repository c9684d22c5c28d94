#include "read_gltf.h"

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glb_container.h"
#include "gltf_accessor.h"
#include "gltf_document.h"
#include "soup_budget.h"
#include "text.h"

namespace girth::io {
namespace {

Error malformed(std::string message) {
  return makeError(ErrorCode::MalformedFile, -1, std::move(message));
}

/// An affine map: the upper three rows of a 4 × 4 matrix, row by row.
struct Transform {
  std::array<double, 12> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

  Vec3 apply(double x, double y, double z) const {
    return {m[0] * x + m[1] * y + m[2] * z + m[3], m[4] * x + m[5] * y + m[6] * z + m[7],
            m[8] * x + m[9] * y + m[10] * z + m[11]};
  }
  /// First `inner`, then this.
  Transform after(const Transform& inner) const {
    Transform result;
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 4; ++c) {
        double sum = c == 3 ? m[4 * r + 3] : 0.0;
        for (std::size_t k = 0; k < 3; ++k) sum += m[4 * r + k] * inner.m[4 * k + c];
        result.m[4 * r + c] = sum;
      }
    }
    return result;
  }
  bool mirrors() const {
    return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
               m[2] * (m[4] * m[9] - m[5] * m[8]) <
           0;
  }
};

/// A node's own transform: its matrix, or translation · rotation · scale.
std::optional<Transform> transformOf(const tinygltf::Node& node) {
  const auto wrong = [](const std::vector<double>& values, std::size_t size) {
    return !values.empty() && values.size() != size;
  };
  if (wrong(node.matrix, 16) || wrong(node.translation, 3) || wrong(node.rotation, 4) ||
      wrong(node.scale, 3)) {
    return std::nullopt;
  }
  Transform transform;
  auto& m = transform.m;
  if (!node.matrix.empty()) {
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 4; ++c) m[4 * r + c] = node.matrix[4 * c + r];
    }
    return transform;
  }
  if (!node.rotation.empty()) {
    const double x = node.rotation[0], y = node.rotation[1], z = node.rotation[2];
    const double w = node.rotation[3];
    m = {1 - 2 * (y * y + z * z), 2 * (x * y - z * w),     2 * (x * z + y * w),     0,
         2 * (x * y + z * w),     1 - 2 * (x * x + z * z), 2 * (y * z - x * w),     0,
         2 * (x * z - y * w),     2 * (y * z + x * w),     1 - 2 * (x * x + y * y), 0};
  }
  for (std::size_t r = 0; r < 3; ++r) {
    if (!node.scale.empty()) {
      for (std::size_t c = 0; c < 3; ++c) m[4 * r + c] *= node.scale[c];
    }
    if (!node.translation.empty()) m[4 * r + 3] = node.translation[r];
  }
  return transform;
}

/// Collects the triangles of a document.
class SceneWalk {
 public:
  SceneWalk(const GltfDocument& document, std::span<const std::byte> binary,
            const ResourceReader& resources, std::size_t fileBytes)
      : document_(document), buffers_(document, binary, resources, budget_) {
    budget_.allowFor(fileBytes);
  }

  Result<TriangleSoup> run() {
    auto roots = rootNodes();
    if (!roots) return roots.error();
    std::optional<Error> error;
    if (document_.model.nodes.empty()) {
      // A library of meshes, which nothing places.
      for (std::size_t m = 0; m < document_.model.meshes.size() && !error; ++m) {
        error = addMesh(m, Transform());
      }
    } else {
      error = walk(roots.value());
    }
    if (error) return *error;
    if (soup_.triangles.empty()) {
      return makeError(ErrorCode::EmptyMesh, -1,
                       otherPrimitives_ ? "it holds only points or lines, no triangles"
                                        : "its scene holds no triangles");
    }
    return std::move(soup_);
  }

 private:
  const std::vector<tinygltf::Node>& nodes() const { return document_.model.nodes; }

  Result<std::vector<int>> rootNodes() const {
    const auto& scenes = document_.model.scenes;
    if (!scenes.empty()) {
      const int scene = document_.model.defaultScene < 0 ? 0 : document_.model.defaultScene;
      if (static_cast<std::size_t>(scene) >= scenes.size()) {
        return malformed("its scene " + std::to_string(scene) + " does not exist");
      }
      return scenes[static_cast<std::size_t>(scene)].nodes;
    }
    std::vector<bool> isChild(nodes().size(), false);
    for (const auto& node : nodes()) {
      for (const int child : node.children) {
        if (child >= 0 && static_cast<std::size_t>(child) < nodes().size()) {
          isChild[static_cast<std::size_t>(child)] = true;
        }
      }
    }
    std::vector<int> roots;
    for (std::size_t i = 0; i < nodes().size(); ++i) {
      if (!isChild[i]) roots.push_back(static_cast<int>(i));
    }
    if (roots.empty() && !nodes().empty()) {
      return malformed("its nodes form a cycle: every node is the child of another");
    }
    return roots;
  }

  /// Depth first, children in order, without recursion: a chain of nodes may be as long as the
  /// file.
  std::optional<Error> walk(const std::vector<int>& roots) {
    struct Visit {
      int node;
      Transform parent;
    };
    std::vector<Visit> waiting;
    std::vector<bool> seen(nodes().size(), false);
    const auto enter = [&](const std::vector<int>& children, const Transform& parent) {
      for (auto child = children.rbegin(); child != children.rend(); ++child) {
        waiting.push_back({*child, parent});
      }
    };
    enter(roots, Transform());
    while (!waiting.empty()) {
      const Visit visit = waiting.back();
      waiting.pop_back();
      const std::string name = "node " + std::to_string(visit.node);
      if (visit.node < 0 || static_cast<std::size_t>(visit.node) >= nodes().size()) {
        return malformed("its scene refers to " + name + ", which does not exist");
      }
      const auto number = static_cast<std::size_t>(visit.node);
      if (seen[number]) {
        return malformed(name + " is reached twice: its nodes form a cycle or share a child");
      }
      seen[number] = true;
      const tinygltf::Node& node = nodes()[number];
      const auto own = transformOf(node);
      if (!own) return malformed(name + " has a transform of the wrong size");
      const Transform world = visit.parent.after(*own);
      if (node.mesh >= 0) {
        if (static_cast<std::size_t>(node.mesh) >= document_.model.meshes.size()) {
          return malformed(name + " refers to mesh " + std::to_string(node.mesh) +
                           ", which does not exist");
        }
        if (auto error = addMesh(static_cast<std::size_t>(node.mesh), world)) return error;
      }
      enter(node.children, world);
    }
    return std::nullopt;
  }

  std::optional<Error> addMesh(std::size_t number, const Transform& world) {
    const tinygltf::Mesh& mesh = document_.model.meshes[number];
    // Primitives of one mesh often share one list of vertices.
    std::map<int, std::pair<Index, Index>> placed;
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const tinygltf::Primitive& primitive = mesh.primitives[p];
      const std::string name = "primitive " + std::to_string(p) + " of mesh " +
                               std::to_string(number) + spacedName(mesh.name);
      if (primitive.mode < TINYGLTF_MODE_POINTS || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
        return malformed(name + " has the unknown mode " + std::to_string(primitive.mode));
      }
      if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
        otherPrimitives_ = true;
        continue;
      }
      const auto position = primitive.attributes.find("POSITION");
      if (position == primitive.attributes.end()) continue;
      auto range = placed.find(position->second);
      if (range == placed.end()) {
        auto added = addPoints(position->second, world, name);
        if (!added) return added.error();
        range = placed.emplace(position->second, added.value()).first;
      }
      const auto [first, count] = range->second;
      if (auto error = addTriangles(primitive, first, count, world.mirrors(), name)) return error;
    }
    return std::nullopt;
  }

  /// Adds an accessor's points; gives the first one's number and how many there are.
  Result<std::pair<Index, Index>> addPoints(int accessor, const Transform& world,
                                            const std::string& name) {
    auto points = readPoints(document_, buffers_, accessor, budget_);
    if (!points) return points.error();
    const std::vector<double>& local = points.value();
    const std::size_t first = soup_.positions.size() / 3;
    const std::size_t count = local.size() / 3;
    if (first + count >= kNoIndex) {
      return makeError(ErrorCode::LimitExceeded, -1, "it has more than 4 billion vertices");
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 point = world.apply(local[3 * i], local[3 * i + 1], local[3 * i + 2]);
      if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) {
        return makeError(ErrorCode::NonFinitePosition, static_cast<std::int64_t>(first + i),
                         "vertex " + std::to_string(i) + " of " + name +
                             " has a coordinate that is not a finite number");
      }
      soup_.positions.insert(soup_.positions.end(), {point.x, point.y, point.z});
    }
    return std::pair{static_cast<Index>(first), static_cast<Index>(count)};
  }

  std::optional<Error> addTriangles(const tinygltf::Primitive& primitive, Index first, Index count,
                                    bool mirrored, const std::string& name) {
    std::vector<Index> corners;
    if (primitive.indices >= 0) {
      auto indices = readIndices(document_, buffers_, primitive.indices, budget_);
      if (!indices) return indices.error();
      corners = std::move(indices).value();
    } else {
      if (!budget_.take(count)) {
        return makeError(ErrorCode::LimitExceeded, -1,
                         name + " makes the model far larger than its file");
      }
      corners.resize(count);
      for (Index i = 0; i < count; ++i) corners[i] = i;
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (corners[i] >= count) {
        return makeError(ErrorCode::IndexOutOfRange, static_cast<std::int64_t>(i),
                         "index " + std::to_string(i) + " of " + name + " names vertex " +
                             std::to_string(corners[i]) + " of " + std::to_string(count));
      }
    }
    const auto add = [&](Index a, Index b, Index c) {
      if (mirrored) std::swap(b, c);
      soup_.triangles.insert(soup_.triangles.end(), {first + a, first + b, first + c});
    };
    // Strips and fans repeat vertices to turn corners; such triangles are not meant to be seen.
    const auto addVisible = [&](Index a, Index b, Index c) {
      if (a != b && b != c && c != a) add(a, b, c);
    };
    const std::size_t n = corners.size();
    if (primitive.mode == TINYGLTF_MODE_TRIANGLES) {
      if (n % 3 != 0) {
        return malformed(name + " has " + std::to_string(n) +
                         " corners, which is not a whole number of triangles");
      }
      for (std::size_t i = 0; i < n; i += 3) add(corners[i], corners[i + 1], corners[i + 2]);
    } else if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
      for (std::size_t i = 0; i + 2 < n; ++i) {
        addVisible(corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]);
      }
    } else {
      for (std::size_t i = 1; i + 1 < n; ++i) addVisible(corners[i], corners[i + 1], corners[0]);
    }
    return std::nullopt;
  }

  const GltfDocument& document_;
  SoupBudget budget_;
  GltfBuffers buffers_;
  TriangleSoup soup_;
  bool otherPrimitives_{false};
};

Result<ReadModel> readDocument(std::string_view json, std::span<const std::byte> binary,
                               const ResourceReader& resources, std::size_t fileBytes,
                               Format format) {
  auto document = parseGltfDocument(json);
  if (!document) return document.error();
  auto soup = SceneWalk(document.value(), binary, resources, fileBytes).run();
  if (!soup) return soup.error();
  return ReadModel{std::move(soup).value(), format, "metre", {}};
}

}  // namespace

Result<ReadModel> readGlb(std::span<const std::byte> bytes, const ResourceReader& resources) {
  auto container = openGlb(bytes);
  if (!container) return container.error();
  return readDocument(container.value().json, container.value().binary, resources, bytes.size(),
                      Format::Glb);
}

Result<ReadModel> readGltf(std::span<const std::byte> bytes, const ResourceReader& resources) {
  const std::string_view json(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return readDocument(json, {}, resources, bytes.size(), Format::Gltf);
}

}  // namespace girth::io
