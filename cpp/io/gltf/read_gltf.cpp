#include "gltf/read_gltf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "formats/colours_note.h"
#include "gltf/document/document.h"
#include "gltf/document/fault.h"
#include "gltf/document/glb_container.h"
#include "gltf/document/tinygltf_model.h"
#include "gltf/scene/notes.h"
#include "gltf/scene/scene_size.h"
#include "gltf/scene/skin.h"
#include "gltf/scene/transform.h"
#include "gltf/unpack/accessor.h"
#include "gltf/unpack/attributes.h"
#include "gltf/unpack/draco.h"
#include "gltf/unpack/point_numbers.h"
#include "gltf/unpack/soup_budget.h"
#include "text/quoted_name.h"

namespace girth::io {
namespace {

/// A mesh where its node puts it.
struct Placement {
  Transform world;
  const SkinPose* pose{nullptr};
  /// The weights of the node; none: those of the mesh count.
  const std::vector<double>* weights{nullptr};
};

/// Points of a primitive in the soup.
struct Points {
  Index first{0};
  Index count{0};
  bool mirrored{false};
  /// Whether some have a coordinate that is not a finite number: they do no harm without a
  /// triangle.
  bool areSomeLost{false};
};

/// The key by which the points of two primitives of one mesh are the same: where positions, morph
/// targets, joints and weights come from. Draco's points are known by buffer view and attribute.
using PointsKey =
    std::tuple<GltfReference, GltfReference, std::uint32_t, std::vector<GltfReference>,
               std::vector<GltfReference>, std::vector<GltfReference>>;

PointsKey keyOf(const GltfPrimitive& primitive) {
  const auto& draco = primitive.draco;
  const bool isPacked = draco && draco->position;
  return {isPacked ? std::nullopt : primitive.position,
          isPacked ? GltfReference(draco->bufferView) : std::nullopt,
          isPacked ? *draco->position : 0,
          primitive.targets,
          primitive.joints,
          primitive.weights};
}

/// Collects the triangles of a document.
class SceneWalk {
 public:
  SceneWalk(GltfDocument& document, std::size_t binaryBytes, const ResourceReader& resources,
            std::size_t fileBytes, const ReadOptions& options)
      : document_(document),
        model_(document.model),
        buffers_(document, binaryBytes, resources, budget_),
        accessors_(model_, buffers_, budget_),
        points_(accessors_, budget_),
        options_(options),
        poses_(model_.skins.size()) {
    budget_.allowFor(fileBytes);
  }

  Result<ReadModel> run() {
    std::optional<Error> error;
    if (model_.nodes.empty()) {
      // A library of meshes, which nothing places.
      for (std::uint32_t m = 0; m < model_.meshes.size() && !error; ++m) {
        error = addMesh(m, Placement());
      }
    } else {
      error = walk();
    }
    if (error) return *error;
    if (soup_.triangles.empty()) return nothingFound();
    ReadModel model;
    if (options_.attributes) {
      GltfAttributes found = attributesOf(document_, points_, budget_, placed_, soup_.triangles);
      model.attributes = std::move(found.attributes);
      model.attributeNotes = std::move(found.notes);
    }
    model.soup = std::move(soup_);
    if (!document_.isUnitUnknown) model.unit = "metre";
    model.notes = notes_.sentences(model_);
    if (!document_.leftOut.empty()) {
      model.notes.push_back("Its " + document_.leftOut + " were left out.");
    }
    if (isColoured()) model.notes.push_back(coloursNote());
    return model;
  }

 private:
  /// Most likely a document without triangles is broken.
  Error nothingFound() {
    if (auto fault = firstFaultOf(document_)) return *fault;
    if (auto fault = buffers_.firstFault()) return *fault;
    return makeError(ErrorCode::EmptyMesh, -1, notes_.whyEmpty(model_));
  }

