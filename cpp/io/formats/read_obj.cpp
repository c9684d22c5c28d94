// Why not tinyobjloader: it turns "nan" into 0, takes 4294967297 for 1, rounds coordinates by way
// of pow(), so that two platforms may read two models, and leaves faces with bad indices in place.
#include "formats/read_obj.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "formats/colours_note.h"
#include "formats/lost_vertices.h"
#include "formats/polygon_soup.h"
#include "text/number_problem.h"
#include "text/number_text.h"
#include "text/quoted_name.h"
#include "text/unit_text.h"
#include "text/words.h"

namespace girth::io {
namespace {

class ObjReader {
 public:
  ObjReader(std::string_view text, const ReadOptions& options)
      : words_(text, '#', Words::Continuation::JoinsLines), options_(options) {
    model_.unit = unitInComments(text, "#");
  }

  Result<ReadModel> read() {
    while (true) {
      const std::string_view keyword = words_.next();
      if (keyword.empty()) break;
      line_ = words_.line();
      std::optional<Error> error;
      if (keyword == "v") {
        error = readVertex();
      } else if (keyword == "f" || keyword == "fo") {
        error = readFace();
      } else if (keyword == "vt" && options_.attributes) {
        readTexture();
      } else if (keyword == "g" || keyword == "o") {
        beginsGroup_ = true;
      } else if (keyword == "usemtl") {
        hasMaterials_ = true;
      } else {
        curves_ = curves_ || keyword == "curv" || keyword == "surf";
      }
      if (error) return *error;
      words_.skipLine();
    }
    return finish();
  }

 private:
  Error failure(ErrorCode code, std::int64_t line, const std::string& message) const {
    return makeError(code, line, "line " + std::to_string(line) + ": " + message);
  }

  Error tooFew(std::size_t coordinates) const {
    if (coordinates != 2) {
      return failure(ErrorCode::MalformedFile, line_, "a vertex with fewer than three coordinates");
    }
    Error error = failure(ErrorCode::MalformedFile, line_,
                          "a vertex of two coordinates, but OBJ has three: x, y and z");
    error.hint = "write a third one into each line \"v\": 0, if it is a drawing in the plane";
    return error;
  }

  std::optional<Error> readVertex() {
    std::array<double, 3> position;
    for (double& coordinate : position) {
      const std::string_view word = words_.nextOnLine();
      if (word.empty()) return tooFew(static_cast<std::size_t>(&coordinate - position.data()));
      const auto number = parseNumber(word);
      if (!number) {
        return withNumberHint(failure(ErrorCode::MalformedFile, line_, numberProblem(word)), word);
      }
      coordinate = *number;
    }
    lost_.look(position, soup().positions.size() / 3, line_);
    if (soup().positions.size() / 3 + 1 >= kNoIndex) {
      return makeError(ErrorCode::LimitExceeded, -1, "it has more than 4 billion vertices");
    }
    soup().positions.insert(soup().positions.end(), position.begin(), position.end());
    // One more number is a weight, three more are a colour.
    const std::string_view fourth = words_.nextOnLine();
    const std::string_view fifth = fourth.empty() ? fourth : words_.nextOnLine();
    if (!fourth.empty() && fourth != "1" && fifth.empty()) {
      const auto weight = parseNumber(fourth);
      weights_ += weight && *weight != 1 ? 1 : 0;
    }
    const std::string_view sixth = fifth.empty() ? fifth : words_.nextOnLine();
    isColoured_ = isColoured_ || !sixth.empty();
    if (options_.attributes) addColour(fourth, fifth, sixth);
    return std::nullopt;
  }

  /// Adds the colour of the vertex read last: none where one of its numbers is none.
  void addColour(std::string_view red, std::string_view green, std::string_view blue) {
    const std::array words{red, green, blue};
    std::array<double, 3> colour;
    colour.fill(std::numeric_limits<double>::quiet_NaN());
    std::array<double, 3> read{};
    bool isColour = !blue.empty();
    for (std::size_t k = 0; k < 3 && isColour; ++k) {
      const auto number = parseNumber(words[k]);
      isColour = number && std::isfinite(*number);
      if (isColour) read[k] = *number;
    }
    if (isColour) {
      colour = read;
      hasColours_ = true;
    }
    colours_.insert(colours_.end(), colour.begin(), colour.end());
  }

  /// The second of its numbers is 0 where there is one alone; one that is none leaves both out.
  void readTexture() {
    std::array<double, 2> place{};
    for (double& coordinate : place) {
      const std::string_view word = words_.nextOnLine();
      if (word.empty() && &coordinate != place.data()) break;
      const auto number = parseNumber(word);
      if (!number || !std::isfinite(*number)) {
        place.fill(std::numeric_limits<double>::quiet_NaN());
        break;
      }
      coordinate = *number;
    }
    texture_.insert(texture_.end(), place.begin(), place.end());
  }

  /// Adds the texture coordinate of the corner read last, by its number as in "7/3/2".
  void addTexture(std::string_view word) {
    const std::size_t slash = word.find('/');
    if (slash == std::string_view::npos) return;
    const std::string_view rest = word.substr(slash + 1);
    const std::string_view name = rest.substr(0, rest.find('/'));
    if (name.empty()) return;
    const auto index = parseInteger(name);
    const auto known = static_cast<std::int64_t>(texture_.size() / 2);
    const std::int64_t number = !index ? -1 : *index > 0 ? *index - 1 : known + *index;
    const bool isKnown = index && *index != 0 && number >= 0 && number < std::int64_t{kNoIndex};
    // One that there cannot be stands for one that there is not.
    faces_.setValue(isKnown ? static_cast<Index>(number) : kNoIndex - 1);
  }

