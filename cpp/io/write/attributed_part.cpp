#include "write/attributed_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "bytes/append.h"
#include "bytes/bit_cast.h"
#include "text/number_text.h"
#include "text/unit_text.h"
#include "write/point_json.h"

namespace girth::io {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The barycentric coordinates of a point that lies in a face.
std::array<double, 3> sharesIn(const SurfaceMesh& mesh, Face face, const SurfacePoint& point) {
  if (point.kind == SurfacePoint::Kind::InFace) {
    return {point.weights[0], point.weights[1], point.weights[2]};
  }
  const Halfedge h = point.halfedge();
  const auto corners = mesh.faceVertices(face);
  std::array<double, 3> shares{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (h == Halfedge::none) {
      shares[k] = corners[k] == point.vertex() ? 1 : 0;
    } else if (corners[k] == mesh.from(h)) {
      shares[k] = point.weights[0];
    } else if (corners[k] == mesh.to(h)) {
      shares[k] = point.weights[1];
    }
  }
  return shares;
}

/// The value at a point of a face, linear between its corners: as it is at a corner, also beside
/// one without a value.
double valueAt(const Attribute& attribute, Face face, const std::array<double, 3>& shares,
               Index component) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (shares[k] == 0) continue;
    const double value =
        attribute.values[(3 * std::size_t{face} + k) * attribute.width + component];
    if (shares[k] == 1) return value;
    sum += shares[k] * value;
  }
  return sum;
}

/// All numbers of a corner, one attribute after the other.
using Values = std::vector<double>;

/// For each corner of a part.
std::vector<Values> cornerValues(const LoadedMesh& loaded, const CutModel& model,
                                 const SurfaceComponent& part) {
  std::size_t width = 0;
  for (const Attribute& attribute : loaded.attributes) width += attribute.width;
  std::vector<Values> corners(part.mesh.halfedgeCount(), Values(width, kNone));
  std::vector<std::optional<Values>> first(part.mesh.vertexCount());
  for (const Face f : part.mesh.faces()) {
    const Face whole = model.faces[part.faces[f]];
    if (whole == Face::none) continue;
    for (Index k = 0; k < 3; ++k) {
      const Halfedge h = SurfaceMesh::side(f, k);
      const Vertex v = part.mesh.from(h);
      const auto shares = sharesIn(loaded.mesh, whole, model.points[part.vertices[v]]);
      std::size_t at = 0;
      for (const Attribute& attribute : loaded.attributes) {
        for (Index i = 0; i < attribute.width; ++i) {
          corners[h][at++] = valueAt(attribute, whole, shares, i);
        }
      }
      if (!first[v]) first[v] = corners[h];
    }
  }
  // Caps: the values of the rim, and round a middle their mean.
  std::vector<Values> sums(part.mesh.vertexCount());
  std::vector<double> counts(part.mesh.vertexCount(), 0);
  for (const Halfedge h : part.mesh.halfedges()) {
    const Vertex v = part.mesh.from(h), next = part.mesh.to(h);
    if (first[v] || !first[next]) continue;
    sums[v].resize(width, 0);
    for (std::size_t i = 0; i < width; ++i) sums[v][i] += (*first[next])[i];
    counts[v] += 1;
  }
  for (const Halfedge h : part.mesh.halfedges()) {
    if (model.faces[part.faces[SurfaceMesh::faceOf(h)]] != Face::none) continue;
    const Vertex v = part.mesh.from(h);
    if (first[v]) {
      corners[h] = *first[v];
    } else if (counts[v] > 0) {
      for (std::size_t i = 0; i < width; ++i) corners[h][i] = sums[v][i] / counts[v];
    }
  }
  return corners;
}

bool isColour(const Attribute& attribute) { return attribute.name == "COLOR_0"; }
bool isTexture(const Attribute& attribute) { return attribute.name == "TEXCOORD_0"; }

/// A channel of light as a screen has it (sRGB).
double screenOf(double channel) {
  return channel <= 0.0031308 ? channel * 12.92 : 1.055 * std::pow(channel, 1 / 2.4) - 0.055;
}

/// A channel of a vertex's colour as PLY and OBJ have it: on a screen, grey where there is none.
double channelOf(const Attribute& colours, std::size_t vertex, Index channel) {
  constexpr double kGrey = 0.5;
  constexpr Index kAlpha = 3;
  const double value = colours.values[vertex * colours.width + channel];
  if (std::isnan(value)) return channel == kAlpha ? 1 : kGrey;
  return colours.isLinear && channel != kAlpha ? screenOf(value) : value;
}

/// The name of a field in PLY: without its underscore, where nothing else has that name.
std::string plyName(const Attribute& field, const std::vector<Attribute>& attributes) {
  constexpr std::array<std::string_view, 12> kTaken{"x",   "y",     "z",    "nx",    "ny", "nz",
                                                    "red", "green", "blue", "alpha", "s",  "t"};
  const std::string name = field.name.substr(1);
  const bool isTaken = std::find(kTaken.begin(), kTaken.end(), name) != kTaken.end() ||
                       std::any_of(attributes.begin(), attributes.end(),
                                   [&](const Attribute& other) { return other.name == name; });
  return isTaken ? field.name : name;
}

}  // namespace

