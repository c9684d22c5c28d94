#define TINYGLTF_IMPLEMENTATION
#include "gltf_document.h"

#include <array>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "json_nesting.h"
#include "text.h"

namespace girth::io {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kDraco = "KHR_draco_mesh_compression";

// No document needs more; a recursive parser survives this.
constexpr std::size_t kDeepest = 64;

Error malformed(std::string message) {
  return makeError(ErrorCode::MalformedFile, -1, std::move(message));
}

/// Required extensions that change how the geometry is stored or placed make it unreadable here;
/// these families do not.
bool leavesGeometryAlone(std::string_view extension) {
  constexpr std::array<std::string_view, 15> kHarmless{
      "KHR_mesh_quantization", "KHR_materials_", "KHR_texture_",
      "KHR_lights_",           "KHR_xmp",        "KHR_animation_",
      "KHR_techniques_",       "KHR_audio",      "KHR_interactivity",
      "EXT_texture_",          "EXT_lights_",    "EXT_materials_",
      "MSFT_texture_",         "MSFT_packing_",  "GOOGLE_texture_"};
  for (const std::string_view prefix : kHarmless) {
    if (extension.substr(0, prefix.size()) == prefix) return true;
  }
  return false;
}

/// Moves the named members of an object into a new one.
Json pick(Json& from, std::initializer_list<const char*> names) {
  Json picked = Json::object();
  if (!from.is_object()) return picked;
  for (const char* name : names) {
    const auto found = from.find(name);
    if (found != from.end()) picked[name] = std::move(*found);
  }
  return picked;
}

const std::string* stringMember(const Json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(name);
  return found == object.end() ? nullptr : found->get_ptr<const std::string*>();
}

/// Of `extensions` only the mark of Draco remains, without its content.
void reduceExtensions(Json& object) {
  const auto found = object.find("extensions");
  if (found == object.end()) return;
  const bool draco = found->is_object() && found->contains(std::string(kDraco));
  object.erase(found);
  if (draco) object["extensions"] = Json{{std::string(kDraco), Json::object()}};
}

/// tinygltf turns numbers into int unseen; a larger one would come out as another.
bool integersFit(const Json& value) {
  if (value.is_structured()) {
    for (const auto& child : value) {
      if (!integersFit(child)) return false;
    }
    return true;
  }
  if (value.is_number_unsigned()) {
    return value.get<std::uint64_t>() <= std::uint64_t{std::numeric_limits<std::int32_t>::max()};
  }
  if (value.is_number_integer()) {
    return value.get<std::int64_t>() >= std::numeric_limits<std::int32_t>::min();
  }
  return true;
}

/// The elements of a top-level array, each reduced by `reduce`, in `reduced`; what does not fit
/// comes back as a message.
template <class Reduce>
std::optional<Error> reduceSection(Json& document, const char* section, Json& reduced,
                                   const Reduce& reduce) {
  const auto found = document.find(section);
  if (found == document.end()) return std::nullopt;
  if (!found->is_array()) return malformed(std::string("\"") + section + "\" is not an array");
  Json& kept = reduced[section] = Json::array();
  std::size_t number = 0;
  for (Json& element : *found) {
    const std::string where = std::string(section) + "[" + std::to_string(number) + "]";
    if (!element.is_object()) return malformed(where + " is not an object");
    Json small = reduce(element);
    if (!integersFit(small)) return malformed(where + " has a number out of range");
    kept.push_back(std::move(small));
    ++number;
  }
  return std::nullopt;
}

/// A copy of what describes geometry. Everything else (materials, images, animations, extras) could
/// only make tinygltf fail or work in vain.
std::optional<Error> reduceDocument(Json& document, Json& reduced) {
  reduced = Json::object();
  reduced["asset"] = {{"version", "2.0"}};
  const std::array<std::optional<Error>, 5> errors{
      reduceSection(document, "bufferViews", reduced,
                    [](Json& view) {
                      return pick(view, {"buffer", "byteOffset", "byteLength", "byteStride"});
                    }),
      reduceSection(document, "accessors", reduced,
                    [](Json& accessor) {
                      Json kept = pick(accessor, {"bufferView", "byteOffset", "componentType",
                                                  "normalized", "count", "type", "sparse"});
                      if (const auto sparse = kept.find("sparse"); sparse != kept.end()) {
                        *sparse = pick(*sparse, {"count", "indices", "values"});
                        for (Json& part : *sparse) {
                          if (!part.is_object()) continue;
                          part = pick(part, {"bufferView", "byteOffset", "componentType"});
                        }
                      }
                      return kept;
                    }),
      reduceSection(
          document, "meshes", reduced,
          [](Json& mesh) {
            Json kept = pick(mesh, {"name", "primitives"});
            const auto primitives = kept.find("primitives");
            if (primitives == kept.end() || !primitives->is_array()) return kept;
            for (Json& primitive : *primitives) {
              primitive = pick(primitive, {"attributes", "indices", "mode", "extensions"});
              if (const auto attributes = primitive.find("attributes");
                  attributes != primitive.end()) {
                *attributes = pick(*attributes, {"POSITION"});
              }
              reduceExtensions(primitive);
            }
            return kept;
          }),
      reduceSection(document, "nodes", reduced,
                    [](Json& node) {
                      return pick(node, {"name", "children", "mesh", "matrix", "rotation", "scale",
                                         "translation"});
                    }),
      reduceSection(document, "scenes", reduced,
                    [](Json& scene) {
                      return pick(scene, {"name", "nodes"});
                    }),
  };
  for (const auto& error : errors) {
    if (error) return error;
  }
  if (const auto scene = document.find("scene"); scene != document.end()) {
    if (!integersFit(*scene)) return malformed("\"scene\" is out of range");
    reduced["scene"] = *scene;
  }
  return std::nullopt;
}

std::optional<Error> checkVersion(const Json& document) {
  const auto asset = document.find("asset");
  const std::string* version = asset == document.end() ? nullptr : stringMember(*asset, "version");
  if (asset == document.end() || !asset->is_object()) {
    return makeError(ErrorCode::UnknownFormat, -1,
                     "the file is JSON, but not glTF: it has no \"asset\"");
  }
  // Version 1.0 had dictionaries where 2.0 has arrays, and was often written without a version.
  const auto meshes = document.find("meshes");
  const bool dictionaries = meshes != document.end() && meshes->is_object();
  if (version == nullptr && !dictionaries) return malformed("its \"asset\" names no glTF version");
  const std::string found = version == nullptr ? "1.0" : *version;
  if (dictionaries || found.substr(0, 2) != "2.") {
    return makeError(ErrorCode::UnsupportedFeature, -1,
                     "this is glTF " + (dictionaries ? std::string("1.0") : inQuotes(found)) +
                         "; only version 2 is read");
  }
  const std::string* least = stringMember(*asset, "minVersion");
  if (least != nullptr && *least != "2.0") {
    return makeError(ErrorCode::UnsupportedFeature, -1,
                     "it requires glTF " + inQuotes(*least) + "; version 2.0 is read");
  }
  return std::nullopt;
}

std::optional<Error> checkExtensions(const Json& document) {
  const auto required = document.find("extensionsRequired");
  if (required == document.end() || !required->is_array()) return std::nullopt;
  for (const Json& extension : *required) {
    const auto* name = extension.get_ptr<const std::string*>();
    if (name == nullptr || leavesGeometryAlone(*name)) continue;
    return makeError(ErrorCode::UnsupportedFeature, -1,
                     "it requires the glTF extension " + inQuotes(*name) + ", which is not read");
  }
  return std::nullopt;
}

/// Draco's content has no uncompressed copy beside it where the accessor has no buffer view.
std::optional<Error> checkDraco(const Json& reduced) {
  const auto meshes = reduced.find("meshes");
  const auto accessors = reduced.find("accessors");
  if (meshes == reduced.end() || accessors == reduced.end()) return std::nullopt;
  for (const Json& mesh : *meshes) {
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array()) continue;
    for (const Json& primitive : *primitives) {
      if (!primitive.contains("extensions")) continue;
      const auto attributes = primitive.find("attributes");
      if (attributes == primitive.end() || !attributes->contains("POSITION")) continue;
      const Json& position = (*attributes)["POSITION"];
      if (!position.is_number_unsigned() || position.get<std::size_t>() >= accessors->size())
        continue;
      if ((*accessors)[position.get<std::size_t>()].contains("bufferView")) continue;
      return makeError(ErrorCode::UnsupportedFeature, -1,
                       "its geometry is compressed with the glTF extension " + inQuotes(kDraco) +
                           ", which is not read");
    }
  }
  return std::nullopt;
}

