#include "gltf/document.h"

#include <limits>
#include <utility>

#include "gltf/json_fields.h"
#include "gltf/json_nesting.h"
#include "text/quoted_name.h"

namespace girth::io {
namespace {

using Json = nlohmann::json;

// No document needs more; a recursive parser survives this.
constexpr std::size_t kDeepest = 64;

// What a double holds exactly, and far more than any file.
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

/// A document, while it is taken apart.
class Parser {
 public:
  explicit Parser(const Json& document) : fields_(document, root_, fault_) {}

  Result<GltfDocument> run() {
    readList("buffers", document_.buffers,
             [this](const JsonFields& fields) { return buffer(fields); });
    readList("bufferViews", document_.bufferViews,
             [this](const JsonFields& fields) { return bufferView(fields); });
    readList("accessors", document_.accessors,
             [this](const JsonFields& fields) { return accessor(fields); });
    readList("meshes", document_.meshes, [this](const JsonFields& fields) { return mesh(fields); });
    readList("nodes", document_.nodes, [this](const JsonFields& fields) { return node(fields); });
    readList("skins", document_.skins, [](const JsonFields& fields) {
      return GltfSkin{fields.text("name"), fields.references("joints"),
                      fields.reference("inverseBindMatrices")};
    });
    readList("scenes", document_.scenes, [](const JsonFields& fields) {
      return GltfScene{fields.text("name"), fields.references("nodes")};
    });
    document_.scene = fields_.reference("scene");
    if (fault_) return *fault_;
    return std::move(document_);
  }

 private:
  template <class Element, class Read>
  void readList(const char* name, std::vector<Element>& list, const Read& read) {
    forEachElement(fields_, name, [&](const Json& element, const JsonPlace& place) {
      list.push_back(read(JsonFields(element, place, fault_)));
    });
  }

  /// Calls `read` with the members of the object of that name, if there is one.
  template <class Read>
  void within(const JsonFields& fields, const char* name, const Read& read) {
    const Json* member = fields.find(name);
    if (member == nullptr) return;
    const JsonPlace place(fields.place(), name);
    read(JsonFields(*member, place, fault_));
  }

  template <class Read>
  void withinExtension(const JsonFields& fields, const char* name, const Read& read) {
    // An "extensions" that is no object holds none; whatever it is, it is not geometry.
    if (const Json* all = fields.find("extensions"); all == nullptr || !all->is_object()) return;
    within(fields, "extensions",
           [&](const JsonFields& extensions) { within(extensions, name, read); });
  }

  GltfBuffer buffer(const JsonFields& fields) {
    return {fields.text("uri"), fields.requiredInteger("byteLength", kMostBytes)};
  }

  GltfBufferView bufferView(const JsonFields& fields) {
    GltfBufferView view;
    view.buffer = fields.requiredReference("buffer");
    view.byteOffset = fields.integer("byteOffset", kMostBytes).value_or(0);
    view.byteLength = fields.requiredInteger("byteLength", kMostBytes);
    view.byteStride = fields.integer("byteStride", kMostBytes).value_or(0);
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
      withinExtension(fields, name,
                      [&](const JsonFields& extension) { view.packed = meshopt(extension, name); });
    }
    return view;
  }

  GltfMeshopt meshopt(const JsonFields& fields, const char* extension) {
    GltfMeshopt packed;
    packed.extension = extension;
    packed.buffer = fields.requiredReference("buffer");
    packed.byteOffset = fields.integer("byteOffset", kMostBytes).value_or(0);
    packed.byteLength = fields.requiredInteger("byteLength", kMostBytes);
    packed.byteStride = fields.requiredInteger("byteStride", kMostBytes);
    packed.count = fields.requiredInteger("count", kMostBytes);
    using Mode = GltfMeshopt::Mode;
    using Filter = GltfMeshopt::Filter;
    packed.mode = choice<Mode, 3>(fields, "mode",
                                  {{{"ATTRIBUTES", Mode::Attributes},
                                    {"TRIANGLES", Mode::Triangles},
                                    {"INDICES", Mode::Indices}}});
    if (fields.find("filter") == nullptr) return packed;
    packed.filter = choice<Filter, 5>(fields, "filter",
                                      {{{"NONE", Filter::None},
                                        {"OCTAHEDRAL", Filter::Octahedral},
                                        {"QUATERNION", Filter::Quaternion},
                                        {"EXPONENTIAL", Filter::Exponential},
                                        {"COLOR", Filter::Color}}});
    return packed;
  }

