#include "commands/common_options.h"

#include <algorithm>
#include <utility>

#include "girth/parallel.h"
#include "process/report.h"
#include "text/length_text.h"

namespace girth::cli {

void addThreadsOption(OptionTable& table, unsigned& threads) {
  table.add("--threads N", threads, "Number of threads; by default one for each core")
      .range(1, 1024);
}

void addMeasuringOptions(OptionTable& table, ModelOptions& preparing, unsigned& threads,
                         bool& json) {
  addSubdivideOption(table, preparing);
  addModelOptions(table, preparing);
  addThreadsOption(table, threads);
  table.add("--json", json, "Print everything as JSON");
}

Option& addLengthOption(OptionTable& table, std::string_view declaration, std::string& length,
                        std::string text) {
  // An empty one is a slip, such as a variable of a script that is not set: not the same as none.
  return table.onValue(
      declaration,
      [&length](const std::string& typed) {
        length = typed;
        return std::string(typed.empty() ? "the length is missing" : "");
      },
      std::move(text));
}

std::optional<Error> readLength(const std::string& text, const std::string& unit, double& length) {
  if (text.empty()) return std::nullopt;
  const auto read = io::lengthInUnit(text, unit);
  if (!read) return read.error();
  length = read.value();
  return std::nullopt;
}

Result<std::size_t> numberWithin(std::int64_t number, std::size_t count, const std::string& things,
                                 const std::string& none) {
  const std::string thing = things.substr(0, things.size() - 1);
  if (number >= 0 && static_cast<std::uint64_t>(number) < count) {
    return static_cast<std::size_t>(number);
  }
  if (count == 0) return usageError("there is no " + thing + " " + std::to_string(number), none);
  const std::string last = std::to_string(count - 1);
  if (static_cast<std::uint64_t>(number) == count) {
    printNote("", things + " count from 0: " + std::to_string(number) + " is taken as the last, " +
                      last + ", as before 1.0");
    return count - 1;
  }
  return usageError("there is no " + thing + " " + std::to_string(number),
                    things + " are numbered from 0 to " + last + ", as girth " + things + " lists");
}

void addJobsOption(OptionTable& table, unsigned& jobs) {
  table.add("--jobs N", jobs, "Models at a time; 1 by default. Threads are divided among them")
      .range(1, 1024);
}

unsigned threadsOfJob(unsigned threads, unsigned jobs) {
  if (threads > 0 || jobs <= 1) return threads;
  return std::max(1u, threadCount({}) / jobs);
}

void addPositionsOption(OptionTable& table, bool& positions) {
  table
      .add("--positions", positions,
           "CSV and JSON: also x, y and z of every vertex; CSV: units in the header")
      .needs("--output");
}

io::Columns columnsOf(bool positions) {
  return positions ? io::Columns::Positions : io::Columns::Fields;
}

}  // namespace girth::cli
