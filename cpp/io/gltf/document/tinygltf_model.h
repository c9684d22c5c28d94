// tinygltf behind guards: what it reads and what it writes.
//
// tinygltf 2.7 reads the elements of a document and data: URIs, and writes GLB. Untrusted files
// reach it only through the functions below, because of what it does with them:
//   - It opens any file that a document names, "../" included. It is compiled without a file
//     system, and no buffer reaches it.
//   - It recurses into nested JSON without a bound, and parses the text once more. geometryJson
//     bounds the nesting and parses the text; tinygltf gets the elements that were checked.
//   - It reads 8 bytes beyond a GLB whose last chunk is too long, and refuses chunks of other
//     kinds, unaligned ones and padding, which are valid. openGlb reads the container.
//   - It throws on an embedded buffer of 0 bytes, and gives every buffer without a uri the binary
//     chunk. Only buffer 0 is read from there.
//   - It reads all buffers at once and refuses the document where one is missing, where a file is
//     longer than it needs to be, or where a data: URI has a media type that it does not know, is
//     not base64, or uses the digits of URLs. Buffers are read one by one when they are asked for.
//   - It refuses documents for images, materials, animations and cameras that nobody asks for, and
//     reads beyond buffers for images. geometryJson leaves them out.
//   - It refuses strides that are not multiples of 4: they are set after it has read the view. It
//     refuses indices without a buffer view, as Draco has them, where it reads a whole document.
//   - It takes whole numbers written as 3.0 for none, and cuts integers to 32 bits without a word.
//     geometryJson writes them in the ranges that it holds.
//   - Its errors name neither a place nor a byte. geometryJson and openGlb report what is wrong
//     before it reads, and the answer to what it refuses nevertheless is INTERNAL.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "gltf/document/geometry_json.h"
#include "gltf/document/tinygltf.h"

namespace girth::io {

/// The model of a checked document, whose JSON is consumed. `binary`: the GLB's binary chunk; its
/// first bytes become buffer 0 where that has no uri. All other buffers are still empty.
Result<tinygltf::Model> loadModel(GeometryJson& document, std::span<const std::byte> binary);

/// A buffer with a copy of the bytes.
tinygltf::Buffer bufferOf(std::span<const std::byte> bytes);

/// A buffer with the content of a data: URI; nothing where the URI is not valid.
std::optional<tinygltf::Buffer> bufferOfData(std::string_view uri);

/// JSON text as a value for "extras"; numbers are doubles, since integers have 32 bits.
tinygltf::Value valueOf(std::string_view json);

/// The model as a GLB file, with buffer 0 as its binary chunk. Error: LIMIT_EXCEEDED where it would
/// pass 4 GB.
Result<std::string> glbOf(const tinygltf::Model& model);

/// A URI's percent escapes undone.
std::string percentDecoded(std::string_view uri);

}  // namespace girth::io