AttributedPart attributedPart(const LoadedMesh& loaded, const CutModel& model, std::size_t part) {
  const SurfaceComponent& component = model.parts[part];
  const SurfaceMesh& mesh = component.mesh;
  AttributedPart result;
  for (const Vertex v : mesh.vertices()) result.places.push_back(mesh.position(v));
  for (const Halfedge h : mesh.halfedges()) result.triangles.push_back(mesh.from(h));
  if (loaded.attributes.empty()) return result;
  const std::vector<Values> corners = cornerValues(loaded, model, component);
  // The numbers of vertices by the values that they stand with, as bits, which equal themselves.
  std::map<std::pair<Index, std::vector<std::uint64_t>>, Index> numbers;
  std::vector<bool> isTaken(mesh.vertexCount(), false);
  std::vector<Values> values(mesh.vertexCount());
  for (const Halfedge h : mesh.halfedges()) {
    const Vertex v = mesh.from(h);
    std::vector<std::uint64_t> bits;
    for (const double value : corners[h]) bits.push_back(bitCast<std::uint64_t>(value));
    const auto next = isTaken[v] ? static_cast<Index>(result.places.size()) : Index{v};
    const auto [place, isNew] = numbers.try_emplace({v, std::move(bits)}, next);
    if (isNew) {
      if (isTaken[v]) {
        result.places.push_back(mesh.position(v));
        values.emplace_back();
      }
      isTaken[v] = true;
      values[place->second] = corners[h];
    }
    result.triangles[h] = place->second;
  }
  std::size_t begin = 0;
  for (const Attribute& attribute : loaded.attributes) {
    result.attributes.push_back({attribute.name, attribute.width, attribute.isLinear, {}});
    for (const Values& of : values) {
      for (Index i = 0; i < attribute.width; ++i) {
        result.attributes.back().values.push_back(of[begin + i]);
      }
    }
    begin += attribute.width;
  }
  return result;
}

void appendObj(const AttributedPart& part, std::size_t before, std::string& text) {
  const auto find = [&](bool (*is)(const Attribute&)) {
    const auto found = std::find_if(part.attributes.begin(), part.attributes.end(), is);
    return found == part.attributes.end() ? nullptr : &*found;
  };
  const Attribute* colour = find(isColour);
  const Attribute* texture = find(isTexture);
  for (std::size_t v = 0; v < part.places.size(); ++v) {
    text += "v " + pointText(part.places[v], ' ');
    for (Index i = 0; colour != nullptr && i < 3; ++i) {
      text += " " + formatNumber(channelOf(*colour, v, i));
    }
    text += "\n";
  }
  for (std::size_t v = 0; texture != nullptr && v < part.places.size(); ++v) {
    const double s = texture->values[2 * v], t = texture->values[2 * v + 1];
    text += "vt " + formatNumber(std::isnan(s) ? 0 : s) + " " +
            formatNumber(std::isnan(t) ? 0 : t) + "\n";
  }
  for (std::size_t i = 0; i < part.triangles.size(); i += 3) {
    text += "f";
    for (std::size_t k = i; k < i + 3; ++k) {
      const std::string number = std::to_string(before + part.triangles[k] + 1);
      text += " " + number + (texture != nullptr ? "/" + number : "");
    }
    text += "\n";
  }
}

std::string plyFile(const AttributedPart& part, std::string_view unit) {
  constexpr double kMost = 255;
  std::string content = "ply\nformat binary_little_endian 1.0\n" + unitComment("comment", unit) +
                        "element vertex " + std::to_string(part.places.size()) +
                        "\nproperty double x\nproperty double y\nproperty double z\n";
  constexpr std::array kChannels{"red", "green", "blue", "alpha"};
  for (const Attribute& attribute : part.attributes) {
    if (isColour(attribute)) {
      for (Index i = 0; i < attribute.width; ++i) {
        content += std::string("property uchar ") + kChannels[i] + "\n";
      }
    } else if (isTexture(attribute)) {
      content += "property double s\nproperty double t\n";
    } else {
      content += "property double " + plyName(attribute, part.attributes) + "\n";
    }
  }
  content += "element face " + std::to_string(part.triangles.size() / 3) +
             "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t v = 0; v < part.places.size(); ++v) {
    for (const double x : {part.places[v].x, part.places[v].y, part.places[v].z}) {
      appendDouble(content, x);
    }
    for (const Attribute& attribute : part.attributes) {
      for (Index i = 0; i < attribute.width; ++i) {
        if (isColour(attribute)) {
          const double value = std::clamp(channelOf(attribute, v, i), 0.0, 1.0);
          appendBytes(content, static_cast<std::uint64_t>(std::round(kMost * value)), 1);
        } else {
          appendDouble(content, attribute.values[v * attribute.width + i]);
        }
      }
    }
  }
  for (std::size_t i = 0; i < part.triangles.size(); i += 3) {
    appendBytes(content, 3, 1);
    for (std::size_t k = i; k < i + 3; ++k) appendBytes(content, part.triangles[k], 4);
  }
  return content;
}

}  // namespace girth::io
