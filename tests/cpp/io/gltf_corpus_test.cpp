// Real glTF files, and files with one fault each: what becomes of them.
#include <cmath>
#include <filesystem>
#include <map>

#include "documents.h"
#include "test_paths.h"

namespace girth::io::testing {
namespace {

namespace fs = std::filesystem;

class GltfCorpus : public ::testing::Test {
 protected:
  void SetUp() override {
    data_ = test::corpusFolder();
    if (data_.empty()) GTEST_SKIP() << "skipped: no corpus";
  }

  static Result<LoadedMesh> readFile(const fs::path& path) {
    return readMesh(contentOf(path).value_or(std::vector<std::byte>()), path.string(),
                    besides(path));
  }
  Result<ReadModel> model(const std::string& name) const {
    const fs::path path = data_ / "gltf" / name;
    return readModel(contentOf(path).value_or(std::vector<std::byte>()), name, besides(path));
  }
  static ResourceReader besides(const fs::path& path) {
    return [folder = path.parent_path()](std::string_view name) {
      return contentOf(folder / std::string(name));
    };
  }

  fs::path data_;
};

/// The files of glTF-Validator are named after the one fault that they have. Files whose fault
/// concerns geometry are refused for it; all others are models without faces that have an area.
TEST_F(GltfCorpus, faultsOfTheValidatorsFiles) {
  const std::map<std::string, std::string> codes{
      {"animation/sampler_bufferview_bytestride.gltf", "MALFORMED_FILE"},
      {"camera/infinite_znear.gltf", "MALFORMED_FILE"},
      {"image/buffer_view_bytestride.gltf", "MALFORMED_FILE"},
      {"image/missing_mime_type_buffer_view.gltf", "MALFORMED_FILE"},
      {"image/valid.gltf", "MISSING_RESOURCE"},
      {"glb/empty_file.glb", "EMPTY_FILE"},
      {"json/empty_file.gltf", "EMPTY_FILE"},
      {"mesh_data/index_buffer_oob.gltf", "INDEX_OUT_OF_RANGE"},
      {"accessor/alignment.gltf", "MALFORMED_FILE"},
      {"accessor/empty_object.gltf", "MALFORMED_FILE"},
      {"accessor/float_normalized.gltf", "MALFORMED_FILE"},
      {"accessor/invalid_sparse_count_and_stride.gltf", "MALFORMED_FILE"},
      {"accessor/matrix_alignment.gltf", "MALFORMED_FILE"},
      {"accessor/small_stride.gltf", "MALFORMED_FILE"},
      {"accessor/unknown_type.gltf", "MALFORMED_FILE"},
      {"accessor/unresolved_bufferviews.gltf", "MALFORMED_FILE"},
      {"accessor/valid.gltf", "MALFORMED_FILE"},
      {"asset/empty_array.gltf", "MALFORMED_FILE"},
      {"buffer/custom_property.gltf", "MALFORMED_FILE"},
      {"buffer/empty_object.gltf", "MALFORMED_FILE"},
      {"buffer/invalid_object.gltf", "MALFORMED_FILE"},
      {"buffer/invalid_uri_data.glb", "MALFORMED_FILE"},
      {"buffer/invalid_uri_data_bytelength.gltf", "MALFORMED_FILE"},
      {"buffer/no_bin_chunk.glb", "MALFORMED_FILE"},
      {"buffer/wrong_bytelength.glb", "MALFORMED_FILE"},
      {"buffer/zero_bytelength.gltf", "MALFORMED_FILE"},
      {"buffer_view/empty_object.gltf", "MALFORMED_FILE"},
      {"buffer_view/invalid_length.gltf", "MALFORMED_FILE"},
      {"buffer_view/invalid_stride_multiple.gltf", "MALFORMED_FILE"},
      {"buffer_view/unresolved_buffer.gltf", "MALFORMED_FILE"},
      {"buffer_view/zero_bytelength.gltf", "MALFORMED_FILE"},
      {"glb/chunk_too_big.glb", "MALFORMED_FILE"},
      {"glb/empty_json_chunk.glb", "MALFORMED_FILE"},
      {"glb/invalid_json_chunk.glb", "MALFORMED_FILE"},
      {"glb/length_mismatch.glb", "MALFORMED_FILE"},
      {"glb/only_bin_chunk.glb", "MALFORMED_FILE"},
      {"glb/only_header.glb", "MALFORMED_FILE"},
      {"glb/truncated_chunk_data.glb", "MALFORMED_FILE"},
      {"glb/truncated_chunk_header.glb", "MALFORMED_FILE"},
      {"glb/two_bin_chunks.glb", "MALFORMED_FILE"},
      {"glb/two_empty_bin_chunks.glb", "MALFORMED_FILE"},
      {"glb/two_empty_json_chunks.glb", "MALFORMED_FILE"},
      {"glb/unknown_chunk.glb", "MALFORMED_FILE"},
      {"glb/zero_chunk_header.glb", "MALFORMED_FILE"},
      {"glb/zero_length.glb", "MALFORMED_FILE"},
      {"json/integer_written_as_float.gltf", "MALFORMED_FILE"},
      {"json/invalid_syntax.gltf", "MALFORMED_FILE"},
      {"mesh/accessor_without_bytestride.gltf", "MALFORMED_FILE"},
      {"mesh/bufferview_target_override.gltf", "MALFORMED_FILE"},
      {"mesh/empty_object.gltf", "MALFORMED_FILE"},
      {"mesh/indices_bytestride.gltf", "MALFORMED_FILE"},
      {"mesh/indices_invalid_format.gltf", "MALFORMED_FILE"},
      {"mesh/morph_attribute_invalid_count.gltf", "MALFORMED_FILE"},
      {"mesh/morph_bufferview_target_override.gltf", "MALFORMED_FILE"},
      {"mesh/morph_weights_wrong_count.gltf", "MALFORMED_FILE"},
      {"mesh/position_accessor_invalid_format.gltf", "MALFORMED_FILE"},
      {"mesh/primitive_incompatible_mode.gltf", "MALFORMED_FILE"},
      {"mesh/unresolved_indices.gltf", "MALFORMED_FILE"},
      {"mesh/unresolved_morph_positions.gltf", "MALFORMED_FILE"},
      {"mesh/unresolved_positions.gltf", "MALFORMED_FILE"},
      {"mesh_data/joints_no_weights.gltf", "MALFORMED_FILE"},
      {"node/infinite_transform.gltf", "MALFORMED_FILE"},
      {"node/node_loop.gltf", "MALFORMED_FILE"},
      {"node/node_loop_scene.gltf", "MALFORMED_FILE"},
      {"node/node_parent_override.gltf", "MALFORMED_FILE"},
      {"node/node_weights_invalid.gltf", "MALFORMED_FILE"},
      {"node/unresolved_child_node.gltf", "MALFORMED_FILE"},
      {"node/unresolved_mesh.gltf", "MALFORMED_FILE"},
      {"node/unresolved_skin.gltf", "MALFORMED_FILE"},
      {"root/named_objects.gltf", "MALFORMED_FILE"},
      {"root/unused_objects.gltf", "MALFORMED_FILE"},
      {"scene/unresolved_child_node.gltf", "MALFORMED_FILE"},
      {"scene/unresolved_default_scene.gltf", "MALFORMED_FILE"},
      {"scene/unresolved_node.gltf", "MALFORMED_FILE"},
      {"skin/buffer_view_bytestride.gltf", "MALFORMED_FILE"},
      {"skin/empty_joints_array.gltf", "MALFORMED_FILE"},
      {"skin/empty_object.gltf", "MALFORMED_FILE"},
      {"skin/ibm_invalid_count.gltf", "MALFORMED_FILE"},
      {"skin/ibm_invalid_format.gltf", "MALFORMED_FILE"},
      {"skin/unresolved_ibm.gltf", "MALFORMED_FILE"},
      {"skin/unresolved_joint.gltf", "MALFORMED_FILE"},
      {"buffer/invalid_uri_scheme.gltf", "MISSING_RESOURCE"},
      {"buffer/non_relative_uri.gltf", "MISSING_RESOURCE"},
      {"buffer/not_found.gltf", "MISSING_RESOURCE"},
      {"glb/empty_json_object.glb", "UNKNOWN_FORMAT"},
      {"glb/invalid_magic.glb", "UNKNOWN_FORMAT"},
      {"glb/no_header.glb", "UNKNOWN_FORMAT"},
      {"json/invalid_object.gltf", "UNKNOWN_FORMAT"},
      {"root/empty_object.gltf", "UNKNOWN_FORMAT"},
      {"asset/1_0_version.gltf", "UNSUPPORTED_FEATURE"},
      {"asset/invalid_version.gltf", "UNSUPPORTED_FEATURE"},
      {"asset/min_version_invalid.gltf", "UNSUPPORTED_FEATURE"},
      {"asset/min_version_valid.gltf", "UNSUPPORTED_FEATURE"},
      {"glb/invalid_version.glb", "UNSUPPORTED_FEATURE"},
      {"root/undefined_used_extensions.gltf", "UNSUPPORTED_FEATURE"}};
  const fs::path folder = data_ / "bad/gltf-validator/base/data";
  std::size_t found = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".gltf" && extension != ".glb") continue;
    const std::string name = entry.path().lexically_relative(folder).generic_string();
    const auto expected = codes.find(name);
    const auto result = readFile(entry.path());
    EXPECT_EQ(codeOf(result), expected == codes.end() ? "EMPTY_MESH" : expected->second)
        << name << ": " << messageOf(result);
    if (expected != codes.end()) ++found;
  }
  EXPECT_EQ(found, codes.size());
}