Result<std::vector<GltfBufferSource>> bufferSources(Json& document) {
  std::vector<GltfBufferSource> sources;
  const auto buffers = document.find("buffers");
  if (buffers == document.end()) return sources;
  if (!buffers->is_array()) return malformed("\"buffers\" is not an array");
  for (Json& buffer : *buffers) {
    const std::string where = "buffers[" + std::to_string(sources.size()) + "]";
    if (!buffer.is_object()) return malformed(where + " is not an object");
    GltfBufferSource source;
    const auto length = buffer.find("byteLength");
    if (length == buffer.end() || !length->is_number_unsigned()) {
      return malformed(where + " has no byteLength");
    }
    source.byteLength = length->get<std::uint64_t>();
    if (const auto uri = buffer.find("uri"); uri != buffer.end()) {
      if (!uri->is_string()) return malformed(where + " has a uri that is not text");
      source.uri = std::move(uri->get_ref<std::string&>());
    }
    if (const auto extensions = buffer.find("extensions");
        extensions != buffer.end() && extensions->is_object()) {
      for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
        if (extensions->contains(name)) source.fallbackFor = name;
      }
    }
    sources.push_back(std::move(source));
  }
  return sources;
}

Result<Json> parseJson(std::string_view text) {
  if (const auto at = nestingBeyond(text, kDeepest)) {
    return makeError(ErrorCode::LimitExceeded, static_cast<std::int64_t>(*at),
                     "its JSON is nested more than " + std::to_string(kDeepest) +
                         " levels deep at byte " + std::to_string(*at));
  }
  try {
    return Json::parse(text.begin(), text.end());
  } catch (const Json::parse_error& error) {
    return makeError(ErrorCode::MalformedFile, static_cast<std::int64_t>(error.byte),
                     error.byte >= text.size()
                         ? "its JSON breaks off at byte " + std::to_string(error.byte)
                         : "its JSON is not valid at byte " + std::to_string(error.byte));
  } catch (const Json::exception&) {
    return malformed("its JSON holds a number that no double can hold");
  }
}

}  // namespace

