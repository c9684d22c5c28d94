#include "girth/io/write_section.h"

#include <cstddef>
#include <string>

#include "girth/describe/section.h"
#include "girth/io/result_csv.h"
#include "girth/io/result_json.h"
#include "text/number_text.h"
#include "write/glb_writer.h"
#include "write/point_json.h"

namespace girth::io {
namespace {

/// Calls `visit(section, its number, curve, its number)` for all curves.
template <class Visit>
void forEachCurve(const Sections& sections, const Visit& visit) {
  for (std::size_t s = 0; s < sections.sections.size(); ++s) {
    const Section& section = sections.sections[s];
    for (std::size_t c = 0; c < section.curves.size(); ++c) {
      visit(section, s, section.curves[c], c);
    }
  }
}

std::string nameOf(std::size_t section, std::size_t curve) {
  return "section_" + std::to_string(section) + "_curve_" + std::to_string(curve);
}

}  // namespace

std::string sectionsJson(const LoadedMesh& loaded, const Sections& sections,
                         std::string_view file) {
  return resultJson(loaded, sections, file);
}

std::string sectionsCsv(const LoadedMesh& loaded, const Sections& sections) {
  ResultCsv<SectionCurve> csv(loaded, "section,offset,curve,limb");
  forEachCurve(sections, [&](const Section& section, std::size_t s, const SectionCurve& curve,
                             std::size_t c) {
    csv.add(curve, std::to_string(s) + "," + formatNumber(section.offset) + "," +
                       std::to_string(c) + "," +
                       (curve.limb == kNoIndex ? "" : std::to_string(curve.limb)));
  });
  return csv.text();
}

std::string sectionPlanesCsv(const LoadedMesh& loaded, const Sections& sections) {
  std::string text = "section,offset,curves,perimeter,tape,area,unit\n";
  for (std::size_t s = 0; s < sections.sections.size(); ++s) {
    const Section& section = sections.sections[s];
    text += std::to_string(s) + "," + formatNumber(section.offset) + "," +
            std::to_string(section.curves.size());
    for (const double measure : {section.perimeter, section.tape, section.area}) {
      text += "," + formatNumber(measure);
    }
    text += "," + loaded.unit + "\n";
  }
  return text;
}

std::string sectionsObj(const LoadedMesh& loaded, const Sections& sections) {
  std::string text;
  std::size_t count = 0;
  forEachCurve(sections,
               [&](const Section&, std::size_t s, const SectionCurve& curve, std::size_t c) {
                 text += "o " + nameOf(s, c) + "\n";
                 appendLine(loaded, curve.points, curve.closed, count, text);
               });
  return text;
}

Result<std::string> sectionsGlb(const LoadedMesh& loaded, const Sections& sections) {
  GlbWriter writer;
  forEachCurve(sections, [&](const Section& section, std::size_t s, const SectionCurve& curve,
                             std::size_t c) {
    addLine(loaded, curve.points,
            JsonObject()
                .add("offset", section.offset)
                .add("perimeter", curve.perimeter)
                .add("tape", curve.tape)
                .add("area", curve.area)
                .add("unit", loaded.unit)
                .text(),
            nameOf(s, c), writer);
  });
  return writer.file(loaded.unit);
}

}  // namespace girth::io
