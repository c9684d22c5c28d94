#include "formats/read_off.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "bytes/cursor.h"
#include "formats/lost_vertices.h"
#include "formats/polygon_soup.h"
#include "malformed.h"
#include "text/number_problem.h"
#include "text/number_text.h"
#include "text/quoted_name.h"
#include "text/unit_text.h"
#include "text/words.h"

namespace girth::io {
namespace {

/// The keyword at the front of the file.
struct Keyword {
  bool texture{false}, colour{false}, normal{false}, homogeneous{false}, anyDimension{false};
  /// Digits right behind it: some writers forget the white space before the counts.
  std::string_view rest;
};

std::optional<Keyword> parseKeyword(std::string_view word) {
  Keyword keyword;
  if (word == "off" || word == "coff") {
    keyword.colour = word[0] == 'c';
    return keyword;
  }
  while (word.substr(0, 3) != "OFF") {
    const std::size_t length = word.substr(0, 2) == "ST" ? 2 : 1;
    bool* const flag = word.empty()     ? nullptr
                       : length == 2    ? &keyword.texture
                       : word[0] == 'C' ? &keyword.colour
                       : word[0] == 'N' ? &keyword.normal
                       : word[0] == '4' ? &keyword.homogeneous
                       : word[0] == 'n' ? &keyword.anyDimension
                                        : nullptr;
    if (flag == nullptr || *flag) return std::nullopt;
    *flag = true;
    word.remove_prefix(length);
  }
  keyword.rest = word.substr(3);
  if (!std::all_of(keyword.rest.begin(), keyword.rest.end(), isDigit)) return std::nullopt;
  return keyword;
}

/// The part that both encodings have in common.
class OffReader {
 protected:
  /// Adds a vertex that stands at `place`, a line or byte.
  void addVertex(std::array<double, 4> position, const Keyword& keyword, std::int64_t place) {
    if (keyword.homogeneous) {
      for (std::size_t k = 0; k < 3; ++k) position[k] /= position[3];
    }
    lost_.look(std::span(position).first<3>(), vertexCount(), place);
    model.soup.positions.insert(model.soup.positions.end(), position.begin(), position.begin() + 3);
  }

  std::size_t vertexCount() const { return model.soup.positions.size() / 3; }

  /// `unit`, `element`: as for LostVertices::inFaceOf.
  Result<ReadModel> finish(const char* unit, LostVertices::Element element) {
    if (auto error = lost_.inFaceOf(faces, model.soup.positions, unit, element)) return *error;
    auto triangles = faces.takeTriangles(model.soup.positions);
    if (!triangles) {
      return makeError(ErrorCode::LimitExceeded, -1,
                       "its polygons have too many corners to be cut into triangles");
    }
    if (triangles->empty()) {
      Error error =
          makeError(ErrorCode::EmptyMesh, -1,
                    vertexCount() == 0 ? "it has neither vertices nor faces"
                                       : "it is a point cloud: " + std::to_string(vertexCount()) +
                                             " points, no faces with three corners");
      if (vertexCount() > 0) {
        error.hint = "make a surface of the points first, for example by Poisson reconstruction";
      }
      return error;
    }
    faces.noteLeftOut(model.notes);
    if (hasColours) model.notes.push_back("Its colours were left out.");
    model.soup.triangles = std::move(*triangles);
    model.format = Format::Off;
    return std::move(model);
  }

  ReadModel model;
  PolygonSoup faces;
  bool hasColours{false};

 private:
  LostVertices lost_;
};

/// Meaning of the ends of lines in ASCII.
struct Layout {
  enum class Ends : std::uint8_t {
    OfElements,  ///< every vertex and face has a line, and what follows its numbers is passed over
    OfColours,   ///< numbers are counted, as Geomview does; a face's colour ends with its line
    None         ///< numbers are counted, and faces have no colours
  };
  Ends ends;
  /// Whether the number of edges has a line of its own.
  bool edgesAlone;
};

constexpr std::array kLayouts{
    Layout{Layout::Ends::OfElements, false}, Layout{Layout::Ends::OfColours, false},
    Layout{Layout::Ends::OfColours, true},   Layout{Layout::Ends::None, false},
    Layout{Layout::Ends::None, true},
};

class AsciiOffReader : OffReader {
 public:
  /// Behind the keyword.
  AsciiOffReader(const Words& words, const Keyword& keyword, std::string_view text,
                 const Layout& layout)
      : words_(words), keyword_(keyword), fileSize_(text.size()), layout_(layout) {
    model.unit = unitInComments(text, "#");
  }

