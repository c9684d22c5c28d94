// In place of Draco and meshopt. In WebAssembly the page unpacks glTF with the decoders' own
// WebAssembly modules, loaded only where they are needed, before the reader sees the file.
#include <utility>

#include "gltf/unpack/draco.h"
#include "gltf/unpack/meshopt.h"

namespace girth::io {
namespace {

Error unsupported(const std::string& place, const std::string& extension) {
  return makeError(ErrorCode::UnsupportedFeature, -1,
                   place + ": the geometry is compressed with the glTF extension " + extension +
                       ", which has to be unpacked first");
}

}  // namespace

Result<std::vector<std::byte>> unpackMeshopt(const GltfMeshopt& packed, std::span<const std::byte>,
                                             SoupBudget&, const std::string& place) {
  return unsupported(place, packed.extension);
}

struct DracoMesh::Content {};

DracoMesh::DracoMesh(std::unique_ptr<Content> content) : content_(std::move(content)) {}
DracoMesh::DracoMesh(DracoMesh&&) noexcept = default;
DracoMesh& DracoMesh::operator=(DracoMesh&&) noexcept = default;
DracoMesh::~DracoMesh() = default;

Result<DracoMesh> DracoMesh::unpack(std::span<const std::byte>, const std::vector<std::uint32_t>&,
                                    SoupBudget&, const std::string& place) {
  return unsupported(place, "KHR_draco_mesh_compression");
}

std::size_t DracoMesh::pointCount() const { return 0; }
std::size_t DracoMesh::faceCount() const { return 0; }
void DracoMesh::appendFaces(std::vector<Index>&) const {}
std::optional<std::vector<std::byte>> DracoMesh::attribute(std::uint32_t, std::size_t, int) const {
  return std::nullopt;
}

}  // namespace girth::io
