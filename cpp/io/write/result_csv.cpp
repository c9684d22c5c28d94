#include "girth/io/result_csv.h"

#include <cmath>

#include "text/number_text.h"

namespace girth::io {

void CsvRow::add(std::string_view cell) {
  if (!text_.empty()) text_ += ',';
  text_ += cell;
}

void CsvRow::operator()(std::string_view, double number) {
  add(std::isfinite(number) ? formatNumber(number) : std::string());
}

void CsvRow::operator()(std::string_view, std::string_view word) {
  if (word.find_first_of(",\"\r\n") == std::string_view::npos) return add(word);
  std::string quoted = "\"";
  for (const char c : word) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  add(quoted + "\"");
}

void CsvRow::operator()(std::string_view, Vertex vertex) {
  const Index input = vertex == Vertex::none ? kNoIndex : loaded_->inputOfVertex[vertex];
  add(input == kNoIndex ? std::string() : std::to_string(input));
}

void CsvRow::operator()(std::string_view name, const Vec3& place) {
  for (const double number : {place.x, place.y, place.z}) (*this)(name, number);
}

void CsvRow::operator()(std::string_view name, const SurfacePoint& place) {
  (*this)(name, positionOf(loaded_->mesh, place));
}

std::string CsvRow::line() {
  add(loaded_->unit);
  return text_ + "\n";
}

void CsvHeader::addName(std::string_view name) {
  if (!text_.empty()) text_ += ',';
  text_ += name;
}

void CsvHeader::addPlace(std::string_view name) {
  for (const char axis : {'x', 'y', 'z'}) {
    addName(hasPlace_ ? name : std::string_view(&axis, 1));
    if (hasPlace_) text_ += static_cast<char>(axis - 'x' + 'X');
  }
  hasPlace_ = true;
}

std::string CsvHeader::line() {
  addName("unit");
  return text_ + "\n";
}

}  // namespace girth::io
