#include "model/model_options.h"

#include "girth/io/length_unit.h"
#include "text/number_text.h"

namespace girth::cli {

void addModelOptions(OptionTable& table, ModelOptions& options) {
  table.add(
      "--weld LENGTH", options.weldDistance,
      "Also join vertices no farther apart than this, as in 0.01 or 0.1mm, and divide open edges "
      "where a neighbour has a vertex within them");
  table.add("--close-holes", options.closeHoles, "Close cracks, and fill every hole with faces");
  table.add("--component N", options.components,
            "Keep this component only: its number in girth info, or largest; may be given several "
            "times");
  table
      .add("--min-component SHARE", options.minComponent,
           "Leave out components with less than this share of the largest component's area, as in "
           "1e-6; by default none")
      .range(0, 1);
  std::vector<std::string> units;
  for (const io::LengthUnit& unit : io::lengthUnits()) units.emplace_back(unit.symbol);
  for (const io::LengthUnit& unit : io::lengthUnits()) units.emplace_back(unit.name);
  table
      .add("--unit UNIT", options.unit,
           "The unit of the file's numbers: " + io::lengthUnitWords() +
               ", or its name, as millimetre; by default what the file states")
      .oneOf(units);
  table
      .add("--in UNIT", options.shownUnit,
           "The unit of typed and written lengths; by default that of the file")
      .oneOf(units);
  table.add("--scale N", options.scale, "Factor to scale the model by").range(1e-12, 1e12);
  table
      .add("--height LENGTH", options.height,
           "Height to scale the model to, as in 900mm; its unit becomes the model's")
      .excludes("--scale");
  table
      .add("--up AXIS", options.up,
           "The axis of --height: x, y or z; by default y for glTF and OBJ, z for STL")
      .oneOf({"x", "y", "z"})
      .needs("--height");
  table.add("--entry NAME", options.entry,
            "The model in a zip, by its path in it; by default the first");
}

void addSubdivideOption(OptionTable& table, ModelOptions& options) {
  table
      .add("--subdivide N", options.subdivide,
           "Divide triangles until there are N; the surface stays as it is")
      .range(4, kMostFaces)
      .formerly("--refine");
}

void addFacesOption(OptionTable& table, ModelOptions& options) {
  table
      .add("--faces N", options.faces, "Measure on at most N triangles: larger models are remeshed")
      .range(4, kMostFaces)
      .excludes("--subdivide");
}

std::string preparationText(const ModelOptions& options) {
  std::string text;
  const auto add = [&text](const char* option, const std::string& value) {
    if (!value.empty()) text += std::string(text.empty() ? "" : " ") + option + " " + value;
  };
  add("--weld", options.weldDistance);
  if (options.closeHoles) text += text.empty() ? "--close-holes" : " --close-holes";
  for (const std::string& component : options.components) add("--component", component);
  if (options.minComponent > 0) add("--min-component", io::formatNumber(options.minComponent));
  add("--unit", options.unit);
  add("--in", options.shownUnit);
  if (options.scale != 1) add("--scale", io::formatNumber(options.scale));
  add("--height", options.height);
  add("--up", options.up);
  add("--entry", options.entry);
  if (options.subdivide > 0) add("--subdivide", std::to_string(options.subdivide));
  if (options.faces > 0) add("--faces", std::to_string(options.faces));
  return text;
}

}  // namespace girth::cli
