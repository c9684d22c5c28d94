// A surface that was cut as a file's content: GLB, OBJ, JSON or CSV.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "girth/cut_surface.h"
#include "girth/export.h"
#include "girth/io/read_mesh.h"

namespace girth::io {

/// The parts of a model that was cut, the largest area first.
struct CutModel {
  std::vector<SurfaceComponent> parts;  ///< vertices and faces are those of the cut surface
  std::vector<Face> faces;              ///< by face of the cut surface: CutSurface::faces
  std::vector<SurfacePoint> points;     ///< by vertex of the cut surface: CutSurface::points
};

/// The parts of a surface that was cut, each with its cavities (partsOf).
GIRTH_EXPORT CutModel cutModel(const CutSurface& cut);

// GLB, OBJ and PLY have what `loaded.attributes` says of the vertices, as far as the format can:
// as it is at vertices of the model, linear between them where new ones stand on edges and in
// faces, and on caps that of their rims. Where the corners at a vertex differ, as along the seam of
// a texture, it is written several times. OBJ has colours and texture coordinates, PLY colours as
// bytes.

/// Each part as a node `part_0`, ... with its triangles, positions rounded to floats. glTF is in
/// metres, as in meshFile. Error: LIMIT_EXCEEDED where the file would pass 4 GB.
GIRTH_EXPORT Result<std::string> cutGlb(const LoadedMesh& loaded, const CutModel& model);

/// Each part as an object `part_0`, ...
GIRTH_EXPORT std::string cutObj(const LoadedMesh& loaded, const CutModel& model);

/// One part, from 0, in a file of its own. Errors: as meshFile.
GIRTH_EXPORT Result<std::string> partFile(const LoadedMesh& loaded, const CutModel& model,
                                          std::size_t part, Format format);

/// One JSON object: `file`, `unit` and `parts`. Each part has its measures (PartMeasures), and the
/// numbers of its `faces` and `vertices`.
GIRTH_EXPORT std::string cutJson(const LoadedMesh& loaded, const CutModel& model,
                                 std::string_view file);

/// For each face of the file the part that has most of its area, from 0; kNoIndex where it is not
/// on the surface.
GIRTH_EXPORT std::vector<Index> partOfFaces(const LoadedMesh& loaded, const CutModel& model);

/// The part of each of `faceCount` faces of the surface that was cut.
GIRTH_EXPORT std::vector<Index> partOfFaces(const CutModel& model, Index faceCount);

/// `face,part` and a row for every face of the file that is on the surface: the part that has most
/// of its area.
GIRTH_EXPORT std::string cutCsv(const LoadedMesh& loaded, const CutModel& model);

}  // namespace girth::io
