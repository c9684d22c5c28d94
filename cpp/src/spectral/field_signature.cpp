#include "girth/fields.h"
#include "girth/heat_kernel.h"
#include "girth/wave_kernel.h"

namespace girth {

Result<VertexSignatures> fieldSignature(const Spectrum& spectrum, std::string_view name,
                                        std::span<const double> times) {
#define GIRTH_SPECTRAL_FIELD(field, unit, title, listTitle, meaning, signature, number, count) \
  if (name == #field) return signature;
#include "girth/fields.def"
  return makeError(ErrorCode::Usage, -1, "there is no field '" + std::string(name) + "'");
}

}  // namespace girth
