#include "gltf/unpack/point_numbers.h"

#include "gltf/document/fault.h"

namespace girth::io {

std::optional<Error> PointNumbers::append(const PointSource& source, int shape,
                                          const std::string& user, std::size_t& count,
                                          std::vector<double>& numbers) {
  auto description = accessors_.find(source.accessor, shape, user);
  if (!description) return description.error();
  std::size_t found = 0;
  if (source.packed != nullptr && source.packedNumber) {
    const tinygltf::Accessor& kind = *description.value();
    const DracoMesh& packed = *source.packed;
    const auto bytes =
        packed.attribute(*source.packedNumber, componentsOf(shape), kind.componentType);
    if (!bytes) {
      return faultAt(user, "its Draco stream has no attribute " +
                               std::to_string(*source.packedNumber) + " of type " +
                               std::string(shapeText(shape)));
    }
    if (kind.count != packed.pointCount()) {
      return faultAt("/accessors/" + std::to_string(source.accessor) + "/count",
                     "is " + std::to_string(kind.count) + ", but its Draco stream holds " +
                         std::to_string(packed.pointCount()));
    }
    if (!budget_.take(kind.count)) {
      return makeError(ErrorCode::LimitExceeded, -1,
                       user + ": makes the model far larger than its file");
    }
    appendComponents(*bytes, kind.componentType, kind.normalized, numbers);
    found = packed.pointCount();
  } else {
    auto read = accessors_.appendNumbers(source.accessor, shape, user, numbers);
    if (!read) return read.error();
    found = read.value();
  }
  if (count != 0 && found != count) return otherCount(user, found, count);
  count = found;
  return std::nullopt;
}

Error PointNumbers::otherCount(const std::string& user, std::uint64_t found, std::size_t count) {
  return faultAt(
      user, "has " + std::to_string(found) + " values for " + std::to_string(count) + " points");
}

}  // namespace girth::io
