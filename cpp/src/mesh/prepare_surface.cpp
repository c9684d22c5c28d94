#include "girth/prepare_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "mesh/coordinates.h"
#include "mesh/prepare/bodies.h"
#include "mesh/prepare/close_holes.h"
#include "mesh/prepare/cracks.h"
#include "mesh/prepare/drop_faces.h"
#include "mesh/prepare/file_connectivity.h"
#include "mesh/prepare/join_faces.h"
#include "mesh/prepare/roots.h"
#include "mesh/prepare/split_vertices.h"
#include "mesh/prepare/weld_vertices.h"
#include "mesh/sides.h"
#include "mesh/vector.h"

namespace girth {

namespace {

using prepare::WorkingFaces;

/// Components of a smaller share of the largest one's area are slivers.
constexpr double kSliver = 1e-6;

/// The volume that a component holds inside, as its faces are added: at a scale near 1.
struct Inside {
  explicit Inside(const Vec3& somewhere) : origin(somewhere) {}

  void add(const WorkingFaces& faces, Index face) {
    std::array<Vec3, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = faces.scaledPosition(faces.triangles[3 * std::size_t{face} + k]) - origin;
      radius = std::max(radius, norm(corner[k]));
    }
    sixfoldVolume += dot(corner[0], cross(corner[1], corner[2]));
  }

  /// Whether two sheets lie on each other.
  bool isNothing(double area) const {
    constexpr double kThinnest = 1e-6;
    return !isOpen && std::fabs(sixfoldVolume) / 3 < kThinnest * area * radius;
  }

  Vec3 origin;
  double sixfoldVolume{0};
  double radius{0};
  bool isOpen{false};
};

std::string countText(std::size_t count, const char* one, const char* many) {
  return count == 1 ? std::string("the only ") + one : "all " + std::to_string(count) + " " + many;
}

/// The first face with a vertex that lies nowhere, or too far away. Vertices without a face may lie
/// anywhere.
std::optional<Error> findBadCoordinate(const TriangleSoup& soup, double scale) {
  const auto isNear = [&](double coordinate) {
    return std::fabs(coordinate) <= kGreatestCoordinate &&
           std::fabs(scale * coordinate) <= kGreatestCoordinate;
  };
  if (std::all_of(soup.positions.begin(), soup.positions.end(), isNear)) return std::nullopt;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const std::size_t vertex = soup.triangles[i];
    const auto coordinates = std::span(soup.positions).subspan(3 * vertex, 3);
    if (std::all_of(coordinates.begin(), coordinates.end(), isNear)) continue;
    auto error = badCoordinateOf(vertex, soup.positions, " of face " + std::to_string(i / 3));
    if (error) return error;
    return makeError(ErrorCode::InvalidOption, -1, "the scale makes the model too large");
  }
  return std::nullopt;
}

/// The first fault of the arrays and the options alone.
std::optional<Error> findBadElement(const TriangleSoup& soup, const PrepareOptions& options) {
  const std::size_t vertices = soup.positions.size() / 3;
  if (!(options.scale > 0) || std::isinf(options.scale)) {
    return makeError(ErrorCode::InvalidOption, -1, "the scale is no number above 0");
  }
  if (!(options.weldDistance >= 0) || std::isinf(options.weldDistance)) {
    return makeError(ErrorCode::InvalidOption, -1,
                     "the distance to weld within is no number of at least 0");
  }
  if (!(options.minComponent >= 0 && options.minComponent <= 1)) {
    return makeError(ErrorCode::InvalidOption, -1,
                     "the share of the largest component is no number from 0 to 1");
  }
  if (soup.positions.size() % 3 != 0 || soup.triangles.size() % 3 != 0) {
    return makeError(ErrorCode::EmptyMesh, -1, "the arrays are not whole triples");
  }
  if (soup.triangles.empty()) {
    return makeError(ErrorCode::EmptyMesh, -1, "the model has no triangles");
  }
  // Halfedge numbers and a flag bit must fit into an Index.
  if (soup.triangles.size() >= 0x7FFFFFFFu || vertices >= 0x7FFFFFFFu) {
    return makeError(ErrorCode::LimitExceeded, -1, "the model has over 700 million triangles");
  }
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    if (soup.triangles[i] >= vertices) {
      return makeError(ErrorCode::IndexOutOfRange, static_cast<std::int64_t>(i / 3),
                       "face " + std::to_string(i / 3) + " names vertex " +
                           std::to_string(soup.triangles[i]) + " of " + std::to_string(vertices));
    }
  }
  return findBadCoordinate(soup, options.scale);
}

