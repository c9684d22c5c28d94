#include "girth/io/write_tighten.h"

#include <cstddef>

#include "girth/io/json_text.h"
#include "write/glb_writer.h"
#include "write/point_json.h"

namespace girth::io {

std::string tightObj(const LoadedMesh& loaded, const TightCurve& curve) {
  if (curve.kind == TightKind::Point) return "# the curve contracts to a point\n";
  std::string text;
  std::size_t count = 0;
  appendLine(loaded, curve.points, curve.kind == TightKind::Loop, count, text);
  return text;
}

Result<std::string> tightGlb(const LoadedMesh& loaded, const TightCurve& curve) {
  GlbWriter writer;
  if (curve.kind != TightKind::Point) {
    addLine(loaded, curve.points,
            JsonObject()
                .add("kind", toString(curve.kind))
                .add("promise", toString(curve.promise))
                .add("lengthBefore", curve.lengthBefore)
                .add("length", curve.length)
                .add("unit", loaded.unit)
                .text(),
            "tight", writer);
  }
  return writer.file(loaded.unit);
}

}  // namespace girth::io
