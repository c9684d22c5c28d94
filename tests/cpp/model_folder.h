// A folder of models for tests of what is read beside a model, and what is not.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "test_paths.h"

namespace girth::test {

/// A folder "outside" with a folder "models" in it.
class ModelFolder : public ::testing::Test {
 protected:
  ModelFolder() { std::filesystem::create_directories(models / "parts"); }
  ~ModelFolder() override { std::filesystem::remove_all(outside); }

  std::string write(const std::string& name, const std::string& content) const {
    const std::filesystem::path path = models / name;
    std::ofstream(path, std::ios::binary) << content;
    return path.string();
  }

  /// A tetrahedron: four points and four triangles.
  static void writeBuffer(const std::filesystem::path& path) {
    const float points[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const unsigned char corners[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(points), sizeof points);
    file.write(reinterpret_cast<const char*>(corners), sizeof corners);
  }

  /// The tetrahedron as a model whose buffer has that address.
  std::string gltfWith(const std::string& uri) const {
    return write("model.gltf",
                 R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":60,"uri":")" + uri +
                     R"("}],"bufferViews":[{"buffer":0,"byteLength":48},)" +
                     R"({"buffer":0,"byteOffset":48,"byteLength":12}],"accessors":[)" +
                     R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)" +
                     R"({"bufferView":1,"componentType":5121,"count":12,"type":"SCALAR"}],)" +
                     R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},)" +
                     R"("indices":1}]}],"nodes":[{"mesh":0}]})");
  }

  std::filesystem::path outside = newFolder(), models = outside / "models";
};

}  // namespace girth::test