/// The steps from a soup to a surface; each leaves its work in the members.
class Preparation {
 public:
  Preparation(TriangleSoup soup, const PrepareOptions& options, const ExecutionContext& context)
      : soup_(std::move(soup)), options_(options), context_(context) {}

  Result<PreparedSurface> run() {
    if (auto error = findBadElement(soup_, options_)) return *error;
    report_.inputVertices = static_cast<Index>(soup_.positions.size() / 3);
    report_.inputFaces = static_cast<Index>(soup_.triangles.size() / 3);
    using Step = std::optional<Error> (Preparation::*)();
    struct TimedStep {
      Step step;
      double finished;  ///< the share of the whole time by its end
    };
    constexpr TimedStep kSteps[] = {{&Preparation::findPlaces, 0.2},
                                    {&Preparation::connect, 0.65},
                                    {&Preparation::chooseParts, 0.8},
                                    {&Preparation::finish, 1.0}};
    for (const TimedStep& timed : kSteps) {
      if (context_.cancelled()) return makeError(ErrorCode::Cancelled, -1, "cancelled");
      if (auto error = (this->*timed.step)()) return *error;
      if (context_.onProgress) context_.onProgress(timed.finished);
    }
    return PreparedSurface{std::move(*mesh_),
                           std::move(vertexOfInput_),
                           std::move(split_.inputOfVertex),
                           std::move(faces_.inputOfFace),
                           std::move(parts_),
                           std::move(report_)};
  }

 private:
  /// Which vertices share a place, and whether that matters.
  std::optional<Error> findPlaces() {
    for (double& coordinate : soup_.positions) coordinate *= options_.scale;
    first_ = prepare::firstAtSamePlace(soup_.positions, soup_.triangles);
    double extent = 0;
    std::size_t used = 0, places = 0;
    for (Index v = 0; v < first_.size(); ++v) {
      if (first_[v] == kNoIndex) continue;
      ++used;
      if (first_[v] == v) ++places;
      for (std::size_t k = 0; k < 3; ++k) {
        extent = std::max(extent, std::fabs(soup_.positions[3 * std::size_t{v} + k]));
      }
    }
    isOfFacets_ = used == soup_.triangles.size();
    faces_.scale = scaleFor(extent);
    faces_.positions = soup_.positions;
    if (options_.weldDistance > 0) {
      prepare::joinWithin(options_.weldDistance, soup_.positions, first_);
    } else if (places < used && !isOfFacets_) {
      // Corners that are all vertices of their own close nothing.
      faces_.place = first_;
      faces_.closedByFile = prepare::closedByTheFile(soup_.triangles, faces_.place);
    }
    return std::nullopt;
  }

  /// From the input's triangles to oriented faces that know their neighbours.
  std::optional<Error> connect() {
    constexpr int kMostRounds = 8;
    const PreparationReport before = report_;
    int round = 0;
    for (bool again = true; again;) {
      if (++round == kMostRounds) faces_.closedByFile.assign(faces_.closedByFile.size(), false);
      if (context_.cancelled()) return makeError(ErrorCode::Cancelled, -1, "cancelled");
      report_ = before;
      weld();
      if (auto error = dropFaces()) return error;
      again = join();
    }
    return std::nullopt;
  }

  void weld() {
    faces_.triangles = soup_.triangles;
    if (!faces_.place.empty()) {
      // Each vertex that is not closed stands for the first such at its place.
      std::vector<Index> firstOpen(first_.size(), kNoIndex);
      for (Index v = 0; v < first_.size(); ++v) {
        first_[v] = faces_.place[v] == kNoIndex ? kNoIndex : ownOf(v);
        if (first_[v] == kNoIndex || faces_.closedByFile[first_[v]]) continue;
        Index& first = firstOpen[faces_.place[v]];
        if (first == kNoIndex) first = first_[v];
        first_[v] = first;
      }
    }
    faces_.inputOfFace.resize(report_.inputFaces);
    for (Index f = 0; f < report_.inputFaces; ++f) faces_.inputOfFace[f] = f;
    for (Index v = 0; v < first_.size(); ++v) {
      if (first_[v] != kNoIndex && first_[v] != v) ++report_.weldedVertices;
    }
    for (Index& v : faces_.triangles) v = first_[v];
  }

  std::optional<Error> dropFaces() {
    prepare::dropCollapsedFaces(faces_, first_, report_);
    prepare::sewCracks(faces_, first_, options_, report_);
    do {
      prepare::dropDuplicateFaces(faces_, report_);
    } while (prepare::dropFlatFaces(faces_, report_));
    if (faces_.faceCount() > 0) return std::nullopt;
    return makeError(ErrorCode::EmptyMesh, -1,
                     countText(report_.inputFaces, "face has no area", "faces have no area"));
  }

