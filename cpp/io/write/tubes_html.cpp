// The report on tubes. Plain HTML and SVG: it is read in ten years' time, and printed.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "girth/io/length_unit.h"
#include "girth/io/write_tubes.h"
#include "text/html_text.h"

namespace girth::io {
namespace {

constexpr const char* kPageStyle = R"(
:root{color-scheme:light dark;--ink:#1b1d21;--soft:#5b616b;--line:#d9dce1;--paper:#fff;--narrow:#a8321e;--wide:#6d3fc0;--one:#0b6b75;--two:#8a6d00;--three:#56707a}
@media (prefers-color-scheme:dark){:root{--ink:#e8eaed;--soft:#a3a9b3;--line:#363a41;--paper:#15171a;--narrow:#f0907c;--wide:#b89cf0;--one:#58c4cf;--two:#d9b23a;--three:#9fb6bf}}
body{margin:0 auto;padding:2.5rem 1.25rem 4rem;max-width:64rem;background:var(--paper);color:var(--ink);font:16px/1.5 system-ui,sans-serif}
h1{font-size:1.6rem;font-weight:600;margin:0 0 .25rem;overflow-wrap:anywhere}h2{font-size:1.1rem;font-weight:600;margin:2.5rem 0 .75rem}
p{margin:.25rem 0 .75rem;max-width:44rem}.soft,figcaption{color:var(--soft)}
.wide{overflow-x:auto}table{border-collapse:collapse;font-variant-numeric:tabular-nums}
th,td{padding:.3rem .55rem;text-align:right;border-bottom:1px solid var(--line);white-space:nowrap}
th:first-child,td:first-child{text-align:left;padding-left:0}thead th{color:var(--soft);font-weight:500}
figure{margin:0}.pictures{display:flex;flex-wrap:wrap;gap:1.5rem}svg{max-width:100%;height:auto}
svg text{fill:var(--soft);font:13px system-ui,sans-serif}svg .narrowing{fill:var(--narrow)}svg .widening{fill:var(--wide)}
)";

/// The symbol of the model's unit.
std::string unitOf(const LoadedMesh& loaded) {
  const LengthUnit* unit = findLengthUnit(loaded.unit);
  return unit == nullptr ? loaded.unit : std::string(unit->symbol);
}

/// A length with four significant digits.
std::string lengthText(double value) {
  if (!std::isfinite(value)) return "–";
  const double size = std::fabs(value);
  const int digits = size > 0 ? 3 - static_cast<int>(std::floor(std::log10(size))) : 3;
  return decimalText(value, std::clamp(digits, 0, 12));
}

std::string percentText(double share) { return decimalText(100 * share, 1) + "%"; }

std::string row(const std::vector<std::string>& cells, const char* tag) {
  std::string text = "<tr>";
  for (const std::string& cell : cells) {
    text += std::string("<") + tag + ">" + cell + "</" + tag + ">";
  }
  return text + "</tr>";
}

std::string tableOf(const std::vector<std::string>& head,
                    const std::vector<std::vector<std::string>>& rows) {
  std::string text = "<div class=\"wide\"><table><thead>" + row(head, "th") + "</thead><tbody>";
  for (const auto& cells : rows) text += row(cells, "td");
  return text + "</tbody></table></div>";
}

/// Places of the model seen along an axis, in a square picture.
class View {
 public:
  static constexpr double kSize = 400, kMargin = 12;

  View(const LoadedMesh& loaded, std::size_t across, std::size_t up)
      : loaded_(loaded), across_(across), up_(up) {
    constexpr double kMost = std::numeric_limits<double>::infinity();
    std::array<double, 2> low{kMost, kMost}, high{-kMost, -kMost};
    for (const Vertex v : loaded.mesh.vertices()) {
      const auto flat = flatten(loaded.mesh.position(v));
      for (std::size_t k = 0; k < 2; ++k) {
        low[k] = std::min(low[k], flat[k]);
        high[k] = std::max(high[k], flat[k]);
      }
    }
    const double extent = std::max({high[0] - low[0], high[1] - low[1], 1e-300});
    scale_ = (kSize - 2 * kMargin) / extent;
    for (std::size_t k = 0; k < 2; ++k) middle_[k] = low[k] / 2 + high[k] / 2;
  }

  std::string place(const Vec3& point) const {
    const auto flat = flatten(point);
    return decimalText(kSize / 2 + scale_ * (flat[0] - middle_[0]), 1) + "," +
           decimalText(kSize / 2 - scale_ * (flat[1] - middle_[1]), 1);
  }

  std::string outline(const std::vector<SurfacePoint>& points, const std::string& look) const {
    std::string text = "<polyline points=\"";
    for (const SurfacePoint& point : points) text += place(positionOf(loaded_.mesh, point)) + " ";
    return text + "\" fill=\"none\" " + look + "/>";
  }

 private:
  std::array<double, 2> flatten(const Vec3& p) const {
    const std::array<double, 3> all{p.x, p.y, p.z};
    return {all[across_], all[up_]};
  }

  const LoadedMesh& loaded_;
  const std::size_t across_, up_;
  std::array<double, 2> middle_{};
  double scale_{1};
};

/// The axis along which the model is longest.
std::size_t longestAxis(const LoadedMesh& loaded) {
  constexpr double kMost = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{kMost, kMost, kMost}, high{-kMost, -kMost, -kMost}, length{};
  for (const Vertex v : loaded.mesh.vertices()) {
    const Vec3& p = loaded.mesh.position(v);
    const std::array<double, 3> all{p.x, p.y, p.z};
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], all[k]);
      high[k] = std::max(high[k], all[k]);
      length[k] = high[k] - low[k];
    }
  }
  return static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
}

/// A round step that divides a length into four to ten.
double roundStep(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length / 4)));
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (length / (factor * power) >= 4) return factor * power;
  }
  return power;
}

