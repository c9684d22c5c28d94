// Which files beside a model the command reads, and which it does not.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

namespace fs = std::filesystem;

/// A folder "outside" with a folder "models" in it.
class Resources : public ::testing::Test {
 protected:
  Resources() {
    std::string name = (fs::temp_directory_path() / "girth-XXXXXX").string();
    outside_ = mkdtemp(name.data());
    models_ = outside_ / "models";
    fs::create_directories(models_ / "parts");
  }
  ~Resources() override { fs::remove_all(outside_); }

  /// A tetrahedron: four points and four triangles.
  static void writeBuffer(const fs::path& path) {
    const float points[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const unsigned char corners[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(points), sizeof points);
    file.write(reinterpret_cast<const char*>(corners), sizeof corners);
  }

  /// What `girth info` says of a model whose buffer has that address.
  std::string infoWith(const std::string& uri) const {
    const fs::path model = models_ / "model.gltf";
    std::ofstream(model) << R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":60,"uri":")"
                         << uri << R"("}],"bufferViews":[{"buffer":0,"byteLength":48},)"
                         << R"({"buffer":0,"byteOffset":48,"byteLength":12}],"accessors":[)"
                         << R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
                         << R"({"bufferView":1,"componentType":5121,"count":12,"type":"SCALAR"}],)"
                         << R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},)"
                         << R"("indices":1}]}],"nodes":[{"mesh":0}]})";
    const std::string command = std::string(GIRTH_COMMAND) + " info '" + model.string() + "' 2>&1";
    std::FILE* pipe = popen(command.c_str(), "r");
    std::string output;
    char block[256];
    while (std::fgets(block, sizeof block, pipe) != nullptr) output += block;
    pclose(pipe);
    return output;
  }
  bool isRead(const std::string& uri) const {
    const std::string said = infoWith(uri);
    EXPECT_EQ(said.find("INTERNAL"), std::string::npos) << said;
    return said.find("MISSING_RESOURCE") == std::string::npos &&
           said.find("faces          4") != std::string::npos;
  }

  fs::path outside_, models_;
};

TEST_F(Resources, filesInTheModelsFolder) {
  writeBuffer(models_ / "buffer.bin");
  writeBuffer(models_ / "parts/in here.bin");
  writeBuffer(models_ / "100%25.bin");
  fs::create_symlink(models_ / "buffer.bin", models_ / "link.bin");
  EXPECT_TRUE(isRead("buffer.bin")) << infoWith("buffer.bin");
  EXPECT_TRUE(isRead("./buffer.bin"));
  EXPECT_TRUE(isRead("parts/in%20here.bin"));
  EXPECT_TRUE(isRead("parts/in here.bin"));
  EXPECT_TRUE(isRead("link.bin"));
  EXPECT_TRUE(isRead("100%25.bin")) << "a name that looks as if it were escaped";
}

TEST_F(Resources, filesElsewhere) {
  writeBuffer(outside_ / "secret.bin");
  fs::create_symlink(outside_ / "secret.bin", models_ / "link.bin");
  fs::create_directory_symlink(outside_, models_ / "folder");
  for (const std::string& uri :
       {std::string("../secret.bin"), std::string("parts/../../secret.bin"),
        std::string("..%2Fsecret.bin"), std::string("%2e%2e/secret.bin"),
        (outside_ / "secret.bin").string(), "file://" + (outside_ / "secret.bin").string(),
        std::string("link.bin"), std::string("folder/secret.bin"), std::string("parts"),
        std::string("/dev/zero"), std::string(".")}) {
    EXPECT_FALSE(isRead(uri)) << uri;
  }
}

TEST_F(Resources, anAbsentFileIsNamed) {
  const std::string said = infoWith("parts/lost%20one.bin");
  EXPECT_NE(said.find("MISSING_RESOURCE: /buffers/0/uri: it refers to the file "
                      "\"parts/lost one.bin\", which is missing"),
            std::string::npos)
      << said;
}

}  // namespace