  /// The scene's own nodes; where there is no scene, all that have no parent.
  Result<std::vector<int>> rootNodes(std::string& place) {
    const auto& nodes = model_.nodes;
    const auto& scenes = model_.scenes;
    if (!scenes.empty()) {
      const std::uint32_t scene = referenceOf(model_.defaultScene).value_or(0);
      if (scene >= scenes.size()) {
        return faultAt("/scene", "there is no scene " + std::to_string(scene));
      }
      notes_.scene = scene;
      place = "/scenes/" + std::to_string(scene) + "/nodes";
      return scenes[scene].nodes;
    }
    std::vector<bool> isChild(nodes.size(), false);
    for (const tinygltf::Node& node : nodes) {
      for (const int child : node.children) {
        if (unsignedOf(child) < nodes.size()) isChild[unsignedOf(child)] = true;
      }
    }
    std::vector<int> roots;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      if (!isChild[n]) roots.push_back(static_cast<int>(n));
    }
    if (roots.empty()) return faultAt("/nodes", "every node is the child of another: a cycle");
    place = "/nodes";
    return roots;
  }

  /// Makes room for meshes that are placed again, or says that there are too many.
  std::optional<Error> allowFor(const SceneSizes& sizes) {
    const SceneSize &placed = sizes.placed, &once = sizes.once;
    if (placed.triangles > std::max(once.triangles, kMostPlacedTriangles)) {
      const bool isBeyond = placed.triangles == std::numeric_limits<std::uint64_t>::max();
      Error error = makeError(
          ErrorCode::LimitExceeded, -1,
          "its scene has " + (isBeyond ? "more than 10^19" : std::to_string(placed.triangles)) +
              " triangles, made of " + std::to_string(once.triangles) +
              " by placing meshes again; at most " + std::to_string(kMostPlacedTriangles) +
              " are read");
      error.hint = "export the model with fewer instances, or with a simpler mesh";
      return error;
    }
    budget_.allowAgain(placed.elements - std::min(placed.elements, once.elements),
                       std::min(placed.triangles, kMostPlacedTriangles));
    return std::nullopt;
  }

  /// Depth first, children in order, without recursion: a chain of nodes may be as long as the
  /// file. A node with several parents is placed under each.
  std::optional<Error> walk() {
    std::string rootPlace;
    auto roots = rootNodes(rootPlace);
    if (!roots) return roots.error();
    if (auto error = allowFor(sceneSizes(document_, roots.value()))) return error;
    struct Visit {
      std::uint32_t node;
      GltfReference parent;
      Transform above;
      bool isLeft;  // all below it was visited
    };
    const auto& nodes = model_.nodes;
    std::vector<Visit> pending;
    std::vector<bool> isAbove(nodes.size(), false);
    std::vector<std::uint8_t> visits(nodes.size(), 0);
    const auto enter = [&](const std::vector<int>& children, GltfReference parent,
                           const Transform& above) {
      for (auto child = children.rbegin(); child != children.rend(); ++child) {
        pending.push_back({unsignedOf(*child), parent, above, false});
      }
    };
    enter(roots.value(), std::nullopt, Transform());
    while (!pending.empty()) {
      const Visit visit = pending.back();
      pending.pop_back();
      if (visit.isLeft) {
        isAbove[visit.node] = false;
        continue;
      }
      const auto place = [&] {
        return visit.parent ? "/nodes/" + std::to_string(*visit.parent) + "/children" : rootPlace;
      };
      const std::string number = std::to_string(visit.node);
      if (visit.node >= nodes.size()) return faultAt(place(), "there is no node " + number);
      if (isAbove[visit.node]) {
        return faultAt(place(), "node " + number + " is below itself: a cycle of nodes");
      }
      if (visits[visit.node] > 0) {
        if (visits[visit.node] == 1) ++notes_.sharedNodes;
        if (!budget_.take(1 + nodes[visit.node].children.size())) return tooLarge("/nodes");
      }
      visits[visit.node] = visits[visit.node] == 0 ? 1 : 2;
      const tinygltf::Node& node = nodes[visit.node];
      if (isHidden(node)) {
        ++notes_.hiddenNodes;
        continue;
      }
      const Transform world = visit.above.after(Transform::ofNode(node));
      if (auto error = addNode(visit.node, world)) return error;
      isAbove[visit.node] = true;
      pending.push_back({visit.node, std::nullopt, Transform(), true});
      enter(node.children, visit.node, world);
    }
    return std::nullopt;
  }

