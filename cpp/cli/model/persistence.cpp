#include "model/persistence.h"

#include <cmath>

#include "process/report.h"
#include "text/length_text.h"

namespace girth::cli {
namespace {

/// The option's text, with the fields that it is for before it.
std::string textFor(const std::string& of, const char* sizes) {
  return (of.empty() ? "Pass" : of + ": pass") +
         " over loops whose saddles last no longer than this, as noise makes them: " + sizes +
         "; 0 by default";
}

}  // namespace

Option& addPersistenceOption(OptionTable& table, std::string& typed, const std::string& of) {
  return table.onValue(
      "--persistence LENGTH",
      [&typed](const std::string& text) {
        // Whether the model has a unit is known only once it has been read.
        const auto length = io::lengthOrShare(text, "m", 1);
        typed = text;
        return length ? std::string() : length.error().message;
      },
      textFor(of, "a length, or, as in 2%, a share of the square root of the area"));
}

void addPersistenceShareOption(OptionTable& table, double& share, const std::string& of) {
  table.onValue(
      "--persistence PERCENT",
      [&share](const std::string& text) {
        const bool isShare = !text.empty() && text.back() == '%';
        if (!isShare && text != "0") return "\"" + text + "\" is no percentage, as in 2%";
        const auto read = io::lengthOrShare(text, "", 1);
        if (read) share = read.value();
        return read ? std::string() : read.error().message;
      },
      textFor(of, "a share of the square root of the area, as in 2%"));
}

Result<double> persistenceOf(const std::string& typed, const io::LoadedMesh& loaded) {
  if (typed.empty()) return 0.0;
  return io::lengthOrShare(typed, loaded.unit, std::sqrt(loaded.mesh.area()));
}

std::string persistenceText(double persistence, const io::LoadedMesh& loaded) {
  if (persistence == 0) return "";
  return ", persistence " + readable(persistence) + unitSuffix(loaded.unit);
}

}  // namespace girth::cli