  /// After reading: whether every face was read, and nothing stood behind them.
  bool isWhole() const { return isWhole_; }

  Result<ReadModel> read() {
    std::array<std::int64_t, 2> counts{};
    std::array<std::int64_t, 2> lines{};
    constexpr std::array<const char*, 2> kNames{"vertices", "faces"};
    for (std::size_t i = 0; i < 2; ++i) {
      const bool glued = i == 0 && !keyword_.rest.empty();
      const std::string_view word = glued ? keyword_.rest : words_.next();
      const auto count = parseInteger(word);
      if (!count || *count < 0) {
        return withNumberHint(
            failure(numberProblem(word, std::string("no number of ") + kNames[i])), word);
      }
      // Whatever is counted takes a number and its separator.
      if (static_cast<std::uint64_t>(*count) > fileSize_ / 2) {
        return failure("it counts " + std::to_string(*count) + " " + kNames[i] +
                       ", more than the file can hold");
      }
      counts[i] = *count;
      lines[i] = words_.line();
    }
    // The number of edges is often missing, and means nothing.
    if (layout_.edgesAlone || lines[0] != lines[1]) {
      words_.next();
    } else {
      words_.nextOnLine();
    }
    if (!isCounted()) words_.skipLine();
    if (auto error = readVertices(counts[0])) return *error;
    if (auto error = readFaces(counts[1])) return *error;
    if (!words_.atEnd()) {
      if (isCounted()) return failure("more numbers than it counts");
      model.notes.push_back("Data after the last face were left out.");
    }
    isWhole_ = model.notes.empty() && faces.polygonCount() == static_cast<std::size_t>(counts[1]);
    return finish("line", LostVertices::Element::Place);
  }

 private:
  Error failure(const std::string& message) const {
    return malformed(words_.line(), "line " + std::to_string(words_.line()) + ": " + message);
  }

  bool isCounted() const { return layout_.ends != Layout::Ends::OfElements; }
  /// A number of an element behind its first one; empty where the element has no more.
  std::string_view nextOfElement() { return isCounted() ? words_.next() : words_.nextOnLine(); }

  std::optional<Error> readVertices(std::int64_t count) {
    model.soup.positions.reserve(3 * std::min(static_cast<std::size_t>(count), fileSize_ / 6));
    const int announced =
        (keyword_.normal ? 3 : 0) + (keyword_.colour ? 4 : 0) + (keyword_.texture ? 2 : 0);
    const bool isOtherAnnounced = !keyword_.colour && announced > 0;
    hasColours = keyword_.colour && isCounted();
    const std::size_t dimension = keyword_.homogeneous ? 4 : 3;
    for (std::int64_t i = 0; i < count; ++i) {
      std::array<double, 4> position{};
      for (std::size_t k = 0; k < dimension; ++k) {
        const std::string_view word = k == 0 ? words_.next() : nextOfElement();
        const auto number = parseNumber(word);
        if (!number) {
          return withNumberHint(failure(!word.empty() ? numberProblem(word)
                                        : k == 0      ? "the file ends after " + std::to_string(i) +
                                                       " of " + std::to_string(count) + " vertices"
                                                 : "a vertex with fewer than " +
                                                       std::to_string(dimension) + " coordinates"),
                                word);
        }
        position[k] = *number;
      }
      addVertex(position, keyword_, words_.line());
      if (!isCounted()) {
        hasColours = hasColours || (!isOtherAnnounced && !words_.nextOnLine().empty());
        words_.skipLine();
      }
      for (int k = 0; isCounted() && k < announced; ++k) {
        if (!parseNumber(words_.next())) return failure("a vertex without what is announced");
      }
    }
    return std::nullopt;
  }

