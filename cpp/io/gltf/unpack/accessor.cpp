#include "gltf/unpack/accessor.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <type_traits>

#include "bytes/bit_cast.h"
#include "gltf/document/fault.h"

namespace girth::io {
namespace {

template <std::size_t kBytes>
using UnsignedOf = std::conditional_t<
    kBytes == 1, std::uint8_t,
    std::conditional_t<kBytes == 2, std::uint16_t,
                       std::conditional_t<kBytes == 4, std::uint32_t, std::uint64_t>>>;

/// A little-endian number. Compilers make one load of it.
template <class T>
T load(const std::byte* at) {
  using Bits = UnsignedOf<sizeof(T)>;
  Bits bits = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    bits = static_cast<Bits>(bits | static_cast<Bits>(std::to_integer<Bits>(at[i]) << (8 * i)));
  }
  return bitCast<T>(bits);
}

template <class T, bool kNormalized>
double numberAt(const std::byte* at) {
  const auto value = static_cast<double>(load<T>(at));
  if constexpr (kNormalized && std::is_integral_v<T>) {
    return std::max(value / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
  } else {
    return value;
  }
}

/// Elements `stride` bytes apart.
struct Run {
  const std::byte* first;
  std::size_t stride;
  std::size_t count;
};

template <class T, bool kNormalized>
void copyNumbers(const Run& run, std::size_t components, double* to) {
  for (std::size_t i = 0; i < run.count; ++i) {
    const std::byte* at = run.first + i * run.stride;
    for (std::size_t k = 0; k < components; ++k) {
      *to++ = numberAt<T, kNormalized>(at + k * sizeof(T));
    }
  }
}

template <class T>
void copyNumbers(const Run& run, std::size_t components, bool normalized, double* to) {
  if (normalized) {
    copyNumbers<T, true>(run, components, to);
  } else {
    copyNumbers<T, false>(run, components, to);
  }
}

void copyNumbers(const Run& run, int componentType, std::size_t components, bool normalized,
                 double* to) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return copyNumbers<std::int8_t>(run, components, normalized, to);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return copyNumbers<std::uint8_t>(run, components, normalized, to);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return copyNumbers<std::int16_t>(run, components, normalized, to);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return copyNumbers<std::uint16_t>(run, components, normalized, to);
    case TINYGLTF_COMPONENT_TYPE_INT:
      return copyNumbers<std::int32_t>(run, components, normalized, to);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return copyNumbers<std::uint32_t>(run, components, normalized, to);
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return copyNumbers<float>(run, components, normalized, to);
    default:
      return copyNumbers<double>(run, components, normalized, to);
  }
}

template <class T>
void copyIndices(const Run& run, Index* to) {
  for (std::size_t i = 0; i < run.count; ++i) to[i] = load<T>(run.first + i * run.stride);
}

bool canBeIndex(int componentType) {
  return componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
         componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

void copyIndices(const Run& run, int componentType, Index* to) {
  if (componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE)
    return copyIndices<std::uint8_t>(run, to);
  if (componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT)
    return copyIndices<std::uint16_t>(run, to);
  return copyIndices<std::uint32_t>(run, to);
}

std::string placeOf(std::uint32_t accessor) { return "/accessors/" + std::to_string(accessor); }

}  // namespace

void appendComponents(std::span<const std::byte> bytes, int componentType, bool normalized,
                      std::vector<double>& numbers) {
  const std::size_t count = bytes.size() / bytesOf(componentType);
  const std::size_t before = numbers.size();
  numbers.resize(before + count);
  copyNumbers({bytes.data(), bytesOf(componentType), count}, componentType, 1, normalized,
              numbers.data() + before);
}

/// Elements that are all inside a buffer view.
struct GltfAccessors::Elements {
  const std::byte* first{nullptr};
  std::size_t stride{0};
};

Result<GltfAccessors::Elements> GltfAccessors::elementsOf(std::uint32_t view,
                                                          const std::string& viewUser,
                                                          std::uint64_t offset, std::uint64_t count,
                                                          std::size_t elementBytes,
                                                          const std::string& place) {
  auto bytes = buffers_.view(view, viewUser);
  if (!bytes) return bytes.error();
  const std::uint64_t given = model_.bufferViews[view].byteStride;
  const std::uint64_t stride = given == 0 ? elementBytes : given;
  if (stride < elementBytes) {
    return faultAt("/bufferViews/" + std::to_string(view) + "/byteStride",
                   "is " + std::to_string(stride) + ", less than the " +
                       std::to_string(elementBytes) + " bytes of an element of " + place);
  }
  const std::uint64_t size = bytes.value().size();
  // In terms of what fits, so that nothing can overflow.
  const bool fits = offset <= size && elementBytes <= size - offset &&
                    count - 1 <= (size - offset - elementBytes) / stride;
  if (!fits) {
    return faultAt(place, "claims " + std::to_string(count) +
                              " elements, which reach beyond the end of buffer view " +
                              std::to_string(view));
  }
  return Elements{bytes.value().data() + offset, static_cast<std::size_t>(stride)};
}

