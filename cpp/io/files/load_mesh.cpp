#include "girth/io/load_mesh.h"

#include <utility>

#include "files/read_file.h"

namespace girth::io {
namespace {

Error ofFile(const std::string& path, Error error) {
  error.file = path;
  return error;
}

}  // namespace

Result<LoadedMesh> loadMesh(const std::string& path, const PrepareOptions& options,
                            const ExecutionContext& context) {
  const auto bytes = readFile(path);
  if (!bytes) return ofFile(path, bytes.error());
  auto loaded = readMesh(bytes.value(), path, resourcesBeside(path), options, context);
  if (!loaded) return ofFile(path, loaded.error());
  return loaded;
}

Result<ReadModel> loadModel(const std::string& path) {
  const auto bytes = readFile(path);
  if (!bytes) return ofFile(path, bytes.error());
  auto model = readModel(bytes.value(), path, resourcesBeside(path));
  if (!model) return ofFile(path, model.error());
  return model;
}

}  // namespace girth::io
