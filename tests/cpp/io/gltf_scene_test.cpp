// Where glTF's nodes, skins, morph targets and instances put a mesh, and what the reader says of
// it.
#include <cmath>

#include "documents.h"

namespace girth::io::testing {
namespace {

constexpr const char* kIndices =
    R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"})";
constexpr const char* kPositions =
    R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})";

/// The tetrahedron with further bytes, each piece in a view and behind an accessor of its own;
/// these are numbered from 2.
struct Extended : TinyGltf {
  void add(const std::string& bytes, const std::string& accessor) {
    views += R"(,{"buffer":0,"byteOffset":)" + std::to_string(binary.size()) + R"(,"byteLength":)" +
             std::to_string(bytes.size()) + "}";
    accessors += R"(,{"bufferView":)" + std::to_string(next_++) + "," + accessor + "}";
    binary += bytes;
  }

 private:
  int next_ = 2;
};

std::string accessorOf(int component, int count, const std::string& type,
                       const std::string& more = {}) {
  return R"("componentType":)" + std::to_string(component) + R"(,"count":)" +
         std::to_string(count) + R"(,"type":")" + type + "\"" + more;
}

ReadModel readAll(const TinyGltf& tiny) {
  auto model = modelOf(tiny.file(), "tiny.glb");
  EXPECT_TRUE(model.ok()) << messageOf(model);
  return model ? std::move(model).value() : ReadModel();
}

Vec3 pointOf(const ReadModel& model, std::size_t vertex) {
  if (3 * vertex + 2 >= model.soup.positions.size()) return {std::nan(""), 0, 0};
  const double* at = model.soup.positions.data() + 3 * vertex;
  return {at[0], at[1], at[2]};
}

void expectPoint(const ReadModel& model, std::size_t vertex, const Vec3& expected) {
  const Vec3 found = pointOf(model, vertex);
  EXPECT_NEAR(found.x, expected.x, 1e-6) << "vertex " << vertex;
  EXPECT_NEAR(found.y, expected.y, 1e-6) << "vertex " << vertex;
  EXPECT_NEAR(found.z, expected.z, 1e-6) << "vertex " << vertex;
}

/// Six times the enclosed volume; positive where the faces look outwards.
double sixfoldVolume(const ReadModel& model) {
  double sum = 0;
  for (std::size_t t = 0; t + 2 < model.soup.triangles.size(); t += 3) {
    const Vec3 p = pointOf(model, model.soup.triangles[t]);
    const Vec3 q = pointOf(model, model.soup.triangles[t + 1]);
    const Vec3 r = pointOf(model, model.soup.triangles[t + 2]);
    sum += p.x * (q.y * r.z - q.z * r.y) - p.y * (q.x * r.z - q.z * r.x) +
           p.z * (q.x * r.y - q.y * r.x);
  }
  return sum;
}

bool hasNote(const ReadModel& model, const std::string& part) {
  for (const std::string& note : model.notes) {
    if (contains(note, part)) return true;
  }
  return false;
}

/// All four vertices on one joint, or shared out between two, with any weights.
void addInfluences(Extended& tiny, const std::string& joints, const std::string& weights) {
  tiny.add(joints, accessorOf(5121, 4, "VEC4"));
  tiny.add(weights, accessorOf(5126, 4, "VEC4"));
  tiny.primitives = R"({"attributes":{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3},"indices":1})";
}

std::string identityMatrix(float x = 0, float y = 0, float z = 0) {
  return packedFloats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1});
}

