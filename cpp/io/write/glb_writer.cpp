#include "write/glb_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bytes/append.h"
#include "girth/io/length_unit.h"
#include "text/json_text.h"
#include "text/number_text.h"

namespace girth::io {
namespace {

// The numbers that glTF has for types and targets.
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kVertices = 34962;
constexpr int kIndices = 34963;

std::string numberText(float value) { return formatNumber(static_cast<double>(value)); }

/// ,"min":[...],"max":[...], as floats: the least and greatest of each of some components.
class Bounds {
 public:
  explicit Bounds(std::size_t components)
      : low_(components, std::numeric_limits<float>::max()),
        high_(components, std::numeric_limits<float>::lowest()) {}

  void take(std::size_t component, float value) {
    low_[component] = std::min(low_[component], value);
    high_[component] = std::max(high_[component], value);
  }
  std::string json() const {
    const auto list = [](const std::vector<float>& values) {
      std::string text;
      for (const float value : values) text += (text.empty() ? "" : ",") + numberText(value);
      return "[" + text + "]";
    };
    return ",\"min\":" + list(low_) + ",\"max\":" + list(high_);
  }

 private:
  std::vector<float> low_, high_;
};

}  // namespace

std::size_t GlbWriter::addAccessor(std::size_t begin, std::size_t count, const std::string& type,
                                   int componentType, int target, const std::string& more) {
  views_ += std::string(views_.empty() ? "" : ",") +
            "{\"buffer\":0,\"byteOffset\":" + std::to_string(begin) +
            ",\"byteLength\":" + std::to_string(binary_.size() - begin) +
            ",\"target\":" + std::to_string(target) + "}";
  accessors_ += std::string(accessors_.empty() ? "" : ",") +
                "{\"bufferView\":" + std::to_string(accessorCount_) +
                ",\"componentType\":" + std::to_string(componentType) +
                ",\"count\":" + std::to_string(count) + ",\"type\":\"" + type + "\"" + more + "}";
  return accessorCount_++;
}

void GlbWriter::addAttribute(const std::string& name, std::size_t accessor) {
  attributes_ +=
      (attributes_.empty() ? "" : ",") + jsonString(name) + ":" + std::to_string(accessor);
}

void GlbWriter::addPositions(std::span<const Vec3> positions) {
  const std::size_t begin = binary_.size();
  Bounds bounds(3);
  for (const Vec3& position : positions) {
    const std::array<double, 3> coordinates{position.x, position.y, position.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const float coordinate = nearestFloat(coordinates[k]);
      appendFloat(binary_, coordinate);
      bounds.take(k, coordinate);
    }
  }
  addAttribute("POSITION",
               addAccessor(begin, positions.size(), "VEC3", kFloat, kVertices, bounds.json()));
}

void GlbWriter::addValues(const std::string& attribute, std::span<const double> values) {
  const std::size_t begin = binary_.size();
  Bounds bounds(1);
  for (const double value : values) {
    const float number = std::isnan(value) ? -1 : nearestFloat(value);
    appendFloat(binary_, number);
    bounds.take(0, number);
  }
  addAttribute(attribute,
               addAccessor(begin, values.size(), "SCALAR", kFloat, kVertices, bounds.json()));
}

void GlbWriter::addColours(std::span<const std::uint16_t> channels) {
  const std::size_t begin = binary_.size();
  for (const std::uint16_t channel : channels) appendBytes(binary_, channel, 2);
  addAttribute("COLOR_0", addAccessor(begin, channels.size() / 4, "VEC4", kUnsignedShort, kVertices,
                                      ",\"normalized\":true"));
  coloured_ = true;
}

void GlbWriter::addTriangles(const SurfaceMesh& mesh) {
  const std::size_t begin = binary_.size();
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    for (const Index v : mesh.faceVertices(f)) appendBytes(binary_, v, 4);
  }
  indices_ = ",\"indices\":" + std::to_string(addAccessor(begin, mesh.halfedgeCount(), "SCALAR",
                                                          kUnsignedInt, kIndices, ""));
}

Result<std::string> GlbWriter::file(int mode, std::string_view unit,
                                    const std::string& extras) const {
  const LengthUnit* known = findLengthUnit(unit);
  const double metres = known == nullptr ? 1 : known->metres;
  // Colours show as they are, from both sides.
  const std::string material =
      coloured_ ? ",\"materials\":[{\"doubleSided\":true,\"pbrMetallicRoughness\":"
                  "{\"metallicFactor\":0,\"roughnessFactor\":1}}]"
                : "";
  std::string json =
      "{\"asset\":{\"version\":\"2.0\",\"generator\":\"Girth\"},\"scene\":0,"
      "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0" +
      (metres == 1 ? std::string()
                   : ",\"scale\":[" + formatNumber(metres) + "," + formatNumber(metres) + "," +
                         formatNumber(metres) + "]") +
      "}],\"meshes\":[{\"primitives\":[{\"attributes\":{" + attributes_ + "}" + indices_ +
      ",\"mode\":" + std::to_string(mode) + (coloured_ ? ",\"material\":0" : "") + "}]" +
      (extras.empty() ? "" : ",\"extras\":" + extras) + "}]" + material + ",\"accessors\":[" +
      accessors_ + "],\"bufferViews\":[" + views_ +
      "],\"buffers\":[{\"byteLength\":" + std::to_string(binary_.size()) + "}]}";
  // Chunks end on multiples of four bytes; all views do already.
  while (json.size() % 4 != 0) json += ' ';
  const std::uint64_t length = 12 + 8 + std::uint64_t{json.size()} + 8 + binary_.size();
  if (length > std::numeric_limits<std::uint32_t>::max()) {
    return makeError(ErrorCode::LimitExceeded, -1, "a GLB file holds at most 4 GB");
  }
  std::string content;
  content.reserve(static_cast<std::size_t>(length));
  content += "glTF";
  appendBytes(content, 2, 4);
  appendBytes(content, length, 4);
  appendBytes(content, json.size(), 4);
  content += "JSON" + json;
  appendBytes(content, binary_.size(), 4);
  content += std::string("BIN\0", 4) + binary_;
  return content;
}

}  // namespace girth::io