  std::optional<Error> addNode(std::uint32_t number, const Transform& world) {
    const tinygltf::Node& node = model_.nodes[number];
    const GltfReference mesh = referenceOf(node.mesh);
    if (!mesh) return std::nullopt;
    const std::string place = "/nodes/" + std::to_string(number);
    if (*mesh >= model_.meshes.size()) {
      return faultAt(place + "/mesh", "there is no mesh " + std::to_string(*mesh));
    }
    Placement placement;
    placement.world = world;
    if (!node.weights.empty()) placement.weights = &node.weights;
    if (const GltfReference skin = referenceOf(node.skin)) {
      auto pose = skinPose(*skin, place + "/skin");
      if (!pose) return pose.error();
      placement.pose = pose.value();
    }
    const auto instancing = instancingOf(node);
    if (!instancing) return addMesh(*mesh, placement);
    auto instances = instancesOf(*instancing, place);
    if (!instances) return instances.error();
    notes_.instances += instances.value().size();
    for (const Transform& instance : instances.value()) {
      placement.world = world.after(instance);
      if (auto error = addMesh(*mesh, placement)) return error;
    }
    return std::nullopt;
  }

  Result<const SkinPose*> skinPose(std::uint32_t skin, const std::string& user) {
    if (skin >= model_.skins.size()) {
      return faultAt(user, "there is no skin " + std::to_string(skin));
    }
    if (!world_) world_.emplace(model_);
    if (!poses_[skin]) {
      auto pose = poseOf(model_, accessors_, *world_, skin);
      if (!pose) return pose.error();
      poses_[skin] = std::move(pose).value();
    }
    return &*poses_[skin];
  }

  Result<std::vector<Transform>> instancesOf(const GltfInstancing& instancing,
                                             const std::string& node) {
    const std::string place = node + "/extensions/EXT_mesh_gpu_instancing/attributes";
    std::optional<std::size_t> count;
    const auto read = [&](const GltfReference& accessor, int shape, const char* name,
                          std::vector<double>& numbers) -> std::optional<Error> {
      if (!accessor) return std::nullopt;
      const std::string user = place + "/" + name;
      auto found = accessors_.appendNumbers(*accessor, shape, user, numbers);
      if (!found) return found.error();
      if (count && *count != found.value()) {
        return faultAt(user, "has " + std::to_string(found.value()) + " values, others " +
                                 std::to_string(*count));
      }
      count = found.value();
      return std::nullopt;
    };
    std::vector<double> translations, rotations, scales;
    if (auto error =
            read(instancing.translation, TINYGLTF_TYPE_VEC3, "TRANSLATION", translations)) {
      return *error;
    }
    if (auto error = read(instancing.rotation, TINYGLTF_TYPE_VEC4, "ROTATION", rotations)) {
      return *error;
    }
    if (auto error = read(instancing.scale, TINYGLTF_TYPE_VEC3, "SCALE", scales)) return *error;
    if (!count) return std::vector<Transform>(1);
    std::vector<Transform> instances;
    for (std::size_t i = 0; i < *count; ++i) {
      std::array<double, 3> translation{0, 0, 0}, scale{1, 1, 1};
      std::array<double, 4> rotation{0, 0, 0, 1};
      for (std::size_t k = 0; k < 3; ++k) {
        if (!translations.empty()) translation[k] = translations[3 * i + k];
        if (!scales.empty()) scale[k] = scales[3 * i + k];
      }
      for (std::size_t k = 0; k < 4 && !rotations.empty(); ++k) rotation[k] = rotations[4 * i + k];
      instances.push_back(Transform::ofParts(translation, rotation, scale));
    }
    return instances;
  }

