#include "commands/section_landmarks.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "files/read_file.h"
#include "model/typed_point.h"

namespace girth::cli {
namespace {

using nlohmann::json;

constexpr MeasureKind kMeasureKinds[]{MeasureKind::Girth, MeasureKind::Section, MeasureKind::Tape,
                                      MeasureKind::Distance};

/// A landmark as it stands in the file: its points are typed.
struct TypedLandmark {
  Landmark landmark;
  TypedPoint point, to;
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

/// Reads a member that is true or false, if it is there. Returns what is wrong with it.
std::string readSwitch(const json& landmark, const char* name, bool& isSo) {
  const auto found = landmark.find(name);
  if (found == landmark.end()) return "";
  if (!found->is_boolean()) return std::string("\"") + name + "\" is neither true nor false";
  isSo = found->get<bool>();
  return "";
}

/// Reads a landmark. Returns what is wrong with it; empty: nothing.
std::string readLandmark(const json& from, TypedLandmark& typed) {
  if (!from.is_object()) return "is no object";
  const auto name = from.find("name"), how = from.find("how");
  if (name == from.end() || !name->is_string()) return "has no \"name\"";
  typed.landmark.name = name->get<std::string>();
  const std::string word = how != from.end() && how->is_string() ? how->get<std::string>() : "";
  const auto* const kind = std::find_if(std::begin(kMeasureKinds), std::end(kMeasureKinds),
                                        [&](MeasureKind one) { return toString(one) == word; });
  if (kind == std::end(kMeasureKinds)) {
    return "has no \"how\" that is \"girth\", \"section\", \"tape\" or \"distance\"";
  }
  typed.landmark.how = *kind;
  std::string problem = readSwitch(from, "across", typed.landmark.across);
  if (problem.empty()) problem = readSwitch(from, "all", typed.landmark.all);
  if (problem.empty()) problem = readMember(from, "point", typed.point);
  if (problem.empty() && typed.landmark.how == MeasureKind::Distance) {
    problem = readMember(from, "to", typed.to);
  }
  return problem;
}

Error malformed(const std::string& file, std::string message, std::int64_t element = -1) {
  Error error = makeError(ErrorCode::MalformedFile, element, std::move(message));
  error.file = file;
  return error;
}

Result<std::vector<TypedLandmark>> readLandmarks(const std::string& file) {
  const auto bytes = io::readFile(file);
  if (!bytes) {
    Error error = bytes.error();
    error.file = file;
    return error;
  }
  const auto* const begin = reinterpret_cast<const char*>(bytes.value().data());
  const json all = json::parse(begin, begin + bytes.value().size(), nullptr, false);
  if (!all.is_array()) return malformed(file, "it is no JSON array of landmarks");
  std::vector<TypedLandmark> landmarks;
  for (const json& one : all) {
    const std::size_t number = landmarks.size();
    TypedLandmark& typed = landmarks.emplace_back();
    if (const std::string problem = readLandmark(one, typed); !problem.empty()) {
      const std::string& name = typed.landmark.name;
      const std::string which = name.empty() ? "" : " (" + name + ")";
      return malformed(file, "landmark " + std::to_string(number) + which + " " + problem,
                       static_cast<std::int64_t>(number));
    }
  }
  return landmarks;
}

}  // namespace

Result<std::vector<Landmark>> landmarksOf(const std::string& file, const io::LoadedMesh& loaded,
                                          const std::string& model, const ModelOptions& preparing) {
  auto typed = readLandmarks(file);
  if (!typed) return typed.error();
  std::vector<Landmark> landmarks;
  for (TypedLandmark& one : typed.value()) {
    Landmark& landmark = one.landmark;
    const auto place = [&](const TypedPoint& meant, SurfacePoint& found) -> std::optional<Error> {
      const auto there = surfacePoint(loaded, meant, model, preparing);
      if (there) {
        found = there.value();
        return std::nullopt;
      }
      Error error = there.error();
      error.message = landmark.name + ": " + error.message;
      return error;
    };
    if (auto error = place(one.point, landmark.point)) return *std::move(error);
    if (landmark.how == MeasureKind::Distance) {
      if (auto error = place(one.to, landmark.to)) return *std::move(error);
    }
    landmarks.push_back(std::move(landmark));
  }
  return landmarks;
}

}  // namespace girth::cli
