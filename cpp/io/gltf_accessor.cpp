#include "gltf_accessor.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

#include "bit_cast.h"

namespace girth::io {
namespace {

Error malformed(std::string message) {
  return makeError(ErrorCode::MalformedFile, -1, std::move(message));
}

/// Bytes of a component; 0 for types that glTF does not have.
std::size_t componentBytes(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_INT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    case TINYGLTF_COMPONENT_TYPE_DOUBLE:
      return 8;
    default:
      return 0;
  }
}

/// A little-endian number of `bytes` bytes, as bits.
std::uint64_t bitsAt(const std::byte* at, std::size_t bytes) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    bits |= std::to_integer<std::uint64_t>(at[i]) << (8 * i);
  }
  return bits;
}

/// A component as a number; normalised integers map onto [0, 1] or [-1, 1].
double componentAt(const std::byte* at, int type, bool normalized) {
  const std::uint64_t bits = bitsAt(at, componentBytes(type));
  double value = 0;
  double scale = 1;
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      value = static_cast<std::int8_t>(bits);
      scale = 127;
      break;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      value = static_cast<std::uint8_t>(bits);
      scale = 255;
      break;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      value = static_cast<std::int16_t>(bits);
      scale = 32767;
      break;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      value = static_cast<std::uint16_t>(bits);
      scale = 65535;
      break;
    case TINYGLTF_COMPONENT_TYPE_INT:
      value = static_cast<std::int32_t>(bits);
      scale = 2147483647;
      break;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      value = static_cast<std::uint32_t>(bits);
      scale = 4294967295;
      break;
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return bitCast<float>(static_cast<std::uint32_t>(bits));
    default:
      return bitCast<double>(bits);
  }
  return normalized ? std::max(value / scale, -1.0) : value;
}

/// `count` elements of `elementBytes`, `stride` bytes apart, all inside the buffer view.
struct Elements {
  const std::byte* first{nullptr};
  std::size_t stride{0};
  const std::byte* operator[](std::size_t i) const { return first + i * stride; }
};

Result<Elements> elementsOf(const GltfDocument& document, GltfBuffers& buffers, int view,
                            std::size_t offset, std::size_t count, std::size_t elementBytes,
                            const std::string& user) {
  auto bytes = buffers.view(view, user);
  if (!bytes) return bytes.error();
  const auto& description = document.model.bufferViews[static_cast<std::size_t>(view)];
  const std::size_t stride = description.byteStride == 0 ? elementBytes : description.byteStride;
  if (stride < elementBytes) {
    return malformed(user + " has elements of " + std::to_string(elementBytes) + " bytes only " +
                     std::to_string(stride) + " bytes apart");
  }
  const std::size_t size = bytes.value().size();
  // In terms of what fits, so that nothing can overflow.
  const bool fits = offset <= size && elementBytes <= size - offset &&
                    count - 1 <= (size - offset - elementBytes) / stride;
  if (!fits) {
    return malformed(user + " claims " + std::to_string(count) +
                     " elements, which reach beyond the end of buffer view " +
                     std::to_string(view));
  }
  return Elements{bytes.value().data() + offset, stride};
}

/// What both kinds of accessor have in common.
struct Checked {
  const tinygltf::Accessor* accessor{nullptr};
  std::string name;
  std::size_t elementBytes{0};
};

Result<Checked> check(const GltfDocument& document, GltfBuffers& buffers, int number,
                      int wantedType, SoupBudget& budget) {
  const auto& accessors = document.model.accessors;
  const std::string name = "accessor " + std::to_string(number);
  if (number < 0 || static_cast<std::size_t>(number) >= accessors.size()) {
    return malformed("a primitive refers to " + name + ", which does not exist");
  }
  const tinygltf::Accessor& accessor = accessors[static_cast<std::size_t>(number)];
  const std::size_t bytes = componentBytes(accessor.componentType);
  if (bytes == 0) {
    return malformed(name + " has the unknown component type " +
                     std::to_string(accessor.componentType));
  }
  if (accessor.type != wantedType) {
    return malformed(name + (wantedType == TINYGLTF_TYPE_VEC3 ? " holds positions, but not VEC3"
                                                              : " holds indices, but not SCALAR"));
  }
  if (accessor.count == 0) return malformed(name + " is empty");
  if (accessor.bufferView >= 0) {
    // Fetched first: a file beside the model makes room for what it holds.
    if (auto view = buffers.view(accessor.bufferView, name); !view) return view.error();
  }
  if (!budget.take(accessor.count)) {
    return makeError(ErrorCode::LimitExceeded, number,
                     name + " with " + std::to_string(accessor.count) +
                         " elements makes the model far larger than its file");
  }
  return Checked{&accessor, name, bytes * (wantedType == TINYGLTF_TYPE_VEC3 ? 3u : 1u)};
}