Result<const tinygltf::Accessor*> GltfAccessors::find(std::uint32_t number, int shape,
                                                      const std::string& user) const {
  if (number >= model_.accessors.size()) {
    return faultAt(user, "there is no accessor " + std::to_string(number));
  }
  const tinygltf::Accessor& accessor = model_.accessors[number];
  if (accessor.type != shape) {
    return faultAt(placeOf(number) + "/type", "is " + std::string(shapeText(accessor.type)) +
                                                  ", but " + user + " needs " +
                                                  std::string(shapeText(shape)));
  }
  if (accessor.count == 0) return faultAt(placeOf(number) + "/count", "is 0");
  return &accessor;
}

/// Calls `put(first element, run)` for every run of elements that have bytes behind them, later
/// ones over earlier ones. All counts are checked, and paid for, before the first call.
template <class Put>
Result<std::size_t> GltfAccessors::forEachRun(const tinygltf::Accessor& accessor,
                                              const std::string& place, const Put& put) {
  const std::size_t elementBytes = bytesOf(accessor.componentType) * componentsOf(accessor.type);
  std::optional<Elements> base;
  if (const GltfReference view = referenceOf(accessor.bufferView)) {
    auto elements = elementsOf(*view, place + "/bufferView", accessor.byteOffset, accessor.count,
                               elementBytes, place);
    if (!elements) return elements.error();
    base = elements.value();
  }
  std::optional<Elements> indices, values;
  const auto& sparse = accessor.sparse;
  if (sparse.isSparse) {
    const std::string sparsePlace = place + "/sparse";
    if (!canBeIndex(sparse.indices.componentType)) {
      return faultAt(sparsePlace + "/indices/componentType", "is not an unsigned integer");
    }
    if (sparse.count == 0) return faultAt(sparsePlace + "/count", "is 0");
    auto foundIndices =
        elementsOf(unsignedOf(sparse.indices.bufferView), sparsePlace + "/indices/bufferView",
                   unsignedOf(sparse.indices.byteOffset), unsignedOf(sparse.count),
                   bytesOf(sparse.indices.componentType), sparsePlace);
    if (!foundIndices) return foundIndices.error();
    auto foundValues = elementsOf(
        unsignedOf(sparse.values.bufferView), sparsePlace + "/values/bufferView",
        unsignedOf(sparse.values.byteOffset), unsignedOf(sparse.count), elementBytes, sparsePlace);
    if (!foundValues) return foundValues.error();
    indices = foundIndices.value();
    values = foundValues.value();
  }
  // Far below what the memory of WebAssembly could hold.
  constexpr std::uint64_t kMost = std::numeric_limits<std::size_t>::max() / 64;
  if (accessor.count > kMost || !budget_.take(accessor.count)) {
    return makeError(ErrorCode::LimitExceeded, -1,
                     place + ": its " + std::to_string(accessor.count) +
                         " elements make the model far larger than its file");
  }
  const auto count = static_cast<std::size_t>(accessor.count);
  put.prepare(count);
  if (base) put(0, Run{base->first, base->stride, count});
  if (!sparse.isSparse) return count;
  for (std::size_t i = 0; i < unsignedOf(sparse.count); ++i) {
    Index target = 0;
    copyIndices({indices->first + i * indices->stride, 0, 1}, sparse.indices.componentType,
                &target);
    if (target >= accessor.count) {
      return faultAt(place + "/sparse", "replaces element " + std::to_string(target) + " of " +
                                            std::to_string(accessor.count));
    }
    put(target, Run{values->first + i * values->stride, 0, 1});
  }
  return count;
}

Result<std::size_t> GltfAccessors::appendNumbers(std::uint32_t number, int shape,
                                                 const std::string& user,
                                                 std::vector<double>& numbers) {
  auto accessor = find(number, shape, user);
  if (!accessor) return accessor.error();
  struct Put {
    const tinygltf::Accessor& accessor;
    std::size_t components, before;
    std::vector<double>& numbers;

    void prepare(std::size_t count) const { numbers.resize(before + components * count); }
    void operator()(std::size_t first, const Run& run) const {
      copyNumbers(run, accessor.componentType, components, accessor.normalized,
                  numbers.data() + before + components * first);
    }
  };
  return forEachRun(*accessor.value(), placeOf(number),
                    Put{*accessor.value(), componentsOf(shape), numbers.size(), numbers});
}

Result<std::size_t> GltfAccessors::appendIndices(std::uint32_t number, const std::string& user,
                                                 std::vector<Index>& indices) {
  auto accessor = find(number, TINYGLTF_TYPE_SCALAR, user);
  if (!accessor) return accessor.error();
  if (!canBeIndex(accessor.value()->componentType)) {
    return faultAt(placeOf(number) + "/componentType",
                   "is not an unsigned integer, but " + user + " needs one");
  }
  struct Put {
    const tinygltf::Accessor& accessor;
    std::size_t before;
    std::vector<Index>& indices;

    void prepare(std::size_t count) const { indices.resize(before + count); }
    void operator()(std::size_t first, const Run& run) const {
      copyIndices(run, accessor.componentType, indices.data() + before + first);
    }
  };
  return forEachRun(*accessor.value(), placeOf(number),
                    Put{*accessor.value(), indices.size(), indices});
}

}  // namespace girth::io