/// A tick without digits that say nothing.
std::string tickText(double value, double step) {
  const int digits = static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
  return decimalText(value, std::clamp(digits, 0, 12));
}

std::string colourOf(TubeChange change) {
  return change == TubeChange::Narrowing ? "var(--narrow)" : "var(--wide)";
}

std::string pictureOf(const LoadedMesh& loaded, const Tubes& tubes, std::size_t across,
                      std::size_t up) {
  constexpr const char* kAxes = "xyz";
  const View view(loaded, across, up);
  const std::string size = decimalText(View::kSize, 0);
  std::string text = "<figure><svg role=\"img\" width=\"" + size + "\" viewBox=\"0 0 " + size +
                     " " + size + "\" aria-label=\"Outlines, " + kAxes[across] + " to the right, " +
                     kAxes[up] + " upwards\">";
  // About a hundred outlines show the form.
  const std::size_t step = tubes.stations.size() / 100 + 1;
  for (std::size_t i = 0; i < tubes.stations.size(); i += step) {
    text += view.outline(tubes.stations[i].points, "stroke=\"var(--three)\" stroke-width=\"0.6\"");
  }
  for (const TubeBranch& branch : tubes.branches) {
    text += "<polyline points=\"";
    for (Index i = branch.firstStation; i < branch.endStation; ++i) {
      text += view.place(tubes.stations[i].centre) + " ";
    }
    text += "\" fill=\"none\" stroke=\"var(--ink)\" stroke-width=\"1.5\"/>";
  }
  for (const TubePlace& place : tubes.places) {
    text += view.outline(place.points,
                         "stroke=\"" + colourOf(place.change) + "\" stroke-width=\"2.5\"");
  }
  return text + "</svg><figcaption>" + kAxes[across] + " to the right, " + kAxes[up] +
         " upwards</figcaption></figure>";
}