  std::optional<Error> addMesh(std::uint32_t number, const Placement& placement) {
    const std::vector<GltfPrimitive>& primitives = document_.primitives[number];
    const std::string& name = model_.meshes[number].name;
    // Primitives of one mesh often share one list of vertices.
    std::map<PointsKey, Points> placed;
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const GltfPrimitive& primitive = primitives[p];
      const std::string place =
          "/meshes/" + std::to_string(number) + "/primitives/" + std::to_string(p);
      if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
        ++(primitive.mode == TINYGLTF_MODE_POINTS ? notes_.pointPrimitives : notes_.linePrimitives);
        continue;
      }
      if (!primitive.position) {
        ++notes_.primitivesWithoutPositions;
        continue;
      }
      const DracoMesh* packed = nullptr;
      if (primitive.draco) {
        auto found = dracoMesh(*primitive.draco, placement.pose != nullptr, place);
        if (!found) return found.error();
        packed = found.value();
      }
      const PointsKey key = keyOf(primitive);
      auto points = placed.find(key);
      if (points == placed.end()) {
        auto added = addPoints(number, primitive, packed, placement, place);
        if (!added) return added.error();
        points = placed.emplace(key, added.value()).first;
      }
      const std::size_t corners = soup_.triangles.size();
      if (auto error =
              addTriangles(primitive, packed, points->second, place + spacedName(name), place)) {
        return error;
      }
      if (!options_.attributes) continue;
      placed_.push_back({number, static_cast<std::uint32_t>(p), packed, points->second.first,
                         points->second.count, corners, soup_.triangles.size()});
    }
    return std::nullopt;
  }

  Result<const DracoMesh*> dracoMesh(const GltfDraco& draco, bool isSkinned,
                                     const std::string& primitive) {
    const std::string place = primitive + "/extensions/KHR_draco_mesh_compression";
    std::vector<std::uint32_t> numbers;
    const auto want = [&](const std::optional<std::uint32_t>& number) {
      if (number) numbers.push_back(*number);
    };
    want(draco.position);
    if (isSkinned) {
      std::for_each(draco.joints.begin(), draco.joints.end(), want);
      std::for_each(draco.weights.begin(), draco.weights.end(), want);
    }
    for (const auto& [name, extra] : draco.extras) {
      if (options_.attributes && isKeptAttribute(name)) numbers.push_back(extra);
    }
    const std::pair key(draco.bufferView, numbers);
    auto found = dracoMeshes_.find(key);
    if (found == dracoMeshes_.end()) {
      auto bytes = buffers_.view(draco.bufferView, place + "/bufferView");
      if (!bytes) return bytes.error();
      auto mesh = DracoMesh::unpack(bytes.value(), numbers, budget_, place);
      if (!mesh) return mesh.error();
      found = dracoMeshes_.emplace(key, std::move(mesh).value()).first;
    }
    return &found->second;
  }

  static Error tooLarge(const std::string& place) {
    return makeError(ErrorCode::LimitExceeded, -1,
                     place + ": makes the model far larger than its file");
  }

  /// Adds a primitive's points, in the world.
  Result<Points> addPoints(std::uint32_t mesh, const GltfPrimitive& primitive,
                           const DracoMesh* packed, const Placement& placement,
                           const std::string& place) {
    std::vector<double>& positions = soup_.positions;
    const std::size_t before = positions.size();
    std::size_t count = 0;
    if (auto error =
            points_.append({*primitive.position, packed,
                            primitive.draco ? primitive.draco->position : std::nullopt},
                           TINYGLTF_TYPE_VEC3, place + "/attributes/POSITION", count, positions)) {
      return *error;
    }
    const std::size_t first = before / 3;
    if (first + count >= kNoIndex) {
      return makeError(ErrorCode::LimitExceeded, -1, "it has more than 4 billion vertices");
    }
    double* local = positions.data() + before;
    if (auto error = applyTargets(mesh, primitive, placement, place, local, count)) return *error;

    Points points{static_cast<Index>(first), static_cast<Index>(count)};
    const bool isSkinned = placement.pose != nullptr && !primitive.joints.empty();
    if (isSkinned) {
      auto mirrored = applySkin(primitive, packed, *placement.pose, place, local, count);
      if (!mirrored) return mirrored.error();
      points.mirrored = 2 * mirrored.value() > count;
      notes_.skinnedMeshes[mesh] = placement.pose->isBindPose;
    } else {
      points.mirrored = placement.world.mirrors();
      for (std::size_t i = 0; i < count; ++i) {
        double* at = local + 3 * i;
        const Vec3 moved = placement.world.apply({at[0], at[1], at[2]});
        at[0] = moved.x;
        at[1] = moved.y;
        at[2] = moved.z;
      }
    }
    points.areSomeLost =
        !std::all_of(local, local + 3 * count, [](double x) { return std::isfinite(x); });
    return points;
  }

  /// Adds the morph targets, as far as their weights reach.
  std::optional<Error> applyTargets(std::uint32_t mesh, const GltfPrimitive& primitive,
                                    const Placement& placement, const std::string& place,
                                    double* points, std::size_t count) {
    if (primitive.targets.empty()) return std::nullopt;
    const std::vector<double>& weights =
        placement.weights != nullptr ? *placement.weights : model_.meshes[mesh].weights;
    if (!weights.empty() && weights.size() != primitive.targets.size()) {
      return faultAt(place + "/targets", "has " + std::to_string(primitive.targets.size()) +
                                             " targets for " + std::to_string(weights.size()) +
                                             " weights");
    }
    bool& moved = notes_.morphedMeshes[mesh];
    for (std::size_t t = 0; t < primitive.targets.size(); ++t) {
      if (!primitive.targets[t]) continue;
      const std::string user = place + "/targets/" + std::to_string(t) + "/POSITION";
      auto target = accessors_.find(*primitive.targets[t], TINYGLTF_TYPE_VEC3, user);
      if (!target) return target.error();
      if (target.value()->count != count) {
        return PointNumbers::otherCount(user, target.value()->count, count);
      }
      if (weights.empty() || weights[t] == 0) continue;
      moved = true;
      std::vector<double> offsets;
      auto read =
          accessors_.appendNumbers(*primitive.targets[t], TINYGLTF_TYPE_VEC3, user, offsets);
      if (!read) return read.error();
      for (std::size_t i = 0; i < offsets.size(); ++i) points[i] += weights[t] * offsets[i];
    }
    return std::nullopt;
  }

  Result<std::size_t> applySkin(const GltfPrimitive& primitive, const DracoMesh* packed,
                                const SkinPose& pose, const std::string& place, double* points,
                                std::size_t count) {
    std::vector<Influences> sets;
    for (std::size_t s = 0; s < primitive.joints.size(); ++s) {
      const std::string user = place + "/attributes/";
      const std::string joints = user + "JOINTS_" + std::to_string(s);
      const std::string weights = user + "WEIGHTS_" + std::to_string(s);
      if (!primitive.joints[s] || !primitive.weights[s]) {
        return faultAt(
            primitive.joints[s] ? joints : weights,
            "comes without its " + std::string(primitive.joints[s] ? "weights" : "joints"));
      }
      sets.emplace_back();
      const auto& draco = primitive.draco;
      std::size_t found = count;
      if (auto error = points_.append(
              {*primitive.joints[s], packed, draco ? draco->joints[s] : std::nullopt},
              TINYGLTF_TYPE_VEC4, joints, found, sets.back().joints)) {
        return *error;
      }
      const tinygltf::Accessor& kind = model_.accessors[*primitive.joints[s]];
      const bool isUnsigned = kind.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                              kind.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                              kind.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
      if (!isUnsigned || kind.normalized) {
        return faultAt(joints, "does not hold unsigned integers");
      }
      if (auto error = points_.append(
              {*primitive.weights[s], packed, draco ? draco->weights[s] : std::nullopt},
              TINYGLTF_TYPE_VEC4, weights, found, sets.back().weights)) {
        return *error;
      }
    }
    return applyPose(pose, sets, points, count, place);
  }

  std::optional<Error> addTriangles(const GltfPrimitive& primitive, const DracoMesh* packed,
                                    const Points& points, const std::string& name,
                                    const std::string& place) {
    std::vector<Index>& triangles = soup_.triangles;
    const std::size_t before = triangles.size();
    const bool isList = primitive.mode == TINYGLTF_MODE_TRIANGLES || packed != nullptr;
    std::vector<Index> strip;
    // Lists go where they belong at once; corners of strips and fans have to be repeated.
    std::vector<Index>& corners = isList ? triangles : strip;
    if (packed != nullptr) {
      const std::size_t found = 3 * packed->faceCount();
      if (primitive.mode == TINYGLTF_MODE_TRIANGLES && primitive.indices) {
        auto accessor =
            accessors_.find(*primitive.indices, TINYGLTF_TYPE_SCALAR, place + "/indices");
        if (!accessor) return accessor.error();
        if (accessor.value()->count != found) {
          return faultAt("/accessors/" + std::to_string(*primitive.indices) + "/count",
                         "is " + std::to_string(accessor.value()->count) +
                             ", but its Draco stream holds " + std::to_string(found));
        }
      }
      if (!budget_.take(found)) return tooLarge(place);
      packed->appendFaces(corners);
    } else if (primitive.indices) {
      auto read = accessors_.appendIndices(*primitive.indices, place + "/indices", corners);
      if (!read) return read.error();
    } else {
      if (!budget_.take(points.count)) return tooLarge(place);
      corners.reserve(corners.size() + points.count);
      for (Index i = 0; i < points.count; ++i) corners.push_back(i);
    }

    // The largest index of its type parts strips and fans, in every renderer.
    const Index restart = restartValue(primitive);
    for (std::size_t i = isList ? before : 0; i < corners.size(); ++i) {
      if (corners[i] < points.count || (!isList && corners[i] == restart)) continue;
      const std::size_t corner = i - (isList ? before : 0);
      Error error =
          makeError(ErrorCode::IndexOutOfRange, static_cast<std::int64_t>(corner),
                    name + ": index " + std::to_string(corner) + " names vertex " +
                        std::to_string(corners[i]) + " of " + std::to_string(points.count));
      if (corners[i] == restart) {
        error.message += ", the value that parts strips, which a list does not have";
      }
      return error;
    }
    if (!isList) {
      std::size_t from = 0;
      while (from < strip.size()) {
        std::size_t to = from;
        while (to < strip.size() && strip[to] != restart) ++to;
        const std::span<const Index> piece(strip.data() + from, to - from);
        if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
          addStrip(piece);
        } else {
          addFan(piece);
        }
        from = to + 1;
      }
    }
    const std::size_t added = triangles.size() - before;
    if (added % 3 != 0) {
      return faultAt(name, "has " + std::to_string(added) +
                               " corners, which is not a whole number of triangles");
    }
    for (std::size_t i = before; i < triangles.size(); i += 3) {
      if (points.mirrored) std::swap(triangles[i + 1], triangles[i + 2]);
      for (std::size_t k = i; k < i + 3; ++k) triangles[k] += points.first;
    }
    for (std::size_t i = before; points.areSomeLost && i < triangles.size(); ++i) {
      const auto at = std::span(soup_.positions).subspan(3 * std::size_t{triangles[i]}, 3);
      if (std::all_of(at.begin(), at.end(), [](double x) { return std::isfinite(x); })) continue;
      return makeError(ErrorCode::NonFinitePosition, triangles[i],
                       name + ": vertex " + std::to_string(triangles[i] - points.first) +
                           " of face " + std::to_string((i - before) / 3) +
                           " has a coordinate that is not a finite number");
    }
    return std::nullopt;
  }

  Index restartValue(const GltfPrimitive& primitive) const {
    if (!primitive.indices || *primitive.indices >= model_.accessors.size()) return kNoIndex;
    const int type = model_.accessors[*primitive.indices].componentType;
    if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) {
      return std::numeric_limits<std::uint8_t>::max();
    }
    if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) {
      return std::numeric_limits<std::uint16_t>::max();
    }
    return std::numeric_limits<std::uint32_t>::max();
  }

  /// Whether some vertices have colours.
  bool isColoured() const {
    return std::any_of(model_.meshes.begin(), model_.meshes.end(), [](const auto& mesh) {
      return std::any_of(mesh.primitives.begin(), mesh.primitives.end(), [](const auto& primitive) {
        return primitive.attributes.count("COLOR_0") > 0;
      });
    });
  }

  /// Strips and fans repeat vertices to turn corners; such triangles are not meant to be seen.
  void addVisible(Index a, Index b, Index c) {
    if (a != b && b != c && c != a) soup_.triangles.insert(soup_.triangles.end(), {a, b, c});
  }
  void addStrip(std::span<const Index> corners) {
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
      addVisible(corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]);
    }
  }
  void addFan(std::span<const Index> corners) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      addVisible(corners[i], corners[i + 1], corners[0]);
    }
  }

  const GltfDocument& document_;
  const tinygltf::Model& model_;
  SoupBudget budget_;
  GltfBuffers buffers_;
  GltfAccessors accessors_;
  PointNumbers points_;
  ReadOptions options_;
  /// Only where attributes are asked for.
  std::vector<PlacedPrimitive> placed_;
  std::optional<WorldTransforms> world_;
  std::vector<std::optional<SkinPose>> poses_;
  /// By buffer view and the attributes that were asked for.
  std::map<std::pair<std::uint32_t, std::vector<std::uint32_t>>, DracoMesh> dracoMeshes_;
  TriangleSoup soup_;
  GltfNotes notes_;
};

