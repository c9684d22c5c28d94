#include "girth/io/write_handles.h"

#include <cstddef>

#include "girth/describe/handles.h"
#include "girth/io/result_json.h"
#include "text/number_text.h"
#include "write/glb_writer.h"
#include "write/point_json.h"

namespace girth::io {
namespace {

std::string kindOf(const Handle& handle) { return std::string(toString(handle.kind)); }

/// Its kind and its number.
std::string nameOf(const Handles& handles, std::size_t i) {
  return kindOf(handles.handles[i]) + "_" + std::to_string(i);
}

}  // namespace

std::string handlesJson(const LoadedMesh& loaded, const Handles& handles, std::string_view file) {
  return resultJson(loaded, handles, file);
}

std::string handlesCsv(const LoadedMesh& loaded, const Handles& handles) {
  std::string text = "handle,length,kind,component,area,x,y,z,unit,mayBeShorterBy\n";
  for (std::size_t i = 0; i < handles.handles.size(); ++i) {
    const Handle& handle = handles.handles[i];
    text += std::to_string(i) + "," + formatNumber(handle.length) + "," + kindOf(handle) + "," +
            std::to_string(handle.component) + "," + formatNumber(handle.area) + "," +
            pointText(handle.centre, ',') + "," + loaded.unit + "," +
            formatNumber(handle.mayBeShorterBy) + "\n";
  }
  return text;
}

std::string handlesObj(const LoadedMesh& loaded, const Handles& handles) {
  std::string text;
  std::size_t count = 0;
  for (std::size_t i = 0; i < handles.handles.size(); ++i) {
    text += "o " + nameOf(handles, i) + "\n";
    appendLine(loaded, handles.handles[i].points, true, count, text);
  }
  return text;
}

Result<std::string> handlesGlb(const LoadedMesh& loaded, const Handles& handles) {
  GlbWriter writer;
  for (std::size_t i = 0; i < handles.handles.size(); ++i) {
    const Handle& handle = handles.handles[i];
    addLine(loaded, handle.points,
            JsonObject()
                .add("length", handle.length)
                .add("kind", toString(handle.kind))
                .add("unit", loaded.unit)
                .text(),
            nameOf(handles, i), writer);
  }
  return writer.file(loaded.unit);
}

}  // namespace girth::io
