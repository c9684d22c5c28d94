#include "support/models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <queue>
#include <span>
#include <unordered_map>
#include <utility>

#include "girth/io/read_mesh.h"

namespace girth::bench {

namespace {

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  std::fprintf(stderr, "%s: %s\n", path.c_str(), what.c_str());
  std::exit(1);
}

SurfaceMesh surfaceOf(std::span<const double> positions, std::span<const Index> triangles) {
  Result<SurfaceMesh> mesh = SurfaceMesh::fromArrays(positions, triangles);
  if (!mesh) fail("a generated model", mesh.error().message);
  return std::move(mesh).value();
}

/// Halves edges, longest first.
class Refinement {
 public:
  explicit Refinement(const SurfaceMesh& mesh) {
    for (const Vertex v : mesh.vertices()) positions_.push_back(mesh.position(v));
    for (const Face f : mesh.faces()) {
      const auto [a, b, c] = mesh.faceVertices(f);
      addFace({a, b, c});
    };
    for (const Halfedge h : mesh.halfedges()) addEdge(mesh.from(h), mesh.to(h));
  }

  SurfaceMesh to(Index faces) {
    while (faces_.size() < faces) splitLongest();
    std::vector<double> positions;
    for (const Vec3& p : positions_) positions.insert(positions.end(), {p.x, p.y, p.z});
    std::vector<Index> triangles;
    for (const auto& face : faces_) triangles.insert(triangles.end(), face.begin(), face.end());
    return surfaceOf(positions, triangles);
  }

 private:
  struct Edge {
    double length;
    Index a, b;
    bool operator<(const Edge& other) const {
      if (length != other.length) return length < other.length;
      return std::pair(a, b) < std::pair(other.a, other.b);
    }
  };
  static std::uint64_t keyOf(Index a, Index b) { return (std::uint64_t{a} << 32) | b; }

  void setFace(Index face, const std::array<Index, 3>& corners) {
    faces_[face] = corners;
    for (std::size_t k = 0; k < 3; ++k) faceOf_[keyOf(corners[k], corners[(k + 1) % 3])] = face;
  }
  void addFace(const std::array<Index, 3>& corners) {
    faces_.emplace_back();
    setFace(static_cast<Index>(faces_.size() - 1), corners);
  }
  void addEdge(Index a, Index b) {
    if (a > b) return;  // seen from the other side
    const Vec3 &p = positions_[a], &q = positions_[b];
    edges_.push({std::hypot(p.x - q.x, p.y - q.y, p.z - q.z), a, b});
  }
  Index oppositeOf(Index a, Index b) const {
    for (const Index v : faces_[faceOf_.at(keyOf(a, b))]) {
      if (v != a && v != b) return v;
    }
    return kNoIndex;
  }
  /// In [-1, 1]; the same numbers everywhere.
  double random() {
    seed_ = seed_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(seed_ >> 11) / 4503599627370496.0 - 1;
  }

  void splitLongest() {
    const Edge edge = edges_.top();
    edges_.pop();
    const auto [length, a, b] = edge;
    const Index c = oppositeOf(a, b), d = oppositeOf(b, a);
    const Index left = faceOf_.at(keyOf(a, b)), right = faceOf_.at(keyOf(b, a));
    const Vec3 p = positions_[a], q = positions_[b];
    const auto middle = [&, away = 0.02 * length](double s, double t) {
      return (s + t) / 2 + away * random();
    };
    const auto m = static_cast<Index>(positions_.size());
    const double x = middle(p.x, q.x), y = middle(p.y, q.y), z = middle(p.z, q.z);
    positions_.push_back({x, y, z});
    faceOf_.erase(keyOf(a, b));
    faceOf_.erase(keyOf(b, a));
    setFace(left, {a, m, c});
    addFace({m, b, c});
    setFace(right, {b, m, d});
    addFace({m, a, d});
    for (const Index v : {a, b, c, d}) addEdge(v, m);
  }

  std::vector<Vec3> positions_;
  std::vector<std::array<Index, 3>> faces_;
  std::unordered_map<std::uint64_t, Index> faceOf_;  // faces by the two vertices of a halfedge
  std::priority_queue<Edge> edges_;
  std::uint64_t seed_{1};
};

}  // namespace

Model loadModel(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (!file) fail(path, "cannot be read");
  const std::filesystem::path name(path);
  Result<io::LoadedMesh> loaded =
      io::readMesh(std::as_bytes(std::span(text.data(), text.size())), path);
  if (!loaded) fail(path, loaded.error().message);
  return {name.stem().string(), std::move(std::move(loaded).value().mesh)};
}

Model bumpyTorus(Index faces) {
  const auto across = static_cast<Index>(std::lround(std::sqrt(faces / 5.0)));
  const auto around = static_cast<Index>(std::lround(faces / (2.0 * across)));
  std::vector<double> positions;
  std::vector<Index> triangles;
  for (Index i = 0; i < around; ++i) {
    const double u = 2 * std::numbers::pi * i / around;
    for (Index j = 0; j < across; ++j) {
      const double v = 2 * std::numbers::pi * j / across;
      const double tube = 1 + 0.3 * std::sin(3 * u) + 0.05 * std::cos(4 * v + 7 * u);
      const double rho = 4 + tube * std::cos(v);
      positions.insert(positions.end(), {rho * std::cos(u), rho * std::sin(u), tube * std::sin(v)});
      const Index in = (i + 1) % around, jn = (j + 1) % across;
      triangles.insert(triangles.end(), {i * across + j, in * across + j, in * across + jn});
      triangles.insert(triangles.end(), {i * across + j, in * across + jn, i * across + jn});
    }
  }
  SurfaceMesh mesh = surfaceOf(positions, triangles);
  return {"torus_" + std::to_string(mesh.faceCount()), std::move(mesh)};
}

Model refined(const Model& model, Index faces) {
  return {model.name + "_to_" + std::to_string(faces), Refinement(model.mesh).to(faces)};
}

std::string corpusFile(const std::string& path) {
  const char* folder = std::getenv("GIRTH_DATA");
  if (folder == nullptr || *folder == 0) return {};
  return (std::filesystem::path(folder) / path).string();
}

std::vector<Model> modelsOfFiveSizes() {
  std::vector<Model> models;
  if (corpusFile("").empty()) {
    for (const Index faces : {6000u, 10000u, 50000u, 70000u, 97000u}) {
      models.push_back(bumpyTorus(faces));
    }
    return models;
  }
  models.push_back(loadModel(corpusFile("models/horse_6000f.off")));
  models.push_back(loadModel(corpusFile("retrieval/tosca_iso_5k/horse0.off")));
  models.push_back(loadModel(corpusFile("models/elephant_49918f_g3.off")));
  models.push_back(refined(loadModel(corpusFile("models/bunny_28576f.obj")), 70000));
  models.push_back(refined(loadModel(corpusFile("models/horse_39996f.off")), 97000));
  return models;
}

}  // namespace girth::bench
