// Values that cross between C++ and JavaScript: arrays are copied both ways, failures become plain
// objects.
#pragma once

#include <emscripten/val.h>

#include <cmath>
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

/// {code, element, message, hint}: `GirthErrorFields` of types.ts. No other result of a function of
/// the modules has a property `code`.
inline emscripten::val toJs(const Error& error) {
  emscripten::val object = emscripten::val::object();
  object.set("code", std::string(toString(error.code)));
  object.set("element", static_cast<double>(error.element));
  object.set("message", error.message);
  object.set("hint", error.hint);
  return object;
}

/// Runs `body` and returns its result. An exception is returned as an error: JavaScript would see
/// only a number.
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

/// A whole number of JavaScript; kNoIndex for whatever else it is.
inline Index indexOf(double number) {
  const bool isIndex = number >= 0 && number < kNoIndex && std::floor(number) == number;
  return isIndex ? static_cast<Index>(number) : kNoIndex;
}

/// A typed array with its own memory. A view into the heap would be detached when the heap grows.
template <class T>
emscripten::val copyOut(const char* typedArray, std::span<const T> content) {
  return emscripten::val::global(typedArray)
      .new_(emscripten::typed_memory_view(content.size(), content.data()));
}

/// A copy of a typed array whose elements are of type T.
template <class T>
std::vector<T> copyIn(const emscripten::val& typedArray) {
  std::vector<T> content(typedArray["length"].as<std::size_t>());
  // The view is made after the allocation, and nothing allocates before it is used.
  emscripten::val(emscripten::typed_memory_view(content.size(), content.data()))
      .call<void>("set", typedArray);
  return content;
}

/// A copy of a Uint8Array.
inline std::vector<std::byte> copyInBytes(const emscripten::val& typedArray) {
  std::vector<std::byte> content(typedArray["length"].as<std::size_t>());
  const auto* first = reinterpret_cast<const std::uint8_t*>(content.data());
  emscripten::val(emscripten::typed_memory_view(content.size(), first))
      .call<void>("set", typedArray);
  return content;
}

/// {bytes}: a file's content as Uint8Array; or an error.
inline emscripten::val fileOf(const Result<std::string>& content) {
  if (!content) return toJs(content.error());
  const auto* first = reinterpret_cast<const std::uint8_t*>(content.value().data());
  emscripten::val result = emscripten::val::object();
  result.set("bytes", copyOut<std::uint8_t>("Uint8Array", {first, content.value().size()}));
  return result;
}

/// For the modules without threads: reports the finished share to JavaScript. Such a module cannot
/// be cancelled while it works; its worker is ended instead.
inline ExecutionContext reportingTo(const emscripten::val& onProgress) {
  ExecutionContext context;
  context.threads = 1;
  context.onProgress = [onProgress](double fraction) { onProgress(fraction); };
  return context;
}

/// The surface of a prepared surface's arrays (Float64Array, Uint32Array): the same, bit for bit.
inline Result<SurfaceMesh> surfaceOf(const emscripten::val& positions,
                                     const emscripten::val& indices) {
  return SurfaceMesh::fromArrays(copyIn<double>(positions), copyIn<Index>(indices),
                                 OpenEdges::Boundary);
}

/// {surface}: an `Owner` of the surface of a prepared surface's arrays, which JavaScript must
/// delete; or an error.
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
