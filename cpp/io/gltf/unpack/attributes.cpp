#include "gltf/unpack/attributes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "gltf/document/fault.h"
#include "text/quoted_name.h"

namespace girth::io {
namespace {

constexpr const char* kColour = "COLOR_0";
constexpr const char* kTexture = "TEXCOORD_0";

/// Reads one attribute after the other.
class AttributeReader {
 public:
  AttributeReader(const GltfDocument& document, PointNumbers& points,
                  const std::vector<PlacedPrimitive>& placed, const std::vector<Index>& triangles)
      : document_(document), points_(points), placed_(placed), triangles_(triangles) {}

  const GltfPrimitive& primitiveOf(const PlacedPrimitive& placed) const {
    return document_.primitives[placed.mesh][placed.primitive];
  }

  GltfColour baseColourOf(const GltfPrimitive& primitive) const {
    const auto& colours = document_.baseColours;
    return primitive.material && *primitive.material < colours.size() ? colours[*primitive.material]
                                                                      : kGltfWhite;
  }

  /// Numbers of each value.
  Index widthOf(const std::string& name) const {
    if (name == kTexture) return 2;
    if (name != kColour) return 1;
    for (const PlacedPrimitive& placed : placed_) {
      const GltfPrimitive& primitive = primitiveOf(placed);
      if (shapeOf(name, primitive) == TINYGLTF_TYPE_VEC4) return 4;
      if (baseColourOf(primitive).back() != 1) return 4;
    }
    return 3;
  }

  /// `missing`: the primitives, each time that they are placed, without a value.
  std::optional<Error> read(const std::string& name, Attribute& attribute, std::size_t& missing) {
    attribute = {name, widthOf(name), name == kColour, {}, {}};
    attribute.corners.assign(triangles_.size(), kNoIndex);
    firsts_.clear();
    missing = 0;
    for (const PlacedPrimitive& placed : placed_) {
      const GltfPrimitive& primitive = primitiveOf(placed);
      const bool isGiven = primitive.extras.count(name) > 0;
      missing += isGiven ? 0 : 1;
      if (!isGiven && name != kColour) continue;
      const auto first =
          isGiven ? valuesOf(placed, attribute) : Result<Index>(plainColour(primitive, attribute));
      if (!first) return first.error();
      for (std::size_t c = placed.firstCorner; c < placed.endCorner; ++c) {
        attribute.corners[c] = first.value() + (isGiven ? triangles_[c] - placed.firstPoint : 0);
      }
    }
    return std::nullopt;
  }

 private:
  /// Accessor, packed mesh and number in it, and the colour that values are multiplied by.
  using Key = std::tuple<GltfReference, const DracoMesh*, GltfReference, GltfColour>;

  int shapeOf(const std::string& name, const GltfPrimitive& primitive) const {
    const auto found = primitive.extras.find(name);
    const auto& accessors = document_.model.accessors;
    return found == primitive.extras.end() || found->second >= accessors.size()
               ? TINYGLTF_TYPE_SCALAR
               : accessors[found->second].type;
  }

  /// The number of the one value of a primitive without colours of its own.
  Index plainColour(const GltfPrimitive& primitive, Attribute& attribute) {
    const GltfColour colour = baseColourOf(primitive);
    const auto next = static_cast<Index>(attribute.values.size() / attribute.width);
    const auto [place, isNew] = firsts_.try_emplace({std::nullopt, nullptr, {}, colour}, next);
    if (isNew) {
      attribute.values.insert(attribute.values.end(), colour.begin(),
                              colour.begin() + attribute.width);
    }
    return place->second;
  }

