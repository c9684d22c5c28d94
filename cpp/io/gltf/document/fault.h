// Faults of a glTF document, named by JSON pointer.
#pragma once

#include <string>

#include "girth/error.h"

namespace girth::io {

/// MALFORMED_FILE: "/accessors/3/bufferView: there is no buffer view 7". An empty pointer is the
/// document itself.
Error faultAt(const std::string& pointer, const std::string& what);

}  // namespace girth::io