/// The diameters and the girth along a branch.
std::string plotOf(const Tubes& tubes, std::size_t number) {
  constexpr double kLeft = 60, kTop = 12, kWidth = 620, kHeight = 220;
  const TubeBranch& branch = tubes.branches[number];
  const auto stations = std::span<const TubeStation>(tubes.stations)
                            .subspan(branch.firstStation, branch.endStation - branch.firstStation);
  double most = 0;
  for (const TubeStation& station : stations) {
    most = std::max({most, station.equivalentDiameter, station.inscribedDiameter});
    if (std::isfinite(station.girth)) most = std::max(most, station.girth / std::numbers::pi);
  }
  if (!(most > 0)) return "";
  const double length = std::max(branch.lastDistance - branch.firstDistance, 1e-300);
  const auto x = [&](double at) {
    return decimalText(kLeft + kWidth * (at - branch.firstDistance) / length, 1);
  };
  const auto y = [&](double at) { return decimalText(kTop + kHeight * (1 - at / most), 1); };
  std::string text =
      "<figure><svg role=\"img\" width=\"880\" viewBox=\"0 0 880 275\" aria-label=\""
      "Diameters along branch " +
      std::to_string(number) + "; the numbers are in the table of stations\">";
  const double upStep = roundStep(most), alongStep = roundStep(length);
  for (double at = 0; at <= most; at += upStep) {
    text += "<path d=\"M" + x(branch.firstDistance) + " " + y(at) + "H" + x(branch.lastDistance) +
            "\" fill=\"none\" stroke=\"var(--line)\"/><text text-anchor=\"end\" x=\"" +
            decimalText(kLeft - 8, 0) + "\" y=\"" + y(at - most * 0.02) + "\">" +
            tickText(at, upStep) + "</text>";
  }
  for (double at = std::ceil(branch.firstDistance / alongStep) * alongStep;
       at <= branch.lastDistance; at += alongStep) {
    text += "<path d=\"M" + x(at) + " " + y(0) + "v5\" fill=\"none\" stroke=\"var(--soft)\"/>" +
            "<text text-anchor=\"middle\" x=\"" + x(at) + "\" y=\"" +
            decimalText(kTop + kHeight + 20, 0) + "\">" + tickText(at, alongStep) + "</text>";
  }
  const auto lineOf = [&](const auto& valueOf, const std::string& look, const std::string& name,
                          int place) {
    std::string line = "<path d=\"";
    bool isDrawing = false;
    for (const TubeStation& station : stations) {
      const double value = valueOf(station);
      if (std::isfinite(value)) {
        line += (isDrawing ? "L" : "M") + x(station.distance) + " " + y(value);
      }
      isDrawing = std::isfinite(value);
    }
    const std::string at = decimalText(kTop + 10 + 22 * place, 0);
    return line + "\" fill=\"none\" stroke-width=\"2\" " + look + "/><path d=\"M" +
           decimalText(kLeft + kWidth + 20, 0) + " " + at + "h30\" stroke-width=\"2\" " + look +
           "/><text x=\"" + decimalText(kLeft + kWidth + 58, 0) + "\" y=\"" +
           decimalText(kTop + 14 + 22 * place, 0) + "\">" + name + "</text>";
  };
  text += lineOf([](const TubeStation& one) { return one.equivalentDiameter; },
                 "stroke=\"var(--one)\"", "equivalent", 0);
  text += lineOf([](const TubeStation& one) { return one.inscribedDiameter; },
                 "stroke=\"var(--two)\" stroke-dasharray=\"7 3\"", "inscribed", 1);
  text += lineOf([](const TubeStation& one) { return one.girth / std::numbers::pi; },
                 "stroke=\"var(--three)\" stroke-dasharray=\"2 3\"", "girth / π", 2);
  for (std::size_t i = 0; i < tubes.places.size(); ++i) {
    const TubePlace& place = tubes.places[i];
    if (place.branch != number) continue;
    text += "<path d=\"M" + x(place.beforeDistance) + " " + y(place.beforeDiameter) + "L" +
            x(place.beyondDistance) + " " + y(place.beyondDiameter) + "\" fill=\"none\" stroke=\"" +
            colourOf(place.change) + "\" stroke-dasharray=\"4 3\"/><circle class=\"" +
            std::string(toString(place.change)) + "\" r=\"4\" cx=\"" + x(place.distance) +
            "\" cy=\"" + y(place.equivalentDiameter) + "\"/><text text-anchor=\"middle\" x=\"" +
            x(place.distance) + "\" y=\"" +
            decimalText(kTop + kHeight * (1 - place.equivalentDiameter / most) +
                            (place.change == TubeChange::Narrowing ? 18 : -9),
                        1) +
            "\">" + std::to_string(i) + ": " + percentText(place.degreeByDiameter) + "</text>";
  }
  text += "<text text-anchor=\"middle\" x=\"" + x(branch.firstDistance + length / 2) + "\" y=\"" +
          decimalText(kTop + kHeight + 40, 0) + "\">distance along the centreline</text>";
  return text + "</svg></figure>";
}

}  // namespace

