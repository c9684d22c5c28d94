#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "curves.h"
#include "girth/describe/barcode.h"
#include "girth/describe/geodesic_solver.h"
#include "girth/describe/prepare_surface.h"
#include "girth/describe/refined_girth.h"
#include "girth/fields.h"
#include "girth/handles.h"
#include "girth/heat_maxima.h"
#include "girth/io/length_unit.h"
#include "girth/io/load_mesh.h"
#include "girth/io/vertex_field.h"
#include "girth/limbs.h"
#include "girth/path_profile.h"
#include "girth/remesh.h"
#include "girth/smooth_surface.h"
#include "girth/spectrum.h"
#include "girth/subdivide_surface.h"
#include "girth/vertex_areas.h"
#include "points.h"
#include "result_dict.h"
#include "surface.h"
#include "working.h"

namespace py = pybind11;

namespace girth::python {
namespace {

using Shared = std::shared_ptr<Surface>;

PrepareOptions prepareOptionsOf(double weld, bool closeHoles, std::vector<Index> components,
                                double minComponent, double scale) {
  PrepareOptions options;
  options.weldDistance = weld;
  options.closeHoles = closeHoles;
  options.components = std::move(components);
  options.minComponent = minComponent;
  options.scale = scale;
  return options;
}

/// Rows of vertices of an integer array; INDEX_OUT_OF_RANGE where one is no vertex.
std::vector<Index> trianglesOf(const Array<std::int64_t>& faces, std::size_t vertices) {
  const auto numbers = spanOf(faces);
  std::vector<Index> triangles(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] < 0 || static_cast<std::uint64_t>(numbers[i]) >= vertices) {
      const auto face = static_cast<std::int64_t>(i / 3);
      Error error = makeError(ErrorCode::IndexOutOfRange, face,
                              "face " + std::to_string(face) + " names vertex " +
                                  std::to_string(numbers[i]) + " of " + std::to_string(vertices));
      error.hint = "vertices are numbered from 0 to the vertex count minus one";
      throwError(error);
    }
    triangles[i] = static_cast<Index>(numbers[i]);
  }
  return triangles;
}

/// The surface of a model that was read, or of arrays.
Shared surfaceOf(io::ReadModel model, const PrepareOptions& options, const Running& running) {
  // std::function is copied, and the model is not to be.
  const auto shared = std::make_shared<io::ReadModel>(std::move(model));
  auto prepared =
      compute<PreparedSurface>(running, [shared, options](const ExecutionContext& context) {
        return prepareSurface(std::move(shared->soup), options, context);
      });
  return std::make_shared<Surface>(
      io::LoadedMesh{std::move(prepared), shared->format, shared->unit, shared->notes});
}

Shared surfaceOfArrays(const Array<double>& positions, const Array<std::int64_t>& faces,
                       double weld, bool closeHoles, std::vector<Index> components,
                       double minComponent, double scale, std::string unit,
                       const Running& running) {
  const auto numbers = spanOf(positions);
  if (numbers.size() / 3 >= kNoIndex || faces.size() / 3 >= kNoIndex / 3) {
    throwError(makeError(ErrorCode::LimitExceeded, -1, "there are too many faces to number"));
  }
  io::ReadModel model;
  model.soup.positions.assign(numbers.begin(), numbers.end());
  model.soup.triangles = trianglesOf(faces, numbers.size() / 3);
  model.unit = std::move(unit);
  return surfaceOf(std::move(model),
                   prepareOptionsOf(weld, closeHoles, std::move(components), minComponent, scale),
                   running);
}

/// A model's surface, and its vertices and faces as they are in the file. A unit replaces that of
/// the file.
py::tuple surfaceOfFile(const std::string& path, double weld, bool closeHoles,
                        std::vector<Index> components, double minComponent, double scale,
                        const std::string& unit, const Running& running) {
  auto model = compute<io::ReadModel>(
      running, [path](const ExecutionContext&) { return io::loadModel(path); });
  if (!unit.empty()) model.unit = unit;
  std::vector<double> positions = model.soup.positions;
  std::vector<std::int64_t> faces(model.soup.triangles.begin(), model.soup.triangles.end());
  const PrepareOptions options =
      prepareOptionsOf(weld, closeHoles, std::move(components), minComponent, scale);
  Shared surface;
  try {
    surface = surfaceOf(std::move(model), options, running);
  } catch (const ThrownError& thrown) {
    Error error = thrown;
    error.file = path;
    throwError(error);
  }
  const auto vertexCount = static_cast<py::ssize_t>(positions.size() / 3);
  const auto faceCount = static_cast<py::ssize_t>(faces.size() / 3);
  return py::make_tuple(surface, arrayOf(std::move(positions), {vertexCount, 3}),
                        arrayOf(std::move(faces), {faceCount, 3}));
}