  /// Returns whether all has to be done again: bodies lie on one another, or fewer vertices are
  /// closed than was thought.
  bool join() {
    prepare::JoinedFaces joined = prepare::joinFaces(faces_, report_);
    findInputOfCorners();
    split_ = prepare::splitVertices(faces_, joined, inputOfCorner_, report_);
    if (separateBodies(joined) || openWhatIsNotClosed()) return true;
    soup_.triangles = {};
    report_.unreferencedVertices =
        static_cast<Index>(first_.size()) - report_.weldedVertices -
        (static_cast<Index>(split_.inputOfVertex.size()) - report_.addedVertices);
    report_.addedVertices += static_cast<Index>(copied_.size());
    findParts(joined);
    // From here on the faces name the surface's vertices.
    faces_.triangles = std::move(split_.vertexOfCorner);
    return false;
  }

  /// Whether edges of more than two faces stay open, and a file lists bodies one after the other
  /// that lie on one another. From then on each body has vertices of its own.
  bool separateBodies(const prepare::JoinedFaces& joined) {
    if (areBodiesKnown_ || options_.weldDistance > 0) return false;
    areBodiesKnown_ = true;
    if (std::none_of(joined.cut.begin(), joined.cut.end(),
                     [&](Index h) { return joined.twin[h] == kNoIndex; })) {
      return false;
    }
    std::vector<Index> place = prepare::firstAtSamePlace(soup_.positions, soup_.triangles);
    prepare::Bodies bodies = prepare::separateBodies(soup_.triangles, place);
    if (bodies.first.empty()) return false;
    own_ = std::move(bodies.first);
    copied_ = std::move(bodies.copied);
    for (const Index v : copied_) {
      for (std::size_t k = 0; k < 3; ++k) {
        soup_.positions.push_back(soup_.positions[3 * std::size_t{v} + k]);
      }
    }
    faces_.positions = soup_.positions;
    first_.resize(place.size());
    faces_.place = std::move(place);
    std::vector<Index> triangles = soup_.triangles;
    for (Index& v : triangles) v = own_[v];
    faces_.closedByFile = prepare::closedByTheFile(triangles, faces_.place);
    return true;
  }

  /// The vertex that stands for a vertex of the input within its body.
  Index ownOf(Index vertex) const { return own_.empty() ? vertex : own_[vertex]; }

  /// The vertex of the input that a vertex is, or copies.
  Index inputOf(Index vertex) const {
    return vertex < report_.inputVertices ? vertex : copied_[vertex - report_.inputVertices];
  }

