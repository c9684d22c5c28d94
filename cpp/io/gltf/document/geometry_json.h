// Checks a glTF document and reduces it to its geometry.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "girth/error.h"

namespace girth::io {

/// Where a buffer's bytes come from.
struct GltfBufferSource {
  /// A data: URI or a relative name; empty: the GLB's binary chunk.
  std::string uri;
  /// How many bytes the document promises.
  std::uint64_t byteLength{0};
};

/// Red, green, blue and alpha, in proportion to light.
using GltfColour = std::array<double, 4>;
constexpr GltfColour kGltfWhite{1, 1, 1, 1};

/// The geometry of a document as JSON whose elements tinygltf reads as they are meant.
struct GeometryJson {  // NOLINT(bugprone-exception-escape): its JSON throws nothing when it is
                       // moved
  /// The document's lists, as far as they matter for the surface, and its default scene.
  nlohmann::json geometry;
  /// The buffers, which are no part of `geometry`.
  std::vector<GltfBufferSource> buffers;
  /// How many bytes of the binary chunk buffer 0 holds; 0 where it is not in the chunk.
  std::size_t embeddedBytes{0};
  /// The base colour of each material: white where it states none, or none that can be.
  std::vector<GltfColour> baseColours;
  /// Whether the extras of some mesh state, as Girth writes them, that its unit is none that is
  /// known: then its numbers are no metres.
  bool isUnitUnknown{false};
  /// Content of the document that no surface keeps, as "materials and textures".
  std::string leftOut;
};

/// Whether an attribute of that name says something of points besides where they are: colours,
/// texture coordinates, and what an application calls `_NAME`.
bool isExtraAttribute(std::string_view name);

/// Parses JSON text that begins at byte `firstByte` of the file and checks the type and the range
/// of every member that matters for the surface; no number is checked against another. The result
/// holds these members alone, whole numbers as integers, and the numbers of extra attributes and of
/// materials, as far as they are numbers. `binaryBytes`: the size of the GLB's
/// binary chunk, 0 where there is none.
///
/// An instancing attribute that is not given is -1, because tinygltf drops empty objects.
///
/// Errors name the place as a JSON pointer, or the byte where the text is not JSON: UNKNOWN_FORMAT
/// (JSON, but not glTF), MALFORMED_FILE, UNSUPPORTED_FEATURE (glTF 1.0, or an extension without
/// which the geometry cannot be read), LIMIT_EXCEEDED.
Result<GeometryJson> geometryJson(std::string_view text, std::size_t firstByte,
                                  std::size_t binaryBytes);

}  // namespace girth::io
