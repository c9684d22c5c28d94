#include "gltf/scene/notes.h"

#include "text/quoted_name.h"

namespace girth::io {
namespace {

/// "1 node", "2 nodes".
std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// "1 node of lines was left out."
std::string leftOut(std::size_t count, const std::string& what, const std::string& which) {
  return counted(count, what) + which + (count == 1 ? " was left out." : " were left out.");
}

/// `Mesh 3 "arm"` or `Meshes 0, 1 and 4 more`: those of one kind.
std::string named(const tinygltf::Model& model, const std::map<std::uint32_t, bool>& meshes,
                  bool kind, std::size_t& count) {
  constexpr std::size_t kMost = 3;
  count = 0;
  std::string list;
  for (const auto& [mesh, isOfKind] : meshes) {
    if (isOfKind != kind) continue;
    if (++count > kMost) continue;
    list += (list.empty() ? "" : ", ") + std::to_string(mesh) + spacedName(model.meshes[mesh].name);
  }
  if (count > kMost) list += " and " + std::to_string(count - kMost) + " more";
  return (count == 1 ? "Mesh " : "Meshes ") + list;
}

}  // namespace

std::vector<std::string> GltfNotes::sentences(const tinygltf::Model& model) const {
  std::vector<std::string> notes;
  if (scene && model.scenes.size() > 1) {
    notes.push_back("Of " + counted(model.scenes.size(), "scene") + ", scene " +
                    std::to_string(*scene) + spacedName(model.scenes[*scene].name) + " is shown.");
  }
  for (const bool isBindPose : {true, false}) {
    std::size_t count = 0;
    const std::string meshes = named(model, skinnedMeshes, isBindPose, count);
    if (count == 0) continue;
    const std::string subject = meshes + (count == 1 ? " is" : " are") + " skinned: shown in the ";
    notes.push_back(subject + (isBindPose ? "bind pose."
                                          : "pose in which the file stores the joints, which is "
                                            "not the bind pose."));
  }
  for (const bool isMoved : {true, false}) {
    std::size_t count = 0;
    const std::string meshes = named(model, morphedMeshes, isMoved, count);
    if (count == 0) continue;
    notes.push_back(
        meshes + (count == 1 ? " has" : " have") + " morph targets: shown at rest" +
        (isMoved ? ", with the weights that the file stores." : ", with all weights 0."));
  }
  if (instances > 0)
    notes.push_back("Its meshes were placed as instances: " + std::to_string(instances) + ".");
  if (sharedNodes > 0) {
    notes.push_back(counted(sharedNodes, "node") +
                    " with more than one parent, which glTF forbids: placed under each.");
  }
  if (hiddenNodes > 0) {
    notes.push_back(leftOut(hiddenNodes, "hidden node", ", with all below,"));
  }
  if (pointPrimitives + linePrimitives > 0) {
    notes.push_back(leftOut(pointPrimitives + linePrimitives, "primitive", " of points or lines"));
  }
  if (primitivesWithoutPositions > 0) {
    notes.push_back(leftOut(primitivesWithoutPositions, "primitive", " without positions"));
  }
  return notes;
}

std::string GltfNotes::whyEmpty(const tinygltf::Model& model) const {
  if (pointPrimitives > 0 && linePrimitives > 0) {
    return "it holds only points and lines, no triangles";
  }
  if (pointPrimitives > 0) return "it is a point cloud: it holds only points, no triangles";
  if (linePrimitives > 0) return "it holds only lines, no triangles";
  if (primitivesWithoutPositions > 0) return "its primitives have no positions";
  if (hiddenNodes > 0) return "all its nodes are hidden";
  if (model.meshes.empty()) return "it holds no meshes";
  return "its scene shows none of its meshes";
}

}  // namespace girth::io
