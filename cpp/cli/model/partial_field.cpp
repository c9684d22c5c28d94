#include "model/partial_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string_view>

#include "files/path_of.h"
#include "files/read_file.h"
#include "files/write_file.h"
#include "girth/version.h"
#include "process/sha256.h"
#include "text/number_text.h"
#include "text/words.h"

namespace girth::cli {
namespace {

constexpr std::string_view kTitle = "# girth igf, stopped: ";
constexpr std::string_view kTitleEnd = "; the same command with --resume goes on";
constexpr std::string_view kHeader = "vertex,igf,kind";

std::optional<LoopKind> kindOf(std::string_view text) {
  for (const LoopKind kind : {LoopKind::Loop, LoopKind::Antipodal, LoopKind::Unresolved}) {
    if (text == toString(kind)) return kind;
  }
  return std::nullopt;
}

/// The text before the separator, which is taken off with it.
std::string_view taken(std::string_view& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view piece = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return piece;
}

Error damaged(std::int64_t line) {
  Error error = makeError(ErrorCode::MalformedFile, line,
                          "line " + std::to_string(line) + " is not one of a stopped run");
  error.hint = "begin again with --force";
  return error;
}

/// A text of a file, or a file's name, for one line of another text.
std::string onOneLine(std::string_view text) {
  std::string line(text);
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < ' ' || c == 127; }, '?');
  return line;
}

/// A row of the file: "12,3.5,loop".
struct Row {
  std::size_t number;
  double value;
  LoopKind kind;
};

std::optional<Row> rowOf(std::string_view line) {
  const auto number = io::parseInteger(taken(line, ','));
  const auto value = io::parseNumber(taken(line, ','));
  const auto kind = kindOf(line);
  if (!number || *number < 0 || !value || std::isnan(*value) || !kind) return std::nullopt;
  return Row{static_cast<std::size_t>(*number), *value, *kind};
}

}  // namespace

std::string partialPathOf(const std::string& output) {
  std::filesystem::path path = io::pathOf(output);
  return path.replace_extension(".partial.csv").string();
}

PartialField::PartialField(const std::string& output, const std::string& model,
                           const SurfaceMesh& mesh, std::span<const Vertex> rows,
                           const std::string& method)
    : path_(partialPathOf(output)), model_(model), mesh_(mesh), rows_(rows), method_(method) {}

std::string PartialField::fingerprint() const {
  Sha256 hash;
  for (const Vertex v : mesh_.vertices()) {
    const Vec3& p = mesh_.position(v);
    const std::array<double, 3> position{p.x, p.y, p.z};
    hash.add(std::as_bytes(std::span(position)));
  }
  for (const Face f : mesh_.faces()) {
    const auto corners = mesh_.faceVertices(f);
    hash.add(std::as_bytes(std::span(corners)));
  }
  hash.add(std::as_bytes(rows_));
  return std::string("# girth ") + GIRTH_VERSION + "\n# method " + method_ + "\n# surface " +
         hexText(hash.finish()) + "\n";
}

std::optional<Error> PartialField::takeHead(std::string_view& text, std::int64_t& line) const {
  line = 1;
  if (taken(text, '\n').substr(0, kTitle.size()) != kTitle) return damaged(line);
  std::string ours = fingerprint();
  for (std::string_view expected = ours; !expected.empty();) {
    ++line;
    const std::string_view wanted = taken(expected, '\n');
    const std::string_view found = taken(text, '\n');
    if (found == wanted) continue;
    const bool isSurface = wanted.substr(0, 9) == "# surface";
    Error error = makeError(
        ErrorCode::InvalidOption, -1,
        isSurface ? std::string("it is of another model, or of one that was prepared otherwise")
                  : "it was made with \"" +
                        std::string(found.substr(std::min<std::size_t>(2, found.size()))) +
                        "\", not \"" + std::string(wanted.substr(2)) + "\"");
    error.hint =
        "resume with the same model and options, or begin without --resume or with --force";
    return error;
  }
  ++line;
  if (taken(text, '\n') != kHeader) return damaged(line);
  return std::nullopt;
}

std::optional<std::string> PartialField::ofAnother() const {
  const auto bytes = io::readFile(path_);
  if (!bytes) return "cannot be read: " + bytes.error().message;
  std::string_view text = io::textOf(bytes.value());
  std::string_view title = text;
  title = taken(title, '\n');
  std::int64_t line = 0;
  const auto error = takeHead(text, line);
  if (!error) return std::nullopt;
  if (error->code == ErrorCode::MalformedFile) return "is damaged: " + error->message;
  title.remove_prefix(kTitle.size());
  return "is of a run that was stopped after " +
         onOneLine(title.substr(0, title.rfind(kTitleEnd))) + ": " + onOneLine(error->message);
}

Result<GirthField> PartialField::read() const {
  const auto bytes = io::readFile(path_);
  if (!bytes) return bytes.error();
  std::string_view text = io::textOf(bytes.value());
  std::int64_t line = 0;
  if (auto error = takeHead(text, line)) return *std::move(error);

  GirthField field;
  field.values.assign(mesh_.vertexCount(), std::numeric_limits<double>::quiet_NaN());
  field.kinds.assign(mesh_.vertexCount(), LoopKind::Loop);
  while (!text.empty()) {
    ++line;
    const auto row = rowOf(taken(text, '\n'));
    if (!row || row->number >= rows_.size() || rows_[row->number] == Vertex::none) {
      return damaged(line);
    }
    const Vertex vertex = rows_[row->number];
    if (std::isnan(field.values[vertex])) ++field.computed;
    field.values[vertex] = row->value;
    field.kinds[vertex] = row->kind;
  }
  return field;
}

std::optional<Error> PartialField::write(const GirthField& field) const {
  std::string text = std::string(kTitle) + std::to_string(field.computed) + " of " +
                     std::to_string(mesh_.vertexCount()) + " vertices of " + onOneLine(model_) +
                     std::string(kTitleEnd) + "\n" + fingerprint() + std::string(kHeader) + "\n";
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const Vertex vertex = rows_[row];
    if (vertex == Vertex::none || std::isnan(field.values[vertex])) continue;
    text += std::to_string(row) + "," + io::formatNumber(field.values[vertex]) + "," +
            std::string(toString(field.kinds[vertex])) + "\n";
  }
  return io::writeFile(path_, text);
}

}  // namespace girth::cli