Result<GltfDocument> parseGltfDocument(std::string_view text) {
  auto parsed = parseJson(text);
  if (!parsed) return parsed.error();
  Json document = std::move(parsed).value();
  if (!document.is_object()) return malformed("its JSON is not an object");
  if (auto error = checkVersion(document)) return *error;
  if (auto error = checkExtensions(document)) return *error;

  GltfDocument result;
  auto sources = bufferSources(document);
  if (!sources) return sources.error();
  result.buffers = std::move(sources).value();

  Json reduced;
  if (auto error = reduceDocument(document, reduced)) return *error;
  if (auto error = checkDraco(reduced)) return *error;
  document = nullptr;
  std::string reducedText = reduced.dump();
  if (reducedText.size() > std::numeric_limits<unsigned int>::max()) {
    return makeError(ErrorCode::LimitExceeded, -1, "its JSON exceeds 4 GB");
  }

  tinygltf::TinyGLTF reader;
  std::string error;
  std::string warning;
  try {
    if (!reader.LoadASCIIFromString(&result.model, &error, &warning, reducedText.data(),
                                    static_cast<unsigned int>(reducedText.size()), std::string())) {
      std::string firstLine = error.substr(0, error.find('\n'));
      while (!firstLine.empty() && (firstLine.back() == '.' || firstLine.back() == ' ')) {
        firstLine.pop_back();
      }
      return malformed("its glTF document is not valid: " +
                       (firstLine.empty() ? std::string("tinygltf refused it") : firstLine));
    }
  } catch (const Json::exception&) {
    return malformed("its glTF document is not valid: a member has the wrong type");
  }
  // tinygltf leaves out primitives that it cannot make sense of.
  for (std::size_t m = 0; m < result.model.meshes.size(); ++m) {
    const Json& mesh = reduced["meshes"][m];
    const auto primitives = mesh.find("primitives");
    const std::size_t written =
        primitives == mesh.end() || !primitives->is_array() ? 0 : primitives->size();
    if (written == 0 || result.model.meshes[m].primitives.size() != written) {
      return malformed("meshes[" + std::to_string(m) + "] has a primitive that is not valid");
    }
  }
  return result;
}

}  // namespace girth::io