  /// Where vertices at one place may differ: the vertex of the input at each corner.
  void findInputOfCorners() {
    if (faces_.place.empty()) return;
    inputOfCorner_ = faces_.triangles;
    for (std::size_t corner = 0; corner < inputOfCorner_.size(); ++corner) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Index input = soup_.triangles[3 * std::size_t{faces_.inputOfFace[corner / 3]} + k];
        if (prepare::rootOf(first_, input) != faces_.triangles[corner]) continue;
        inputOfCorner_[corner] = input;
        break;
      }
    }
  }

  /// Whether vertices were taken as closed that the surface's own faces do not close; they no
  /// longer are.
  bool openWhatIsNotClosed() {
    if (faces_.place.empty()) return false;
    const std::size_t copies = split_.inputOfVertex.size();
    std::vector<Index> firstAt(first_.size(), kNoIndex), place(copies);
    for (Index v = 0; v < copies; ++v) {
      Index& first = firstAt[faces_.place[split_.inputOfVertex[v]]];
      if (first == kNoIndex) first = v;
      place[v] = first;
    }
    const std::vector<bool> closed = prepare::closedByTheFile(split_.vertexOfCorner, place);
    bool opened = false;
    for (std::size_t corner = 0; corner < inputOfCorner_.size(); ++corner) {
      const Index own = ownOf(inputOfCorner_[corner]);
      if (closed[split_.vertexOfCorner[corner]]) continue;
      opened = opened || faces_.closedByFile[own];
      faces_.closedByFile[own] = false;
    }
    return opened;
  }

  /// Floods the components, in the order of their first faces.
  void findParts(const prepare::JoinedFaces& joined) {
    partOfFace_.assign(faces_.faceCount(), kNoIndex);
    std::vector<Index> front;
    for (Index seed = 0; seed < faces_.faceCount(); ++seed) {
      if (partOfFace_[seed] != kNoIndex) continue;
      const auto number = static_cast<Index>(parts_.size());
      SurfacePart part;
      part.firstFace = kNoIndex;
      Inside inside(faces_.scaledPosition(faces_.triangles[3 * std::size_t{seed}]));
      front.assign(1, seed);
      partOfFace_[seed] = number;
      while (!front.empty()) {
        const Index f = front.back();
        front.pop_back();
        ++part.faces;
        part.area += faces_.shape(f).doubleArea / 2;
        inside.add(faces_, f);
        part.firstFace = std::min(part.firstFace, faces_.inputOfFace[f]);
        for (Index h = 3 * f; h < 3 * f + 3; ++h) {
          if (joined.twin[h] == kNoIndex) {
            inside.isOpen = true;
            continue;
          }
          const Index g = joined.twin[h] / 3;
          if (partOfFace_[g] != kNoIndex) continue;
          partOfFace_[g] = number;
          front.push_back(g);
        }
      }
      if (inside.isNothing(part.area)) ++report_.doubledComponents;
      part.area = part.area / faces_.scale / faces_.scale;
      parts_.push_back(part);
    }
    report_.components = static_cast<Index>(parts_.size());
    const double largest = largestArea();
    for (const SurfacePart& part : parts_) {
      report_.sliverComponents += part.area < kSliver * largest ? 1 : 0;
    }
  }

  double largestArea() const {
    double largest = 0;
    for (const SurfacePart& part : parts_) largest = std::max(largest, part.area);
    return largest;
  }

  std::optional<Error> chooseParts() {
    std::vector<bool> chosen(parts_.size(), options_.components.empty());
    for (const Index part : options_.components) {
      if (part >= parts_.size()) {
        Error error = makeError(ErrorCode::ComponentOutOfRange, part,
                                "there is no component " + std::to_string(part));
        error.hint = "they are numbered from 0 to " + std::to_string(parts_.size() - 1);
        return error;
      }
      chosen[part] = true;
    }
    const double least = options_.minComponent * largestArea();
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      if (parts_[part].area < least) chosen[part] = false;
    }
    report_.keptComponents = static_cast<Index>(std::count(chosen.begin(), chosen.end(), true));
    if (report_.keptComponents == 0) {
      return makeError(ErrorCode::EmptyMesh, -1,
                       "the components that were chosen are smaller than those that are kept");
    }
    if (report_.keptComponents < parts_.size()) {
      const auto isKept = [&](Index f) { return bool(chosen[partOfFace_[f]]); };
      std::size_t kept = 0;
      for (std::size_t corner = 0; corner < inputOfCorner_.size(); ++corner) {
        if (isKept(static_cast<Index>(corner / 3))) inputOfCorner_[kept++] = inputOfCorner_[corner];
      }
      inputOfCorner_.resize(kept);
      faces_.filter(isKept);
    }
    partOfFace_ = {};
    numberVertices();
    return std::nullopt;
  }

  /// Leaves out the vertices of faces that are gone, and finds the way from the input.
  void numberVertices() {
    const std::size_t copies = split_.inputOfVertex.size();
    std::vector<Index> facesOfVertex(copies, 0);
    for (const Index v : faces_.triangles) ++facesOfVertex[v];
    std::vector<Index> number(copies, kNoIndex);
    std::vector<Index> kept;
    for (Index v = 0; v < copies; ++v) {
      if (facesOfVertex[v] == 0) continue;
      number[v] = static_cast<Index>(kept.size());
      kept.push_back(inputOf(split_.inputOfVertex[v]));
    }
    // For each vertex of the input its copy: one that stands for it, that with the most faces, the
    // first.
    std::vector<Index> copyOfInput(report_.inputVertices, kNoIndex);
    const auto rootOfInput = [&](Index v) { return inputOf(prepare::rootOf(first_, v)); };
    const auto consider = [&](Index input, Index v) {
      const auto rank = [&](Index copy) {
        return std::tuple(inputOf(split_.inputOfVertex[copy]) != input, ~facesOfVertex[copy], copy);
      };
      Index& copy = copyOfInput[input];
      if (copy == kNoIndex || rank(v) < rank(copy)) copy = v;
    };
    for (std::size_t corner = 0; corner < inputOfCorner_.size(); ++corner) {
      consider(inputOf(inputOfCorner_[corner]), faces_.triangles[corner]);
    }
    std::vector<Index> own = copyOfInput;
    for (Index v = 0; v < copies; ++v) {
      if (facesOfVertex[v] > 0) consider(rootOfInput(split_.inputOfVertex[v]), v);
    }
    vertexOfInput_.assign(report_.inputVertices, Vertex::none);
    for (Index input = 0; input < report_.inputVertices; ++input) {
      if (first_[input] == kNoIndex) continue;
      Index copy = own[input];
      if (copy == kNoIndex) copy = copyOfInput[rootOfInput(input)];
      if (copy != kNoIndex) vertexOfInput_[input] = Vertex(number[copy]);
    }
    inputOfCorner_ = {};
    for (Index& v : faces_.triangles) v = number[v];
    split_.inputOfVertex = std::move(kept);
  }

  std::optional<Error> finish() {
    // Positions of the surface's vertices take the place of the input's.
    std::vector<double> positions;
    positions.reserve(3 * split_.inputOfVertex.size());
    for (const Index input : split_.inputOfVertex) {
      const auto at = soup_.positions.begin() + 3 * static_cast<std::ptrdiff_t>(input);
      positions.insert(positions.end(), at, at + 3);
    }
    soup_.positions = {};
    auto mesh = SurfaceMesh::fromArrays(positions, faces_.triangles, OpenEdges::Boundary);
    if (!mesh) return mesh.error();
    mesh_.emplace(std::move(mesh).value());
    if (options_.closeHoles) {
      if (auto error = closeHoles(positions)) return error;
    }
    for (Index c = 0; c < mesh_->componentCount(); ++c) {
      report_.boundaryCurves += mesh_->boundaryCount(c);
    }
    for (Index h = 0; h < mesh_->halfedgeCount(); ++h) {
      if (mesh_->twin(Halfedge(h)) == kNoIndex) ++report_.boundaryEdges;
    }
    if (report_.boundaryEdges > 0) {
      const prepare::Cracks cracks =
          prepare::findCracks(positions, faces_.triangles, faces_.scale, 0);
      report_.crackVertices = static_cast<Index>(cracks.nearVertices.size());
      report_.tJunctions = static_cast<Index>(cracks.onEdges.size());
      report_.crackWidth = cracks.width(faces_.scale);
    }
    return std::nullopt;
  }

  std::optional<Error> closeHoles(std::vector<double>& positions) {
    const std::size_t coordinates = positions.size(), corners = faces_.triangles.size();
    prepare::HoleFillings fillings = prepare::fillHoles(*mesh_);
    if (fillings.holes.empty()) return std::nullopt;
    const auto filled = [&] {
      positions.resize(coordinates);
      faces_.triangles.resize(corners);
      positions.insert(positions.end(), fillings.positions.begin(), fillings.positions.end());
      faces_.triangles.insert(faces_.triangles.end(), fillings.triangles.begin(),
                              fillings.triangles.end());
      return SurfaceMesh::fromArrays(positions, faces_.triangles, OpenEdges::Boundary);
    };
    auto mesh = filled();
    if (!mesh) {
      fillings = prepare::fillHoles(*mesh_, true);
      mesh = filled();
    }
    if (!mesh) return mesh.error();
    mesh_.emplace(std::move(mesh).value());
    report_.closedHoles = static_cast<Index>(fillings.holes.size());
    report_.holes = std::move(fillings.holes);
    for (ClosedHole& hole : report_.holes) hole.vertex = split_.inputOfVertex[hole.vertex];
    split_.inputOfVertex.resize(mesh_->vertexCount(), kNoIndex);
    faces_.inputOfFace.resize(mesh_->faceCount(), kNoIndex);
    return std::nullopt;
  }

  TriangleSoup soup_;
  const PrepareOptions& options_;
  const ExecutionContext& context_;
  PreparationReport report_;
  std::vector<Index> first_;  ///< for each vertex of the input the one that stands for it
  WorkingFaces faces_;
  std::vector<Index> own_;     ///< the first vertex of its body at each place; empty: no bodies
  std::vector<Index> copied_;  ///< the vertices of several bodies that those after the input copy
  bool isOfFacets_{false};     ///< every corner is a vertex of its own
  bool areBodiesKnown_{false};
  std::vector<Index> inputOfCorner_;  ///< empty where vertices at one place are one
  prepare::SplitVertices split_;
  std::vector<Index> partOfFace_;
  std::vector<SurfacePart> parts_;
  std::vector<Vertex> vertexOfInput_;
  std::optional<SurfaceMesh> mesh_;
};

}  // namespace

Result<PreparedSurface> prepareSurface(TriangleSoup soup, const PrepareOptions& options,
                                       const ExecutionContext& context) {
  try {
    return Preparation(std::move(soup), options, context).run();
  } catch (const std::bad_alloc&) {
    return makeError(ErrorCode::OutOfMemory, -1, "there is not enough memory for the model");
  }
}

}  // namespace girth
