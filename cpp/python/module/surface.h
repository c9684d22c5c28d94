// A prepared surface as Python holds it, with what is kept between calls.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "girth/barcode.h"
#include "girth/geodesic_solver.h"
#include "girth/girth_field.h"
#include "girth/girth_solver.h"
#include "girth/io/read_mesh.h"
#include "girth/shape_diameter.h"

namespace girth::python {

/// Immutable for its users, and may be used by several threads at once: what it keeps (the fields
/// that others are made of, and solvers with their memory) changes no result.
class Surface {
 public:
  /// Takes over a prepared surface.
  explicit Surface(io::LoadedMesh loaded);

  /// The surface, how it was made, and what its file states of it.
  const io::LoadedMesh& loaded() const { return loaded_; }
  /// The surface.
  const SurfaceMesh& mesh() const { return loaded_.mesh; }

  /// The girth, computed once; I_tau for a persistence of more than 0, of which the latest is kept.
  /// Errors: INVALID_OPTION, CANCELLED.
  Result<std::shared_ptr<const GirthField>> girth(double persistence,
                                                  const ExecutionContext& context) const;
  /// The shape diameter by the default rays, computed once. Errors: CANCELLED.
  Result<std::shared_ptr<const std::vector<double>>> diameter(
      const ExecutionContext& context) const;

  /// The loop at a point. Errors: as of GirthSolver.
  Result<GirthLoop> loop(const SurfacePoint& point, double persistence,
                         const ExecutionContext& context) const;
  /// The saddles of the distance from a point. Errors: as of GirthSolver.
  Result<Barcode> barcode(const SurfacePoint& point, const BarcodeOptions& options,
                          const ExecutionContext& context) const;
  /// Distances from sources. Errors: as of GeodesicSolver.
  Result<std::vector<double>> distances(const std::vector<SurfacePoint>& sources, double radius,
                                        const ExecutionContext& context) const;
  /// A shortest path. Errors: as of GeodesicSolver.
  Result<GeodesicPath> path(const SurfacePoint& from, const SurfacePoint& to,
                            const ExecutionContext& context) const;

 private:
  io::LoadedMesh loaded_;
  mutable std::mutex fields_;
  mutable std::shared_ptr<const GirthField> girth_, persistentGirth_;
  mutable double persistence_{0};  // the persistence of `persistentGirth_`
  mutable std::shared_ptr<const std::vector<double>> diameter_;
  /// A thread that finds the kept solver in use makes one for itself.
  mutable std::mutex loops_, geodesics_;
  mutable std::optional<GirthSolver> loopSolver_;
  mutable std::optional<GeodesicSolver> geodesicSolver_;
};

}  // namespace girth::python