  /// One of a few words.
  template <class Value, std::size_t kCount>
  Value choice(const JsonFields& fields, const char* name,
               const std::array<std::pair<std::string_view, Value>, kCount>& choices) {
    const std::string found = fields.text(name);
    for (const auto& [word, value] : choices) {
      if (found == word) return value;
    }
    fields.report(found.empty() ? "is missing" : "is unknown: " + inQuotes(found), name);
    return choices[0].second;
  }

  GltfComponent component(const JsonFields& fields) {
    constexpr std::uint64_t kFirst = 5120, kFloat = 5126, kDouble = 5130;
    const std::uint64_t type = fields.requiredInteger("componentType", kMostBytes);
    if (type < kFirst || (type > kFloat && type != kDouble)) {
      fields.report("is unknown: " + std::to_string(type), "componentType");
      return GltfComponent::Float;
    }
    return static_cast<GltfComponent>(type);
  }

  GltfAccessor accessor(const JsonFields& fields) {
    GltfAccessor accessor;
    accessor.bufferView = fields.reference("bufferView");
    accessor.byteOffset = fields.integer("byteOffset", kMostBytes).value_or(0);
    accessor.count = fields.requiredInteger("count", kMostBytes);
    accessor.component = component(fields);
    using Shape = GltfShape;
    accessor.shape = choice<Shape, 7>(fields, "type",
                                      {{{"SCALAR", Shape::Scalar},
                                        {"VEC2", Shape::Vec2},
                                        {"VEC3", Shape::Vec3},
                                        {"VEC4", Shape::Vec4},
                                        {"MAT2", Shape::Mat2},
                                        {"MAT3", Shape::Mat3},
                                        {"MAT4", Shape::Mat4}}});
    accessor.normalized = fields.flag("normalized");
    within(fields, "sparse",
           [&](const JsonFields& sparse) { accessor.sparse = sparsePart(sparse); });
    return accessor;
  }

  GltfSparse sparsePart(const JsonFields& fields) {
    GltfSparse sparse;
    sparse.count = fields.requiredInteger("count", kMostBytes);
    for (const char* name : {"indices", "values"}) {
      if (fields.find(name) == nullptr) fields.report("has no " + inQuotes(name));
    }
    within(fields, "indices", [&](const JsonFields& indices) {
      sparse.indicesView = indices.requiredReference("bufferView");
      sparse.indicesOffset = indices.integer("byteOffset", kMostBytes).value_or(0);
      sparse.indicesComponent = component(indices);
    });
    within(fields, "values", [&](const JsonFields& values) {
      sparse.valuesView = values.requiredReference("bufferView");
      sparse.valuesOffset = values.integer("byteOffset", kMostBytes).value_or(0);
    });
    return sparse;
  }

  /// PREFIX_0, PREFIX_1, ...
  std::vector<GltfReference> sets(const JsonFields& attributes, const std::string& prefix) {
    std::vector<GltfReference> found;
    for (std::size_t set = 0; set < kMostJointSets; ++set) {
      const std::string name = prefix + std::to_string(set);
      const auto reference = attributes.reference(name.c_str());
      if (!reference) continue;
      found.resize(set + 1);
      found[set] = reference;
    }
    return found;
  }

  GltfMesh mesh(const JsonFields& fields) {
    GltfMesh mesh;
    mesh.name = fields.text("name");
    mesh.weights = fields.numbers("weights", 0);
    if (fields.find("primitives") == nullptr) fields.report("has no \"primitives\"");
    forEachElement(fields, "primitives", [&](const Json& element, const JsonPlace& place) {
      mesh.primitives.push_back(primitive(JsonFields(element, place, fault_)));
    });
    return mesh;
  }

