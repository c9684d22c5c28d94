// The boundary to JavaScript: arrays are copied both ways, failures become plain objects.
#pragma once

#include <emscripten/val.h>

#include <exception>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "girth/error.h"
#include "girth/surface_mesh.h"

namespace girth::bind {

/// {code, element, message, hint}, as `GirthErrorFields` of types.ts. Anything else that a function
/// of the modules returns has no property `code`.
inline emscripten::val toJs(const Error& error) {
  emscripten::val object = emscripten::val::object();
  object.set("code", std::string(toString(error.code)));
  object.set("element", static_cast<double>(error.element));
  object.set("message", error.message);
  object.set("hint", error.hint);
  return object;
}

/// Runs `body`; an exception comes back as an error. None may leave a module: JavaScript would see
/// nothing but a number.
template <class Body>
emscripten::val guarded(Body&& body) {
  try {
    return body();
  } catch (const std::bad_alloc&) {
    return toJs(makeError(ErrorCode::OutOfMemory, -1, "the memory does not suffice"));
  } catch (const std::exception& exception) {
    return toJs(makeError(ErrorCode::Internal, -1, exception.what()));
  } catch (...) {
    return toJs(makeError(ErrorCode::Internal, -1, "an unknown exception"));
  }
}

/// A typed array of JavaScript's own memory. A view into the heap would die when the heap grows.
template <class T>
emscripten::val copyOut(const char* typedArray, std::span<const T> content) {
  return emscripten::val::global(typedArray)
      .new_(emscripten::typed_memory_view(content.size(), content.data()));
}

/// The content of a typed array whose elements are of type T.
template <class T>
std::vector<T> copyIn(const emscripten::val& typedArray) {
  std::vector<T> content(typedArray["length"].as<std::size_t>());
  // The view is made after the allocation, and nothing allocates before it is used.
  emscripten::val(emscripten::typed_memory_view(content.size(), content.data()))
      .call<void>("set", typedArray);
  return content;
}

/// A surface from a Float64Array and a Uint32Array.
inline Result<SurfaceMesh> surfaceOf(const emscripten::val& positions,
                                     const emscripten::val& indices) {
  return SurfaceMesh::fromArrays(copyIn<double>(positions), copyIn<Index>(indices));
}

}  // namespace girth::bind
