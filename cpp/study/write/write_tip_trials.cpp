#include "girth/study/write_tip_trials.h"

#include "girth/io/json_text.h"

namespace girth::study {

using io::JsonList;
using io::JsonObject;

namespace {

std::string trialJson(const TipTrial& trial) {
  JsonObject json;
  json.add("change", trial.noise ? "noise" : "subdivided");
  if (trial.noise) json.add("noise", *trial.noise);
  if (trial.failed) return json.add("error", trial.failed->message).text();
  JsonList found;
  for (const bool again : trial.found) found.add(again ? "true" : "false");
  return json.add("tips", trial.tips).add("arcs", trial.arcs).addJson("found", found.text()).text();
}

}  // namespace

std::string tipTrialsJson(std::span<const TipTrial> trials) {
  if (trials.empty()) return "";
  JsonList list(true);
  for (const TipTrial& trial : trials) list.add(trialJson(trial));
  return list.text();
}

}  // namespace girth::study
