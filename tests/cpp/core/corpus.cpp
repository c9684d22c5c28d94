#include "corpus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <utility>

#include "girth/io/read_mesh.h"
#include "shapes.h"
#include "test_paths.h"

namespace girth::test {

namespace {

std::filesystem::path modelFolder() {
  const std::string data = corpusFolder();
  return data.empty() ? std::filesystem::path() : std::filesystem::path(data) / "models";
}

/// The text format of the Object File Format, triangles only.
Shape readOff(std::istream& file) {
  Shape shape;
  std::string magic;
  Index vertices = 0, faces = 0, edges = 0;
  file >> magic >> vertices >> faces >> edges;
  shape.positions.resize(3 * static_cast<std::size_t>(vertices));
  shape.triangles.resize(3 * static_cast<std::size_t>(faces));
  for (double& x : shape.positions) file >> x;
  for (std::size_t i = 0; i < shape.triangles.size(); ++i) {
    Index corners = 0;
    if (i % 3 == 0) file >> corners;
    file >> shape.triangles[i];
  }
  EXPECT_TRUE(magic.ends_with("OFF") && file);  // some begin with a byte order mark
  return shape;
}

}  // namespace

bool corpusIsThere() { return !modelFolder().empty(); }

std::vector<std::string> corpusModels(Index mostFaces) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(modelFolder())) {
    // name_facesf_genus.obj
    const std::string name = entry.path().filename().string();
    const std::size_t faces = name.find('_');
    if (faces == std::string::npos || name.find("OPEN") != std::string::npos) continue;
    if (std::strtoul(name.c_str() + faces + 1, nullptr, 10) <= mostFaces) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

SurfaceMesh corpusModel(const std::string& name) {
  std::ifstream file(modelFolder() / name, std::ios::binary);
  EXPECT_TRUE(file) << name;
  if (name.ends_with(".off")) return readOff(file).mesh();
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  auto loaded = io::readMesh(std::as_bytes(std::span(text)), name);
  if (loaded) return std::move(loaded).value().mesh;
  ADD_FAILURE() << loaded.error().message;
  return tetrahedron().mesh();
}

}  // namespace girth::test
