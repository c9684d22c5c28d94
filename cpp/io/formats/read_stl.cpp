#include "formats/read_stl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "bytes/cursor.h"
#include "formats/polygon_soup.h"
#include "malformed.h"
#include "text/number_problem.h"
#include "text/number_text.h"
#include "text/passed_text.h"
#include "text/quoted_name.h"
#include "text/unit_text.h"
#include "text/words.h"

namespace girth::io {
namespace {

constexpr std::size_t kHeaderSize = 84;
constexpr std::size_t kTriangleSize = 50;

/// Compares with a word in lower case.
bool isKeyword(std::string_view word, std::string_view keyword) {
  if (word.size() != keyword.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const char c =
        word[i] >= 'A' && word[i] <= 'Z' ? static_cast<char>(word[i] - 'A' + 'a') : word[i];
    if (c != keyword[i]) return false;
  }
  return true;
}

bool isControl(char c) { return c >= 0 && c < ' ' && !isBlank(c) && !isLineEnd(c); }

/// Text has no control characters but white space; in names there may be some, or padding, before
/// the first facet.
bool looksLikeText(std::string_view text) {
  constexpr std::size_t kSample = 1024;
  const std::string_view beginning = text.substr(0, kSample);
  if (std::none_of(beginning.begin(), beginning.end(), isControl)) return true;
  // A facet, a normal of three numbers, "outer".
  constexpr int kWordsToOuter = 6;
  for (Words words(beginning); !words.atEnd();) {
    const bool isFacet = isKeyword(words.next(), "facet");
    for (int i = 1; isFacet && i < kWordsToOuter; ++i) {
      if (isKeyword(words.next(), "outer")) return true;
    }
  }
  return false;
}

Error tooManyVertices() {
  return makeError(ErrorCode::LimitExceeded, -1, "it has more than 4 billion corners");
}

class AsciiStlReader {
 public:
  explicit AsciiStlReader(std::string_view text) : words_(text) {}

  Result<ReadModel> read() {
    while (true) {
      const std::string_view word = nextWord();
      const std::string_view ended = endedBy(word);
      const std::int64_t line = words_.line();
      const bool beginsLine = line != lastLine_;
      lastLine_ = line;
      std::optional<Error> error;
      if (word.empty()) {
        if (inLoop_) error = failure("the file ends within a facet");
      } else if (isKeyword(word, "vertex")) {
        error = readVertex();
      } else if (isKeyword(word, "facet")) {
        if (inLoop_) error = failure("a facet within a facet");
        passNormal();
      } else if (isKeyword(word, "outer")) {
        inLoop_ = true;
      } else if (isKeyword(ended, "loop") || isKeyword(ended, "facet")) {
        error = endLoop();
      } else if (isKeyword(word, "solid") || isKeyword(ended, "solid")) {
        if (inLoop_) error = failure("a facet is not ended");
        open_ = isKeyword(word, "solid");
        solids_ += open_ ? 1 : 0;
        words_.skipLine();
      } else if (!isKeyword(word, "loop")) {
        if (beginsLine) {
          error = failure(inQuotes(word) + " is no keyword of STL");
        } else {
          passed_.add(word, line);
        }
      }
      if (error) return *error;
      if (word.empty()) return finish();
    }
  }

 private:
  Error failure(const std::string& message) const {
    return malformed(words_.line(), "line " + std::to_string(words_.line()) + ": " + message);
  }

  /// Without control characters round it, which are padding.
  std::string_view nextWord() {
    while (true) {
      const std::string_view word = words_.next();
      const auto begin = std::find_if_not(word.begin(), word.end(), isControl);
      if (begin == word.end() && !word.empty()) continue;
      const auto end = std::find_if_not(word.rbegin(), word.rend(), isControl);
      const auto before = static_cast<std::size_t>(begin - word.begin());
      return word.substr(before,
                         word.size() - before - static_cast<std::size_t>(end - word.rbegin()));
    }
  }

  /// The word that a keyword ends, which is its second half or the word behind it: "endloop", "end
  /// loop".
  std::string_view endedBy(std::string_view word) {
    constexpr std::size_t kEnd = 3;
    if (!isKeyword(word.substr(0, kEnd), "end")) return {};
    return word.size() > kEnd ? word.substr(kEnd) : words_.nextOnLine();
  }

  /// To the loop: programs write all sorts of normals, also none.
  void passNormal() {
    for (std::string_view word = words_.nextOnLine(); !word.empty(); word = words_.nextOnLine()) {
      if (isKeyword(word, "outer")) {
        inLoop_ = true;
        return;
      }
    }
  }

  std::optional<Error> readVertex() {
    if (!inLoop_) return failure("a vertex outside of a facet");
    std::array<double, 3> position{};
    for (double& coordinate : position) {
      const std::string_view word = words_.next();
      const auto number = parseNumber(word);
      if (!number) {
        return withNumberHint(
            failure(word.empty() ? "the file ends within a vertex" : numberProblem(word)), word);
      }
      if (!std::isfinite(*number)) {
        return makeError(ErrorCode::NonFinitePosition, words_.line(),
                         "line " + std::to_string(words_.line()) + ": the coordinate " +
                             inQuotes(word) + " is not a finite number");
      }
      coordinate = *number;
      lastLine_ = words_.line();
    }
    std::vector<double>& positions = model_.soup.positions;
    const std::size_t vertex = positions.size() / 3;
    if (vertex >= kNoIndex) return tooManyVertices();
    positions.insert(positions.end(), position.begin(), position.end());
    polygons_.addCorner(static_cast<Index>(vertex), vertex + 1, words_.line());
    return std::nullopt;
  }