TEST_F(GltfCorpus, faultsAreNamedByTheirPlace) {
  const std::map<std::string, std::string> places{
      {"accessor/unresolved_bufferviews.gltf", "/accessors/0/bufferView: "},
      {"accessor/unknown_type.gltf", "/accessors/0/type: "},
      {"accessor/invalid_sparse_count_and_stride.gltf", "/accessors/0/sparse/count: "},
      {"buffer/not_found.gltf", "the file \"not_found.bin\" is missing: "},
      {"buffer/wrong_bytelength.glb", "/buffers/0/byteLength: "},
      {"buffer_view/unresolved_buffer.gltf", "/bufferViews/0/buffer: "},
      {"buffer_view/invalid_stride_multiple.gltf", "/bufferViews/0/byteStride: "},
      {"mesh/unresolved_indices.gltf", "/meshes/0/primitives/0/indices: "},
      {"mesh/unresolved_positions.gltf", "/meshes/0/primitives/0/attributes/POSITION: "},
      {"mesh/unresolved_morph_positions.gltf", "/meshes/0/primitives/0/targets/0/POSITION: "},
      {"mesh_data/index_buffer_oob.gltf", "/meshes/0/primitives/0: index 5 names vertex 5 of 4"},
      {"node/unresolved_child_node.gltf", "/nodes/0/children: "},
      {"node/node_loop_scene.gltf", "/nodes/0/children: "},
      {"scene/unresolved_node.gltf", "/scenes/0/nodes/0: "},
      {"scene/unresolved_default_scene.gltf", "/scene: "},
      {"skin/ibm_invalid_count.gltf", "/skins/2/inverseBindMatrices: "},
      {"glb/invalid_json_chunk.glb", "its JSON is not valid at byte 21"}};
  for (const auto& [name, place] : places) {
    const auto result = readFile(data_ / "bad/gltf-validator/base/data" / name);
    EXPECT_EQ(messageOf(result).substr(0, place.size()), place) << name << messageOf(result);
  }
}

