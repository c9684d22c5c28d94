// Values that a stopped run of `girth igf` leaves beside its output, with whose they
// are, so that another run can go on from there.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "girth/girth_field.h"
#include "girth/surface_mesh.h"

namespace girth::cli {

/// "values.partial.csv" for "values.glb".
std::string partialPathOf(const std::string& output);

/// A CSV file: lines that begin with '#', with how far the run was and of which model, the version,
/// the method and the surface's fingerprint, then `vertex,igf,kind` and one row for every vertex
/// that has a value. Numbers read back as the same doubles.
class PartialField {
 public:
  /// `model`: what people call it. `rows`: for every vertex number of the file the vertex of
  /// `mesh`, or none. `output`: the file that the run was to write. All but the output must outlive
  /// the object.
  PartialField(const std::string& output, const std::string& model, const SurfaceMesh& mesh,
               std::span<const Vertex> rows, const std::string& method);

  const std::string& path() const { return path_; }

  /// The values of the stopped run; NaN where it has none. `computed` has how many there are.
  /// Errors: FILE_NOT_FOUND, ..., MALFORMED_FILE; INVALID_OPTION where they are of another surface,
  /// by another method or from another version, so that they do not belong to this run.
  Result<GirthField> read() const;

  /// The file that is there, where it belongs to another run, or is damaged: whose
  /// it is and how far that run was, in words. Nothing where it belongs to this one.
  std::optional<std::string> ofAnother() const;

  /// Error: FILE_UNWRITABLE.
  std::optional<Error> write(const GirthField& field) const;

 private:
  /// The lines that must be the same in both runs.
  std::string fingerprint() const;

  /// Takes the lines before the rows off a text. Error: as of `read`.
  std::optional<Error> takeHead(std::string_view& text, std::int64_t& line) const;

  std::string path_;
  const std::string& model_;
  const SurfaceMesh& mesh_;
  std::span<const Vertex> rows_;
  const std::string& method_;
};

}  // namespace girth::cli
