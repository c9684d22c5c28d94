// The content of a model's file besides its surface, on its way to JavaScript and back to writers.
#pragma once

#include <emscripten/val.h>

#include <vector>

#include "girth/io/attributes.h"
#include "girth/io/read_mesh.h"
#include "girth/prepare_surface.h"

namespace girth::bind {

/// `FileContent` of protocol.ts. `corners`: of the surface's corners, as `io::cornerAttributes`
/// gives them. Corners at a vertex that have the same values share them: what comes out takes 12
/// bytes a face, and the values about once for each vertex.
emscripten::val fileContentOf(const PreparedSurface& surface,
                              const std::vector<io::Attribute>& corners);

/// A surface with the same faces has it back, for writers, as long as this lives.
class WithFileContent {
 public:
  WithFileContent(io::LoadedMesh& loaded, const emscripten::val& content);
  ~WithFileContent();
  WithFileContent(const WithFileContent&) = delete;
  WithFileContent& operator=(const WithFileContent&) = delete;

 private:
  io::LoadedMesh& loaded_;
};

}  // namespace girth::bind