py::dict reportOf(const Surface& surface) {
  return dictOf(surface.loaded(), surface.loaded().report);
}

py::tuple arraysOf(const GirthField& field) {
  std::vector<std::uint8_t> kinds;
  kinds.reserve(field.kinds.size());
  for (const LoopKind kind : field.kinds) kinds.push_back(static_cast<std::uint8_t>(kind));
  return py::make_tuple(arrayOf(std::vector<double>(field.values)), arrayOf(std::move(kinds)));
}

py::tuple girthOf(const Shared& surface, const std::string& method, double persistence,
                  const Running& running) {
  if (method == "exact") {
    return arraysOf(*compute<std::shared_ptr<const GirthField>>(
        running, [surface, persistence](const ExecutionContext& context) {
          return surface->girth(persistence, context);
        }));
  }
  return arraysOf(compute<GirthField>(
      running, [surface](const ExecutionContext& context) -> Result<GirthField> {
        GirthField field = girthField(surface->mesh(), GirthMethod::Marched, context);
        if (!field.complete()) return makeError(ErrorCode::Cancelled, -1, "stopped");
        return field;
      }));
}

/// Values, kinds, states and the audit.
py::tuple refinedGirthOf(const Shared& surface, Index audit, std::uint64_t seed,
                         const Running& running) {
  RefinedOptions options;
  options.audit = audit;
  options.seed = seed;
  RefinedGirth refined =
      compute<RefinedGirth>(running, [surface, options](const ExecutionContext& context) {
        return refinedGirth(surface->mesh(), options, context);
      });
  std::vector<std::uint8_t> states;
  states.reserve(refined.states.size());
  for (const GirthState state : refined.states) {
    states.push_back(static_cast<std::uint8_t>(state));
  }
  const py::tuple girth = arraysOf(refined.field);
  return py::make_tuple(girth[0], girth[1], arrayOf(std::move(states)),
                        dictOf(surface->loaded(), refined.audit));
}

using Values = std::vector<double>;

// The kinds of the table of fields: how a parameter is taken from Python.
struct Count {
  /// A number that is no count becomes 0, which the core refuses.
  static void take(const py::object& given, unsigned& parameter) {
    const auto number = given.cast<std::int64_t>();
    parameter = number > 0 && number < std::int64_t{1} << 31 ? static_cast<unsigned>(number) : 0;
  }
};
struct Degrees {
  static void take(const py::object& given, double& parameter) {
    parameter = given.cast<double>() * std::numbers::pi / 180;
  }
};
struct Method {
  static void take(const py::object& given, DistanceMethod& parameter) {
    parameter = given.cast<bool>() ? DistanceMethod::Exact : DistanceMethod::FastMarching;
  }
};
struct Length {
  static void take(const py::object& given, double& parameter) { parameter = given.cast<double>(); }
};
struct Persistence : Length {};
struct Points {
  static void take(const py::object& given, std::vector<SurfacePoint>& parameter) {
    for (const Point& one : given.cast<std::vector<Point>>()) parameter.push_back(pointOf(one));
  }
};