/// Refused with good reason; everything else in the folder of real files is read.
TEST_F(GltfCorpus, realFilesAreRead) {
  const std::map<std::string, std::string> refused{
      {"draco-testdata/KhronosSampleModels/DragonAttenuation/glTF/DragonAttenuation.gltf",
       "MISSING_RESOURCE"},
      {"draco-testdata/SphereTwoMaterials/sphere_two_materials_point_cloud.gltf", "EMPTY_MESH"},
      {"gltf-blender-io/roundtrip/00_empty_scene/00_empty_scene.gltf", "EMPTY_MESH"},
      {"gltf-blender-io/roundtrip/00_no_nodes/00_no_nodes.gltf", "EMPTY_MESH"},
      {"gltf-transform/cli/test/in/ACMEBox.gltf", "UNSUPPORTED_FEATURE"},
      {"khronos-gltf-ext/extensions/2.0/Archived/KHR_techniques_webgl/examples/"
       "sample_techniques.gltf",
       "MALFORMED_FILE"}};
  std::size_t read = 0;
  for (const auto& entry : fs::recursive_directory_iterator(data_ / "gltf")) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".gltf" && extension != ".glb") continue;
    const std::string name = entry.path().lexically_relative(data_ / "gltf").generic_string();
    std::string expected = "OK";
    if (name.rfind("gltf-pipeline/1.0/", 0) == 0) expected = "UNSUPPORTED_FEATURE";
    if (const auto found = refused.find(name); found != refused.end()) expected = found->second;
    const auto result = model(name);
    EXPECT_EQ(codeOf(result), expected) << name << ": " << messageOf(result);
    if (result) ++read;
  }
  EXPECT_GE(read, 170u);
}