std::string tubesHtml(const LoadedMesh& loaded, const Tubes& tubes, std::string_view file) {
  std::string text =
      "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\"><title>Tubes of " +
      escapedHtml(file) + "</title><style>" + kPageStyle + "</style></head><body><h1>Tubes of " +
      escapedHtml(file) + "</h1><p class=\"soft\">" + std::to_string(tubes.branches.size()) +
      (tubes.branches.size() == 1 ? " branch, " : " branches, ") +
      std::to_string(tubes.places.size()) +
      (tubes.places.size() == 1 ? " narrowing or widening. " : " narrowings and widenings. ") +
      (loaded.unit.empty() ? "Lengths are in the units of the file."
                           : "Lengths are in " + unitOf(loaded) + ".") +
      "</p>";
  if (!tubes.branches.empty()) {
    // The longest side of the model is upright.
    const std::size_t up = longestAxis(loaded);
    text += "<div class=\"pictures\">" + pictureOf(loaded, tubes, up == 0 ? 1 : 0, up) +
            pictureOf(loaded, tubes, up == 2 ? 1 : 2, up) + "</div>";
  }
  if (!tubes.places.empty()) {
    text +=
        "<h2>Narrowings and widenings</h2><p>The degree is how much the equivalent diameter, or "
        "the area, differs from the reference: the diameter of both sides, or of one.</p>";
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < tubes.places.size(); ++i) {
      const TubePlace& place = tubes.places[i];
      rows.push_back({std::to_string(i), std::string(toString(place.change)),
                      std::to_string(place.branch), lengthText(place.distance),
                      lengthText(place.length), lengthText(place.equivalentDiameter),
                      lengthText(place.reference), percentText(place.degreeByDiameter),
                      percentText(place.degreeByArea), lengthText(place.area),
                      lengthText(place.inscribedDiameter), lengthText(place.girth)});
    }
    text += tableOf({"Number", "Kind", "Branch", "At", "Length", "Diameter", "Reference",
                     "By diameter", "By area", "Area", "Inscribed", "Girth"},
                    rows);
  }
  if (!tubes.branches.empty()) {
    text += "<h2>Branches</h2>";
    std::vector<std::vector<std::string>> rows;
    for (std::size_t b = 0; b < tubes.branches.size(); ++b) {
      const TubeBranch& branch = tubes.branches[b];
      rows.push_back({std::to_string(b),
                      branch.parent == kNoIndex ? "–" : std::to_string(branch.parent),
                      std::string(branchEndWords(branch)), lengthText(branch.firstDistance),
                      lengthText(branch.lastDistance), lengthText(branch.median)});
    }
    text += tableOf({"Number", "Leaves", "Leads to", "From", "To", "Median diameter"}, rows);
    for (std::size_t b = 0; b < tubes.branches.size(); ++b) {
      text += "<h2>Branch " + std::to_string(b) + "</h2>" + plotOf(tubes, b);
    }
  }
  if (!tubes.others.empty()) {
    text += "<h2>No tubes</h2><ul>";
    constexpr std::size_t kMostListed = 50;
    for (std::size_t i = 0; i < tubes.others.size() && i < kMostListed; ++i) {
      text += "<li>Component " + std::to_string(tubes.others[i].component) + " " +
              std::string(noTubeWords(tubes.others[i].reason)) + ".</li>";
    }
    if (tubes.others.size() > kMostListed) {
      text += "<li>… and " + std::to_string(tubes.others.size() - kMostListed) + " more.</li>";
    }
    text += "</ul>";
  }
  return text + "</body></html>\n";
}

}  // namespace girth::io
