#include "girth/version.h"

namespace girth {

std::string_view version() { return GIRTH_VERSION; }

}  // namespace girth