TEST(GltfScene, mirrorsKeepTheOutside) {
  for (const auto& [scale, volume] :
       {std::pair{"[-1,2,3]", 6.0}, {"[1,-2,-3]", 6.0}, {"[-1,-2,-3]", 6.0}, {"[0.5,4,1]", 2.0}}) {
    TinyGltf tiny;
    tiny.nodes = R"({"mesh":0,"translation":[5,6,7],"scale":)" + std::string(scale) + "}";
    EXPECT_NEAR(sixfoldVolume(readAll(tiny)), volume, 1e-9) << scale;
    // A mirroring parent does as much.
    tiny.nodes =
        R"({"children":[1],"scale":[-1,1,1]},{"mesh":0,"scale":)" + std::string(scale) + "}";
    EXPECT_NEAR(sixfoldVolume(readAll(tiny)), volume, 1e-9) << scale;
  }
}

TEST(GltfScene, rotationsNeedNotBeOfUnitLength) {
  TinyGltf tiny;
  tiny.nodes = R"({"mesh":0,"rotation":[0,0,3,3]})";
  const ReadModel model = readAll(tiny);
  expectPoint(model, 1, {0, 1, 0});
  expectPoint(model, 2, {-1, 0, 0});
}

TEST(GltfScene, instances) {
  Extended tiny;
  tiny.add(packedFloats({0, 0, 0, 10, 0, 0, 20, 0, 0}), accessorOf(5126, 3, "VEC3"));
  // Turned by 0, 90 and 180 degrees about z, in normalised shorts.
  tiny.add(packed({0, 0, 0, 32767, 0, 0, 23170, 23170, 0, 0, 32767, 0}, 2),
           accessorOf(5122, 3, "VEC4", R"(,"normalized":true)"));
  tiny.add(packedFloats({1, 1, 1, 2, 2, 2, -3, 3, 3}), accessorOf(5126, 3, "VEC3"));
  tiny.nodes = R"({"mesh":0,"translation":[0,100,0],"extensions":{"EXT_mesh_gpu_instancing":)"
               R"({"attributes":{"TRANSLATION":2,"ROTATION":3,"SCALE":4,"_ID":1}}}})";
  tiny.more = R"(,"extensionsRequired":["EXT_mesh_gpu_instancing"])";
  const ReadModel model = readAll(tiny);
  ASSERT_EQ(model.soup.positions.size(), 36u);
  expectPoint(model, 1, {1, 100, 0});
  expectPoint(model, 5, {10, 102, 0});
  expectPoint(model, 9, {23, 100, 0});
  EXPECT_NEAR(sixfoldVolume(model), 1 + 8 + 27, 1e-3) << "the third is mirrored";
  EXPECT_TRUE(hasNote(model, "instances: 3"));
}

TEST(GltfScene, instancesOfDifferentNumber) {
  Extended tiny;
  tiny.add(packedFloats({0, 0, 0, 10, 0, 0}), accessorOf(5126, 2, "VEC3"));
  tiny.add(packedFloats({1, 1, 1}), accessorOf(5126, 1, "VEC3"));
  tiny.nodes = R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":)"
               R"({"attributes":{"TRANSLATION":2,"SCALE":3}}}})";
  const auto model = modelOf(tiny.file(), "tiny.glb");
  EXPECT_EQ(codeOf(model), "MALFORMED_FILE");
  EXPECT_TRUE(
      contains(messageOf(model), "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/SCALE"))
      << messageOf(model);
}

/// A tetrahedron and so many instances of it, all in the same place: nothing of them is written.
std::string instancesInOnePlace(std::size_t count) {
  TinyGltf tiny;
  tiny.accessors = std::string(kPositions) + "," + kIndices + "," +
                   R"({"componentType":5126,"count":)" + std::to_string(count) +
                   R"(,"type":"VEC3"})";
  tiny.nodes =
      R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":2}}}})";
  return tiny.file();
}