Result<GltfDocument> documentOf(std::string_view json, std::size_t firstByte,
                                std::span<const std::byte> binary) {
  auto geometry = geometryJson(json, firstByte, binary.size());
  if (!geometry) return geometry.error();
  auto model = loadModel(geometry.value(), binary);
  if (!model) return model.error();
  GltfDocument document{std::move(model).value(),
                        std::move(geometry.value().buffers),
                        {},
                        std::move(geometry.value().baseColours),
                        geometry.value().isUnitUnknown,
                        std::move(geometry.value().leftOut)};
  for (const tinygltf::Mesh& mesh : document.model.meshes) {
    document.primitives.emplace_back(mesh.primitives.begin(), mesh.primitives.end());
  }
  return document;
}

Result<ReadModel> readDocument(std::string_view json, std::size_t firstByte,
                               std::span<const std::byte> binary, const ResourceReader& resources,
                               std::size_t fileBytes, Format format, const ReadOptions& options) {
  try {
    auto document = documentOf(json, firstByte, binary);
    if (!document) return document.error();
    auto model = SceneWalk(document.value(), binary.size(), resources, fileBytes, options).run();
    if (model) model.value().format = format;
    return model;
  } catch (const std::length_error&) {
    return makeError(ErrorCode::OutOfMemory, -1, "there is not enough memory to read the file");
  }
}

}  // namespace

Result<ReadModel> readGlb(std::span<const std::byte> bytes, const ResourceReader& resources,
                          const ReadOptions& options) {
  auto container = openGlb(bytes);
  if (!container) return container.error();
  const std::string_view json = container.value().json;
  const auto* begin = reinterpret_cast<const char*>(bytes.data());
  return readDocument(json, static_cast<std::size_t>(json.data() - begin), container.value().binary,
                      resources, bytes.size(), Format::Glb, options);
}

Result<ReadModel> readGltf(std::span<const std::byte> bytes, const ResourceReader& resources,
                           const ReadOptions& options) {
  const std::string_view json(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return readDocument(json, 0, {}, resources, bytes.size(), Format::Gltf, options);
}

}  // namespace girth::io