TEST_F(GltfCorpus, twinsAgree) {
  const std::string khronos = "draco-testdata/KhronosSampleModels/";
  const std::string pipeline = "gltf-pipeline/2.0/extensions/";
  const std::vector<std::pair<std::string, std::string>> twins{
      {khronos + "Duck/glTF/Duck.gltf", khronos + "Duck/glTF_Binary/Duck.glb"},
      {khronos + "SheenCloth/glTF/SheenCloth.gltf",
       khronos + "SheenCloth/glTF_Binary/SheenCloth.glb"},
      {"draco-testdata/CesiumMan/glTF/CesiumMan.gltf",
       "draco-testdata/CesiumMan/glTF_Binary/CesiumMan.glb"},
      {"gltf-transform/core/test/in/Box_glTF/Box.gltf",
       "gltf-transform/core/test/in/Box_glTF-Binary/Box.glb"},
      {"gltf-transform/core/test/in/Box_glTF/Box.gltf",
       "gltf-transform/core/test/in/Box_glTF-Embedded/Box.gltf"},
      {"gltf-transform/extensions/test/in/BoxMeshopt.glb",
       "gltf-transform/extensions/test/in/BoxMeshopt.gltf"},
      {pipeline + "EXT_meshopt_compression/meshopt-fallback/meshopt-fallback.gltf",
       pipeline + "KHR_meshopt_compression/meshopt-no-fallback/meshopt-no-fallback.gltf"}};
  for (const auto& [one, other] : twins) {
    const auto first = model(one), second = model(other);
    ASSERT_TRUE(first.ok() && second.ok()) << one;
    const auto& positions = first.value().soup.positions;
    const auto& others = second.value().soup.positions;
    ASSERT_EQ(positions.size(), others.size()) << one;
    // Their JSON was not written by the same program.
    for (std::size_t i = 0; i < positions.size(); ++i) {
      ASSERT_NEAR(positions[i], others[i], 1e-6) << one;
    }
    EXPECT_EQ(first.value().soup.triangles, second.value().soup.triangles) << one;
    EXPECT_EQ(first.value().notes, second.value().notes) << one;
  }
}

TEST_F(GltfCorpus, dracoTwinsAreNear) {
  for (const auto& [one, other] : {std::pair{"draco-testdata/Box/glTF_Binary/Box.glb",
                                             "draco-testdata/Box/glTF_Binary/Box_Draco.glb"},
                                   {"draco-testdata/BoxMeta/glTF/BoxMeta.gltf",
                                    "draco-testdata/BoxMetaDraco/glTF/BoxMetaDraco.gltf"}}) {
    const auto plain = model(one), packed = model(other);
    ASSERT_TRUE(plain.ok() && packed.ok()) << one;
    EXPECT_EQ(plain.value().soup.triangles.size(), packed.value().soup.triangles.size()) << one;
    const auto& positions = packed.value().soup.positions;
    ASSERT_EQ(plain.value().soup.positions.size(), positions.size()) << one;
    for (const double x : positions) {
      const double corner = std::abs(x - std::round(x));
      EXPECT_NEAR(corner, 0.5, 1e-3) << one << ": all corners of this box lie at halves";
    }
  }
}

}  // namespace
}  // namespace girth::io::testing