  /// Texture coordinates may come later in the file than the corners that name them.
  void finishTexture() {
    std::vector<Index> corners = faces_.takeValues();
    const std::size_t count = texture_.size() / 2;
    std::size_t absent = 0;
    bool isThere = false;
    for (Index& corner : corners) {
      if (corner == kNoIndex) continue;
      if (corner < count) {
        isThere = true;
      } else {
        ++absent;
        corner = kNoIndex;
      }
    }
    if (absent > 0) {
      model_.attributeNotes.push_back(std::to_string(absent) +
                                      " corners of triangles name texture coordinates that the "
                                      "file does not have.");
    }
    if (!isThere) return;
    model_.attributes.push_back({"TEXCOORD_0", 2, false, std::move(texture_), std::move(corners)});
  }

  std::optional<Error> readFace() {
    const auto known = static_cast<std::int64_t>(soup().positions.size() / 3);
    while (true) {
      const std::string_view word = words_.nextOnLine();
      if (word.empty()) break;
      const std::string_view name = word.substr(0, word.find('/'));
      const auto index = parseInteger(name);
      if (!index) {
        return withNumberHint(
            failure(ErrorCode::MalformedFile, line_, numberProblem(word, "not a face's corner")),
            name);
      }
      // From 1, or backwards from the last vertex so far.
      const std::int64_t vertex = *index > 0 ? *index - 1 : known + *index;
      if (*index == 0 || vertex < 0 || vertex >= std::int64_t{kNoIndex}) {
        return failure(
            ErrorCode::IndexOutOfRange, line_,
            "a face names vertex " + std::string(name.substr(0, 20)) +
                (*index == 0 ? ", but OBJ counts from 1"
                             : ", and there are " + std::to_string(known) + " before it"));
      }
      faces_.addCorner(static_cast<Index>(vertex), static_cast<std::size_t>(known), line_);
      if (options_.attributes) addTexture(word);
    }
    if (!faces_.endPolygon()) return std::nullopt;
    if (beginsGroup_ || groups_ == 0) ++groups_;
    beginsGroup_ = false;
    return std::nullopt;
  }

  Result<ReadModel> finish() {
    const std::size_t vertices = soup().positions.size() / 3;
    // Faces may name vertices that come later in the file: they are pending until all are known.
    if (const auto corner = faces_.firstOutside(vertices)) {
      return failure(ErrorCode::IndexOutOfRange, corner->place,
                     "a face names vertex " + std::to_string(std::uint64_t{corner->vertex} + 1) +
                         ", and there are " + std::to_string(vertices));
    }
    if (faces_.polygonCount() == 0) return nothing(vertices);
    if (auto error =
            lost_.inFaceOf(faces_, soup().positions, "line", LostVertices::Element::Place)) {
      return *error;
    }
    auto triangles = faces_.takeTriangles(soup().positions);
    if (!triangles) {
      return makeError(ErrorCode::LimitExceeded, -1,
                       "its polygons have too many corners to be cut into triangles");
    }
    soup().triangles = std::move(*triangles);
    model_.format = Format::Obj;
    if (hasColours_) model_.attributes.push_back({"COLOR_0", 3, false, std::move(colours_)});
    finishTexture();
    faces_.noteLeftOut(model_.notes);
    if (groups_ > 1) {
      model_.notes.push_back("Its " + std::to_string(groups_) + " groups were put together.");
    }
    if (isColoured_) model_.notes.push_back(coloursNote());
    if (hasMaterials_) model_.notes.push_back("Its materials were left out.");
    if (weights_ > 0) {
      model_.notes.push_back("The weight w of " + std::to_string(weights_) +
                             " vertices was passed over: it counts for curves only.");
    }
    if (curves_) model_.notes.push_back("Its free-form curves and surfaces were left out.");
    return std::move(model_);
  }

  Error nothing(std::size_t vertices) const {
    if (curves_) {
      Error error = makeError(ErrorCode::UnsupportedFeature, -1,
                              "it holds only free-form curves or surfaces");
      error.hint = "export it as polygons";
      return error;
    }
    if (vertices == 0) {
      return makeError(ErrorCode::EmptyMesh, -1, "it has neither vertices nor faces");
    }
    Error error = makeError(
        ErrorCode::EmptyMesh, -1,
        "it has " + std::to_string(vertices) + " vertices, but no faces: points or lines only");
    error.hint = "export the faces, too; a point cloud needs a surface first";
    return error;
  }

  TriangleSoup& soup() { return model_.soup; }

  Words words_;
  std::int64_t line_{0};  ///< the line of the statement
  ReadModel model_;
  PolygonSoup faces_;
  LostVertices lost_;
  std::size_t weights_{0};
  bool curves_{false};
  bool hasMaterials_{false};
  bool isColoured_{false};
  bool beginsGroup_{false};
  std::size_t groups_{0};  ///< runs of faces between statements that name groups or objects
  ReadOptions options_;
  std::vector<double> colours_;
  std::vector<double> texture_;
  bool hasColours_{false};
};

}  // namespace

Result<ReadModel> readObj(std::span<const std::byte> bytes, const ReadOptions& options) {
  return ObjReader(textOf(bytes), options).read();
}

bool isObjLine(std::string_view line) {
  constexpr std::array<std::string_view, 23> kKeywords{
      "v",     "vn",  "vt",     "vp",     "f",      "fo",     "l",   "p",
      "o",     "g",   "s",      "mg",     "mtllib", "usemtl", "deg", "cstype",
      "bevel", "lod", "usemap", "maplib", "curv",   "surf",   "t"};
  const std::string_view keyword = Words(line).nextOnLine();
  return std::find(kKeywords.begin(), kKeywords.end(), keyword) != kKeywords.end();
}

}  // namespace girth::io
