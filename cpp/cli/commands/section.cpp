// girth section: the curves in which planes cut a surface.
#include "girth/section.h"

#include <algorithm>
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
#include "commands/section_landmarks.h"
#include "commands/table.h"
#include "girth/describe/landmarks.h"
#include "girth/describe/section.h"
#include "girth/io/result_csv.h"
#include "girth/io/result_json.h"
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
  bool across{false};
  bool widest{false};
  bool narrowest{false};
  bool byTape{false};
  bool inscribed{false};
  bool limbs{false};
  /// One tape, and one row, for all curves of a plane.
  bool overAll{false};
  /// As typed: two lengths.
  std::string within;
  std::string landmarks;
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

/// A typed height: a length, but one below 0 too.
std::optional<Error> readHeight(const std::string& text, const std::string& unit, double& height) {
  const bool isBelow = text.starts_with('-');
  auto error = readLength(isBelow ? text.substr(1) : text, unit, height);
  if (isBelow) height = -height;
  return error;
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
                                      const HeightRange& range) {
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
  std::vector<double> offsets;
  for (const std::string& text : options.heights) {
    if (auto error = readHeight(text, loaded.unit, offsets.emplace_back())) {
      return *std::move(error);
    }
  }
  return offsets.empty() ? evenly(range, 1) : offsets;
}

/// The typed range; the whole of it where none was typed.
Result<HeightRange> typedRange(const Options& options, const io::LoadedMesh& loaded,
                               const HeightRange& whole) {
  if (options.within.empty()) return whole;
  HeightRange range;
  const std::size_t comma = options.within.find(',');
  if (comma == std::string::npos || comma == 0 || comma + 1 == options.within.size()) {
    return usageError("--within " + options.within + " is no range",
                      "type two heights, as in 0.9m,1.2m");
  }
  if (auto error = readHeight(options.within.substr(0, comma), loaded.unit, range.low)) {
    return *std::move(error);
  }
  if (auto error = readHeight(options.within.substr(comma + 1), loaded.unit, range.high)) {
    return *std::move(error);
  }
  return range;
}

Sections only(Section section) {
  Sections sections;
  sections.sections.push_back(std::move(section));
  return sections;
}

/// The plane through a point, across the limb or tube there or with the usual normal.
Result<Sections> throughPoint(const Options& options, const io::LoadedMesh& loaded,
                              const Vec3& direction) {
  const auto point = surfacePoint(loaded, *options.through, options.model, options.preparing);
  if (!point) return point.error();
  return sectionsThrough(loaded.mesh,
                         {{point.value()}, direction, options.across, options.inscribed},
                         {options.threads, nullptr, {}});
}

Result<Sections> extreme(const Options& options, const io::LoadedMesh& loaded,
                         const Vec3& direction, const HeightRange& whole) {
  const auto range = typedRange(options, loaded, whole);
  if (!range) return range.error();
  auto section = extremeSection(
      loaded.mesh,
      {direction, options.widest ? SectionExtreme::Widest : SectionExtreme::Narrowest,
       range.value().low, range.value().high,
       options.byTape ? SectionMeasure::Tape : SectionMeasure::Perimeter, options.inscribed},
      {options.threads, nullptr, {}});
  if (!section) return section.error();
  return only(std::move(section).value());
}

/// Finds the limbs of the model, and that of each curve.
std::optional<Error> findLimbsOf(const Options& options, const io::LoadedMesh& loaded,
                                 Sections& sections) {
  const auto tips = computeTips(options.model, loaded.mesh, 0, options.threads);
  if (!tips) return tips.error();
  ProgressLine progress(options.model);
  const auto limbs = findLimbs(loaded.mesh, tips.value().girth.values, tips.value().tips.tips, {},
                               watched(options.threads, progress));
  if (!limbs) return limbs.error();
  placeOnLimbs(loaded.mesh, limbs.value().limbs, sections);
  return std::nullopt;
}

Result<Sections> compute(const Options& options, const io::LoadedMesh& loaded) {
  const Vec3 direction = options.along.value_or(usualDirection(loaded));
  const auto range = heightRange(loaded.mesh, direction);
  if (!range) return usageError("--along 0,0,0 is no direction", "type x, y, z or as 0,0.5,1");
  auto found = [&]() -> Result<Sections> {
    if (options.through && options.every.empty()) return throughPoint(options, loaded, direction);
    if (options.widest || options.narrowest) {
      return extreme(options, loaded, direction, range.value());
    }
    const auto offsets = offsetsOf(options, loaded, range.value());
    if (!offsets) return offsets.error();
    return findSections(loaded.mesh, {direction, offsets.value(), options.inscribed},
                        {options.threads, nullptr, {}});
  }();
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
  if (options.limbs) {
    if (auto error = findLimbsOf(options, loaded, found.value())) return *std::move(error);
  }
  return found;
}