  /// The number of the first of a primitive's values, which are read where they are new.
  Result<Index> valuesOf(const PlacedPrimitive& placed, Attribute& attribute) {
    const GltfPrimitive& primitive = primitiveOf(placed);
    PointSource source{primitive.extras.at(attribute.name), placed.packed, std::nullopt};
    if (primitive.draco) {
      const auto found = primitive.draco->extras.find(attribute.name);
      if (found != primitive.draco->extras.end()) source.packedNumber = found->second;
    }
    const bool isColour = attribute.name == kColour;
    const GltfColour factor = isColour ? baseColourOf(primitive) : kGltfWhite;
    const bool isPacked = source.packed != nullptr && source.packedNumber;
    const Key key{source.accessor, isPacked ? source.packed : nullptr, source.packedNumber, factor};
    if (const auto known = firsts_.find(key); known != firsts_.end()) return known->second;

    const std::string user = "/meshes/" + std::to_string(placed.mesh) + "/primitives/" +
                             std::to_string(placed.primitive) + "/attributes/" + attribute.name;
    const bool isOpaque = isColour && shapeOf(attribute.name, primitive) == TINYGLTF_TYPE_VEC3;
    const int shape = isColour               ? (isOpaque ? TINYGLTF_TYPE_VEC3 : TINYGLTF_TYPE_VEC4)
                      : attribute.width == 2 ? TINYGLTF_TYPE_VEC2
                                             : TINYGLTF_TYPE_SCALAR;
    std::vector<double> numbers;
    std::size_t count = placed.pointCount;
    if (auto error = points_.append(source, shape, user, count, numbers)) return *error;
    const tinygltf::Accessor& accessor = document_.model.accessors[source.accessor];
    const bool isFloat = accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT ||
                         accessor.componentType == TINYGLTF_COMPONENT_TYPE_DOUBLE;
    if (isColour && !isFloat && !accessor.normalized) {
      return faultAt(user, "holds neither floats nor normalized integers");
    }
    const std::size_t first = attribute.values.size() / attribute.width;
    if (first + count >= kNoIndex) {
      return makeError(ErrorCode::LimitExceeded, -1, user + ": has more than 4 billion values");
    }
    const std::size_t given = componentsOf(shape);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < attribute.width; ++k) {
        double number = k < given ? numbers[given * i + k] : 1;
        if (isColour) number *= factor[k];
        attribute.values.push_back(
            std::isfinite(number) ? number : std::numeric_limits<double>::quiet_NaN());
      }
    }
    return firsts_.emplace(key, static_cast<Index>(first)).first->second;
  }

  const GltfDocument& document_;
  PointNumbers& points_;
  const std::vector<PlacedPrimitive>& placed_;
  const std::vector<Index>& triangles_;
  /// The places where values of the attribute begin that were read before.
  std::map<Key, Index> firsts_;
};

/// `_A, _B and 3 more`.
std::string listOf(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) {
    text += (i == 0 ? "" : ", ") + inQuotes(names[i]);
  }
  if (names.size() > kMost) text += " and " + std::to_string(names.size() - kMost) + " more";
  return text;
}

}  // namespace

bool isKeptAttribute(std::string_view name) {
  constexpr std::size_t kLongest = 64;
  if (name == kColour || name == kTexture) return true;
  return name.size() > 1 && name.size() <= kLongest && name[0] == '_' &&
         std::all_of(name.begin(), name.end(), [](char c) { return c > ' ' && c <= '~'; });
}

GltfAttributes attributesOf(const GltfDocument& document, PointNumbers& points,
                            const SoupBudget& budget, const std::vector<PlacedPrimitive>& placed,
                            const std::vector<Index>& triangles) {
  constexpr std::size_t kMostScalars = 16;
  // Any attributes of a small model; of a large one, several for each vertex that its file stores.
  constexpr std::uint64_t kFreeNumbers = 16'000'000, kNumbersPerByte = 16;

  AttributeReader reader(document, points, placed, triangles);
  bool hasColours = false, hasTexture = false;
  std::set<std::string> scalars, others;
  for (const PlacedPrimitive& one : placed) {
    const GltfPrimitive& primitive = reader.primitiveOf(one);
    hasColours = hasColours || reader.baseColourOf(primitive) != kGltfWhite;
    for (const auto& [name, accessor] : primitive.extras) {
      hasColours = hasColours || name == kColour;
      hasTexture = hasTexture || name == kTexture;
      if (name != kColour && name != kTexture)
        (isKeptAttribute(name) ? scalars : others).insert(name);
    }
  }
  std::vector<std::string> names, leftOut(others.begin(), others.end());
  if (hasColours) names.emplace_back(kColour);
  if (hasTexture) names.emplace_back(kTexture);
  std::size_t count = 0;
  for (const std::string& name : scalars) {
    (++count <= kMostScalars ? names : leftOut).push_back(name);
  }

  GltfAttributes result;
  std::uint64_t left = kFreeNumbers + kNumbersPerByte * budget.bytes();
  for (const std::string& name : names) {
    const std::uint64_t numbers = std::uint64_t{triangles.size()} * reader.widthOf(name);
    if (numbers > left) {
      leftOut.push_back(name);
      continue;
    }
    Attribute attribute;
    std::size_t missing = 0;
    if (const auto error = reader.read(name, attribute, missing)) {
      result.notes.push_back("The attribute " + inQuotes(name) + " is left out: " + error->message +
                             ".");
      continue;
    }
    left -= numbers;
    if (missing > 0 && name != kColour) {
      result.notes.push_back("The attribute " + inQuotes(name) + " has no value in " +
                             std::to_string(missing) + " of " + std::to_string(placed.size()) +
                             " primitives.");
    }
    result.attributes.push_back(std::move(attribute));
  }
  if (!leftOut.empty()) {
    result.notes.push_back((leftOut.size() == 1 ? "The attribute " : "The attributes ") +
                           listOf(leftOut) + (leftOut.size() == 1 ? " is" : " are") + " left out.");
  }
  return result;
}

}  // namespace girth::io
