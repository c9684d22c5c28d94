#include "girth/io/read_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "girth/transfer.h"
#include "text/number_text.h"
#include "text/words.h"

namespace girth::io {
namespace {

using Json = nlohmann::json;

Error noCurves(const std::string& what) {
  Error error = makeError(ErrorCode::MalformedFile, -1, what);
  error.hint =
      "use a .json file that girth loop, necks, handles, bottleneck or tighten has written";
  return error;
}

Error atPoint(std::size_t place, const std::string& what) {
  return makeError(ErrorCode::InvalidPoint, static_cast<std::int64_t>(place),
                   "point " + std::to_string(place) + " of the curve " + what);
}

class CurveReader {
 public:
  explicit CurveReader(const LoadedMesh& loaded) : loaded_(loaded) {}

  Result<SurfaceCurve> curve(const Json& object) const {
    const auto points = object.is_object() ? object.find("points") : object.end();
    if (!object.is_object() || points == object.end() || !points->is_array()) {
      return noCurves("a curve has no array \"points\"");
    }
    SurfaceCurve result;
    for (const Json& point : *points) {
      auto read = this->point(point, result.size());
      if (!read) return read.error();
      result.push_back(read.value());
    }
    return result;
  }

 private:
  Result<SurfacePoint> point(const Json& object, std::size_t place) const {
    if (!object.is_object() || !object.contains("vertices") || !object.contains("weights")) {
      return noCurves("point " + std::to_string(place) +
                      " of a curve has no \"vertices\" and \"weights\"");
    }
    const Json &vertices = object["vertices"], &weights = object["weights"];
    const std::size_t count = vertices.is_array() ? vertices.size() : 0;
    if (count < 1 || count > 3 || !weights.is_array() || weights.size() != count) {
      return noCurves("point " + std::to_string(place) +
                      " of a curve has not one, two or three vertices with a weight each");
    }
    std::array<Vertex, 3> corners{};
    std::array<double, 3> shares{};
    for (std::size_t i = 0; i < count; ++i) {
      const auto vertex = vertexOf(vertices[i]);
      if (!vertex) return atPoint(place, "names a vertex that the model does not have");
      if (!weights[i].is_number()) {
        return noCurves("a weight of point " + std::to_string(place) + " is no number");
      }
      corners[i] = *vertex;
      shares[i] = weights[i].get<double>();
    }
    if (count == 1) return SurfacePoint::atVertex(corners[0]);
    const SurfaceMesh& mesh = loaded_.mesh;
    const Halfedge start = mesh.outgoing(corners[0]);
    for (Halfedge h = start;;) {
      const Face face = SurfaceMesh::faceOf(h);
      if (count == 2) {
        if (mesh.to(h) == corners[1]) return SurfacePoint::onHalfedge(h, shares[1]);
        const Halfedge back = SurfaceMesh::previous(h);
        if (mesh.from(back) == corners[1]) return SurfacePoint::onHalfedge(back, shares[0]);
      } else {
        const auto own = mesh.faceVertices(face);
        std::array<double, 3> ordered{};
        bool isHere = true;
        for (std::size_t i = 0; i < 3; ++i) {
          const auto at = std::find(own.begin(), own.end(), corners[i]);
          isHere = isHere && at != own.end();
          if (isHere) ordered[static_cast<std::size_t>(at - own.begin())] = shares[i];
        }
        if (isHere) return SurfacePoint::inFace(face, ordered);
      }
      h = mesh.twin(SurfaceMesh::previous(h));
      if (h == Halfedge::none || h == start) break;
    }
    return atPoint(place, count == 2 ? "lies on an edge that the model does not have"
                                     : "lies in a face that the model does not have");
  }

  std::optional<Vertex> vertexOf(const Json& number) const {
    if (!number.is_number_unsigned()) return std::nullopt;
    const auto input = number.get<std::uint64_t>();
    if (input >= loaded_.vertexOfInput.size()) return std::nullopt;
    const Vertex vertex(loaded_.vertexOfInput[static_cast<std::size_t>(input)]);
    if (vertex == Vertex::none) return std::nullopt;
    return vertex;
  }

  const LoadedMesh& loaded_;
};

/// The farthest that a point of a curve may lie beside the surface, as a share of the diagonal.
constexpr double kMostBeside = 1e-3;

Error atLine(std::int64_t line, const std::string& what) {
  return makeError(ErrorCode::MalformedFile, line, "line " + std::to_string(line) + ": " + what);
}

/// Vertices and lines of an OBJ file.
class ObjLines {
 public:
  explicit ObjLines(std::string_view obj) : words_(obj, '#', Words::Continuation::JoinsLines) {}

