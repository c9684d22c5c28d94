// Plane sections as a file's content: JSON, CSV, OBJ or GLB.
#pragma once

#include <string>
#include <string_view>

#include "girth/error.h"
#include "girth/export.h"
#include "girth/io/read_mesh.h"
#include "girth/section.h"

namespace girth::io {

/// One JSON object: `file`, `unit` and `sections` (girth/describe/section.h).
GIRTH_EXPORT std::string sectionsJson(const LoadedMesh& loaded, const Sections& sections,
                                      std::string_view file);

/// `section,offset,curve,limb,perimeter,tape,area,equivalentDiameter,leastWidth,greatestWidth,x,y,z,
/// inscribedDiameter,inscribedCentreX,inscribedCentreY,inscribedCentreZ,closed,hole,component,unit`
/// and a row for each curve; sections, curves and limbs are numbered from 0, x, y, z is the centre.
GIRTH_EXPORT std::string sectionsCsv(const LoadedMesh& loaded, const Sections& sections);

/// `section,offset,curves,perimeter,tape,area,unit` and a row for each section: its number from 0,
/// how many curves it has, and its measures, of which the tape goes round all of them.
GIRTH_EXPORT std::string sectionPlanesCsv(const LoadedMesh& loaded, const Sections& sections);

/// Each curve as an object `section_0_curve_0`, ... with a line element.
GIRTH_EXPORT std::string sectionsObj(const LoadedMesh& loaded, const Sections& sections);

/// Each curve as a node `section_0_curve_0`, ... with a line strip (mode 3), positions rounded to
/// floats; in the mesh's `extras` its `offset`, `perimeter`, `tape`, `area` and `unit`. glTF is in
/// metres, as in fieldGlb. An empty scene where there is no curve. Error: LIMIT_EXCEEDED where the
/// file would pass 4 GB.
GIRTH_EXPORT Result<std::string> sectionsGlb(const LoadedMesh& loaded, const Sections& sections);

}  // namespace girth::io
