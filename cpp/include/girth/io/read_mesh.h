// Reading models: bytes in, a surface out, with a way back to the file's own vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/io/attributes.h"
#include "girth/prepare_surface.h"
#include "girth/triangle_soup.h"

namespace girth::io {

/// The formats that are read and written.
enum class Format : std::uint8_t {
  Glb,   ///< glTF 2.0 in one binary file
  Gltf,  ///< glTF 2.0 as JSON
  Obj,   ///< Wavefront OBJ
  Ply,   ///< Stanford PLY, ASCII or binary
  Stl,   ///< STL, ASCII or binary
  Off,   ///< OFF, ASCII or binary
};

/// "GLB", "glTF", "OBJ", "PLY", "STL" or "OFF".
GIRTH_EXPORT std::string_view toString(Format format);

/// A model as it is in its file, nothing repaired.
struct ReadModel {
  /// Positions of the triangles' vertices are finite, others may not be, as where a scanner has
  /// measured nothing; polygons are cut into triangles. Vertices are in the file's order; glTF:
  /// in world space, in metres, in the order of a depth-first walk of the default scene; primitives
  /// of one mesh that share a list of positions share its vertices, and points and lines are left
  /// out.
  TriangleSoup soup;
  /// The format that the bytes were recognised as.
  Format format{Format::Obj};
  /// "metre" for glTF; empty where the file does not state it. Girth's own files state theirs: OBJ,
  /// OFF and PLY in a comment, as in "unit: millimetre", STL in its header; a GLB of a model
  /// without a known unit has `"unit":""` in the extras of its meshes, and is not in metres.
  std::string unit;
  /// Remarks of the reader that a user may want to know, one sentence each.
  std::vector<std::string> notes;
  /// Attributes of the vertices, or of the triangles' corners, where ReadOptions asks for them.
  std::vector<Attribute> attributes{};
  /// Attributes that are left out, or missing somewhere, one sentence each.
  std::vector<std::string> attributeNotes{};
};

/// A model's surface, how the file's vertices and triangles map onto it, and what was done.
struct LoadedMesh : PreparedSurface {
  /// As in ReadModel.
  Format format{Format::Obj};
  /// As in ReadModel.
  std::string unit;
  /// As in ReadModel.
  std::vector<std::string> notes;
  /// Attributes of the corners of the surface's faces, halfedge by halfedge (cornerAttributes);
  /// empty where the file has none, or nobody asked.
  std::vector<Attribute> attributes{};
  /// As in ReadModel.
  std::vector<std::string> attributeNotes{};
  /// Where the surface has fewer triangles than the file, as it was remeshed to be measured: how
  /// many. Writers of JSON state it. 0: it has those of the file.
  Index fewerFaces{0};
};

/// Parts of a file that are read besides the surface.
struct ReadOptions {
  /// Attributes of vertices. PLY: colours (`red`, `green`, `blue`, `alpha`), texture coordinates
  /// (`s`, `t` or `u`, `v`), and other properties of one number, but normals, as `_name`. OBJ:
  /// colours behind the coordinates, and texture coordinates. glTF: `COLOR_0` times the base colour
  /// of the material, as it is shown, `TEXCOORD_0`, and the application's own scalars, `_NAME`, at
  /// most 16 of them; an attribute that cannot be read is left out, and `attributeNotes` say so. No
  /// texture is read, and of STL and OFF nothing.
  bool attributes{false};
};

/// Brings a file that a model refers to by a relative name; nothing if there is none.
using ResourceReader = std::function<std::optional<std::vector<std::byte>>(std::string_view name)>;

/// Reads bytes. The format is recognised by content; `name` only breaks ties and is used in
/// messages. Touches no file system. Any bytes are safe to read: nothing is trusted, and memory
/// stays in proportion to the bytes; where glTF places meshes again, to the triangles of the scene,
/// of which there may be 10 million (3 million in WebAssembly), or as many as the file stores.
/// Extra text at the end of a line of STL or PLY is passed over, and a note says so.
///
/// glTF: all meshes of the scene are merged, with world transforms applied (mirrored ones keep
/// their outside); buffers come from the file, from data: URIs, or through `resources`, which is
/// only ever asked for relative names that do not lead out of the model's folder. Draco and meshopt
/// compression are undone (in WebAssembly by the page, beforehand); skinned meshes stand as the
/// file stores their joints, morph targets are at rest. Faults of the document are named by JSON
/// pointer, as in "/accessors/3/bufferView: there is no buffer view 7". OBJ, PLY and OFF (ASCII and
/// binary): vertices in the file's order, polygons cut into triangles. STL (ASCII and binary):
/// every corner of a triangle is a vertex of its own, in the file's order.
///
/// Errors: EMPTY_FILE, UNKNOWN_FORMAT, MALFORMED_FILE (element: byte or line), UNSUPPORTED_FEATURE
/// (glTF 1.0, required extensions, ...), MISSING_RESOURCE, NON_FINITE_POSITION (vertex of a
/// triangle; in OBJ and OFF: its line), INDEX_OUT_OF_RANGE (glTF: corner of the primitive; others:
/// line or byte), EMPTY_MESH (also: point clouds and lines), LIMIT_EXCEEDED, OUT_OF_MEMORY.
GIRTH_EXPORT Result<ReadModel> readModel(std::span<const std::byte> bytes, std::string_view name,
                                         const ResourceReader& resources = {},
                                         const ReadOptions& options = {});

/// readModel, then prepareSurface. Errors: those of both.
GIRTH_EXPORT Result<LoadedMesh> readMesh(std::span<const std::byte> bytes, std::string_view name,
                                         const ResourceReader& resources = {},
                                         const PrepareOptions& options = {},
                                         const ExecutionContext& context = {});

}  // namespace girth::io
