#include "girth/io/write_barcodes.h"

#include <cmath>
#include <cstddef>

#include "bytes/append.h"
#include "girth/io/result_json.h"
#include "text/number_text.h"
#include "write/npy.h"

namespace girth::io {
namespace {

/// Calls `take(input, bar)` for every bar of every vertex of the file.
template <class Take>
void forEachBar(const LoadedMesh& loaded, std::span<const Barcode> barcodes, Take take) {
  for (std::size_t input = 0; input < loaded.vertexOfInput.size(); ++input) {
    const Vertex vertex = loaded.vertexOfInput[input];
    if (vertex == Vertex::none) continue;
    for (const SaddleBar& bar : barcodes[vertex].bars) take(input, bar);
  }
}

std::string barsJson(const Barcode& barcode) {
  JsonList bars;
  for (const SaddleBar& bar : barcode.bars) {
    bars.add("[" + formatNumber(bar.birth) + "," + numberJson(bar.death) + "]");
  }
  return bars.text();
}

}  // namespace

std::string barcodesJson(const LoadedMesh& loaded, std::span<const Barcode> barcodes,
                         std::string_view file) {
  ResultJson json(file, loaded);
  json.addValue("maxPersistence", barcodes.empty() ? 0 : barcodes.front().maxPersistence)
      .addValue("vertices", loaded.vertexOfInput.size());
  const auto column = [&](const char* name, const char* separator, const auto& textOf) {
    std::string entries;
    for (const Vertex vertex : loaded.vertexOfInput) {
      entries += (entries.empty() ? "" : separator) +
                 (vertex == Vertex::none ? std::string("null") : textOf(barcodes[vertex]));
    }
    json.addJsonLine(name, "[" + entries + "]");
  };
  column("bars", ",\n", barsJson);
  column("rest", ",", [](const Barcode& barcode) { return numberJson(barcode.rest.length); });
  column("restKind", ",",
         [](const Barcode& barcode) { return jsonString(toString(barcode.rest.kind)); });
  return json.file();
}

std::string barcodesCsv(const LoadedMesh& loaded, std::span<const Barcode> barcodes) {
  std::string text = "vertex,birth,death\n";
  forEachBar(loaded, barcodes, [&](std::size_t input, const SaddleBar& bar) {
    text += std::to_string(input) + "," + formatNumber(bar.birth) + "," +
            (std::isfinite(bar.death) ? formatNumber(bar.death) : "") + "\n";
  });
  return text;
}

std::string barcodesNpy(const LoadedMesh& loaded, std::span<const Barcode> barcodes) {
  std::string rows;
  std::size_t count = 0;
  forEachBar(loaded, barcodes, [&](std::size_t input, const SaddleBar& bar) {
    for (const double number : {static_cast<double>(input), bar.birth, bar.death}) {
      appendDouble(rows, number);
    }
    ++count;
  });
  return npyHeader(std::to_string(count) + ", 3") + rows;
}

}  // namespace girth::io
