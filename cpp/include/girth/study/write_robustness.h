// The study of robustness as a file's content: CSV or JSON.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "girth/export.h"
#include "girth/study/robustness.h"

namespace girth::study {

/// `figure,change,faces,difference,unchanged,paper,note`, one row for each change; empty where
/// there is no value.
GIRTH_EXPORT std::string robustnessCsv(std::span<const RobustnessRow> rows);

/// One object with `file` and `rows`, of each the columns above; null where there is no value.
GIRTH_EXPORT std::string robustnessJson(std::span<const RobustnessRow> rows, std::string_view file);

}  // namespace girth::study
