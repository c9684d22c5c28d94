// girth section: the curves in which planes cut a surface.
#include "girth/section.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "commands/common_options.h"
#include "commands/measure.h"
#include "commands/table.h"
#include "girth/io/write_section.h"
#include "model/computing.h"
#include "model/typed_point.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace section_command {
namespace {

constexpr std::int64_t kMostPlanes = 100'000;
/// Rows that are printed.
constexpr std::size_t kMostRows = 50;

struct Options : MeasuringOptions {
  std::optional<Vec3> along;
  std::vector<std::string> heights;
  std::optional<TypedPoint> through;
  std::optional<std::int64_t> levels;
  std::string every;
};

/// Reads an axis (x, y, z, -x, -y or -z), or three numbers with commas between. Returns what is
/// wrong with it; empty: nothing.
std::string readDirection(const std::string& text, std::optional<Vec3>& direction) {
  constexpr std::string_view kAxes = "xyz";
  const bool isNegative = text.starts_with('-');
  const std::string axis = text.substr(isNegative ? 1 : 0);
  std::array<double, 3> numbers{0, 0, 0};
  if (axis.size() == 1 && kAxes.find(axis) != std::string_view::npos) {
    numbers[kAxes.find(axis)] = isNegative ? -1 : 1;
  } else if (std::string problem = readWeights(text, numbers); !problem.empty()) {
    return problem + "; a direction is x, y, z, -x, -y, -z, or as 0,0.5,1";
  }
  direction = Vec3{numbers[0], numbers[1], numbers[2]};
  return "";
}

/// glTF has the axis y upwards; in other formats it is mostly z.
Vec3 usualDirection(const io::LoadedMesh& loaded) {
  const bool isGltf = loaded.format == io::Format::Glb || loaded.format == io::Format::Gltf;
  return isGltf ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
}

/// Planes of the same distance, the outermost half of it within the model.
std::vector<double> evenly(const HeightRange& range, double count) {
  std::vector<double> offsets;
  for (double i = 0; i < count; ++i) {
    offsets.push_back(range.low + (i + 0.5) / count * (range.high - range.low));
  }
  return offsets;
}

/// Where the planes lie.
Result<std::vector<double>> offsetsOf(const Options& options, const io::LoadedMesh& loaded,
                                      const Vec3& normal, const HeightRange& range) {
  if (options.levels) return evenly(range, static_cast<double>(*options.levels));
  if (!options.every.empty()) {
    double step = 0;
    if (auto error = readLength(options.every, loaded.unit, step)) return *std::move(error);
    if (!(step > 0)) return usageError("--every needs a length above 0", "type one as in 5mm");
    const double first = std::floor(range.low / step) + 1, last = std::ceil(range.high / step) - 1;
    if (!(last - first < static_cast<double>(kMostPlanes))) {
      return usageError("--every " + options.every + " makes more than " +
                            std::to_string(kMostPlanes) + " planes",
                        "take a greater length");
    }
    std::vector<double> offsets;
    for (double i = first; i <= last; ++i) offsets.push_back(i * step);
    return offsets;
  }
  if (options.through) {
    const auto point = surfacePoint(loaded, *options.through, options.model, options.preparing);
    if (!point) return point.error();
    const Vec3 place = positionOf(loaded.mesh, point.value());
    const double length =
        std::sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
    return std::vector<double>{(normal.x * place.x + normal.y * place.y + normal.z * place.z) /
                               length};
  }
  std::vector<double> offsets;
  for (const std::string& text : options.heights) {
    if (auto error = readLength(text, loaded.unit, offsets.emplace_back())) {
      return *std::move(error);
    }
  }
  return offsets.empty() ? evenly(range, 1) : offsets;
}

Result<Sections> compute(const Options& options, const io::LoadedMesh& loaded) {
  const Vec3 direction = options.along.value_or(usualDirection(loaded));
  const auto range = heightRange(loaded.mesh, direction);
  if (!range) return usageError("--along 0,0,0 is no direction", "type x, y, z or as 0,0.5,1");
  const auto offsets = offsetsOf(options, loaded, direction, range.value());
  if (!offsets) return offsets.error();
  const auto found =
      findSections(loaded.mesh, direction, offsets.value(), {options.threads, nullptr, {}});
  if (!found) return found.error();
  bool isAny = false;
  for (const Section& section : found.value().sections) isAny = isAny || !section.curves.empty();
  if (!isAny) {
    const std::string unit = unitSuffix(loaded.unit);
    return usageError("no plane meets the surface",
                      "along this direction the model reaches from " + readable(range.value().low) +
                          " to " + readable(range.value().high) + unit +
                          "; its lowest faces have nothing below them");
  }
  return found;
}

void printText(const std::string& model, const io::LoadedMesh& loaded, const Sections& sections) {
  std::printf("%s: %zu section%s\n", model.c_str(), sections.sections.size(),
              sections.sections.size() == 1 ? "" : "s");
  std::printf("  %7s %12s %5s %12s %12s %12s %12s %12s\n", "section", "offset", "curve",
              "perimeter", "tape", "area", "least width", "greatest");
  std::size_t rows = 0;
  for (std::size_t s = 0; s < sections.sections.size() && rows < kMostRows; ++s) {
    const Section& section = sections.sections[s];
    for (std::size_t c = 0; c < section.curves.size(); ++c, ++rows) {
      const SectionCurve& curve = section.curves[c];
      std::printf("  %7zu %12s %5zu %12s %12s %12s %12s %12s%s%s\n", s,
                  readable(section.offset).c_str(), c, readable(curve.perimeter).c_str(),
                  readable(curve.tape).c_str(), readable(curve.area).c_str(),
                  readable(curve.leastWidth).c_str(), readable(curve.greatestWidth).c_str(),
                  curve.hole ? "  (a hole)" : "", curve.closed ? "" : "  (open)");
    }
    if (section.curves.empty()) {
      std::printf("  %7zu %12s  no curve\n", s, readable(section.offset).c_str());
      ++rows;
    }
    if (rows >= kMostRows && s + 1 < sections.sections.size()) {
      std::printf("  ... and %zu more sections, which -o writes\n",
                  sections.sections.size() - s - 1);
    }
  }
  printUnits(loaded.unit);
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  const Writers<Sections> writers{
      {{".csv", io::sectionsCsv}, {".obj", io::sectionsObj}, {".glb", io::sectionsGlb}},
      [options](const io::LoadedMesh& loaded, const Sections& sections) {
        return io::sectionsJson(loaded, sections, options->model);
      },
      [options](const io::LoadedMesh& loaded, const Sections& sections) {
        printText(options->model, loaded, sections);
      }};
  table.add("MODEL", options->model, "The model to read").required();
  table.onValue(
      "--along DIRECTION",
      [options](const std::string& text) { return readDirection(text, options->along); },
      "The planes' normal: x, y, z, -x, -y, -z or three numbers with commas between. "
      "Default: up, which is y in glTF and z in other formats");
  table
      .add("--at-height LENGTH", options->heights,
           "Where a plane cuts, along the normal, in the model's own coordinates, as in 1.05m. May "
           "be given several times. Default: half-way")
      .excludes("--levels");
  table
      .onValue(
          "--through POINT",
          [options](const std::string& text) {
            return readPoint(text, options->through.emplace());
          },
          "The plane passes a vertex, by its number, or a point of a face, FACE:U,V,W")
      .excludes("--at-height");
  table.add("--levels N", options->levels, "So many planes, evenly over the whole height")
      .range(1, static_cast<double>(kMostPlanes))
      .excludes("--through");
  table.add("--every LENGTH", options->every, "A plane at every multiple of a length, as in 5mm")
      .excludes("--levels");
  addOutputOptions(table, options->output, writers.endings(),
                   "Write the sections: .json, .csv (a row for each curve), .obj or .glb (lines)");
  addFacesOption(table, options->preparing);
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth section body.glb --at-height 1.05m", "The waist: girth, tape and area.");
  table.example("girth section vessel.stl --unit mm --every 5mm -o sections.csv",
                "Perimeter and area, a row for each curve.");
  table.note("Tape",
             "A tape measure spans hollows: the perimeter of the curve's convex hull. The girth of "
             "a point (girth loop) is a third answer: it need not lie in a plane.");
  return [options, writers] {
    return measure(
        *options, [&](const io::LoadedMesh& loaded) { return compute(*options, loaded); }, writers);
  };
}

}  // namespace
}  // namespace section_command

const Command kSection{"section", "Cut a surface with planes, and measure the curves",
                       section_command::add};

}  // namespace girth::cli
