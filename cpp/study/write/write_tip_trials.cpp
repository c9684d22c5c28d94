#include "girth/study/write_tip_trials.h"

#include <cstddef>

#include "text/json_text.h"
#include "text/number_text.h"

namespace girth::study {

using io::formatNumber;
using io::jsonString;

namespace {

std::string trialJson(const TipTrial& trial) {
  std::string text = trial.noise ? "{\"change\":\"noise\",\"noise\":" + formatNumber(*trial.noise)
                                 : std::string("{\"change\":\"subdivided\"");
  if (trial.failed) return text + ",\"error\":" + jsonString(trial.failed->message) + "}";
  std::string found;
  for (const bool again : trial.found) {
    found += std::string(found.empty() ? "" : ",") + (again ? "true" : "false");
  }
  return text + ",\"tips\":" + std::to_string(trial.tips) +
         ",\"arcs\":" + std::to_string(trial.arcs) + ",\"found\":[" + found + "]}";
}

}  // namespace

std::string tipTrialsJson(std::span<const TipTrial> trials) {
  if (trials.empty()) return "";
  std::string text;
  for (const TipTrial& trial : trials) {
    text += (text.empty() ? "[\n" : ",\n") + trialJson(trial);
  }
  return text + "]";
}

}  // namespace girth::study