TEST(GltfScene, instancesAreBoundedByTheirTriangles) {
  const auto many = modelOf(instancesInOnePlace(300'000), "tiny.glb");
  ASSERT_TRUE(many.ok()) << messageOf(many);
  EXPECT_EQ(many.value().soup.triangles.size(), 3u * 1'200'000);
  const auto model = modelOf(instancesInOnePlace(2'500'001), "tiny.glb");
  EXPECT_EQ(codeOf(model), "LIMIT_EXCEEDED");
  EXPECT_TRUE(contains(messageOf(model), "10000004 triangles, made of 4")) << messageOf(model);
  EXPECT_TRUE(contains(messageOf(model), "at most 10000000 are read")) << messageOf(model);
  EXPECT_TRUE(contains(model.error().hint, "fewer instances")) << model.error().hint;
}

TEST(GltfScene, aMeshPlacedByManyNodesIsBoundedToo) {
  // Each node doubles what is below it.
  const auto doubled = [](int times) {
    TinyGltf tiny;
    tiny.nodes = "";
    for (int i = 0; i < times; ++i) {
      const std::string next = std::to_string(i + 1);
      tiny.nodes += R"({"children":[)" + next + "," + next + "]},";
    }
    tiny.nodes += R"({"mesh":0})";
    return modelOf(tiny.file(), "tiny.glb");
  };
  const auto model = doubled(10);
  ASSERT_TRUE(model.ok()) << messageOf(model);
  EXPECT_EQ(model.value().soup.triangles.size(), 3u * 4 * 1024);
  for (const int times : {22, 63, 200}) {
    const auto large = doubled(times);
    EXPECT_EQ(codeOf(large), "LIMIT_EXCEEDED");
    EXPECT_TRUE(contains(messageOf(large), "triangles, made of 4")) << messageOf(large);
  }
}

TEST(GltfScene, skinInItsBindPose) {
  Extended tiny;
  addInfluences(tiny, packed({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, 1),
                packedFloats({1, 0, 0, 0, .5f, .5f, 0, 0, .25f, .75f, 0, 0, 0, 1, 0, 0}));
  tiny.add(identityMatrix() + identityMatrix(0, -2, 0), accessorOf(5126, 2, "MAT4"));
  // The mesh's own node is far away, and turned: glTF ignores it.
  tiny.nodes = R"({"mesh":0,"skin":0,"translation":[50,60,70],"scale":[-9,9,9]},)"
               R"({"children":[2],"translation":[3,0,0]},{"translation":[0,2,0]})";
  tiny.scenes = R"("scenes":[{"nodes":[0,1]}])";
  tiny.more = R"(,"skins":[{"joints":[1,2],"inverseBindMatrices":4}])";
  const ReadModel model = readAll(tiny);
  expectPoint(model, 0, {3, 0, 0});
  expectPoint(model, 1, {4, 0, 0});
  expectPoint(model, 3, {3, 0, 1});
  EXPECT_NEAR(sixfoldVolume(model), 1, 1e-6);
  EXPECT_TRUE(hasNote(model, "Mesh 0 \"tiny\" is skinned: shown in the bind pose."))
      << model.notes.size();
}

TEST(GltfScene, skinAsItsJointsAreStored) {
  Extended tiny;
  // Weights that add up to 2, to 0 (the first joint counts), and to 1.
  addInfluences(tiny, packed({0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, 1),
                packedFloats({1, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}));
  tiny.nodes = R"({"mesh":0,"skin":0},{"translation":[0,0,10]},{"translation":[0,0,20]})";
  tiny.scenes = R"("scenes":[{"nodes":[0,1,2]}])";
  tiny.more = R"(,"skins":[{"name":"arm","joints":[1,2]}])";
  const ReadModel model = readAll(tiny);
  expectPoint(model, 0, {0, 0, 15});
  expectPoint(model, 1, {1, 0, 20});
  expectPoint(model, 2, {0, 1, 10});
  expectPoint(model, 3, {0, 0, 21});
  EXPECT_TRUE(hasNote(model, "not the bind pose"));
}

TEST(GltfScene, skinWithTwoSetsAndMirroringJoints) {
  Extended tiny;
  addInfluences(tiny, std::string(16, '\0'),
                packedFloats({.5f, 0, 0, 0, .5f, 0, 0, 0,  //
                              .5f, 0, 0, 0, .5f, 0, 0, 0}));
  tiny.add(packed({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 2),
           accessorOf(5123, 4, "VEC4"));
  tiny.add(packed({128, 0, 0, 0, 128, 0, 0, 0, 128, 0, 0, 0, 128, 0, 0, 0}, 1),
           accessorOf(5121, 4, "VEC4", R"(,"normalized":true)"));
  tiny.primitives = R"({"attributes":{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3,)"
                    R"("JOINTS_1":4,"WEIGHTS_1":5},"indices":1})";
  tiny.nodes = R"({"mesh":0,"skin":0},{"scale":[-1,1,1]},{"scale":[-1,1,1],"translation":[0,0,4]})";
  tiny.scenes = R"("scenes":[{"nodes":[0,1,2]}])";
  tiny.more = R"(,"skins":[{"joints":[1,2]}])";
  const ReadModel model = readAll(tiny);
  const double share = 128.0 / 255 / (128.0 / 255 + 0.5);
  expectPoint(model, 1, {-1, 0, 4 * share});
  EXPECT_NEAR(sixfoldVolume(model), 1, 1e-6) << "the outside stays outside";
}

TEST(GltfScene, faultsOfSkins) {
  const auto messageWith = [](const std::string& skin, const std::string& joints) {
    Extended tiny;
    addInfluences(tiny, joints, packedFloats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}));
    tiny.add(identityMatrix(), accessorOf(5126, 1, "MAT4"));
    tiny.nodes = R"({"mesh":0,"skin":0},{})";
    tiny.more = R"(,"skins":[)" + skin + "]";
    const auto model = modelOf(tiny.file(), "tiny.glb");
    EXPECT_EQ(codeOf(model), "MALFORMED_FILE");
    return messageOf(model);
  };
  const std::string zeros(16, '\0');
  EXPECT_TRUE(contains(messageWith("", zeros), "/nodes/0/skin"));
  EXPECT_TRUE(contains(messageWith(R"({"joints":[]})", zeros), "/skins/0"));
  EXPECT_TRUE(contains(messageWith(R"({"joints":[7]})", zeros), "/skins/0/joints/0"));
  EXPECT_TRUE(contains(messageWith(R"({"joints":[1,1],"inverseBindMatrices":4})", zeros),
                       "/skins/0/inverseBindMatrices"));
  EXPECT_TRUE(contains(messageWith(R"({"joints":[1],"inverseBindMatrices":0})", zeros),
                       "/accessors/0/type"));
  EXPECT_TRUE(contains(messageWith(R"({"joints":[1]})", std::string(16, '\1')), "joint 1 of 1"));
}

TEST(GltfScene, jointsInACycle) {
  Extended tiny;
  addInfluences(tiny, std::string(16, '\0'),
                packedFloats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}));
  tiny.nodes = R"({"mesh":0,"skin":0},{"children":[2]},{"children":[1]})";
  tiny.more = R"(,"skins":[{"joints":[2]}])";
  const auto model = modelOf(tiny.file(), "tiny.glb");
  EXPECT_EQ(codeOf(model), "MALFORMED_FILE");
  EXPECT_TRUE(contains(messageOf(model), "/skins/0/joints/0")) << messageOf(model);
}

TEST(GltfScene, jointsWithoutASkinStayPut) {
  Extended tiny;
  addInfluences(tiny, std::string(16, '\0'), std::string(64, '\0'));
  tiny.nodes = R"({"mesh":0,"translation":[1,0,0]})";
  const ReadModel model = readAll(tiny);
  expectPoint(model, 0, {1, 0, 0});
  EXPECT_TRUE(model.notes.empty());
}

TEST(GltfScene, whatIsNoGeometryIsNamed) {
  Extended tiny;
  tiny.more =
      R"(,"materials":[{"normalTexture":{"index":0}}],"textures":[{}],"animations":[{"channels":[]}],)"
      R"("cameras":[{}],"extensions":{"KHR_lights_punctual":{"lights":[{}]}})";
  EXPECT_TRUE(hasNote(readAll(tiny),
                      "Its materials, textures, animations, cameras and lights were left out."));
  tiny.more = R"(,"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1]}}])";
  EXPECT_TRUE(hasNote(readAll(tiny), "Its materials were left out."));
  // Content that Girth writes for any surface is no loss.
  tiny.more = R"(,"materials":[{"doubleSided":true,"pbrMetallicRoughness":{"metallicFactor":0}}])";
  EXPECT_TRUE(readAll(tiny).notes.empty());
}