/// (values, method) of a field but a spectral one, with the parameters that are given, by their
/// keywords.
py::tuple fieldOf(const Shared& surface, const std::string& name,
                  const std::map<std::string, py::object>& given, const Running& running) {
  FieldOptions options;
#define GIRTH_FIELD_PARAMETER(keyword, value, fields, kind, member, least, greatest, words) \
  if (given.count(#keyword) > 0) kind::take(given.at(#keyword), options.member);
#include "girth/fields.def"
  const std::string method = io::methodText(name, options);
  // The shape diameter by default is kept, since parts are made of it.
  if (name == "sdf" && given.empty()) {
    const auto kept = compute<std::shared_ptr<const Values>>(
        running, [surface](const ExecutionContext& context) { return surface->diameter(context); });
    return py::make_tuple(arrayOf(Values(*kept)), method);
  }
  auto found =
      compute<FieldValues>(running, [surface, name, options](const ExecutionContext& context) {
        return fieldValues(surface->mesh(), name, options, context);
      });
  return py::make_tuple(arrayOf(std::move(found.values)), method);
}

/// The kinds of the parameters of a field, by their keywords.
py::dict fieldParameters(const std::string& name) {
  py::dict found;
#define GIRTH_FIELD_PARAMETER(keyword, value, fields, kind, member, least, greatest, words) \
  if (std::string(" " fields " ").find(" " + name + " ") != std::string::npos)              \
    found[#keyword] = #kind;
#include "girth/fields.def"
  return found;
}

/// The fields in the order of the table, and what their values are.
py::dict fieldKinds() {
  py::dict kinds;
  for (const FieldInfo& field : fields()) {
    constexpr std::array words{"length", "radian", "per area", ""};
    kinds[py::str(std::string(field.name))] = words[static_cast<std::size_t>(field.unit)];
  }
  return kinds;
}

/// The defaults of options.
py::dict defaults() {
  py::dict values;
  values["audit"] = RefinedOptions{}.audit;
  values["seed"] = RefinedOptions{}.seed;
  values["stations"] = LimbOptions{}.stations;
  values["base_points"] = HandleOptions{}.basePoints;
  values["samples"] = PathProfileOptions{}.samples;
  values["time"] = kHeatMaximaTime;
  return values;
}

/// The symbols of the units of length by their names.
py::dict lengthUnitSymbols() {
  py::dict symbols;
  for (const io::LengthUnit& unit : io::lengthUnits()) {
    symbols[py::str(std::string(unit.name))] = std::string(unit.symbol);
  }
  return symbols;
}

/// A spectral field and its method.
struct SpectralValues {
  VertexSignatures signature;
  std::string method;
};

/// (all numbers of a spectral field's signature, method). `shares`: of hks, times as shares of the
/// area.
py::tuple spectralFieldOf(const Shared& surface, const std::string& name,
                          std::optional<Index> pairs, const std::optional<Values>& shares,
                          const Running& running) {
  auto found = compute<SpectralValues>(
      running, [surface, name, pairs, shares](const ExecutionContext& c) -> Result<SpectralValues> {
        const SpectrumOptions usual;
        const auto spectrum = laplaceSpectrum(surface->mesh(), {pairs.value_or(usual.pairs)}, c);
        if (!spectrum) return spectrum.error();
        const auto& areas = spectrum.value().areas;
        const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
        Values scaled;
        for (const double time : shares.value_or(Values{kHeatMaximaTime}))
          scaled.push_back(time * area);
        auto signature = fieldSignature(spectrum.value(), name, scaled);
        if (!signature) return signature.error();
        const std::string count = std::to_string(spectrum.value().values.size());
        return SpectralValues{std::move(signature).value(), count + " eigenpairs"};
      });
  const auto vertices = static_cast<py::ssize_t>(surface->mesh().vertexCount());
  const auto dimensions = static_cast<py::ssize_t>(found.signature.dimensions);
  return py::make_tuple(arrayOf(std::move(found.signature.values), {vertices, dimensions}),
                        found.method);
}

py::dict loopAt(const Shared& surface, const Point& at, double persistence,
                const Running& running) {
  const SurfacePoint point = pointOf(at);
  const auto loop =
      compute<GirthLoop>(running, [surface, point, persistence](const ExecutionContext& context) {
        return surface->loop(point, persistence, context);
      });
  return dictOf(surface->loaded(), loop);
}

py::dict barcodeAt(const Shared& surface, const Point& at, double maxPersistence,
                   std::size_t maxSaddles, bool loops, const Running& running) {
  const SurfacePoint point = pointOf(at);
  const BarcodeOptions options{maxPersistence, maxSaddles, loops};
  const auto barcode =
      compute<Barcode>(running, [surface, point, options](const ExecutionContext& context) {
        return surface->barcode(point, options, context);
      });
  return dictOf(surface->loaded(), barcode);
}

Array<double> distancesFrom(const Shared& surface, const std::vector<Point>& from, double radius,
                            const Running& running) {
  std::vector<SurfacePoint> sources;
  for (const Point& at : from) sources.push_back(pointOf(at));
  return arrayOf(
      compute<Values>(running, [surface, sources, radius](const ExecutionContext& context) {
        return surface->distances(sources, radius, context);
      }));
}

py::dict pathBetween(const Shared& surface, const Point& from, const Point& to,
                     const Running& running) {
  const SurfacePoint start = pointOf(from);
  const SurfacePoint end = pointOf(to);
  const auto path =
      compute<GeodesicPath>(running, [surface, start, end](const ExecutionContext& context) {
        return surface->path(start, end, context);
      });
  return dictOf(surface->loaded(), path);
}

/// Vertices and faces of another mesh of the surface.
py::tuple remeshed(const Shared& surface, std::int64_t faces, bool even, const Running& running) {
  RemeshOptions options;
  options.faces = faces >= 0 && faces < std::int64_t{kNoIndex} ? static_cast<Index>(faces) : 0;
  options.method = even ? RemeshMethod::Even : RemeshMethod::Fitting;
  const auto result =
      compute<RemeshedSurface>(running, [surface, options](const ExecutionContext& context) {
        return remesh(surface->mesh(), options, context);
      });
  return py::make_tuple(positionArray(result.mesh), triangleArray(result.mesh));
}

/// Vertices and faces of the surface with its vertices moved.
py::tuple smoothed(const Shared& surface, std::int64_t steps, const Running& running) {
  const bool isIndex = steps >= 0 && steps < std::int64_t{kNoIndex};
  const Index wanted = isIndex ? static_cast<Index>(steps) : kNoIndex;
  const auto smooth =
      compute<SurfaceMesh>(running, [surface, wanted](const ExecutionContext& context) {
        return smoothSurface(surface->mesh(), wanted, context);
      });
  return py::make_tuple(positionArray(smooth), triangleArray(smooth));
}

/// Vertices and faces of the surface with its longest edges cut in two.
py::tuple subdivided(const Shared& surface, std::int64_t faces, const Running& running) {
  const Index wanted =
      static_cast<Index>(std::clamp<std::int64_t>(faces, 0, std::int64_t{kNoIndex} - 1));
  const auto fine =
      compute<PreparedSurface>(running, [surface, wanted](const ExecutionContext& context) {
        return subdivideSurface(PreparedSurface(surface->loaded()), wanted, context);
      });
  return py::make_tuple(positionArray(fine.mesh), triangleArray(fine.mesh));
}

}  // namespace

void bindSurface(py::module_& module) {
  py::class_<Running>(module, "Running")
      .def(py::init([](unsigned threads, py::object progress) {
             return Running{threads, std::move(progress)};
           }),
           py::arg("threads"), py::arg("progress"))
      .def_readonly("progress", &Running::progress);
  module.def("load", &surfaceOfFile);
  module.def("defaults", &defaults);
  module.def("fields", &fieldKinds);
  module.def("is_spectral", [](const std::string& name) { return findField(name)->isSpectral; });
  module.def("field_parameters", &fieldParameters);
  module.def("length_unit_symbols", &lengthUnitSymbols);
  module.def("unit_of_field", [](const std::string& name, const std::string& length) {
    return unitText(findField(name)->unit, length);
  });
  py::class_<Surface, Shared>(module, "Surface")
      .def(py::init(&surfaceOfArrays))
      .def_property_readonly("unit", [](const Surface& s) { return s.loaded().unit; })
      .def_property_readonly("notes", [](const Surface& s) { return s.loaded().notes; })
      .def_property_readonly("vertex_count",
                             [](const Surface& s) { return s.mesh().vertexCount(); })
      .def_property_readonly("face_count", [](const Surface& s) { return s.mesh().faceCount(); })
      .def_property_readonly("area", [](const Surface& s) { return s.mesh().area(); })
      .def("report", &reportOf)
      .def("vertex_of_input",
           [](const Surface& s) { return numberArray(s.loaded().vertexOfInput); })
      .def("input_of_vertex",
           [](const Surface& s) { return numberArray(s.loaded().inputOfVertex); })
      .def("input_of_face", [](const Surface& s) { return numberArray(s.loaded().inputOfFace); })
      .def("positions", [](const Surface& s) { return positionArray(s.mesh()); })
      .def("triangles", [](const Surface& s) { return triangleArray(s.mesh()); })
      .def("boundary", [](const Surface& s) { return boundaryArray(s.mesh()); })
      .def("areas", [](const Surface& s) { return arrayOf(vertexAreas(s.mesh())); })
      .def("girth", &girthOf)
      .def("refined_girth", &refinedGirthOf)
      .def("field", &fieldOf)
      .def("spectral_field", &spectralFieldOf)
      .def("loop", &loopAt)
      .def("barcode", &barcodeAt)
      .def("distances", &distancesFrom)
      .def("path", &pathBetween)
      .def("remesh", &remeshed)
      .def("subdivide", &subdivided)
      .def("smooth", &smoothed);
}

}  // namespace girth::python
