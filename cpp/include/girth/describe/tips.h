// The members of what girth/tips.h finds.
#pragma once

#include "girth/describe/description.h"
#include "girth/tips.h"

namespace girth {

/// The members of a line of a contour.
constexpr auto describe(Members<ContourLine>) {
  return described<ContourLine>(member("closed", &ContourLine::closed),
                                line("points", &ContourLine::points));
}

/// The members of a tip.
constexpr auto describe(Members<Tip>) {
  return described<Tip>(member("area", &Tip::area), member("boundaryLength", &Tip::boundaryLength),
                        member("jump", &Tip::jump), member("apex", &Tip::apex),
                        member("apexDistance", &Tip::apexDistance),
                        member("vertices", &Tip::vertices), member("contour", &Tip::contour));
}

/// The members of an arc.
constexpr auto describe(Members<OpenArc>) {
  return described<OpenArc>(member("length", &OpenArc::length), member("jump", &OpenArc::jump),
                            member("line", &OpenArc::line));
}

/// The members of all tips.
constexpr auto describe(Members<Tips>) {
  return described<Tips>(member("crossedEdges", &Tips::crossedEdges), member("tips", &Tips::tips),
                         member("arcs", &Tips::arcs));
}

}  // namespace girth