  std::optional<Error> endLoop() {
    // An endfacet follows an endloop.
    if (!inLoop_) return std::nullopt;
    inLoop_ = false;
    if (!polygons_.endPolygon()) return failure("a facet with fewer than three vertices");
    return std::nullopt;
  }

  Result<ReadModel> finish() {
    auto triangles = polygons_.takeTriangles(model_.soup.positions);
    if (!triangles) {
      return makeError(ErrorCode::LimitExceeded, -1,
                       "its facets have too many corners to be cut into triangles");
    }
    if (triangles->empty()) return makeError(ErrorCode::EmptyMesh, -1, "its solids have no facets");
    model_.soup.triangles = std::move(*triangles);
    model_.format = Format::Stl;
    if (solids_ > 1) {
      model_.notes.push_back("Its " + std::to_string(solids_) + " solids were put together.");
    }
    if (passed_.lines() > 0) model_.notes.push_back(passed_.note());
    if (open_) model_.notes.push_back("It has no \"endsolid\": it may be cut off.");
    return std::move(model_);
  }

  Words words_;
  ReadModel model_;
  PolygonSoup polygons_;
  bool inLoop_{false};
  bool open_{false};  ///< a solid that has not ended
  std::size_t solids_{0};
  std::int64_t lastLine_{0};  ///< the line of the last word
  PassedText passed_;         ///< behind keywords and their numbers
};

std::uint64_t triangleCount(std::span<const std::byte> bytes) {
  return loadAs<std::uint32_t>(&bytes[kHeaderSize - 4], ByteOrder::Little);
}

Result<ReadModel> readBinary(std::span<const std::byte> bytes) {
  if (bytes.size() < kHeaderSize) {
    return malformed(static_cast<std::int64_t>(bytes.size()),
                     "the file ends within the header, at byte " + std::to_string(bytes.size()) +
                         " of " + std::to_string(kHeaderSize));
  }
  ReadModel model;
  model.format = Format::Stl;
  model.unit = unitInHeader(textOf(bytes.first(kHeaderSize - 4)));
  const std::uint64_t held = (bytes.size() - kHeaderSize) / kTriangleSize;
  std::uint64_t count = triangleCount(bytes);
  // Programs that do not know the number beforehand write anything there, such as 0 or the
  // greatest.
  if (count != held && held > 0 && (bytes.size() - kHeaderSize) % kTriangleSize == 0) {
    const bool isCutOff = count > held && count != std::numeric_limits<std::uint32_t>::max();
    model.notes.push_back("Its header counts " + std::to_string(count) +
                          " triangles, but its size is that of " + std::to_string(held) +
                          ", which were read" + (isCutOff ? ": it may be cut off." : "."));
    count = held;
  }
  if (count > held) {
    return malformed(static_cast<std::int64_t>(bytes.size()),
                     "the header counts " + std::to_string(count) +
                         " triangles, but the file ends after " + std::to_string(held) +
                         ", at byte " + std::to_string(bytes.size()));
  }
  if (count == 0) return makeError(ErrorCode::EmptyMesh, -1, "it holds no triangles");
  if (3 * count >= kNoIndex) return tooManyVertices();
  const auto corners = static_cast<std::size_t>(3 * count);
  model.soup.positions.resize(3 * corners);
  model.soup.triangles.resize(corners);
  bool hasMore = false;
  for (std::size_t corner = 0; corner < corners; ++corner) {
    // A triangle: its normal, three corners, two bytes of whatever.
    const std::size_t at = kHeaderSize + corner / 3 * kTriangleSize + 12 + corner % 3 * 12;
    for (std::size_t k = 0; k < 3; ++k) {
      const double coordinate =
          static_cast<double>(loadAs<float>(&bytes[at + 4 * k], ByteOrder::Little));
      if (!std::isfinite(coordinate)) {
        return makeError(ErrorCode::NonFinitePosition, static_cast<std::int64_t>(corner),
                         "byte " + std::to_string(at + 4 * k) + ": triangle " +
                             std::to_string(corner / 3) +
                             " has a coordinate that is not a finite number");
      }
      model.soup.positions[3 * corner + k] = coordinate;
    }
    model.soup.triangles[corner] = static_cast<Index>(corner);
    const std::byte* more = &bytes[kHeaderSize + (corner / 3 + 1) * kTriangleSize - 2];
    hasMore = hasMore || more[0] != std::byte{0} || more[1] != std::byte{0};
  }
  if (hasMore) {
    model.notes.push_back(
        "Bytes behind triangles, where some programs have colours, were left out.");
  }
  const std::uint64_t used = kHeaderSize + count * kTriangleSize;
  if (used < bytes.size()) {
    model.notes.push_back(std::to_string(bytes.size() - used) +
                          " bytes after the last triangle were left out.");
  }
  return model;
}

}  // namespace

bool hasBinaryStlSize(std::span<const std::byte> bytes) {
  if (bytes.size() <= kHeaderSize) return false;
  const std::uint64_t count = triangleCount(bytes);
  return count > 0 && bytes.size() == kHeaderSize + count * kTriangleSize;
}

bool hasStlMark(std::string_view text) { return isKeyword(Words(text).next(), "solid"); }

Result<ReadModel> readStl(std::span<const std::byte> bytes) {
  const std::string_view text = textOf(bytes);
  if (!hasBinaryStlSize(bytes) && hasStlMark(text) && looksLikeText(text)) {
    return AsciiStlReader(text).read();
  }
  return readBinary(bytes);
}

}  // namespace girth::io