/// Two targets: one lifts vertex 3 by 1, the other, sparse, moves vertex 1 by 2.
Extended morphed() {
  Extended tiny;
  tiny.add(packedFloats({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}), accessorOf(5126, 4, "VEC3"));
  tiny.views += R"(,{"buffer":0,"byteOffset":)" + std::to_string(tiny.binary.size()) +
                R"(,"byteLength":4},{"buffer":0,"byteOffset":)" +
                std::to_string(tiny.binary.size() + 4) + R"(,"byteLength":12})";
  tiny.binary += packed({1, 0, 0, 0}, 1) + packedFloats({2, 0, 0});
  tiny.accessors +=
      R"(,{"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":1,)"
      R"("indices":{"bufferView":3,"componentType":5121},"values":{"bufferView":4}}})";
  tiny.primitives =
      R"({"attributes":{"POSITION":0},"indices":1,"targets":[{"POSITION":2},{"POSITION":3}]})";
  return tiny;
}

std::string withMeshWeights(const TinyGltf& tiny, const std::string& weights) {
  std::string json = tiny.json();
  json.insert(json.find(R"("primitives")"), R"("weights":)" + weights + ",");
  return glb(json, tiny.binary);
}

TEST(GltfScene, morphTargetsAtRest) {
  const ReadModel plain = readAll(morphed());
  expectPoint(plain, 3, {0, 0, 1});
  EXPECT_TRUE(hasNote(plain, "morph targets: shown at rest, with all weights 0."));

  const auto weighted = modelOf(withMeshWeights(morphed(), "[0.5,-1]"), "tiny.glb");
  ASSERT_TRUE(weighted.ok()) << messageOf(weighted);
  expectPoint(weighted.value(), 1, {-1, 0, 0});
  expectPoint(weighted.value(), 3, {0, 0, 1.5});
  EXPECT_TRUE(hasNote(weighted.value(), "with the weights that the file stores"));

  Extended tiny = morphed();
  tiny.nodes = R"({"mesh":0,"weights":[3,0]})";
  const auto ofNode = modelOf(withMeshWeights(tiny, "[0.5,-1]"), "tiny.glb");
  ASSERT_TRUE(ofNode.ok()) << messageOf(ofNode);
  expectPoint(ofNode.value(), 3, {0, 0, 4});
  expectPoint(ofNode.value(), 1, {1, 0, 0});
}

