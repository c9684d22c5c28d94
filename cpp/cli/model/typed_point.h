// Points of a model as they are typed.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "girth/error.h"
#include "girth/io/read_mesh.h"
#include "girth/surface_point.h"
#include "model/model_options.h"

namespace girth::cli {

/// A vertex in the file's numbering, from 0; or a point of a face.
struct TypedPoint {
  std::optional<std::int64_t> vertex;
  /// A triangle in the file's order, from 0; polygons count as the triangles they are cut into.
  std::optional<std::int64_t> face;
  /// The point's shares of the face's three vertices.
  std::array<double, 3> weights{1.0 / 3, 1.0 / 3, 1.0 / 3};

  /// For people: "vertex 12", "face 7 at 0.2,0.3,0.5".
  std::string text() const;
};

/// "A,B,C": the shares of a face's three vertices. Returns what is wrong with it; empty: nothing.
std::string readWeights(const std::string& text, std::array<double, 3>& weights);

/// "12": a vertex; "7:0.2,0.3,0.5": a point of a face. Returns what is wrong with it.
std::string readPoint(const std::string& text, TypedPoint& point);

/// Points in one text, with commas between, or the name of a file that has them. Returns what is
/// wrong with it; empty: nothing.
std::string readPoints(const std::string& text, std::vector<TypedPoint>& points);

/// The points of a file, row by row, as they are typed, with commas, semicolons or white space
/// between them. Empty rows and a header, whose first letter is none of a point's, are passed over.
/// Errors: those of reading; MALFORMED_FILE with the row.
Result<std::vector<std::vector<TypedPoint>>> readPointRows(const std::string& path);

/// The point of the surface that is meant. `path`, `preparing`: of the model, which is read again
/// where a face may have been turned over. Errors: VERTEX_OUT_OF_RANGE, INVALID_POINT.
Result<SurfacePoint> surfacePoint(const io::LoadedMesh& loaded, const TypedPoint& point,
                                  const std::string& path, const ModelOptions& preparing);

/// Several of them, in order. The first error.
Result<std::vector<SurfacePoint>> surfacePoints(const io::LoadedMesh& loaded,
                                                const std::vector<TypedPoint>& points,
                                                const std::string& path,
                                                const ModelOptions& preparing);

}  // namespace girth::cli
