#include "commands/section_landmarks.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "files/read_file.h"
#include "girth/geodesic_solver.h"
#include "girth/girth_solver.h"
#include "girth/section.h"
#include "model/typed_point.h"

namespace girth::cli {
namespace {

using nlohmann::json;

constexpr MeasureKind kMeasureKinds[]{MeasureKind::Girth, MeasureKind::Section, MeasureKind::Tape,
                                      MeasureKind::Distance};

/// A landmark as it stands in the file.
struct Landmark {
  std::string name;
  MeasureKind how{MeasureKind::Girth};
  TypedPoint point, to;
  bool across{false};
};

/// Reads a point. Returns what is wrong with it; empty: nothing.
std::string readMember(const json& landmark, const char* name, TypedPoint& point) {
  const auto found = landmark.find(name);
  if (found == landmark.end()) return std::string("has no \"") + name + "\"";
  if (found->is_number_integer()) {
    point.vertex = found->get<std::int64_t>();
    return "";
  }
  if (!found->is_string()) return std::string("\"") + name + "\" is no point";
  return readPoint(found->get<std::string>(), point);
}

/// Reads a landmark. Returns what is wrong with it; empty: nothing.
std::string readLandmark(const json& from, Landmark& landmark) {
  if (!from.is_object()) return "is no object";
  const auto name = from.find("name"), how = from.find("how"), across = from.find("across");
  if (name == from.end() || !name->is_string()) return "has no \"name\"";
  landmark.name = name->get<std::string>();
  const std::string word = how != from.end() && how->is_string() ? how->get<std::string>() : "";
  const auto* const kind = std::find_if(std::begin(kMeasureKinds), std::end(kMeasureKinds),
                                        [&](MeasureKind one) { return toString(one) == word; });
  if (kind == std::end(kMeasureKinds)) {
    return "has no \"how\" that is \"girth\", \"section\", \"tape\" or \"distance\"";
  }
  landmark.how = *kind;
  if (across != from.end() && !across->is_boolean()) return "\"across\" is neither true nor false";
  landmark.across = across != from.end() && across->get<bool>();
  std::string problem = readMember(from, "point", landmark.point);
  if (problem.empty() && landmark.how == MeasureKind::Distance) {
    problem = readMember(from, "to", landmark.to);
  }
  return problem;
}

Error malformed(const std::string& file, std::string message, std::int64_t element = -1) {
  Error error = makeError(ErrorCode::MalformedFile, element, std::move(message));
  error.file = file;
  return error;
}

Result<std::vector<Landmark>> readLandmarks(const std::string& file) {
  const auto bytes = io::readFile(file);
  if (!bytes) {
    Error error = bytes.error();
    error.file = file;
    return error;
  }
  const auto* const begin = reinterpret_cast<const char*>(bytes.value().data());
  const json all = json::parse(begin, begin + bytes.value().size(), nullptr, false);
  if (!all.is_array()) return malformed(file, "it is no JSON array of landmarks");
  std::vector<Landmark> landmarks;
  for (const json& one : all) {
    const std::size_t number = landmarks.size() + 1;
    if (const std::string problem = readLandmark(one, landmarks.emplace_back()); !problem.empty()) {
      return malformed(file, "landmark " + std::to_string(number) + " " + problem,
                       static_cast<std::int64_t>(number));
    }
  }
  return landmarks;
}

Result<NamedMeasure> measured(const Landmark& landmark, const SurfacePoint& point,
                              const SurfacePoint& to, const SurfaceMesh& mesh, const Vec3& usual) {
  NamedMeasure measure{landmark.name, landmark.how, point, 0, {}};
  if (landmark.how == MeasureKind::Girth) {
    auto loop = GirthSolver(mesh).loop(point);
    if (!loop) return loop.error();
    measure.length = loop.value().length;
    measure.points = std::move(loop.value().points);
    return measure;
  }
  if (landmark.how == MeasureKind::Distance) {
    auto path = GeodesicSolver(mesh).path(point, to);
    if (!path) return path.error();
    measure.length = path.value().length;
    measure.points = std::move(path.value().points);
    return measure;
  }
  const auto normal = landmark.across ? directionAlong(mesh, point) : Result<Vec3>(usual);
  if (!normal) return normal.error();
  const auto offset = heightOf(mesh, normal.value(), point);
  if (!offset) return offset.error();
  const auto section = findSection(mesh, normal.value(), offset.value());
  if (!section) return section.error();
  const SectionCurve* curve = curveThrough(mesh, section.value(), point);
  if (curve == nullptr) {
    return makeError(ErrorCode::InvalidPoint, -1,
                     "the plane through the point only touches the surface");
  }
  measure.length = landmark.how == MeasureKind::Tape ? curve->tape : curve->perimeter;
  measure.points = curve->points;
  return measure;
}

}  // namespace

std::string_view toString(MeasureKind kind) {
  switch (kind) {
    case MeasureKind::Girth:
      return "girth";
    case MeasureKind::Section:
      return "section";
    case MeasureKind::Tape:
      return "tape";
    case MeasureKind::Distance:
      return "distance";
  }
  return "";
}

Result<NamedMeasures> measureLandmarks(const std::string& file, const io::LoadedMesh& loaded,
                                       const Vec3& normal, const std::string& model,
                                       const ModelOptions& preparing) {
  const auto landmarks = readLandmarks(file);
  if (!landmarks) return landmarks.error();
  NamedMeasures all;
  for (const Landmark& landmark : landmarks.value()) {
    const auto measure = [&]() -> Result<NamedMeasure> {
      const auto point = surfacePoint(loaded, landmark.point, model, preparing);
      if (!point) return point.error();
      if (landmark.how != MeasureKind::Distance) {
        return measured(landmark, point.value(), {}, loaded.mesh, normal);
      }
      const auto to = surfacePoint(loaded, landmark.to, model, preparing);
      if (!to) return to.error();
      return measured(landmark, point.value(), to.value(), loaded.mesh, normal);
    }();
    if (!measure) {
      Error error = measure.error();
      error.message = landmark.name + ": " + error.message;
      return error;
    }
    all.measures.push_back(measure.value());
  }
  return all;
}

}  // namespace girth::cli