TEST(GltfScene, faultsOfMorphTargets) {
  const auto wrongCount = modelOf(withMeshWeights(morphed(), "[1]"), "tiny.glb");
  EXPECT_EQ(codeOf(wrongCount), "MALFORMED_FILE");
  EXPECT_TRUE(contains(messageOf(wrongCount), "/meshes/0/primitives/0/targets"));
  Extended tiny = morphed();
  tiny.primitives = R"({"attributes":{"POSITION":0},"indices":1,"targets":[{"POSITION":9}]})";
  const auto missing = modelOf(tiny.file(), "tiny.glb");
  EXPECT_EQ(codeOf(missing), "MALFORMED_FILE");
  EXPECT_TRUE(contains(messageOf(missing), "/meshes/0/primitives/0/targets/0/POSITION"));
}

TEST(GltfScene, hiddenNodesAreLeftOut) {
  TinyGltf tiny;
  tiny.nodes = R"({"mesh":0},{"extensions":{"KHR_node_visibility":{"visible":false}},)"
               R"("children":[2],"mesh":0},{"mesh":0})";
  tiny.scenes = R"("scenes":[{"nodes":[0,1]}])";
  const ReadModel model = readAll(tiny);
  EXPECT_EQ(model.soup.triangles.size(), 12u);
  EXPECT_TRUE(hasNote(model, "1 hidden node, with all below, was left out."));
}