  GltfPrimitive primitive(const JsonFields& fields) {
    GltfPrimitive primitive;
    constexpr std::uint64_t kLastMode = 6;
    const std::uint64_t mode = fields.integer("mode", kMostBytes).value_or(4);
    if (mode > kLastMode) {
      fields.report("is unknown: " + std::to_string(mode), "mode");
      return primitive;
    }
    primitive.mode = static_cast<GltfMode>(mode);
    primitive.indices = fields.reference("indices");
    if (fields.find("attributes") == nullptr) fields.report("has no \"attributes\"");
    within(fields, "attributes", [&](const JsonFields& attributes) {
      primitive.position = attributes.reference("POSITION");
      primitive.joints = sets(attributes, "JOINTS_");
      primitive.weights = sets(attributes, "WEIGHTS_");
      const std::size_t most = std::max(primitive.joints.size(), primitive.weights.size());
      primitive.joints.resize(most);
      primitive.weights.resize(most);
    });
    forEachElement(fields, "targets", [&](const Json& element, const JsonPlace& place) {
      primitive.targets.push_back(JsonFields(element, place, fault_).reference("POSITION"));
    });
    withinExtension(fields, "KHR_draco_mesh_compression", [&](const JsonFields& extension) {
      GltfDraco draco;
      draco.bufferView = extension.requiredReference("bufferView");
      within(extension, "attributes", [&](const JsonFields& attributes) {
        draco.position = attributes.reference("POSITION");
        draco.joints = sets(attributes, "JOINTS_");
        draco.weights = sets(attributes, "WEIGHTS_");
      });
      draco.joints.resize(primitive.joints.size());
      draco.weights.resize(primitive.weights.size());
      primitive.draco = std::move(draco);
    });
    return primitive;
  }

  GltfNode node(const JsonFields& fields) {
    GltfNode node;
    node.name = fields.text("name");
    node.children = fields.references("children");
    node.mesh = fields.reference("mesh");
    node.skin = fields.reference("skin");
    node.matrix = fields.numbers("matrix", 16);
    node.translation = fields.numbers("translation", 3);
    node.rotation = fields.numbers("rotation", 4);
    node.scale = fields.numbers("scale", 3);
    node.weights = fields.numbers("weights", 0);
    withinExtension(fields, "EXT_mesh_gpu_instancing", [&](const JsonFields& extension) {
      within(extension, "attributes", [&](const JsonFields& attributes) {
        node.instancing =
            GltfInstancing{attributes.reference("TRANSLATION"), attributes.reference("ROTATION"),
                           attributes.reference("SCALE")};
      });
    });
    withinExtension(fields, "KHR_node_visibility", [&](const JsonFields& extension) {
      node.hidden = extension.find("visible") != nullptr && !extension.flag("visible");
    });
    return node;
  }

  JsonPlace root_;
  std::optional<Error> fault_;
  JsonFields fields_;
  GltfDocument document_;
};

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

}  // namespace

std::size_t bytesOf(GltfComponent component) {
  switch (component) {
    case GltfComponent::Byte:
    case GltfComponent::UnsignedByte:
      return 1;
    case GltfComponent::Short:
    case GltfComponent::UnsignedShort:
      return 2;
    case GltfComponent::Int:
    case GltfComponent::UnsignedInt:
    case GltfComponent::Float:
      return 4;
    case GltfComponent::Double:
      break;
  }
  return 8;
}

std::string_view toString(GltfShape shape) {
  constexpr std::array<std::string_view, 7> kNames{"SCALAR", "VEC2", "VEC3", "VEC4",
                                                   "MAT2",   "MAT3", "MAT4"};
  return kNames[static_cast<std::size_t>(shape)];
}

Result<GltfDocument> parseGltfDocument(std::string_view text, std::size_t firstByte) {
  auto parsed = parseJson(text, firstByte);
  if (!parsed) return parsed.error();
  const Json& document = parsed.value();
  if (!document.is_object()) return faultAt("", "is not an object");
  if (auto error = checkVersion(document)) return *error;
  if (auto error = checkExtensions(document)) return *error;
  return Parser(document).run();
}

}  // namespace girth::io
