// Which files beside a model the command reads, and which it does not.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "../model_folder.h"
#include "test_paths.h"

namespace girth::test {
namespace {

namespace fs = std::filesystem;

class Resources : public ModelFolder {
 protected:
  /// The output of `girth info` for a model whose buffer has that address.
  std::string infoWith(const std::string& uri) const {
    const std::string model = gltfWith(uri);
    const std::string command = quoted(girthCommand()) + " info " + quoted(model) + " 2>&1";
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
};

TEST_F(Resources, filesInTheModelsFolder) {
  writeBuffer(models / "buffer.bin");
  writeBuffer(models / "parts/in here.bin");
  writeBuffer(models / "100%25.bin");
  fs::create_symlink(models / "buffer.bin", models / "link.bin");
  EXPECT_TRUE(isRead("buffer.bin")) << infoWith("buffer.bin");
  EXPECT_TRUE(isRead("./buffer.bin"));
  EXPECT_TRUE(isRead("parts/in%20here.bin"));
  EXPECT_TRUE(isRead("parts/in here.bin"));
  EXPECT_TRUE(isRead("link.bin"));
  EXPECT_TRUE(isRead("100%25.bin")) << "a name that looks as if it were escaped";
}

TEST_F(Resources, filesElsewhere) {
  writeBuffer(outside / "secret.bin");
  fs::create_symlink(outside / "secret.bin", models / "link.bin");
  fs::create_directory_symlink(outside, models / "folder");
  for (const std::string& uri :
       {std::string("../secret.bin"), std::string("parts/../../secret.bin"),
        std::string("..%2Fsecret.bin"), std::string("%2e%2e/secret.bin"),
        (outside / "secret.bin").string(), "file://" + (outside / "secret.bin").string(),
        std::string("link.bin"), std::string("folder/secret.bin"), std::string("parts"),
        std::string("/dev/zero"), std::string(".")}) {
    EXPECT_FALSE(isRead(uri)) << uri;
  }
}

TEST_F(Resources, anAbsentFileIsNamed) {
  const std::string said = infoWith("parts/lost%20one.bin");
  EXPECT_NE(said.find("MISSING_RESOURCE: the file \"parts/lost one.bin\" is missing: "
                      "the model refers to it"),
            std::string::npos)
      << said;
}

}  // namespace
}  // namespace girth::test