  std::optional<Error> readFaces(std::int64_t count) {
    bool doOthersBeginLines = true;
    bool doesFirstBeginLine = true;
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t lineBefore = words_.line();
      const std::string_view first = words_.next();
      bool& beginsLine = i == 0 ? doesFirstBeginLine : doOthersBeginLines;
      beginsLine = beginsLine && words_.line() != lineBefore;
      const auto corners = parseInteger(first);
      if (!corners || *corners < 0) {
        return withNumberHint(failure(first.empty() ? "the file ends after " + std::to_string(i) +
                                                          " of " + std::to_string(count) + " faces"
                                                    : numberProblem(first, "no number of corners")),
                              first);
      }
      for (std::int64_t k = 0; k < *corners; ++k) {
        const std::string_view word = nextOfElement();
        const auto vertex = parseInteger(word);
        if (!vertex) {
          return withNumberHint(
              failure(word.empty() ? "a face with " + std::to_string(k) + " corners in place of " +
                                         std::to_string(*corners)
                                   : numberProblem(word, "not a face's corner")),
              word);
        }
        if (*vertex < 0 || static_cast<std::uint64_t>(*vertex) >= vertexCount()) {
          return makeError(ErrorCode::IndexOutOfRange, words_.line(),
                           "line " + std::to_string(words_.line()) + ": a face names vertex " +
                               std::string(word.substr(0, 20)) + " of " +
                               std::to_string(vertexCount()));
        }
        faces.addCorner(static_cast<Index>(*vertex), vertexCount(), 0);
      }
      if (!faces.endPolygon() && isCounted()) return failure("a face with too few corners");
      if (layout_.ends == Layout::Ends::None) continue;
      const std::size_t numbers = numbersLeftOnLine();
      if (isCounted() && (numbers == 2 || numbers > 4)) {
        return failure("numbers behind a face that are no colour");
      }
      hasColours = hasColours || numbers > 0;
      words_.skipLine();
    }
    // Where a coordinate is missing, the first face's numbers complete the vertices, and nothing
    // but its place shows it.
    const bool areFacesLines = layout_.ends == Layout::Ends::OfColours || doOthersBeginLines;
    if (isCounted() && count > 1 && !doesFirstBeginLine && areFacesLines) {
      return failure("the first face has no line of its own, as others do");
    }
    return std::nullopt;
  }

  /// A face's colour: an index, or three or four numbers.
  std::size_t numbersLeftOnLine() {
    std::size_t numbers = 0;
    while (parseNumber(words_.nextOnLine())) ++numbers;
    return numbers;
  }

  Words words_;
  Keyword keyword_;
  std::size_t fileSize_;
  Layout layout_;
  bool isWhole_{false};
};

class BinaryReader : OffReader {
 public:
  BinaryReader(std::span<const std::byte> bytes, std::size_t at, const Keyword& keyword)
      : cursor_(bytes, at, ByteOrder::Big), keyword_(keyword) {}

  Result<ReadModel> read() {
    std::array<std::int32_t, 3> counts{};
    for (std::int32_t& count : counts) {
      if (!cursor_.take(count)) return ends("the counts");
      if (count < 0) return failure("a count below zero");
    }
    hasColours = keyword_.colour && counts[0] > 0;
    if (auto error = readVertices(counts[0])) return *error;
    if (auto error = readFaces(counts[1])) return *error;
    if (cursor_.remaining() > 0) {
      model.notes.push_back("Data after the last face were left out.");
    }
    return finish("byte", LostVertices::Element::Vertex);
  }

 private:
  std::int64_t byte() const { return static_cast<std::int64_t>(cursor_.offset()); }
  Error failure(const std::string& message) const {
    return malformed(byte(), "byte " + std::to_string(byte()) + ": " + message);
  }
  Error ends(const std::string& within) const { return failure("the file ends within " + within); }

