// The tips found again on changed surfaces, as JSON.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <span>
#include <string>

#include "girth/export.h"
#include "girth/study/tip_stability.h"

namespace girth::study {

/// A JSON array, for `trials` of io::tipsJson. Each trial has `change` ("subdivided" or "noise"),
/// `noise` (mean edge lengths), `tips` and `arcs` (how many), and `found` (for each tip, in order,
/// true or false); or `error`, why there is none. Empty text without trials.
GIRTH_EXPORT std::string tipTrialsJson(std::span<const TipTrial> trials);

}  // namespace girth::study
