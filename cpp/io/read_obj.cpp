// Why not tinyobjloader: it turns "nan" into 0, takes 4294967297 for 1, rounds coordinates by way
// of pow(), so that two platforms may read two models, and leaves faces with bad indices in place.
#include "read_obj.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "girth/io/number_text.h"
#include "polygon.h"
#include "text.h"

namespace girth::io {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

/// Takes the next word off the front of a line; empty at its end.
std::string_view takeWord(std::string_view& line) {
  std::size_t begin = 0;
  while (begin < line.size() && isBlank(line[begin])) ++begin;
  std::size_t end = begin;
  while (end < line.size() && !isBlank(line[end])) ++end;
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

/// The lines of a text, ended by \n, \r\n or \r; a backslash at the end joins the next line on.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  /// The next line; it stays valid until the next call.
  bool next(std::string_view& line) {
    if (rest_.empty()) return false;
    line = takeLine();
    number_ = nextNumber_++;
    if (line.empty() || line.back() != '\\') return true;
    joined_.clear();
    while (!line.empty() && line.back() == '\\') {
      joined_.append(line.substr(0, line.size() - 1));
      joined_ += ' ';
      if (rest_.empty()) {
        line = joined_;
        return true;
      }
      line = takeLine();
      ++nextNumber_;
    }
    joined_.append(line);
    line = joined_;
    return true;
  }
  /// The number of the line, from 1.
  std::int64_t number() const { return number_; }

 private:
  std::string_view takeLine() {
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    const std::string_view line = rest_.substr(0, end);
    const bool pair = rest_.substr(end, 2) == "\r\n";
    rest_.remove_prefix(std::min(end + (pair ? 2 : 1), rest_.size()));
    return line;
  }

  std::string_view rest_;
  std::string joined_;
  std::int64_t number_{0};
  std::int64_t nextNumber_{1};
};

/// A decimal integer with an optional sign, all of `text`; too large ones come out as the largest.
std::optional<std::int64_t> parseInteger(std::string_view text) {
  const bool negative = !text.empty() && text[0] == '-';
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
  if (text.empty()) return std::nullopt;
  std::int64_t value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    if (value < 1'000'000'000'000) value = 10 * value + (c - '0');
  }
  return negative ? -value : value;
}

class ObjReader {
 public:
  explicit ObjReader(std::string_view text) : lines_(text) {}

  Result<TriangleSoup> read() {
    soup_.format = Format::Obj;
    std::string_view line;
    while (lines_.next(line)) {
      const std::string_view keyword = takeWord(line);
      std::optional<Error> error;
      if (keyword == "v") {
        error = readVertex(line);
      } else if (keyword == "f" || keyword == "fo") {
        error = readFace(line);
      }
      if (error) return *error;
    }
    // Faces may name vertices that come later in the file, and so wait until all are known.
    if (auto error = cutFaces()) return *error;
    if (soup_.triangles.empty()) {
      return makeError(ErrorCode::EmptyMesh, -1,
                       soup_.positions.empty() ? "it has neither vertices nor faces"
                                               : "it has vertices, but no faces");
    }
    return std::move(soup_);
  }

 private:
  Error failure(ErrorCode code, std::int64_t line, const std::string& message) const {
    return makeError(code, line, "line " + std::to_string(line) + ": " + message);
  }

  std::optional<Error> readVertex(std::string_view line) {
    std::array<double, 3> position;
    for (double& coordinate : position) {
      const std::string_view word = takeWord(line);
      if (word.empty()) {
        return failure(ErrorCode::MalformedFile, lines_.number(),
                       "a vertex with fewer than three coordinates");
      }
      const auto number = parseNumber(word);
      if (!number) {
        return failure(ErrorCode::MalformedFile, lines_.number(),
                       inQuotes(word) + " is not a number");
      }
      if (!std::isfinite(*number)) {
        return failure(ErrorCode::NonFinitePosition, lines_.number(),
                       "the coordinate " + inQuotes(word) + " is not a finite number");
      }
      coordinate = *number;
    }
    soup_.positions.insert(soup_.positions.end(), position.begin(), position.end());
    return std::nullopt;
  }

  std::optional<Error> readFace(std::string_view line) {
    const auto known = static_cast<std::int64_t>(soup_.positions.size() / 3);
    std::int64_t corners = 0;
    while (true) {
      const std::string_view word = takeWord(line);
      if (word.empty() || word[0] == '#') break;
      const auto index = parseInteger(word.substr(0, word.find('/')));
      if (!index) {
        return failure(ErrorCode::MalformedFile, lines_.number(),
                       inQuotes(word) + " is not a face's corner");
      }
      // From 1, or backwards from the last vertex so far.
      const std::int64_t vertex = *index > 0 ? *index - 1 : known + *index;
      if (*index == 0 || vertex < 0 || vertex >= std::int64_t{kNoIndex}) {
        return failure(
            ErrorCode::IndexOutOfRange, lines_.number(),
            "a face names vertex " + std::string(word.substr(0, word.find('/'))) +
                (*index == 0 ? ", but OBJ counts from 1"
                             : ", and there are " + std::to_string(known) + " before it"));
      }
      corners_.push_back(static_cast<Index>(vertex));
      ++corners;
    }
    if (corners < 3) {
      return failure(ErrorCode::MalformedFile, lines_.number(),
                     "a face with fewer than three corners");
    }
    faces_.push_back({lines_.number(), corners});
    return std::nullopt;
  }

  std::optional<Error> cutFaces() {
    const std::size_t vertices = soup_.positions.size() / 3;
    if (vertices >= kNoIndex) {
      return makeError(ErrorCode::LimitExceeded, -1, "it has more than 4 billion vertices");
    }
    PolygonCutter cutter;
    std::size_t first = 0;
    for (const Face& face : faces_) {
      const std::span<const Index> corners(corners_.data() + first,
                                           static_cast<std::size_t>(face.corners));
      first += corners.size();
      const Index largest = *std::max_element(corners.begin(), corners.end());
      if (largest >= vertices) {
        return failure(ErrorCode::IndexOutOfRange, face.line,
                       "a face names vertex " + std::to_string(std::uint64_t{largest} + 1) +
                           ", and there are " + std::to_string(vertices));
      }
      if (!cutter.cut(soup_.positions, corners, soup_.triangles)) {
        return failure(ErrorCode::LimitExceeded, face.line,
                       "its polygons have too many corners to be cut into triangles");
      }
    }
    return std::nullopt;
  }

  struct Face {
    std::int64_t line;
    std::int64_t corners;
  };

  Lines lines_;
  TriangleSoup soup_;
  std::vector<Index> corners_;
  std::vector<Face> faces_;
};

std::string_view textOf(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

Result<TriangleSoup> readObj(std::span<const std::byte> bytes) {
  std::string_view text = textOf(bytes);
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  return ObjReader(text).read();
}

bool isObjLine(std::string_view line) {
  constexpr std::array<std::string_view, 23> kKeywords{
      "v",     "vn",  "vt",     "vp",     "f",      "fo",     "l",   "p",
      "o",     "g",   "s",      "mg",     "mtllib", "usemtl", "deg", "cstype",
      "bevel", "lod", "usemap", "maplib", "curv",   "surf",   "t"};
  const std::string_view keyword = takeWord(line);
  return std::find(kKeywords.begin(), kKeywords.end(), keyword) != kKeywords.end();
}

}  // namespace girth::io
