#include "gltf/document/geometry_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "girth/io/length_unit.h"
#include "gltf/document/fault.h"
#include "gltf/document/json_fields.h"
#include "gltf/document/json_nesting.h"
#include "text/quoted_name.h"

namespace girth::io {
namespace {

using Json = nlohmann::json;

// No document needs more; a recursive parser survives this.
constexpr std::size_t kDeepest = 64;

// The greatest number that a double holds exactly, and far more than any file.
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 53;

// More influences a vertex than any exporter writes.
constexpr std::size_t kMostJointSets = 16;

/// Required extensions that change how the geometry is stored or placed make it unreadable, unless
/// they are among these. Names that end in '_' or '-' stand for families.
bool isUnderstood(std::string_view extension) {
  constexpr std::array<std::string_view, 31> kUnderstood{
      // Read.
      "KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression",
      "KHR_mesh_quantization", "EXT_mesh_gpu_instancing", "KHR_node_visibility",
      // Beside the geometry.
      "KHR_materials_", "KHR_texture_", "KHR_lights_", "KHR_xmp", "KHR_animation_", "KHR_technique",
      "KHR_audio", "KHR_interactivity", "KHR_node_hoverability", "KHR_node_selectability",
      "KHR_physics_", "KHR_collision_", "EXT_texture_", "EXT_lights_", "EXT_materials_",
      "EXT_mesh_features", "EXT_mesh_manifold", "EXT_structural_metadata", "EXT_instance_features",
      "MSFT_texture_", "MSFT_packing_", "MSFT_lod", "GOOGLE_texture_", "CESIUM_primitive_outline",
      "VRM"};
  for (const std::string_view name : kUnderstood) {
    if (extension == name) return true;
    const bool isFamily =
        name.back() == '_' || name == "KHR_xmp" || name == "KHR_technique" || name == "VRM";
    if (isFamily && extension.substr(0, name.size()) == name) return true;
  }
  return false;
}

/// The demand on a member.
enum class Kind : std::uint8_t {
  Present,          // anything, but it must be there
  Reference,        // the number of another element, or a small count
  ReferenceOrNone,  // a reference; -1 where it is not given
  Count,            // a number of bytes or elements
  ValueCount,       // a count in an extension, where tinygltf holds integers of 32 bits
  Component,        // a component type
  Mode,             // the kind of elements that a primitive draws
  Word,             // one of `words`
  Text,
  Flag,
  Numbers,     // as many as `size`, or any number of them where that is 0
  References,  // the numbers of other elements
  Sets,        // NAME0, NAME1, ...: references
  Extras,      // references that the surface does not need: what is none is left out
  Extra,       // one such reference
  Object,      // an object with `members`
  List,        // an array of objects with `members`
  Extension    // an object with `members`, in "extensions"
};

struct Rule {
  const char* name;
  Kind kind;
  bool required{false};
  std::uint64_t size{0};
  std::span<const Rule> members{};
  std::span<const std::string_view> words{};
};

// The members of each kind of object, in the order in which they are checked.
constexpr std::string_view kModes[]{"ATTRIBUTES", "TRIANGLES", "INDICES"};
constexpr std::string_view kFilters[]{"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"};
constexpr std::string_view kShapes[]{"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};

constexpr Rule kMeshopt[]{{"buffer", Kind::Reference, true},
                          {"byteOffset", Kind::ValueCount},
                          {"byteLength", Kind::ValueCount, true},
                          {"byteStride", Kind::ValueCount, true},
                          {"count", Kind::ValueCount, true},
                          {"mode", Kind::Word, true, 0, {}, kModes},
                          {"filter", Kind::Word, false, 0, {}, kFilters}};
constexpr Rule kBufferView[]{{"buffer", Kind::Reference, true},
                             {"byteOffset", Kind::Count},
                             {"byteLength", Kind::Count, true},
                             {"byteStride", Kind::Count},
                             {"EXT_meshopt_compression", Kind::Extension, false, 0, kMeshopt},
                             {"KHR_meshopt_compression", Kind::Extension, false, 0, kMeshopt}};

constexpr Rule kSparseIndices[]{{"bufferView", Kind::Reference, true},
                                {"byteOffset", Kind::Reference},
                                {"componentType", Kind::Component, true}};
constexpr Rule kSparseValues[]{{"bufferView", Kind::Reference, true},
                               {"byteOffset", Kind::Reference}};
constexpr Rule kSparse[]{{"count", Kind::Reference, true},
                         {"indices", Kind::Present},
                         {"values", Kind::Present},
                         {"indices", Kind::Object, true, 0, kSparseIndices},
                         {"values", Kind::Object, true, 0, kSparseValues}};
constexpr Rule kAccessor[]{{"bufferView", Kind::Reference},
                           {"byteOffset", Kind::Count},
                           {"count", Kind::Count, true},
                           {"componentType", Kind::Component, true},
                           {"type", Kind::Word, true, 0, {}, kShapes},
                           {"normalized", Kind::Flag},
                           {"sparse", Kind::Object, false, 0, kSparse}};

constexpr Rule kAttributes[]{{"POSITION", Kind::Reference},
                             {"JOINTS_", Kind::Sets},
                             {"WEIGHTS_", Kind::Sets},
                             {"", Kind::Extras}};
constexpr Rule kTarget[]{{"POSITION", Kind::Reference}};
constexpr Rule kDraco[]{{"bufferView", Kind::Reference, true},
                        {"attributes", Kind::Object, false, 0, kAttributes}};
constexpr Rule kPrimitive[]{{"mode", Kind::Mode},
                            {"indices", Kind::Reference},
                            {"material", Kind::Extra},
                            {"attributes", Kind::Present},
                            {"attributes", Kind::Object, true, 0, kAttributes},
                            {"targets", Kind::List, false, 0, kTarget},
                            {"KHR_draco_mesh_compression", Kind::Extension, false, 0, kDraco}};
constexpr Rule kMesh[]{{"name", Kind::Text},
                       {"weights", Kind::Numbers},
                       {"primitives", Kind::Present},
                       {"primitives", Kind::List, true, 0, kPrimitive}};

constexpr Rule kInstances[]{{"TRANSLATION", Kind::ReferenceOrNone},
                            {"ROTATION", Kind::ReferenceOrNone},
                            {"SCALE", Kind::ReferenceOrNone}};
constexpr Rule kInstancing[]{{"attributes", Kind::Object, false, 0, kInstances}};
constexpr Rule kVisibility[]{{"visible", Kind::Flag}};
constexpr Rule kNode[]{{"name", Kind::Text},
                       {"children", Kind::References},
                       {"mesh", Kind::Reference},
                       {"skin", Kind::Reference},
                       {"matrix", Kind::Numbers, false, 16},
                       {"translation", Kind::Numbers, false, 3},
                       {"rotation", Kind::Numbers, false, 4},
                       {"scale", Kind::Numbers, false, 3},
                       {"weights", Kind::Numbers},
                       {"EXT_mesh_gpu_instancing", Kind::Extension, false, 0, kInstancing},
                       {"KHR_node_visibility", Kind::Extension, false, 0, kVisibility}};
constexpr Rule kSkin[]{
    {"name", Kind::Text}, {"joints", Kind::References}, {"inverseBindMatrices", Kind::Reference}};
constexpr Rule kScene[]{{"name", Kind::Text}, {"nodes", Kind::References}};

constexpr Rule kBuffer[]{{"uri", Kind::Text}, {"byteLength", Kind::Count, true}};
constexpr Rule kBuffers[]{{"buffers", Kind::List, false, 0, kBuffer}};
constexpr Rule kDocument[]{{"bufferViews", Kind::List, false, 0, kBufferView},
                           {"accessors", Kind::List, false, 0, kAccessor},
                           {"meshes", Kind::List, false, 0, kMesh},
                           {"nodes", Kind::List, false, 0, kNode},
                           {"skins", Kind::List, false, 0, kSkin},
                           {"scenes", Kind::List, false, 0, kScene},
                           {"scene", Kind::Reference}};

/// The largest that std::size_t holds stands for all that is larger: it reaches beyond every
/// buffer, too.
std::uint64_t withinMemory(std::uint64_t count) {
  return std::min<std::uint64_t>(count, std::numeric_limits<std::size_t>::max());
}

/// tinygltf holds whole numbers of values as integers of 32 bits, and all others as doubles.
Json valueNumber(std::uint64_t number) {
  if (number > std::numeric_limits<std::int32_t>::max()) return static_cast<double>(number);
  return number;
}

void copyMembers(const JsonFields& fields, std::span<const Rule> rules, Json& to);

Json objectOf(const Json& value, const JsonPlace& place, std::optional<Error>& fault,
              std::span<const Rule> rules) {
  Json object = Json::object();
  copyMembers(JsonFields(value, place, fault), rules, object);
  return object;
}

std::optional<std::uint64_t> integer(const JsonFields& fields, const Rule& rule,
                                     std::uint64_t most) {
  if (rule.required) return fields.requiredInteger(rule.name, most);
  return fields.integer(rule.name, most);
}

void copyComponent(const JsonFields& fields, const Rule& rule, Json& to) {
  constexpr std::uint64_t kFirst = 5120, kFloat = 5126, kDouble = 5130;
  const std::uint64_t type = fields.requiredInteger(rule.name, kMostBytes);
  if (type < kFirst || (type > kFloat && type != kDouble)) {
    fields.report("is unknown: " + std::to_string(type), rule.name);
  }
  to[rule.name] = type;
}

void copyMode(const JsonFields& fields, const Rule& rule, Json& to) {
  constexpr std::uint64_t kTriangles = 4, kLast = 6;
  const std::uint64_t mode = fields.integer(rule.name, kMostBytes).value_or(kTriangles);
  if (mode > kLast) fields.report("is unknown: " + std::to_string(mode), rule.name);
  to[rule.name] = mode;
}

void copyWord(const JsonFields& fields, const Rule& rule, Json& to) {
  if (!rule.required && fields.find(rule.name) == nullptr) return;
  const std::string found = fields.text(rule.name);
  if (std::find(rule.words.begin(), rule.words.end(), found) == rule.words.end()) {
    fields.report(found.empty() ? "is missing" : "is unknown: " + inQuotes(found), rule.name);
  }
  to[rule.name] = found;
}

void copyList(const JsonFields& fields, const Rule& rule, Json& to) {
  if (fields.find(rule.name) == nullptr) return;
  Json& list = to[rule.name] = Json::array();
  forEachElement(fields, rule.name, [&](const Json& element, const JsonPlace& place) {
    list.push_back(objectOf(element, place, fields.fault(), rule.members));
  });
}

/// Copies a member that nothing but an attribute depends on, if it is the number of an element.
void copyExtra(const std::string& name, const Json& member, Json& to) {
  if (!member.is_number()) return;
  const auto number = member.get<double>();
  const bool isReference =
      number >= 0 && number <= static_cast<double>(kMostReference) && number == std::floor(number);
  if (isReference) to[name] = static_cast<std::uint64_t>(number);
}

void copyExtension(const JsonFields& fields, const Rule& rule, Json& to) {
  // An "extensions" that is not an object holds none; whatever it is, it is not geometry.
  const Json* all = fields.find("extensions");
  if (all == nullptr || !all->is_object()) return;
  const JsonPlace place(fields.place(), "extensions");
  const JsonFields extensions(*all, place, fields.fault());
  if (const Json* extension = extensions.find(rule.name)) {
    to["extensions"][rule.name] =
        objectOf(*extension, JsonPlace(place, rule.name), fields.fault(), rule.members);
  }
}

void copyMember(const JsonFields& fields, const Rule& rule, Json& to) {
  switch (rule.kind) {
    case Kind::Present:
      if (fields.find(rule.name) == nullptr) fields.report("has no " + inQuotes(rule.name));
      break;
    case Kind::Reference:
      if (const auto number = integer(fields, rule, kMostReference)) to[rule.name] = *number;
      break;
    case Kind::ReferenceOrNone: {
      const auto number = fields.reference(rule.name);
      to[rule.name] = number ? static_cast<std::int64_t>(*number) : -1;
      break;
    }
    case Kind::Count:
      if (const auto count = integer(fields, rule, kMostBytes)) {
        to[rule.name] = withinMemory(*count);
      }
      break;
    case Kind::ValueCount:
      if (const auto count = integer(fields, rule, kMostBytes)) {
        to[rule.name] = valueNumber(*count);
      }
      break;
    case Kind::Component:
      copyComponent(fields, rule, to);
      break;
    case Kind::Mode:
      copyMode(fields, rule, to);
      break;
    case Kind::Word:
      copyWord(fields, rule, to);
      break;
    case Kind::Text:
      if (std::string text = fields.text(rule.name); !text.empty()) to[rule.name] = std::move(text);
      break;
    case Kind::Flag:
      if (fields.find(rule.name) != nullptr) to[rule.name] = fields.flag(rule.name);
      break;
    case Kind::Numbers:
      if (const auto numbers = fields.numbers(rule.name, static_cast<std::size_t>(rule.size));
          !numbers.empty()) {
        to[rule.name] = numbers;
      }
      break;
    case Kind::References:
      to[rule.name] = fields.references(rule.name);
      break;
    case Kind::Sets:
      for (std::size_t set = 0; set < kMostJointSets; ++set) {
        const std::string name = rule.name + std::to_string(set);
        if (const auto number = fields.reference(name.c_str())) to[name] = *number;
      }
      break;
    case Kind::Extras:
      if (fields.object() == nullptr) break;
      for (const auto& [name, member] : fields.object()->items()) {
        if (isExtraAttribute(name)) copyExtra(name, member, to);
      }
      break;
    case Kind::Extra:
      if (const Json* member = fields.find(rule.name)) copyExtra(rule.name, *member, to);
      break;
    case Kind::Object:
      if (const Json* object = fields.find(rule.name)) {
        to[rule.name] =
            objectOf(*object, JsonPlace(fields.place(), rule.name), fields.fault(), rule.members);
      }
      break;
    case Kind::List:
      copyList(fields, rule, to);
      break;
    case Kind::Extension:
      copyExtension(fields, rule, to);
      break;
  }
}

/// Copies what the rules name from an object to `to`. After a fault, the copy is of no use.
void copyMembers(const JsonFields& fields, std::span<const Rule> rules, Json& to) {
  for (const Rule& rule : rules) {
    copyMember(fields, rule, to);
    if (fields.fault()) return;
  }
}

const std::string* stringMember(const Json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(name);
  return found == object.end() ? nullptr : found->get_ptr<const std::string*>();
}

std::optional<Error> checkVersion(const Json& document) {
  const auto asset = document.find("asset");
  // Version 1.0 had dictionaries where 2.0 has arrays, and was often written without a version, or
  // without anything about the asset.
  const auto isDictionary = [&](const char* name) {
    const auto found = document.find(name);
    return found != document.end() && found->is_object();
  };
  const bool dictionaries =
      isDictionary("meshes") || (isDictionary("accessors") && isDictionary("bufferViews"));
  if (!dictionaries && (asset == document.end() || !asset->is_object())) {
    return makeError(ErrorCode::UnknownFormat, -1,
                     "the file is JSON, but not glTF: it has no \"asset\"");
  }
  const std::string* version = asset == document.end() ? nullptr : stringMember(*asset, "version");
  if ((version == nullptr || version->empty()) && !dictionaries) {
    return faultAt("/asset/version", "is missing");
  }
  if (dictionaries || version->substr(0, 2) != "2.") {
    Error error =
        makeError(ErrorCode::UnsupportedFeature, -1,
                  "this is glTF " +
                      (dictionaries || version->substr(0, 2) == "1." ? std::string("1.0")
                                                                     : inQuotes(*version)) +
                      "; only version 2 is read");
    error.hint =
        "convert it to glTF 2.0: open it in an editor that still reads it, export it again";
    return error;
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
    if (name == nullptr || isUnderstood(*name)) continue;
    return makeError(ErrorCode::UnsupportedFeature, -1,
                     "it requires the glTF extension " + inQuotes(*name) + ", which is not read");
  }
  return std::nullopt;
}

Result<Json> parseJson(std::string_view text, std::size_t firstByte) {
  const auto atByte = [](std::size_t byte) { return " at byte " + std::to_string(byte); };
  if (const auto at = nestingBeyond(text, kDeepest)) {
    return makeError(ErrorCode::LimitExceeded, static_cast<std::int64_t>(firstByte + *at),
                     "its JSON is nested more than " + std::to_string(kDeepest) + " levels deep" +
                         atByte(firstByte + *at));
  }
  try {
    return Json::parse(text.begin(), text.end());
  } catch (const Json::parse_error& error) {
    // The parser counts bytes from 1.
    const std::size_t byte = firstByte + (error.byte > 0 ? error.byte - 1 : 0);
    return makeError(ErrorCode::MalformedFile, static_cast<std::int64_t>(byte),
                     (error.byte >= text.size() ? "its JSON breaks off" : "its JSON is not valid") +
                         atByte(byte));
  } catch (const Json::exception&) {
    return makeError(ErrorCode::MalformedFile, -1,
                     "its JSON holds a number that no double can hold");
  }
}

/// The base colours of the materials; white where a material states none, or none that can be.
std::vector<GltfColour> baseColours(const Json& document) {
  std::vector<GltfColour> colours;
  const auto materials = document.find("materials");
  if (materials == document.end() || !materials->is_array()) return colours;
  const auto memberOf = [](const Json* object, const char* name) -> const Json* {
    if (object == nullptr || !object->is_object()) return nullptr;
    const auto found = object->find(name);
    return found == object->end() ? nullptr : &*found;
  };
  for (const Json& material : *materials) {
    colours.push_back(kGltfWhite);
    const Json* factor = memberOf(memberOf(&material, "pbrMetallicRoughness"), "baseColorFactor");
    if (factor == nullptr || !factor->is_array() || factor->size() != colours.back().size()) {
      continue;
    }
    const bool isColour = std::all_of(factor->begin(), factor->end(), [](const Json& channel) {
      return channel.is_number() && channel.get<double>() >= 0 && channel.get<double>() <= 1;
    });
    if (isColour) colours.back() = factor->get<GltfColour>();
  }
  return colours;
}

/// Whether `extras` of some mesh have a `unit` that is none.
bool statesUnknownUnit(const Json& document) {
  const auto meshes = document.find("meshes");
  if (meshes == document.end() || !meshes->is_array()) return false;
  return std::any_of(meshes->begin(), meshes->end(), [](const Json& mesh) {
    const auto extras = mesh.is_object() ? mesh.find("extras") : mesh.end();
    const std::string* unit = extras == mesh.end() ? nullptr : stringMember(*extras, "unit");
    return unit != nullptr && findLengthUnit(*unit) == nullptr;
  });
}

/// Whether a material says something of its looks, besides how it shines and that both sides show.
bool isPainted(const Json& material) {
  if (!material.is_object()) return false;
  const auto saysOnly = [](const Json& object, std::initializer_list<std::string_view> names) {
    for (const auto& [name, value] : object.items()) {
      if (std::find(names.begin(), names.end(), name) == names.end()) return false;
    }
    return true;
  };
  const auto shine = material.find("pbrMetallicRoughness");
  return !saysOnly(material, {"name", "doubleSided", "pbrMetallicRoughness", "extras"}) ||
         (shine != material.end() && shine->is_object() &&
          !saysOnly(*shine, {"metallicFactor", "roughnessFactor"}));
}

/// "materials, textures and animations", of those that there are.
std::string besidesGeometry(const Json& document) {
  std::vector<std::string> found;
  const auto listOf = [](const Json& object, const char* name) -> const Json* {
    const auto list = object.is_object() ? object.find(name) : object.end();
    return list == object.end() || !list->is_array() || list->empty() ? nullptr : &*list;
  };
  const Json* materials = listOf(document, "materials");
  if (materials != nullptr && std::any_of(materials->begin(), materials->end(), isPainted)) {
    found.emplace_back("materials");
  }
  for (const char* name : {"textures", "animations", "cameras"}) {
    if (listOf(document, name) != nullptr) found.emplace_back(name);
  }
  if (const auto extensions = document.find("extensions");
      extensions != document.end() && extensions->is_object()) {
    const auto lights = extensions->find("KHR_lights_punctual");
    if (lights != extensions->end() && listOf(*lights, "lights") != nullptr) {
      found.emplace_back("lights");
    }
  }
  std::string text;
  for (std::size_t i = 0; i < found.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < found.size() ? ", " : " and ") + found[i];
  }
  return text;
}

/// The buffers of a document, out of the JSON.
std::vector<GltfBufferSource> takeBuffers(Json& buffers) {
  std::vector<GltfBufferSource> sources;
  for (Json& buffer : buffers) {
    GltfBufferSource source;
    source.byteLength = buffer["byteLength"].get<std::uint64_t>();
    if (const auto uri = buffer.find("uri"); uri != buffer.end()) {
      source.uri = std::move(uri->get_ref<std::string&>());
    }
    sources.push_back(std::move(source));
  }
  return sources;
}

}  // namespace

bool isExtraAttribute(std::string_view name) {
  return name.starts_with("_") || name.starts_with("COLOR_") || name.starts_with("TEXCOORD_");
}

Result<GeometryJson> geometryJson(std::string_view text, std::size_t firstByte,
                                  std::size_t binaryBytes) {
  auto parsed = parseJson(text, firstByte);
  if (!parsed) return parsed.error();
  Json& document = parsed.value();
  if (!document.is_object()) return faultAt("", "is not an object");
  if (auto error = checkVersion(document)) return *error;
  if (auto error = checkExtensions(document)) return *error;

  const JsonPlace root;
  std::optional<Error> fault;
  const JsonFields fields(document, root, fault);
  Json buffers = Json::object();
  copyMembers(fields, kBuffers, buffers);
  GeometryJson result;
  result.geometry = Json::object();
  if (!fault) copyMembers(fields, kDocument, result.geometry);
  if (fault) return *fault;
  result.baseColours = baseColours(document);
  result.isUnitUnknown = statesUnknownUnit(document);
  result.leftOut = besidesGeometry(document);

  if (buffers.contains("buffers")) result.buffers = takeBuffers(buffers["buffers"]);
  if (!result.buffers.empty() && result.buffers[0].uri.empty()) {
    const std::uint64_t bytes = result.buffers[0].byteLength;
    if (bytes <= binaryBytes) result.embeddedBytes = static_cast<std::size_t>(bytes);
  }
  return result;
}

}  // namespace girth::io
