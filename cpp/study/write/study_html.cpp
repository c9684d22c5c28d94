// The page of a study. Plain HTML and SVG: it is read in ten years' time, and printed.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "bytes/base64.h"
#include "girth/study/write_study.h"
#include "text/html_text.h"

namespace girth::study {
namespace {

constexpr const char* kStyle = R"(
:root{color-scheme:light dark;--ink:#1b1d21;--soft:#5b616b;--line:#d9dce1;--paper:#fff;--accent:#0b6b75;--wrong:#a8321e}
@media (prefers-color-scheme:dark){:root{--ink:#e8eaed;--soft:#a3a9b3;--line:#363a41;--paper:#15171a;--accent:#58c4cf;--wrong:#f0907c}svg [stroke^="#"]{filter:brightness(1.7)}}
body{margin:0 auto;padding:2.5rem 1.25rem 4rem;max-width:64rem;background:var(--paper);color:var(--ink);font:16px/1.5 system-ui,sans-serif}
h1{font-size:1.6rem;font-weight:600;margin:0 0 .25rem}h2{font-size:1.1rem;font-weight:600;margin:2.5rem 0 .75rem}
p{margin:.25rem 0 .75rem;max-width:44rem}.soft,figcaption,caption{color:var(--soft)}
.wide{overflow-x:auto}table{border-collapse:collapse;font-variant-numeric:tabular-nums}
th,td{padding:.3rem .8rem;text-align:right;border-bottom:1px solid var(--line);white-space:nowrap}
th:first-child,td:first-child{text-align:left;padding-left:0}thead th{color:var(--soft);font-weight:500}
td.best{font-weight:600;color:var(--accent)}
svg{min-width:44rem;max-width:100%;height:auto}svg text{fill:var(--soft);font:13px system-ui,sans-serif}
.sheet{display:grid;gap:.75rem}.row{display:flex;gap:.5rem;flex-wrap:wrap}
.row figure{margin:0;width:88px}.row img{width:80px;height:80px;display:block;padding:3px;border:1px solid var(--line)}
.row figure.wrong img{border:1px dashed var(--wrong)}.row figcaption{font-size:11px;line-height:1.3;overflow-wrap:anywhere}
.row figure.wrong figcaption{color:var(--wrong)}.row figure.query{margin-right:.75rem}.row figure.query img{border-color:var(--accent)}
.matrices{display:flex;flex-wrap:wrap;gap:1.5rem}.matrices figure{margin:0}.matrices img{width:18rem;max-width:100%;image-rendering:pixelated;border:1px solid var(--line)}
dl{display:grid;grid-template-columns:max-content 1fr;gap:.2rem 1rem;margin:0}dt{color:var(--soft)}dd{margin:0;overflow-wrap:anywhere}
li{overflow-wrap:anywhere}
)";

std::string picture(const std::string& png, const std::string& description) {
  return "<img alt=\"" + io::escapedHtml(description) + "\" src=\"data:image/png;base64," +
         io::base64(png) + "\">";
}

std::string table(const RetrievalStudy& study) {
  using Value = double RetrievalMeasures::*;
  using Measures = RetrievalMeasures;
  constexpr std::array<Value, 6> kValues{&Measures::nearestNeighbour,  &Measures::firstTier,
                                         &Measures::secondTier,        &Measures::eMeasure,
                                         &Measures::eMeasureWithQuery, &Measures::discountedGain};
  std::string text =
      "<div class=\"wide\"><table><thead><tr><th scope=\"col\">Descriptor</th>"
      "<th scope=\"col\">Nearest</th><th scope=\"col\">First tier</th>"
      "<th scope=\"col\">Second tier</th><th scope=\"col\">E</th>"
      "<th scope=\"col\">E with query</th><th scope=\"col\">DCG</th></tr></thead><tbody>";
  for (const StudyDescriptor& descriptor : study.descriptors) {
    text += "<tr><td>" + io::escapedHtml(descriptor.name) + "</td>";
    for (const Value value : kValues) {
      const bool best = std::all_of(study.descriptors.begin(), study.descriptors.end(),
                                    [&](const StudyDescriptor& other) {
                                      return other.mean.*value <= descriptor.mean.*value;
                                    });
      text += best ? "<td class=\"best\">" : "<td>";
      text += io::decimalText(100 * descriptor.mean.*value, 2) + "%</td>";
    }
    text += "</tr>";
  }
  return text + "</tbody></table></div>";
}

/// Distinct without colour: each line has its own dashes and its name in the legend.
std::string curves(const RetrievalStudy& study) {
  constexpr std::array<const char*, 10> kColours{"#0b7285", "#c2410c", "#6d3fc0", "#2f7d32",
                                                 "#b0267a", "#8a6d00", "#1d5fc4", "#7a4a2b",
                                                 "#56707a", "#b3261e"};
  constexpr std::array<const char*, 5> kDashes{"", "7 3", "2 3", "9 3 2 3", "14 4"};
  constexpr double kLeft = 50, kTop = 15, kWidth = 480, kHeight = 320, kLegend = 560;
  const double height =
      std::max(kHeight + 70, 40 + 20.0 * static_cast<double>(study.descriptors.size()));
  const auto x = [&](double recall) { return io::decimalText(kLeft + kWidth * recall, 1); };
  const auto y = [&](double precision) {
    return io::decimalText(kTop + kHeight * (1 - precision), 1);
  };
  std::string text =
      "<svg role=\"img\" aria-label=\"Precision against recall; the numbers are in "
      "precision_recall.csv\" viewBox=\"0 0 820 " +
      io::decimalText(height, 0) + "\" width=\"820\">";
  for (int i = 0; i <= 5; ++i) {
    const double at = i / 5.0;
    text += "<path d=\"M" + x(0) + " " + y(at) + "H" + x(1) + "M" + x(at) + " " + y(0) + "V" +
            y(1) + "\" fill=\"none\" stroke=\"var(--line)\"/>";
    text += "<text x=\"" + io::decimalText(kLeft - 8, 0) + "\" y=\"" +
            io::decimalText(kTop + kHeight * (1 - at) + 4, 1) + "\" text-anchor=\"end\">" +
            io::decimalText(at, 1) + "</text>";
    text += "<text x=\"" + x(at) + "\" y=\"" + io::decimalText(kTop + kHeight + 20, 1) +
            "\" text-anchor=\"middle\">" + io::decimalText(at, 1) + "</text>";
  }
  text += "<text x=\"" + x(0.5) + "\" y=\"" + io::decimalText(kTop + kHeight + 42, 1) +
          "\" text-anchor=\"middle\">recall</text><text transform=\"translate(12 " + y(0.5) +
          ") rotate(-90)\" text-anchor=\"middle\">precision</text>";
  for (std::size_t i = 0; i < study.descriptors.size(); ++i) {
    const auto& precision = study.descriptors[i].mean.precision;
    const std::string look = std::string("fill=\"none\" stroke-width=\"2\" stroke=\"") +
                             kColours[i % kColours.size()] + "\" stroke-dasharray=\"" +
                             kDashes[i / 2 % kDashes.size()] + "\"";
    std::string points;
    for (std::size_t level = 0; level < precision.size(); ++level) {
      points += x(static_cast<double>(level + 1) / static_cast<double>(precision.size())) + "," +
                y(precision[level]) + " ";
    }
    text += "<polyline points=\"" + points + "\" " + look + "/>";
    const std::string row = io::decimalText(kTop + 10 + 20 * static_cast<double>(i), 1);
    text += "<path d=\"M" + io::decimalText(kLegend, 0) + " " + row + "h36\" " + look +
            "/><text x=\"" + io::decimalText(kLegend + 44, 0) + "\" y=\"" +
            io::decimalText(kTop + 14 + 20 * static_cast<double>(i), 1) + "\">" +
            io::escapedHtml(study.descriptors[i].name) + "</text>";
  }
  return text + "</svg>";
}

std::string cell(const RetrievalStudy& study, std::uint32_t model, const std::string& kind) {
  const StudyModel& shown = study.models[model];
  return "<figure class=\"" + kind + "\">" + picture(study.thumbnails[model], shown.name) +
         "<figcaption>" + (kind == "wrong" ? "✕ " : "") +
         io::escapedHtml(study.classes[shown.ofClass]) + "<br>" +
         io::escapedHtml(shown.name.substr(shown.name.find_last_of('/') + 1)) +
         "</figcaption></figure>";
}

std::string sheet(const RetrievalStudy& study) {
  std::string text = "<div class=\"sheet\">";
  for (const StudyAnswers& row : study.shown) {
    text += "<div class=\"row\">" + cell(study, row.query, "query");
    for (const std::uint32_t answer : row.answers) {
      const bool right = study.models[answer].ofClass == study.models[row.query].ofClass;
      text += cell(study, answer, right ? "right" : "wrong");
    }
    text += "</div>";
  }
  return text + "</div>";
}

std::string listOf(const std::vector<std::string>& items) {
  std::string text = "<ul>";
  for (const std::string& item : items) text += "<li>" + io::escapedHtml(item) + "</li>";
  return text + "</ul>";
}

}  // namespace

std::string studyHtml(const RetrievalStudy& study) {
  std::string text =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width\"><title>" +
      io::escapedHtml(study.title) + "</title><style>" + kStyle + "</style></head><body>" + "<h1>" +
      io::escapedHtml(study.title) + "</h1><p class=\"soft\">" +
      std::to_string(study.models.size()) + " models in " + std::to_string(study.classes.size()) +
      " classes</p>";
  text += "<h2>How well models of a class find each other</h2>" + table(study) +
          "<p class=\"soft\">Shilane et al. 2004; the query is left out of its own ranking. "
          "<em>E with query</em> counts it as found.</p>";
  text += "<h2>Precision and recall</h2><div class=\"wide\">" + curves(study) + "</div>";
  if (!study.shown.empty()) {
    text += "<h2>Queries and their nearest models, by " + io::escapedHtml(study.shownDescriptor) +
            "</h2><p class=\"soft\">The query stands first; a dashed frame and ✕ mark answers of "
            "another class.</p>" +
            sheet(study);
  }
  std::string matrices;
  for (const StudyDescriptor& descriptor : study.descriptors) {
    if (descriptor.matrix.empty()) continue;
    matrices += "<figure>" + picture(descriptor.matrix, "Distances by " + descriptor.name) +
                "<figcaption>" + io::escapedHtml(descriptor.name) + "</figcaption></figure>";
  }
  if (!matrices.empty()) {
    text +=
        "<h2>Distances</h2><p class=\"soft\">Models in the order of their classes, along both "
        "sides; dark is near.</p><div class=\"matrices\">" +
        matrices + "</div>";
  }
  if (!study.failed.empty()) {
    std::vector<std::string> lines;
    for (const auto& [name, reason] : study.failed) lines.push_back(name + ": " + reason);
    text += "<h2>Left out</h2>" + listOf(lines);
  }
  if (!study.notes.empty()) text += "<h2>Notes</h2>" + listOf(study.notes);
  text += "<h2>How it was made</h2><dl>";
  for (const auto& [name, value] : study.settings) {
    text += "<dt>" + io::escapedHtml(name) + "</dt><dd>" + io::escapedHtml(value) + "</dd>";
  }
  return text + "</dl></body></html>\n";
}

}  // namespace girth::study
