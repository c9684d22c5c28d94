// The members of the account of girth/prepare_surface.h.
#pragma once

#include "girth/describe/description.h"
#include "girth/prepare_surface.h"

namespace girth {

/// The members of a hole that was closed.
constexpr auto describe(Members<ClosedHole>) {
  return described<ClosedHole>(
      member("edges", &ClosedHole::edges), member("perimeter", &ClosedHole::perimeter),
      member("area", &ClosedHole::area), member("vertex", &ClosedHole::vertex));
}

/// The members of the account.
constexpr auto describe(Members<PreparationReport>) {
  using Report = PreparationReport;
  return described<PreparationReport>(
      member("inputVertices", &Report::inputVertices), member("inputFaces", &Report::inputFaces),
      member("weldedVertices", &Report::weldedVertices),
      member("degenerateFaces", &Report::degenerateFaces),
      member("addedFaces", &Report::addedFaces), member("flippedFaces", &Report::flippedFaces),
      member("duplicateFaces", &Report::duplicateFaces),
      member("unreferencedVertices", &Report::unreferencedVertices),
      member("reorientedFaces", &Report::reorientedFaces),
      member("oneSidedEdges", &Report::oneSidedEdges),
      member("nonManifoldEdges", &Report::nonManifoldEdges),
      member("nonManifoldVertices", &Report::nonManifoldVertices),
      member("addedVertices", &Report::addedVertices), member("components", &Report::components),
      member("sliverComponents", &Report::sliverComponents),
      member("doubledComponents", &Report::doubledComponents),
      member("keptComponents", &Report::keptComponents),
      member("boundaryCurves", &Report::boundaryCurves),
      member("boundaryEdges", &Report::boundaryEdges),
      member("crackVertices", &Report::crackVertices), member("tJunctions", &Report::tJunctions),
      member("closedHoles", &Report::closedHoles), member("crackWidth", &Report::crackWidth),
      member("holes", &Report::holes));
}

}  // namespace girth
