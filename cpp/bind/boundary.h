// The boundary to JavaScript: arrays are copied both ways, failures become plain objects.
#pragma once

#include <emscripten/val.h>

#include <exception>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
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

/// The content of a Uint8Array.
inline std::vector<std::byte> copyInBytes(const emscripten::val& typedArray) {
  std::vector<std::byte> content(typedArray["length"].as<std::size_t>());
  const auto* first = reinterpret_cast<const std::uint8_t*>(content.data());
  emscripten::val(emscripten::typed_memory_view(content.size(), first))
      .call<void>("set", typedArray);
  return content;
}

/// {bytes}, a file's content as Uint8Array, or an error.
inline emscripten::val fileOf(const Result<std::string>& content) {
  if (!content) return toJs(content.error());
  const auto* first = reinterpret_cast<const std::uint8_t*>(content.value().data());
  emscripten::val result = emscripten::val::object();
  result.set("bytes", copyOut<std::uint8_t>("Uint8Array", {first, content.value().size()}));
  return result;
}

/// For the modules without threads: tells JavaScript the finished share; nothing else can be told
/// or heard while a module works.
inline ExecutionContext reportingTo(const emscripten::val& onProgress) {
  ExecutionContext context;
  context.threads = 1;
  context.onProgress = [onProgress](double fraction) { onProgress(fraction); };
  return context;
}

/// The surface of a prepared one's arrays, a Float64Array and a Uint32Array: the same, bit for bit.
inline Result<SurfaceMesh> surfaceOf(const emscripten::val& positions,
                                     const emscripten::val& indices) {
  return SurfaceMesh::fromArrays(copyIn<double>(positions), copyIn<Index>(indices),
                                 OpenEdges::Boundary);
}

/// {surface}, an `Owner` made of the surface of a prepared one's arrays, or an error; the owner is
/// the caller's to delete.
template <class Owner>
emscripten::val exactSurface(const emscripten::val& positions, const emscripten::val& indices) {
  return guarded([&] {
    Result<SurfaceMesh> mesh = surfaceOf(positions, indices);
    if (!mesh) return toJs(mesh.error());
    emscripten::val result = emscripten::val::object();
    result.set("surface", std::make_shared<Owner>(std::move(mesh).value()));
    return result;
  });
}

}  // namespace girth::bind