/// Words on a curve besides its measures.
std::string wordsOf(const SectionCurve& curve) {
  std::string words;
  if (!std::isnan(curve.inscribedDiameter)) {
    words += "  (circle " + readable(curve.inscribedDiameter) + ")";
  }
  if (curve.limb != kNoIndex) words += "  (limb " + std::to_string(curve.limb) + ")";
  if (curve.hole) words += "  (a hole)";
  if (!curve.closed) words += "  (open)";
  return words;
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
      std::printf("  %7zu %12s %5zu %12s %12s %12s %12s %12s%s\n", s,
                  readable(section.offset).c_str(), c, readable(curve.perimeter).c_str(),
                  readable(curve.tape).c_str(), readable(curve.area).c_str(),
                  readable(curve.leastWidth).c_str(), readable(curve.greatestWidth).c_str(),
                  wordsOf(curve).c_str());
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

/// A row for each plane: one tape round all of its curves.
void printPlanes(const std::string& model, const io::LoadedMesh& loaded, const Sections& found) {
  const std::size_t count = found.sections.size();
  std::printf("%s: %zu section%s\n", model.c_str(), count, count == 1 ? "" : "s");
  std::printf("  %7s %12s %6s %12s %12s %12s\n", "section", "offset", "curves", "perimeter", "tape",
              "area");
  for (std::size_t s = 0; s < std::min(count, kMostRows); ++s) {
    const Section& section = found.sections[s];
    std::printf("  %7zu %12s %6zu %12s %12s %12s\n", s, readable(section.offset).c_str(),
                section.curves.size(), readable(section.perimeter).c_str(),
                readable(section.tape).c_str(), readable(section.area).c_str());
  }
  if (count > kMostRows) {
    std::printf("  ... and %zu more sections, which -o writes\n", count - kMostRows);
  }
  printUnits(loaded.unit);
}

void printMeasures(const std::string& model, const io::LoadedMesh& loaded,
                   const NamedMeasures& found) {
  std::printf("%s: %zu measure%s\n", model.c_str(), found.measures.size(),
              found.measures.size() == 1 ? "" : "s");
  for (const NamedMeasure& measure : found.measures) {
    std::printf("  %12s  %-8s  %s\n", readable(measure.length).c_str(),
                std::string(toString(measure.how)).c_str(), measure.name.c_str());
  }
  printUnits(loaded.unit);
}

/// The measures at the landmarks of a file.
int measureNamed(const Options& options) {
  const auto refuse = [](const io::LoadedMesh&, const NamedMeasures&) -> Result<std::string> {
    return usageError("measures at landmarks are no lines", "write them as .json or .csv");
  };
  const Writers<NamedMeasures> writers{
      {{".csv", io::resultCsv<NamedMeasures>}, {".obj", refuse}, {".glb", refuse}},
      [&](const io::LoadedMesh& loaded, const NamedMeasures& found) {
        return io::resultJson(loaded, found, options.model);
      },
      [&](const io::LoadedMesh& loaded, const NamedMeasures& found) {
        printMeasures(options.model, loaded, found);
      }};
  return measure<NamedMeasures>(
      options,
      [&](const io::LoadedMesh& loaded) {
        auto landmarks = landmarksOf(options.landmarks, loaded, options.model, options.preparing);
        if (!landmarks) return Result<NamedMeasures>(landmarks.error());
        return measureLandmarks(
            loaded.mesh,
            {std::move(landmarks).value(), options.along.value_or(usualDirection(loaded))},
            {options.threads, nullptr, {}});
      },
      writers);
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  const Writers<Sections> writers{
      {{".csv",
        [options](const io::LoadedMesh& loaded, const Sections& sections) {
          return options->overAll ? io::sectionPlanesCsv(loaded, sections)
                                  : io::sectionsCsv(loaded, sections);
        }},
       {".obj", io::sectionsObj},
       {".glb", io::sectionsGlb}},
      [options](const io::LoadedMesh& loaded, const Sections& sections) {
        return io::sectionsJson(loaded, sections, options->model);
      },
      [options](const io::LoadedMesh& loaded, const Sections& sections) {
        if (options->overAll) return printPlanes(options->model, loaded, sections);
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
  table
      .add("--across", options->across,
           "The plane through the point is perpendicular to the limb or tube there: to the normal "
           "of the mean plane of the point's girth loop")
      .needs("--through");
  table.add("--widest", options->widest, "The plane with the greatest perimeter")
      .excludes("--narrowest");
  table
      .add("--narrowest", options->narrowest,
           "The plane with the least perimeter, of those that meet the surface")
      .needs("--within");
  table.add("--within LOW,HIGH", options->within,
            "The heights between which it is looked for, as in 0.9m,1.2m");
  table.add("--by-tape", options->byTape,
            "--widest and --narrowest compare one tape round all curves of a plane, not the sum of "
            "their perimeters");
  table.onValue(
      "--tape-over WHAT",
      [options](const std::string& text) -> std::string {
        options->overAll = text == "all";
        return options->overAll || text == "curve" ? "" : "tapes go over all or over each curve";
      },
      "all: a row for each plane in text and CSV, with one tape round all of its curves. curve: a "
      "row and a tape for each curve. Default: curve");
  table.add("--inscribed", options->inscribed,
            "Find the largest circle inside each curve too, which takes longer");
  table.add("--limbs", options->limbs,
            "Find the limbs of the model too, and on which one each curve lies");
  table.add(
      "--landmarks FILE", options->landmarks,
      "Named measures: a JSON array of objects with name, point (12, or \"7:0.2,0.3,0.5\"), how "
      "(girth, section, tape or distance), to (of a distance), across and all (true or false)");
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
  table.example("girth section body.glb --narrowest --within 0.9m,1.2m --by-tape",
                "The waist, wherever it is between two heights.");
  table.note("Tape",
             "A tape measure spans hollows: the perimeter of the curve's convex hull. The girth of "
             "a point (girth loop) is a third answer: it need not lie in a plane.");
  return [options, writers] {
    if (!options->landmarks.empty()) return measureNamed(*options);
    return measure(
        *options, [&](const io::LoadedMesh& loaded) { return compute(*options, loaded); }, writers);
  };
}

}  // namespace
}  // namespace section_command

const Command kSection{"section", "Cut a surface with planes, and measure the curves",
                       section_command::add};

}  // namespace girth::cli
