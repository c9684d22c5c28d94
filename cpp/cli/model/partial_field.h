// What a stopped run of `girth igf` leaves beside its output: the values so far, with whose they
// are, so that another run can go on from there.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "girth/girth_field.h"
#include "girth/surface_mesh.h"

namespace girth::cli {

/// "values.partial.csv" for "values.glb".
std::string partialPathOf(const std::string& output);

/// A CSV file: lines that begin with '#', with the version, the surface's fingerprint and the
/// method, then `vertex,igf,kind` and one row for every vertex that has a value. Numbers read back
/// as the same doubles.
class PartialField {
 public:
  /// `rows`: for every vertex number of the file the vertex of `mesh`, or none. `output`: the file
  /// that the run was to write. All but the string must outlive the object.
  PartialField(const std::string& output, const SurfaceMesh& mesh, std::span<const Vertex> rows,
               const std::string& method);

  const std::string& path() const { return path_; }

  /// The values of the stopped run; NaN where it has none. `computed` has how many there are.
  /// Errors: FILE_NOT_FOUND, ..., MALFORMED_FILE; INVALID_OPTION where they are of another surface,
  /// by another method or from another version, so that they do not belong to this run.
  Result<GirthField> read() const;

  /// Error: FILE_UNWRITABLE.
  std::optional<Error> write(const GirthField& field) const;

 private:
  /// The lines that must be the same in both runs.
  std::string fingerprint() const;

  std::string path_;
  const SurfaceMesh& mesh_;
  std::span<const Vertex> rows_;
  const std::string& method_;
};

}  // namespace girth::cli
