// A surface that a worker for jobs keeps from one job to the next.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "described.h"
#include "girth/io/read_mesh.h"
#include "result_object.h"

namespace girth::bind {

class JobSurface {
 public:
  /// `vertexOfInput` and `inputOfVertex` are those of `PreparedSurface`.
  JobSurface(SurfaceMesh mesh, const std::vector<Index>& vertexOfInput,
             std::vector<Index> inputOfVertex)
      : loaded_{{std::move(mesh),
                 std::vector<Vertex>(vertexOfInput.begin(), vertexOfInput.end()),
                 std::move(inputOfVertex),
                 {},
                 {},
                 {}},
                io::Format::Obj,
                {},
                {}},
        origin_(drawingOrigin(loaded_.mesh)) {}
  JobSurface(const JobSurface&) = delete;
  JobSurface& operator=(const JobSurface&) = delete;

  const SurfaceMesh& mesh() const { return loaded_.mesh; }

  /// The point that drawn points of the surface are relative to.
  const Vec3& origin() const { return origin_; }

  /// The surface as its results are drawn.
  DrawnSurface drawn() const { return {&mesh(), origin_}; }

  /// The surface as writers take it, with a unit for its lengths: 'metre', or ''. The reference is
  /// the same for every call.
  const io::LoadedMesh& inUnit(std::string unit) {
    loaded_.unit = std::move(unit);
    return loaded_;
  }

  /// The loaded mesh, to be given the rest of the file while something is written.
  io::LoadedMesh& loaded() { return loaded_; }

 private:
  io::LoadedMesh loaded_;
  Vec3 origin_;
};

}  // namespace girth::bind
