#include "model/model_options.h"

#include <CLI/CLI.hpp>

#include "girth/io/length_unit.h"

namespace girth::cli {

void addModelOptions(CLI::App& app, ModelOptions& options) {
  app.add_option("--weld", options.weldDistance,
                 "Also join vertices no farther apart than this length, as in 0.01 or 0.1mm");
  app.add_flag("--close-holes", options.closeHoles, "Fill every hole with faces");
  app.add_option("--component", options.components,
                 "Keep this component only: its number in girth info, or largest; may be given "
                 "several times")
      ->type_name("N|largest")
      ->take_all();
  std::vector<std::string> units;
  for (const io::LengthUnit& unit : io::lengthUnits()) units.emplace_back(unit.symbol);
  app.add_option(
         "--unit", options.unit,
         "The unit of the file's numbers, where it states none: um, mm, cm, m, km, in or ft")
      ->check(CLI::IsMember(units));
}

}  // namespace girth::cli