TEST(GltfScene, nodesWithSeveralParents) {
  TinyGltf tiny;
  tiny.nodes = R"({"children":[1,2]},{"children":[3]},{"children":[3],"translation":[9,0,0]},)"
               R"({"mesh":0})";
  const ReadModel model = readAll(tiny);
  ASSERT_EQ(model.soup.positions.size(), 24u);
  expectPoint(model, 4, {9, 0, 0});
  EXPECT_TRUE(hasNote(model, "more than one parent"));
  // Each doubles what is below: nobody may ask for 2^40 nodes.
  tiny.nodes = "";
  for (int i = 0; i < 40; ++i) {
    const std::string next = std::to_string(i + 1);
    tiny.nodes += R"({"children":[)" + next + "," + next + "]},";
  }
  tiny.nodes += "{}";
  EXPECT_EQ(codeOf(modelOf(tiny.file(), "tiny.glb")), "LIMIT_EXCEEDED");
}

TEST(GltfScene, otherScenesAndPrimitivesAreMentioned) {
  TinyGltf tiny;
  tiny.nodes = R"({"mesh":0},{"mesh":0,"translation":[7,0,0]})";
  tiny.scenes = R"("scene":1,"scenes":[{"nodes":[0]},{"name":"second","nodes":[1]}])";
  tiny.primitives += R"(,{"attributes":{"POSITION":0},"mode":0},{"attributes":{"POSITION":0},)"
                     R"("mode":3},{"attributes":{},"indices":1})";
  const ReadModel model = readAll(tiny);
  expectPoint(model, 0, {7, 0, 0});
  EXPECT_EQ(model.soup.triangles.size(), 12u);
  EXPECT_TRUE(hasNote(model, "Of 2 scenes, scene 1 \"second\" is shown."));
  EXPECT_TRUE(hasNote(model, "2 primitives of points or lines were left out."));
  EXPECT_TRUE(hasNote(model, "1 primitive without positions was left out."));
}

TEST(GltfScene, restartPartsStripsAndFans) {
  TinyGltf tiny;
  // Two strips of one triangle each, one longer one, and nothing between two restarts.
  tiny.binary = tiny.binary.substr(0, 48) +
                packed({0, 2, 1, 65535, 65535, 0, 1, 3, 65535, 0, 3, 2, 65535, 1, 2, 3}, 2);
  tiny.views = R"({"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":32})";
  for (const int mode : {5, 6}) {
    tiny.accessors = std::string(kPositions) +
                     R"(,{"bufferView":1,"componentType":5123,"count":16,"type":"SCALAR"})";
    tiny.primitives =
        R"({"attributes":{"POSITION":0},"indices":1,"mode":)" + std::to_string(mode) + "}";
    const ReadModel model = readAll(tiny);
    EXPECT_EQ(model.soup.triangles.size(), 12u);
    EXPECT_NEAR(sixfoldVolume(model), 1, 1e-12) << mode;
  }
  tiny.accessors = std::string(kPositions) +
                   R"(,{"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"})";
  tiny.primitives = R"({"attributes":{"POSITION":0},"indices":1})";
  const auto list = modelOf(tiny.file(), "tiny.glb");
  EXPECT_EQ(codeOf(list), "INDEX_OUT_OF_RANGE");
  EXPECT_TRUE(contains(messageOf(list), "parts strips")) << messageOf(list);
}

