#include "model/clear_necks.h"

#include <vector>

#include "commands/common_options.h"
#include "model/computing.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {

void addProminenceOption(OptionTable& table, std::string& typed, const std::string& words) {
  const std::string text =
      words + ", as in 2mm; by default a twentieth of the narrowest neck's length, 0 for all necks";
  addLengthOption(table, "--min-prominence LENGTH", typed, text.c_str());
}

Result<std::optional<double>> readProminence(const std::string& typed, const std::string& unit) {
  if (typed.empty()) return std::optional<double>();
  double length = 0;
  if (auto error = readLength(typed, unit, length)) return *std::move(error);
  return std::optional(length);
}

Result<Necks> computeNecks(const std::string& model, const io::LoadedMesh& loaded,
                           std::span<const double> girth, std::optional<double> minProminence,
                           unsigned threads) {
  auto found = [&] {
    ProgressLine progress(model);
    return findNecks(loaded.mesh, girth, {minProminence.value_or(0)}, watched(threads, progress));
  }();
  if (!found || minProminence) return found;
  std::vector<Neck>& necks = found.value().necks;
  const double least = found.value().suggestedProminence;
  const std::size_t all = necks.size();
  std::erase_if(necks, [&](const Neck& neck) { return neck.prominence < least; });
  if (const std::size_t out = all - necks.size(); out > 0) {
    printNote(model, std::to_string(out) + " of " + std::to_string(all) +
                         " necks have a prominence below " + readable(least) +
                         unitSuffix(loaded.unit) +
                         ", the suggested least, and are left out; --min-prominence 0 keeps them");
  }
  return found;
}

}  // namespace girth::cli