  std::optional<Error> readVertices(std::int32_t count) {
    const std::size_t dimension = keyword_.homogeneous ? 4 : 3;
    const std::size_t more = 4 * ((keyword_.normal ? 3u : 0u) + (keyword_.colour ? 4u : 0u) +
                                  (keyword_.texture ? 2u : 0u));
    const std::size_t size = 4 * dimension + more;
    model.soup.positions.reserve(
        3 * std::min(static_cast<std::size_t>(count), cursor_.remaining() / size));
    for (std::int32_t i = 0; i < count; ++i) {
      std::array<double, 4> position{};
      for (std::size_t k = 0; k < dimension; ++k) {
        float coordinate = 0;
        if (!cursor_.take(coordinate)) return vertexEnds(i, count);
        position[k] = static_cast<double>(coordinate);
      }
      if (!cursor_.skip(more)) return vertexEnds(i, count);
      addVertex(position, keyword_, byte());
    }
    return std::nullopt;
  }
  Error vertexEnds(std::int32_t number, std::int32_t count) const {
    return ends("vertex " + std::to_string(number) + " of " + std::to_string(count));
  }

  std::optional<Error> readFaces(std::int32_t count) {
    for (std::int32_t i = 0; i < count; ++i) {
      const auto faceEnds = [&] {
        return ends("face " + std::to_string(i) + " of " + std::to_string(count));
      };
      std::int32_t corners = 0, colours = 0;
      if (!cursor_.take(corners)) return faceEnds();
      if (corners < 0) return failure("a face with a number of corners below zero");
      for (std::int32_t k = 0; k < corners; ++k) {
        std::int32_t vertex = 0;
        if (!cursor_.take(vertex)) return faceEnds();
        if (vertex < 0 || static_cast<std::size_t>(vertex) >= vertexCount()) {
          return makeError(ErrorCode::IndexOutOfRange, byte(),
                           "byte " + std::to_string(byte()) + ": a face names vertex " +
                               std::to_string(vertex) + " of " + std::to_string(vertexCount()));
        }
        faces.addCorner(static_cast<Index>(vertex), vertexCount(), 0);
      }
      faces.endPolygon();
      if (!cursor_.take(colours)) return faceEnds();
      if (colours < 0 || colours > 4) {
        return failure("a colour of " + std::to_string(colours) + " components");
      }
      hasColours = hasColours || colours > 0;
      if (!cursor_.skip(4 * static_cast<std::uint64_t>(colours))) return faceEnds();
    }
    return std::nullopt;
  }

  BinaryCursor cursor_;
  Keyword keyword_;
};

/// `words`: behind the keyword. Most files have a line for each vertex and face, and many have
/// colours that no keyword announces. Where something is left out or wrong then, but every number
/// counts in another layout, that is the one. Where no layout fits, the first error says most.
Result<ReadModel> readAscii(const Words& words, const Keyword& keyword, std::string_view text) {
  AsciiOffReader first(words, keyword, text, kLayouts[0]);
  auto model = first.read();
  if (first.isWhole()) return model;
  for (std::size_t i = 1; i < kLayouts.size(); ++i) {
    if (auto counted = AsciiOffReader(words, keyword, text, kLayouts[i]).read()) return counted;
  }
  return model;
}

}  // namespace

bool hasOffMark(std::string_view text) { return parseKeyword(Words(text, '#').next()).has_value(); }

bool canBeOffWithoutMark(std::string_view text) {
  Words words(text, '#');
  int numbers = 0;
  for (std::string_view word = words.next(); !word.empty(); word = words.nextOnLine()) {
    const auto number = parseInteger(word);
    if (!number || *number < 0 || ++numbers > 3) return false;
  }
  return numbers >= 2;
}

Result<ReadModel> readOff(std::span<const std::byte> bytes) {
  const std::string_view text = textOf(bytes);
  Words words(text, '#');
  const Words beginning = words;
  const auto keyword = parseKeyword(words.next());
  if (!keyword) return readAscii(beginning, {}, text);
  if (keyword->anyDimension) {
    Error error = makeError(ErrorCode::UnsupportedFeature, words.line(),
                            "line " + std::to_string(words.line()) +
                                ": its vertices have any number of dimensions (nOFF)");
    error.hint = "write it as OFF, with three coordinates a vertex";
    return error;
  }
  const Words behindKeyword = words;
  if (words.nextOnLine() == "BINARY") {
    words.skipLine();
    return BinaryReader(bytes.subspan(bytes.size() - text.size()), words.offset(), *keyword).read();
  }
  return readAscii(behindKeyword, *keyword, text);
}

}  // namespace girth::io
