#include "girth/io/read_mesh.h"

#include <new>
#include <string>
#include <utility>

#include "formats/foreign_formats.h"
#include "formats/read_obj.h"
#include "formats/read_off.h"
#include "formats/read_ply.h"
#include "formats/read_stl.h"
#include "gltf/document/glb_container.h"
#include "gltf/read_gltf.h"
#include "text/ending.h"
#include "text/words.h"

namespace girth::io {
namespace {

/// Whether the first line that is not blank or a comment could be OBJ.
bool beginsAsObj(std::string_view text) {
  const std::string_view word = Words(text, '#').next();
  return !word.empty() && isObjLine(word);
}

/// Whether there is nothing but comments, or a line near the beginning that could be OBJ.
bool canBeObj(std::string_view text) {
  constexpr std::size_t kSample = 65536;
  Words words(text.substr(0, kSample), '#');
  bool anything = false;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (isObjLine(word)) return true;
    anything = true;
    words.skipLine();
  }
  return !anything;
}

/// Binary files may begin with any letter.
bool isText(std::string_view text) {
  constexpr std::size_t kSample = 4096;
  return text.substr(0, kSample).find('\0') == std::string_view::npos;
}

Error unknownFormat(std::string_view name) {
  const std::string ending = endingOf(name);
  const auto error = [](std::string message) {
    return makeError(ErrorCode::UnknownFormat, -1, std::move(message));
  };
  if (ending == ".glb") {
    return error("the file is named .glb, but does not begin as GLB does (\"glTF\")");
  }
  if (ending == ".gltf") return error("the file is named .gltf, but is not JSON");
  if (ending == ".ply") {
    return error("the file is named .ply, but does not begin as PLY does (\"ply\")");
  }
  if (ending == ".obj") return error("the file is named .obj, but does not look like OBJ");
  if (ending == ".off") return error("the file is named .off, but does not look like OFF");
  return error("the file is not one of the formats that are read");
}

/// Marks that no other format can have go first; what several could be is left to the name.
Result<ReadModel> readByContent(std::span<const std::byte> bytes, std::string_view name,
                                const ResourceReader& resources, const ReadOptions& options) {
  if (bytes.empty()) return makeError(ErrorCode::EmptyFile, -1, "the file is empty");
  const std::string ending = endingOf(name);
  const std::string_view text = textOf(bytes);
  if (hasGlbMark(bytes)) return readGlb(bytes, resources, options);
  if (ending == ".glb" && std::string_view("glTF").starts_with(text)) return openGlb(bytes).error();
  if (hasPlyMark(text)) return readPly(bytes, options);
  if (hasBinaryStlSize(bytes)) return readStl(bytes);
  if (auto error = foreignFormat({reinterpret_cast<const char*>(bytes.data()), bytes.size()})) {
    return *error;
  }

  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) {
    return makeError(ErrorCode::EmptyFile, -1, "the file holds nothing but white space");
  }
  if (text[first] == '{') return readGltf(bytes, resources, options);
  if (hasOffMark(text)) return readOff(bytes);
  if (hasStlMark(text)) return readStl(bytes);
  if (isText(text) && beginsAsObj(text)) return readObj(bytes, options);
  if (ending == ".stl") return readStl(bytes);
  if (ending == ".obj" && isText(text) && canBeObj(text)) return readObj(bytes, options);
  if (ending == ".off" && isText(text) && canBeOffWithoutMark(text)) return readOff(bytes);
  return unknownFormat(name);
}

}  // namespace

std::string_view toString(Format format) {
  switch (format) {
    case Format::Glb:
      return "GLB";
    case Format::Gltf:
      return "glTF";
    case Format::Ply:
      return "PLY";
    case Format::Stl:
      return "STL";
    case Format::Off:
      return "OFF";
    case Format::Obj:
      break;
  }
  return "OBJ";
}

Result<ReadModel> readModel(std::span<const std::byte> bytes, std::string_view name,
                            const ResourceReader& resources, const ReadOptions& options) {
  try {
    return readByContent(bytes, name, resources, options);
  } catch (const std::bad_alloc&) {
    return makeError(ErrorCode::OutOfMemory, -1, "there is not enough memory to read the file");
  }
}

Result<LoadedMesh> readMesh(std::span<const std::byte> bytes, std::string_view name,
                            const ResourceReader& resources, const PrepareOptions& options,
                            const ExecutionContext& context) {
  auto model = readModel(bytes, name, resources);
  if (!model) return model.error();
  ReadModel& read = model.value();
  auto prepared = prepareSurface(std::move(read.soup), options, context);
  if (!prepared) return prepared.error();
  return LoadedMesh{std::move(prepared).value(), read.format, std::move(read.unit),
                    std::move(read.notes)};
}

}  // namespace girth::io
