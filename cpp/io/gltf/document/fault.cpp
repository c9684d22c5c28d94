#include "gltf/document/fault.h"

namespace girth::io {

Error faultAt(const std::string& pointer, const std::string& what) {
  return makeError(ErrorCode::MalformedFile, -1,
                   (pointer.empty() ? "its JSON" : pointer + ":") + ' ' + what);
}

}  // namespace girth::io
