#include "girth/io/read_mesh.h"

#include <algorithm>
#include <array>
#include <new>
#include <string>
#include <utility>

#include "glb_container.h"
#include "read_gltf.h"
#include "read_obj.h"
#include "text.h"

namespace girth::io {
namespace {

/// The name's ending in lower case, without the dot.
std::string extensionOf(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos || name.find_first_of("/\\", dot) != std::string_view::npos) {
    return {};
  }
  std::string extension(name.substr(dot + 1));
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension;
}

bool beginsWith(std::string_view text, std::string_view prefix) {
  return text.substr(0, prefix.size()) == prefix;
}

/// Formats that people are likely to try, by their first bytes.
std::string_view knownForeignFormat(std::string_view text) {
  struct Mark {
    std::string_view prefix, name;
  };
  constexpr std::array<Mark, 15> kMarks{{
      {"ply\n", "PLY"},
      {"ply\r", "PLY"},
      {"solid ", "STL"},
      {"OFF", "OFF"},
      {"COFF", "OFF"},
      {"STOFF", "OFF"},
      {"NOFF", "OFF"},
      {"PK\x03\x04", "zip (3MF, USDZ or an archive)"},
      {"\x1F\x8B", "gzip"},
      {"Kaydara FBX", "FBX"},
      {"; FBX", "FBX"},
      {"BLENDER", "Blender"},
      {"DRACO", "Draco"},
      {"<?xml", "XML (COLLADA or X3D)"},
      {"<", "XML or HTML"},
  }};
  for (const Mark& mark : kMarks) {
    if (beginsWith(text, mark.prefix)) return mark.name;
  }
  return {};
}

/// Whether the first line that says anything could be OBJ. `certain`: such a line was seen.
bool looksLikeObj(std::string_view text, bool& certain) {
  certain = false;
  // Binary files may begin with any letter.
  constexpr std::size_t kSample = 4096;
  if (text.substr(0, kSample).find('\0') != std::string_view::npos) return false;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos || line[first] == '#') continue;
    certain = isObjLine(line);
    return certain;
  }
  return true;
}

Error unknownFormat(std::string_view text, std::string_view name) {
  const std::string extension = extensionOf(name);
  const auto error = [](std::string message) {
    return makeError(ErrorCode::UnknownFormat, -1, std::move(message));
  };
  if (const auto foreign = knownForeignFormat(text); !foreign.empty()) {
    return error("the file looks like " + std::string(foreign) + ", which is not read");
  }
  if (extension == "glb") {
    return error("the file is named .glb, but does not begin as GLB does (\"glTF\")");
  }
  if (extension == "gltf") return error("the file is named .gltf, but is not JSON");
  if (extension == "obj") return error("the file is named .obj, but does not look like OBJ");
  return error("the file is not one of the formats that are read");
}

Result<TriangleSoup> readByContent(std::span<const std::byte> bytes, std::string_view name,
                                   const ResourceReader& resources) {
  if (bytes.empty()) return makeError(ErrorCode::EmptyFile, -1, "the file is empty");
  if (hasGlbMark(bytes)) return readGlb(bytes, resources);

  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (beginsWith("glTF", text) && extensionOf(name) == "glb") return openGlb(bytes).error();
  if (beginsWith(text, "\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) {
    return makeError(ErrorCode::EmptyFile, -1, "the file holds nothing but white space");
  }
  if (text[first] == '{') return readGltf(bytes, resources);
  bool certain = false;
  if (looksLikeObj(text, certain) && (certain || extensionOf(name) == "obj")) return readObj(bytes);
  return unknownFormat(text, name);
}

}  // namespace

std::string_view toString(Format format) {
  switch (format) {
    case Format::Glb:
      return "GLB";
    case Format::Gltf:
      return "glTF";
    case Format::Obj:
      break;
  }
  return "OBJ";
}

Result<TriangleSoup> readSoup(std::span<const std::byte> bytes, std::string_view name,
                              const ResourceReader& resources) {
  try {
    return readByContent(bytes, name, resources);
  } catch (const std::bad_alloc&) {
    return makeError(ErrorCode::OutOfMemory, -1, "there is not enough memory to read the file");
  }
}

Result<LoadedMesh> readMesh(std::span<const std::byte> bytes, std::string_view name,
                            const ResourceReader& resources) {
  auto soup = readSoup(bytes, name, resources);
  if (!soup) return soup.error();
  try {
    return weld(std::move(soup).value());
  } catch (const std::bad_alloc&) {
    return makeError(ErrorCode::OutOfMemory, -1, "there is not enough memory for the model");
  }
}

}  // namespace girth::io
