// From any triangles to a surface: an oriented manifold mesh, possibly with boundary, every change
// counted.
#pragma once

#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"
#include "girth/triangle_soup.h"

namespace girth {

/// Changes to triangles beyond those that a surface needs.
struct PrepareOptions {
  /// Multiplies every position before anything else: lengths below, and all that come out, are
  /// those of the larger or smaller model. Positive.
  double scale{1};
  /// 0: vertices at exactly equal positions become one (0 and −0 are equal), but where the input's
  /// own triangles close the surface round them. Above: all vertices at equal positions do, and
  /// those no farther apart than this, in model units.
  double weldDistance{0};
  /// Joins the sides of cracks (PreparationReport::crackVertices, tJunctions). Then fills every
  /// boundary curve with faces: one of up to 100 edges with the triangulation of least area, a
  /// longer one with a fan round its middle. A curve is left as it is where that gives faces
  /// without area, or one that lies on a face of the same component or on one that is turned the
  /// same way.
  bool closeHoles{false};
  /// Keeps these components only, numbered by their first face of the input, from 0 (the index into
  /// PreparedSurface::parts); empty: all.
  std::vector<Index> components;
  /// Leaves out components whose area is less than this share of the largest one's, in [0, 1]; of
  /// those that `components` keeps, if it names any. 0: none. Drawings and exports leave crumbs
  /// behind; 1e-6 leaves out most of them.
  double minComponent{0};
};

/// A boundary curve that was filled.
struct ClosedHole {
  /// Its number of edges.
  Index edges{0};
  /// Its length, in model units.
  double perimeter{0};
  /// Area of the faces that fill it, in squared model units.
  double area{0};
  /// A vertex of the input on it.
  Index vertex{kNoIndex};
};

/// Account of what was done, step by step, in this order. All numbers but crackWidth are counts; an
/// unspoilt closed surface has zeros from weldedVertices to addedVertices.
///
///   inputVertices − weldedVertices − unreferencedVertices + addedVertices: the vertices, and
///   inputFaces + addedFaces − degenerateFaces − duplicateFaces: the faces, before components are
///   chosen and holes are closed.
struct PreparationReport {
  /// Vertices of the input.
  Index inputVertices{0};
  /// Triangles of the input.
  Index inputFaces{0};
  /// Vertices that became one with an earlier one: at the same position, within the distance asked
  /// for, or so near that a face between them has no area (1e-12 of its longest side).
  Index weldedVertices{0};
  /// Faces without area, dropped: they repeat a vertex, or their smallest height is below 1e-12 of
  /// their longest side.
  Index degenerateFaces{0};
  /// Faces made by dividing others, whose open edges had vertices of neighbours within them
  /// (PrepareOptions::weldDistance, closeHoles).
  Index addedFaces{0};
  /// Faces without area whose middle vertex lies on their longest side, and whose loss would open
  /// the surface: that side was flipped, so that the neighbour's area is shared by two faces.
  Index flippedFaces{0};
  /// Faces that have the three vertices of another one, dropped. Two copies are kept only as a
  /// partition between two solids: where all edges of the doubled patch's rim that have other faces
  /// have an even number of them.
  Index duplicateFaces{0};
  /// Vertices that no face is left to use, dropped.
  Index unreferencedVertices{0};
  /// Faces turned over, so that neighbours agree. The greater part of each piece (pieces: connected
  /// by edges of two faces) keeps its side.
  Index reorientedFaces{0};
  /// Edges cut because the surface has one side only there, as a Möbius strip has.
  Index oneSidedEdges{0};
  /// Edges with more than two faces, cut apart. Pieces that have two faces there keep them joined;
  /// of the rest, those that bound wedges of solid in turn (facing away and towards each other
  /// alternately) are joined in pairs. Where solids cross that are open nowhere, what lies inside
  /// of more of them is joined first: they stay closed. All others have their boundary there.
  Index nonManifoldEdges{0};
  /// Vertices cut apart, apart from the ends of cut edges: parts touched only there.
  Index nonManifoldVertices{0};
  /// Copies of vertices made by all cutting.
  Index addedVertices{0};
  /// Connected components of what came out.
  Index components{0};
  /// How many of them are slivers: of less than a millionth of the largest one's area.
  Index sliverComponents{0};
  /// How many of them are closed and hold nothing: two sheets on each other, such as cutting edges
  /// of many faces leaves behind. The volume inside, divided by half the area, is below a millionth
  /// of the component's extent.
  Index doubledComponents{0};
  /// How many are kept.
  Index keptComponents{0};
  /// Boundary curves of the kept components (web/docs/definitions.md, section 2), counted after
  /// holes were closed.
  Index boundaryCurves{0};
  /// The edges of these curves.
  Index boundaryEdges{0};
  /// Boundary vertices that nearly coincide with another one, as where two sides of a crack differ
  /// by a rounding: by less than a hundred thousandth of the extent and a tenth of the edges there.
  Index crackVertices{0};
  /// Boundary vertices that lie as near to the inside of a boundary edge: a neighbour has no vertex
  /// there.
  Index tJunctions{0};
  /// A weldDistance, in model units, that joins both; 0 where there are none.
  double crackWidth{0};
  /// Boundary curves that were filled.
  Index closedHoles{0};
  /// Each of these.
  std::vector<ClosedHole> holes;
};

/// A connected component, before any is left out.
struct SurfacePart {
  /// How many faces it has.
  Index faces{0};
  /// In squared model units.
  double area{0};
  /// Its first face of the input.
  Index firstFace{kNoIndex};
};

/// A surface made of triangles, and how both correspond.
struct PreparedSurface {
  /// The surface.
  SurfaceMesh mesh;
  /// For each vertex of the input, its vertex on the surface: of several copies that with the most
  /// faces, of equals the first; none where the vertex was dropped.
  std::vector<Vertex> vertexOfInput;
  /// For each vertex of the surface, the first vertex of the input that it comes from; kNoIndex for
  /// those made here.
  std::vector<Index> inputOfVertex;
  /// For each face of the surface, the triangle of the input that it covers (flipping may leave two
  /// faces on one); kNoIndex for those made here.
  std::vector<Index> inputOfFace;
  /// All components, numbered by their first face of the input.
  std::vector<SurfacePart> parts;
  /// The changes that were made.
  PreparationReport report;
};

/// Makes a surface of any triangles: welds, drops faces without area and duplicates, orients, cuts
/// where more than two faces meet or parts touch, chooses components, and fills holes if asked to;
/// other open edges become boundaries. Bodies that the input's own vertex numbers close stay
/// closed, also where bodies touch or cross at equal positions; where their sides lie in one plane,
/// bodies that the input lists one after the other are told apart by the order of their faces.
/// Faces and vertices keep the order of the input. Equal arrays always give the same surface, and
/// preparing a prepared surface's arrays once more gives the same arrays. O(n log n) in the faces;
/// about 200 bytes a face, and as many an open edge.
///
/// Errors: EMPTY_MESH (nothing is left, and why), NON_FINITE_POSITION (vertex of the input
/// that a triangle has), INDEX_OUT_OF_RANGE (triangle of the input), INVALID_OPTION (a distance
/// that is negative or not a number, a share outside of its range), COMPONENT_OUT_OF_RANGE,
/// LIMIT_EXCEEDED (too many faces to number; a vertex with a coordinate of more than 1e300),
/// CANCELLED.
///
/// \code
/// // The last two vertices lie at one place, and become one.
/// girth::TriangleSoup soup{{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1},
///                          {0, 2, 1, 0, 1, 3, 0, 4, 2, 1, 2, 4}};
/// const auto prepared = girth::prepareSurface(std::move(soup)).value();
/// std::cout << prepared.mesh.vertexCount() << " vertices\n";
/// \endcode
GIRTH_EXPORT Result<PreparedSurface> prepareSurface(TriangleSoup soup,
                                                    const PrepareOptions& options = {},
                                                    const ExecutionContext& context = {});

}  // namespace girth
