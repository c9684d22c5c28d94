#include "model/typed_point.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <sstream>
#include <system_error>

#include "files/read_file.h"
#include "model/fewer_triangles.h"
#include "model/loading.h"
#include "process/files.h"
#include "process/report.h"
#include "text/number_text.h"

namespace girth::cli {
namespace {

/// The shares of a face's corners as they stand on the surface, where it may have been turned over
/// since it was read.
Result<std::array<double, 3>> sharesOnSurface(const io::LoadedMesh& loaded, Index face,
                                              const TypedPoint& point, const std::string& path,
                                              const ModelOptions& preparing) {
  const PreparationReport& report = loaded.report;
  if (report.reorientedFaces + report.flippedFaces + report.addedFaces == 0) return point.weights;
  const auto model = readModelFile(path, preparing.entry);
  if (!model) return model.error();
  const auto corners = loaded.mesh.faceVertices(Face(face));
  std::array<double, 3> shares{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Index input = model.value().soup.triangles[3 * static_cast<std::size_t>(*point.face) + k];
    const Index first = loaded.inputOfVertex[loaded.vertexOfInput[input]];
    const auto corner = std::find_if(corners.begin(), corners.end(),
                                     [&](Index v) { return loaded.inputOfVertex[v] == first; });
    if (corner == corners.end()) {
      return makeError(
          ErrorCode::InvalidPoint, *point.face,
          "face " + std::to_string(*point.face) +
              (report.addedFaces > 0 ? " was divided where a neighbour has a vertex within its edge"
                                     : " had no area and shares that of its neighbour now"));
    }
    shares[static_cast<std::size_t>(corner - corners.begin())] = point.weights[k];
  }
  return shares;
}

/// The points of one row. A face's shares have commas between, too.
std::string readRow(std::string line, std::vector<TypedPoint>& points) {
  for (char& c : line) {
    if (c == ',' || c == ';' || c == '\t' || c == '\r' || c == '"') c = ' ';
  }
  std::istringstream words(line);
  for (std::string word; words >> word;) {
    if (word.find(':') != std::string::npos) {
      std::string second, third;
      words >> second >> third;
      word += "," + second + "," + third;
    }
    if (std::string problem = readPoint(word, points.emplace_back()); !problem.empty()) {
      return problem;
    }
  }
  return "";
}

}  // namespace

std::string TypedPoint::text() const {
  if (vertex) return "vertex " + std::to_string(*vertex);
  std::string words = "face " + std::to_string(*face) + " at ";
  for (std::size_t i = 0; i < 3; ++i) words += (i == 0 ? "" : ",") + readable(weights[i]);
  return words;
}

std::string readWeights(const std::string& text, std::array<double, 3>& weights) {
  std::string rest = text + ",";
  for (double& weight : weights) {
    const std::size_t comma = rest.find(',');
    const std::optional<double> number =
        comma == std::string::npos ? std::nullopt : io::parseNumber(rest.substr(0, comma));
    if (!number) return "\"" + text + "\" is not three numbers with commas between";
    weight = *number;
    rest.erase(0, comma + 1);
  }
  return rest.empty() ? "" : "\"" + text + "\" is more than three numbers";
}

std::string readPoint(const std::string& text, TypedPoint& point) {
  const std::size_t colon = text.find(':');
  const std::string number = text.substr(0, colon);
  std::int64_t element = 0;
  const auto [end, problem] =
      std::from_chars(number.data(), number.data() + number.size(), element);
  if (number.empty() || end != number.data() + number.size() || problem != std::errc()) {
    return "\"" + text + "\" is no point: name a vertex, as in 12, or a face with the shares of " +
           "its vertices, as in 7:0.2,0.3,0.5";
  }
  (colon == std::string::npos ? point.vertex : point.face) = element;
  return colon == std::string::npos ? "" : readWeights(text.substr(colon + 1), point.weights);
}

std::string readPoints(const std::string& text, std::vector<TypedPoint>& points) {
  const bool isTyped = !text.empty() && (io::isDigit(text.front()) || text.front() == '-');
  const std::string problem = isTyped ? readRow(text, points) : std::string();
  // A file's name may begin with a digit, too.
  if (isTyped && (problem.empty() || !isFile(text))) return problem;
  points.clear();
  const auto rows = readPointRows(text);
  if (!rows) return rows.error().message;
  for (const auto& row : rows.value()) points.insert(points.end(), row.begin(), row.end());
  return points.empty() ? "\"" + text + "\" has no points" : "";
}

Result<std::vector<std::vector<TypedPoint>>> readPointRows(const std::string& path) {
  const auto content = io::readFile(path);
  if (!content) {
    Error error = content.error();
    error.file = path;
    return error;
  }
  std::istringstream lines(
      std::string(reinterpret_cast<const char*>(content.value().data()), content.value().size()));
  std::vector<std::vector<TypedPoint>> rows;
  std::int64_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::size_t first = line.find_first_not_of(" \t\r\"");
    if (first == std::string::npos) continue;
    if (number == 1 && !io::isDigit(line[first]) && line[first] != '-') continue;
    if (const std::string problem = readRow(line, rows.emplace_back()); !problem.empty()) {
      Error error = makeError(ErrorCode::MalformedFile, number,
                              "row " + std::to_string(number) + ": " + problem);
      error.file = path;
      return error;
    }
  }
  return rows;
}

Result<SurfacePoint> surfacePoint(const io::LoadedMesh& loaded, const TypedPoint& point,
                                  const std::string& path, const ModelOptions& preparing) {
  if (point.vertex) {
    const Result<Vertex> vertex = surfaceVertex(loaded, *point.vertex);
    if (!vertex) return vertex.error();
    return SurfacePoint::atVertex(vertex.value());
  }
  if (preparing.faces > 0) return otherFaces("name a vertex");
  const Index count = loaded.report.inputFaces;
  if (*point.face < 0 || *point.face >= std::int64_t{count}) {
    Error error = makeError(ErrorCode::InvalidPoint, *point.face,
                            "there is no face " + std::to_string(*point.face));
    error.hint = "its faces are numbered from 0 to " + std::to_string(count - 1);
    return error;
  }
  const auto found = std::find(loaded.inputOfFace.begin(), loaded.inputOfFace.end(),
                               static_cast<Index>(*point.face));
  if (found == loaded.inputOfFace.end()) {
    Error error = makeError(ErrorCode::InvalidPoint, *point.face,
                            "face " + std::to_string(*point.face) + " was left out");
    error.hint = "girth info lists what was left out and why";
    return error;
  }
  const auto face = static_cast<Index>(found - loaded.inputOfFace.begin());
  const auto shares = sharesOnSurface(loaded, face, point, path, preparing);
  if (!shares) return shares.error();
  return SurfacePoint::inFace(Face(face), shares.value());
}

Result<std::vector<SurfacePoint>> surfacePoints(const io::LoadedMesh& loaded,
                                                const std::vector<TypedPoint>& points,
                                                const std::string& path,
                                                const ModelOptions& preparing) {
  std::vector<SurfacePoint> found;
  for (const TypedPoint& one : points) {
    const auto point = surfacePoint(loaded, one, path, preparing);
    if (!point) return point.error();
    found.push_back(point.value());
  }
  return found;
}

}  // namespace girth::cli
