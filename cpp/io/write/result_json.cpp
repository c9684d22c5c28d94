#include "girth/io/result_json.h"

#include "write/point_json.h"

namespace girth::io {

ResultJson::ResultJson(std::string_view file, const LoadedMesh& loaded)
    : loaded_(&loaded), isOutermost_(true) {
  add("file", file).add("unit", loaded.unit);
  if (loaded.fewerFaces != 0) add("fewerFaces", loaded.fewerFaces);
}

std::string ResultJson::textOf(const Vec3& point) const {
  JsonList numbers;
  for (const double number : {point.x, point.y, point.z}) numbers.add(numberJson(number));
  return numbers.text();
}

std::string ResultJson::textOf(const SurfacePoint& point) const {
  return pointJson(*loaded_, point);
}

std::string ResultJson::textOf(const std::vector<SurfacePoint>& points) const {
  return pointsJson(*loaded_, points);
}

std::string ResultJson::textOf(const Curve& curve) const {
  return pointsJson(*loaded_, curve.points);
}

std::string ResultJson::textOf(const Line& line) const {
  return positionsJson(*loaded_, line.points);
}

std::string ResultJson::textOf(Vertex vertex) const { return vertexJson(*loaded_, vertex); }

std::string ResultJson::textOf(const std::vector<Vertex>& vertices) const {
  return inputsJson(*loaded_, vertices);
}

std::string ResultJson::textOf(const std::vector<Face>& faces) const {
  return facesJson(*loaded_, faces);
}

std::string ResultJson::textOf(const VertexNumbers& numbers) const {
  return numbersJson(*loaded_, numbers);
}

std::string ResultJson::textOf(const Numbers& numbers) const { return numbersJson(numbers.places); }

}  // namespace girth::io