TEST(GltfScene, everyComponentType) {
  struct Kind {
    int type, size;
  };
  for (const Kind& kind :
       {Kind{5120, 1}, Kind{5121, 1}, Kind{5122, 2}, Kind{5123, 2}, Kind{5124, 4}, Kind{5125, 4}}) {
    TinyGltf tiny;
    tiny.binary = packed({0, 0, 0, 3, 0, 0, 0, 3, 0, 0, 0, 3}, kind.size);
    tiny.binary.resize(48);
    tiny.binary += packed({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, 2);
    tiny.accessors = R"({"bufferView":0,"componentType":)" + std::to_string(kind.type) +
                     R"(,"count":4,"type":"VEC3"},)" + kIndices;
    EXPECT_NEAR(sixfoldVolume(readAll(tiny)), 27, 1e-12) << kind.type;
  }
  TinyGltf tiny;
  tiny.binary.clear();
  for (const double number : {0., 0., 0., 0.1, 0., 0., 0., 1., 0., 0., 0., 1.}) {
    tiny.binary += packed({std::bit_cast<std::int64_t>(number)}, 8);
  }
  tiny.binary += packed({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, 2);
  tiny.views = R"({"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":24})";
  tiny.accessors =
      std::string(R"({"bufferView":0,"componentType":5130,"count":4,"type":"VEC3"},)") + kIndices;
  EXPECT_EQ(pointOf(readAll(tiny), 1).x, 0.1) << "doubles stay doubles";
}

TEST(GltfScene, extremesOfNormalisedNumbers) {
  TinyGltf tiny;
  tiny.binary = packed({-128, -127, 127}, 1);
  tiny.binary.resize(48);
  tiny.binary += packed({0, 0, 0}, 2);
  tiny.views = R"({"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":6})";
  tiny.accessors = R"({"bufferView":0,"componentType":5120,"normalized":true,"count":1,)"
                   R"("type":"VEC3"},{"bufferView":1,"componentType":5123,"count":3,)"
                   R"("type":"SCALAR"})";
  const Vec3 point = pointOf(readAll(tiny), 0);
  EXPECT_EQ(point.x, -1);
  EXPECT_EQ(point.y, -1);
  EXPECT_EQ(point.z, 1);
}

TEST(GltfScene, sparseOverAView) {
  TinyGltf tiny;
  tiny.binary += packed({1, 0, 0, 0}, 1) + packedFloats({4, 0, 0});
  tiny.views += R"(,{"buffer":0,"byteOffset":72,"byteLength":1},)"
                R"({"buffer":0,"byteOffset":76,"byteLength":12})";
  tiny.accessors = R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":)"
                   R"({"count":1,"indices":{"bufferView":2,"componentType":5121},)"
                   R"("values":{"bufferView":3}}},)" +
                   std::string(kIndices);
  const ReadModel model = readAll(tiny);
  expectPoint(model, 1, {4, 0, 0});
  expectPoint(model, 2, {0, 1, 0});
}

TEST(GltfScene, wholeNumbersMayBeWrittenWithAPoint) {
  TinyGltf tiny;
  tiny.accessors = R"({"bufferView":0.0,"componentType":5126.0,"count":4.0,"type":"VEC3"},)" +
                   std::string(kIndices);
  EXPECT_NEAR(sixfoldVolume(readAll(tiny)), 1, 1e-12);
  tiny.accessors =
      R"({"bufferView":0.5,"componentType":5126,"count":4,"type":"VEC3"},)" + std::string(kIndices);
  const auto model = modelOf(tiny.file(), "tiny.glb");
  EXPECT_EQ(messageOf(model), "/accessors/0/bufferView: is not a whole number");
}

}  // namespace
}  // namespace girth::io::testing