  /// The places of each line.
  Result<std::vector<std::vector<Vec3>>> read() {
    for (;;) {
      const std::string_view keyword = words_.next();
      if (keyword.empty()) break;
      std::optional<Error> error;
      if (keyword == "v") error = readVertex();
      if (keyword == "l") error = readLine();
      if (error) return *std::move(error);
      words_.skipLine();
    }
    if (lines_.empty() && !vertices_.empty()) {
      for (std::size_t i = 0; i < vertices_.size(); ++i) appendTo(i);
    }
    std::vector<std::vector<Vec3>> places;
    for (const std::vector<std::size_t>& line : lines_) {
      std::vector<Vec3>& own = places.emplace_back();
      for (const std::size_t vertex : line) own.push_back(vertices_[vertex]);
    }
    return places;
  }

 private:
  void appendTo(std::size_t vertex) {
    if (lines_.empty()) lines_.emplace_back();
    lines_.back().push_back(vertex);
  }

  std::optional<Error> readVertex() {
    std::array<double, 3> position{};
    for (double& coordinate : position) {
      const auto number = parseNumber(words_.nextOnLine());
      if (!number || !std::isfinite(*number)) {
        return atLine(words_.line(), "a vertex without three numbers");
      }
      coordinate = *number;
    }
    vertices_.push_back({position[0], position[1], position[2]});
    return std::nullopt;
  }

  std::optional<Error> readLine() {
    std::vector<std::size_t> line;
    for (;;) {
      const std::string_view word = words_.nextOnLine();
      if (word.empty()) break;
      // A number, with that of a texture's vertex behind it, or counted from the end.
      const auto number = parseInteger(word.substr(0, word.find('/')));
      const auto count = static_cast<std::int64_t>(vertices_.size());
      const std::int64_t index = !number ? -1 : *number < 0 ? count + *number : *number - 1;
      if (index < 0 || index >= count) {
        return atLine(words_.line(), "a line through a vertex that does not stand before it");
      }
      line.push_back(static_cast<std::size_t>(index));
    }
    if (line.size() < 2) return atLine(words_.line(), "a line of fewer than two vertices");
    if (!lines_.empty() && lines_.back().back() == line.front() &&
        lines_.back().front() != line.front()) {
      lines_.back().insert(lines_.back().end(), line.begin() + 1, line.end());
    } else {
      lines_.push_back(std::move(line));
    }
    return std::nullopt;
  }

  Words words_;
  std::vector<Vec3> vertices_;
  std::vector<std::vector<std::size_t>> lines_;
};

double diagonalOf(const SurfaceMesh& mesh) {
  Vec3 low = mesh.position(Vertex(0)), high = low;
  for (const Vertex v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return std::hypot(high.x - low.x, high.y - low.y, high.z - low.z);
}

}  // namespace

Result<std::vector<SurfaceCurve>> readCurvesObj(std::string_view obj, const LoadedMesh& loaded) {
  const auto lines = ObjLines(obj).read();
  if (!lines) return lines.error();
  const double most = kMostBeside * diagonalOf(loaded.mesh);
  std::vector<SurfaceCurve> curves;
  for (const std::vector<Vec3>& places : lines.value()) {
    SurfaceCurve curve = nearestPoints(loaded.mesh, places);
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Vec3 at = positionOf(loaded.mesh, curve[i]), &meant = places[i];
      if (std::hypot(at.x - meant.x, at.y - meant.y, at.z - meant.z) <= most) continue;
      Error error = atPoint(i, "does not lie on the surface");
      error.hint = "draw the curve on this model, in its unit";
      return error;
    }
    curves.push_back(std::move(curve));
  }
  if (!curves.empty()) return curves;
  Error error = makeError(ErrorCode::MalformedFile, -1, "the file has no line");
  error.hint = "write vertices, and lines as \"l 1 2 3\"";
  return error;
}

Result<std::vector<SurfaceCurve>> readCurves(std::string_view json, const LoadedMesh& loaded) {
  const Json document = Json::parse(json, nullptr, false);
  if (document.is_discarded()) return noCurves("it is no JSON");
  if (!document.is_object()) return noCurves("it is no JSON object");
  std::vector<const Json*> objects;
  bool hasList = false;
  for (const char* list : {"necks", "handles", "loops", "distances"}) {
    const auto found = document.find(list);
    if (found == document.end()) continue;
    hasList = true;
    if (!found->is_array()) return noCurves(std::string("\"") + list + "\" is no array");
    for (const Json& one : *found) objects.push_back(&one);
  }
  if (!hasList) objects.push_back(&document);
  const CurveReader reader(loaded);
  std::vector<SurfaceCurve> curves;
  for (const Json* object : objects) {
    auto curve = reader.curve(*object);
    if (!curve) return curve.error();
    curves.push_back(std::move(curve).value());
  }
  return curves;
}

}  // namespace girth::io