/// Calls `put(i, bytes)` for every element, with sparse replacements applied. Elements that no
/// buffer view stands behind are zero and are not reported.
template <class Put>
std::optional<Error> forEachElement(const GltfDocument& document, GltfBuffers& buffers,
                                    const Checked& checked, const Put& put) {
  const tinygltf::Accessor& accessor = *checked.accessor;
  if (accessor.bufferView >= 0) {
    auto elements = elementsOf(document, buffers, accessor.bufferView, accessor.byteOffset,
                               accessor.count, checked.elementBytes, checked.name);
    if (!elements) return elements.error();
    for (std::size_t i = 0; i < accessor.count; ++i) put(i, elements.value()[i]);
  }
  if (!accessor.sparse.isSparse) return std::nullopt;

  const auto& sparse = accessor.sparse;
  const std::string name = "the sparse part of " + checked.name;
  const std::size_t indexBytes = componentBytes(sparse.indices.componentType);
  const bool unsignedIndices =
      sparse.indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
      sparse.indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
      sparse.indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  if (!unsignedIndices || sparse.count <= 0 || sparse.indices.byteOffset < 0 ||
      sparse.values.byteOffset < 0) {
    return malformed(name + " is not valid");
  }
  const auto count = static_cast<std::size_t>(sparse.count);
  auto indices =
      elementsOf(document, buffers, sparse.indices.bufferView,
                 static_cast<std::size_t>(sparse.indices.byteOffset), count, indexBytes, name);
  if (!indices) return indices.error();
  auto values = elementsOf(document, buffers, sparse.values.bufferView,
                           static_cast<std::size_t>(sparse.values.byteOffset), count,
                           checked.elementBytes, name);
  if (!values) return values.error();
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t target = bitsAt(indices.value()[i], indexBytes);
    if (target >= accessor.count) {
      return malformed(name + " replaces element " + std::to_string(target) + " of " +
                       std::to_string(accessor.count));
    }
    put(static_cast<std::size_t>(target), values.value()[i]);
  }
  return std::nullopt;
}

}  // namespace

Result<std::vector<double>> readPoints(const GltfDocument& document, GltfBuffers& buffers,
                                       int accessor, SoupBudget& budget) {
  auto checked = check(document, buffers, accessor, TINYGLTF_TYPE_VEC3, budget);
  if (!checked) return checked.error();
  const tinygltf::Accessor& description = *checked.value().accessor;
  const std::size_t bytes = componentBytes(description.componentType);
  std::vector<double> points(3 * description.count, 0.0);
  const auto error =
      forEachElement(document, buffers, checked.value(), [&](std::size_t i, const std::byte* at) {
        for (std::size_t k = 0; k < 3; ++k) {
          points[3 * i + k] =
              componentAt(at + k * bytes, description.componentType, description.normalized);
        }
      });
  if (error) return *error;
  return points;
}

Result<std::vector<Index>> readIndices(const GltfDocument& document, GltfBuffers& buffers,
                                       int accessor, SoupBudget& budget) {
  auto checked = check(document, buffers, accessor, TINYGLTF_TYPE_SCALAR, budget);
  if (!checked) return checked.error();
  const tinygltf::Accessor& description = *checked.value().accessor;
  const int type = description.componentType;
  if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
      type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
      type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
    return malformed(checked.value().name + " holds indices that are not unsigned integers");
  }
  std::vector<Index> indices(description.count, 0);
  const auto error =
      forEachElement(document, buffers, checked.value(), [&](std::size_t i, const std::byte* at) {
        indices[i] = static_cast<Index>(bitsAt(at, componentBytes(type)));
      });
  if (error) return *error;
  return indices;
}

}  // namespace girth::io
