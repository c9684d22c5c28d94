#include "checks.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace girth::fuzz {

void demand(bool condition, const std::string& rule) {
  if (condition) return;
  std::fprintf(stderr, "broken: %s\n", rule.c_str());
  std::abort();
}

void check(const Error& error) {
  demand(error.code != ErrorCode::Internal, "no internal errors: " + error.message);
  demand(!error.message.empty() && !error.hint.empty(), "errors say what, and what to do");
  demand(error.message.find('\n') == std::string::npos, "messages are one line");
  demand(error.message.size() < 400, "messages are short: " + error.message);
}

namespace {

void checkNotes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) {
    demand(!note.empty() && note.find('\n') == std::string::npos, "notes are one line");
  }
}

}  // namespace

std::span<const std::byte> bytesOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const std::byte*>(data), size};
}

std::optional<std::vector<std::byte>> resource(std::string_view name) {
  if (name.size() < 4 || name.substr(name.size() - 4) != ".bin") return std::nullopt;
  constexpr std::size_t kSize = 512;
  std::vector<std::byte> content(kSize);
  for (std::size_t i = 0; i < kSize; ++i) content[i] = static_cast<std::byte>(i % 7);
  return content;
}

int check(const Result<io::ReadModel>& model) {
  if (!model) {
    check(model.error());
    return 0;
  }
  const TriangleSoup& soup = model.value().soup;
  demand(soup.positions.size() % 3 == 0, "three coordinates a vertex");
  demand(soup.triangles.size() % 3 == 0 && !soup.triangles.empty(), "whole triangles");
  for (const Index vertex : soup.triangles) {
    demand(vertex < soup.positions.size() / 3, "triangles name vertices");
    for (std::size_t k = 0; k < 3; ++k) {
      demand(std::isfinite(soup.positions[3 * std::size_t{vertex} + k]),
             "their vertices are finite");
    }
  }
  checkNotes(model.value().notes);
  return 0;
}

int check(const Result<io::LoadedMesh>& loaded) {
  if (!loaded) {
    check(loaded.error());
    return 0;
  }
  const io::LoadedMesh& mesh = loaded.value();
  demand(mesh.inputOfVertex.size() == mesh.mesh.vertexCount(), "every vertex comes from somewhere");
  demand(mesh.inputOfFace.size() == mesh.mesh.faceCount(), "every face comes from somewhere");
  for (const Index vertex : mesh.vertexOfInput) {
    demand(vertex == kNoIndex || vertex < mesh.mesh.vertexCount(), "vertices of the surface");
  }
  for (const Index vertex : mesh.inputOfVertex) {
    demand(vertex == kNoIndex || vertex < mesh.vertexOfInput.size(), "vertices of the file");
  }
  for (const Halfedge h : mesh.mesh.halfedges()) {
    demand(mesh.mesh.length(h) > 0 && std::isfinite(mesh.mesh.length(h)), "edges have a length");
  }
  checkNotes(mesh.notes);
  return 0;
}

}  // namespace girth::fuzz
