#include "model/curve_file.h"

#include <string_view>

#include "files/read_file.h"
#include "girth/io/read_curves.h"
#include "text/ending.h"

namespace girth::cli {

Result<std::vector<SurfaceCurve>> readCurveFile(const std::string& path,
                                                const io::LoadedMesh& loaded) {
  const auto read = [&]() -> Result<std::vector<SurfaceCurve>> {
    const auto bytes = io::readFile(path);
    if (!bytes) return bytes.error();
    const std::string_view text(reinterpret_cast<const char*>(bytes.value().data()),
                                bytes.value().size());
    return io::endingOf(path) == ".obj" ? io::readCurvesObj(text, loaded)
                                        : io::readCurves(text, loaded);
  };
  auto curves = read();
  if (curves) return curves;
  Error error = curves.error();
  error.file = path;
  return error;
}

}  // namespace girth::cli
