#include "girth/io/read_curves.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace girth::io {
namespace {

using Json = nlohmann::json;

Error noCurves(const std::string& what) {
  Error error = makeError(ErrorCode::MalformedFile, -1, what);
  error.hint = "use a .json file that girth loop, necks, handles or bottleneck has written";
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

}  // namespace

Result<std::vector<SurfaceCurve>> readCurves(std::string_view json, const LoadedMesh& loaded) {
  const Json document = Json::parse(json, nullptr, false);
  if (document.is_discarded()) return noCurves("it is no JSON");
  if (!document.is_object()) return noCurves("it is no JSON object");
  std::vector<const Json*> objects;
  bool hasList = false;
  for (const char* list : {"necks", "handles", "loops"}) {
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
