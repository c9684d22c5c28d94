#include "formats/foreign_formats.h"

#include <algorithm>
#include <array>
#include <string>

#include "girth/error.h"

namespace girth::io {
namespace {

constexpr std::string_view kConvert = "open it in a 3D program, such as Blender, and export GLB";
constexpr std::string_view kUnpack = "unpack it and use the model inside";
constexpr std::string_view kNoModel = "choose the model itself";
constexpr std::string_view kSolids =
    "it describes solids, not triangles: export a mesh (STL, OBJ) from a CAD program";

constexpr std::string_view kUtf16 = "text in UTF-16";
constexpr std::string_view kSaveAsUtf8 = "save it as UTF-8";

struct Mark {
  std::string_view prefix, name, hint;
};

constexpr std::array kMarks{
    Mark{"\x1F\x8B", "a gzip archive", kUnpack},
    Mark{"7z\xBC\xAF\x27\x1C", "a 7z archive", kUnpack},
    Mark{"Rar!", "a RAR archive", kUnpack},
    Mark{"BZh", "a bzip2 archive", kUnpack},
    Mark{"\xFD"
         "7zXZ",
         "an xz archive", kUnpack},
    Mark{"\x28\xB5\x2F\xFD", "a zstd archive or a compressed Blender file", kConvert},
    Mark{"Kaydara FBX", "FBX", kConvert},
    Mark{"; FBX", "FBX", kConvert},
    Mark{"BLENDER", "a Blender file", "export GLB from Blender"},
    Mark{"DRACO", "a Draco file by itself", "put it into a GLB, or decode it to PLY or OBJ"},
    Mark{"PXR-USDC", "USD", kConvert},
    Mark{"#usda", "USD", kConvert},
    Mark{"#VRML", "VRML", kConvert},
    Mark{"#X3D", "X3D", kConvert},
    Mark{"xof ", "DirectX", kConvert},
    Mark{"# vtk DataFile", "VTK", "write the surface as PLY, STL or OBJ"},
    Mark{"MeshVersionFormatted", "MEDIT", "write the surface as PLY, STL or OBJ"},
    Mark{"$MeshFormat", "Gmsh", "write the surface as PLY, STL or OBJ"},
    Mark{"3D Geometry File Format", "a Rhino file", "export a mesh (STL, OBJ) from Rhino"},
    Mark{"ISO-10303-21", "STEP", kSolids},
    Mark{"newmtl", "the materials of an OBJ", kNoModel},
    Mark{"version https://git-lfs", "a pointer of Git LFS, not the file itself",
         "fetch the file with git lfs pull"},
    Mark{"\x89PNG", "a picture", kNoModel},
    Mark{"\xFF\xD8\xFF", "a picture", kNoModel},
    Mark{"GIF8", "a picture", kNoModel},
    Mark{"\xABKTX", "a texture", kNoModel},
    Mark{"%PDF", "a PDF", kNoModel},
    Mark{"\xFF\xFE", kUtf16, kSaveAsUtf8},
    Mark{"\xFE\xFF", kUtf16, kSaveAsUtf8},
};

Error looksLike(std::string_view name, std::string_view hint) {
  Error error = makeError(ErrorCode::UnknownFormat, -1,
                          "the file looks like " + std::string(name) + ", which is not read");
  error.hint = hint;
  return error;
}

Error threeMf() { return looksLike("3MF", "export STL from the program it comes from"); }

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// Names stand uncompressed in an archive.
Error zipFile(std::string_view bytes) {
  if (contains(bytes, "3dmodel.model")) return threeMf();
  if (contains(bytes, ".usdc") || contains(bytes, ".usda")) return looksLike("USDZ", kConvert);
  return looksLike("a zip archive", kUnpack);
}

Error markupFile(std::string_view text) {
  const std::string_view head = text.substr(0, 4096);
  std::string lower(head);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (contains(lower, "<model") && contains(lower, "3dmanufacturing")) return threeMf();
  if (contains(lower, "<collada")) return looksLike("COLLADA", kConvert);
  if (contains(lower, "<x3d")) return looksLike("X3D", kConvert);
  if (contains(lower, "<amf")) return looksLike("AMF", "export STL from the program it comes from");
  if (contains(lower, "<vtkfile")) return looksLike("VTK", "write the surface as PLY, STL or OBJ");
  if (contains(lower, "<html") || contains(lower, "<!doctype html")) {
    return looksLike("a web page", "the download went wrong: load the model again");
  }
  return looksLike("XML", kConvert);
}

/// 3DS: a chunk 4D4D as long as the file.
bool isThreeDs(std::string_view bytes) {
  if (bytes.size() < 6 || !bytes.starts_with("MM")) return false;
  std::size_t length = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    length |= std::size_t{static_cast<unsigned char>(bytes[2 + i])} << (8 * i);
  }
  return length == bytes.size();
}

/// Text in UTF-16 without a mark: every other byte of its beginning is 0, and the others are ASCII.
bool isUtf16(std::string_view bytes) {
  constexpr std::size_t kSample = 16, kLeast = 8;
  const std::string_view beginning = bytes.substr(0, kSample);
  if (beginning.size() < kLeast) return false;
  const std::size_t zero = beginning[0] == '\0' ? 0 : 1;
  for (std::size_t i = 0; i < beginning.size(); ++i) {
    const char c = beginning[i];
    const bool isText = (c >= ' ' && c <= '~') || (c >= '\t' && c <= '\r');
    if (i % 2 == zero ? c != '\0' : !isText) return false;
  }
  return true;
}

}  // namespace

std::optional<Error> foreignModel(std::string_view bytes) {
  auto error = foreignFormat(bytes);
  return error && error->hint == kNoModel ? std::nullopt : error;
}

std::optional<Error> foreignFormat(std::string_view bytes) {
  for (const Mark& mark : kMarks) {
    if (bytes.starts_with(mark.prefix)) return looksLike(mark.name, mark.hint);
  }
  if (bytes.starts_with("PK\x03\x04")) return zipFile(bytes);
  if (isThreeDs(bytes)) return looksLike("3DS", kConvert);
  if (isUtf16(bytes)) return looksLike(kUtf16, kSaveAsUtf8);
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && bytes[first] == '<') return markupFile(bytes);
  return std::nullopt;
}

}  // namespace girth::io
