// Limbs as a file's content: JSON or CSV.
#pragma once

#include <string>
#include <string_view>

#include "girth/export.h"
#include "girth/io/read_mesh.h"
#include "girth/limbs.h"

namespace girth::io {

/// One JSON object: `file`, `unit`, `limbs` and `tipsWithoutLimb` (numbers of tips, as
/// `tips`). Each limb has `length`, `narrowest`, `narrowestDistance`, `median`, `base`, `end`,
/// `tips`, `apex` (as a point of `loopJson`), `vertices` (of the file), and `profile`: stations
/// with `distance`, `ring`, `median`, `least` and the point `place` of the least. Numbers that
/// there are none of are null. `persistence`: that of the girth, behind `unit`, where it is not 0.
GIRTH_EXPORT std::string limbsJson(const LoadedMesh& loaded, const Limbs& limbs,
                                   std::string_view file, double persistence = 0);

/// `limb,length,narrowest,narrowestDistance,median,base,end,apex,unit` and a row for each limb;
/// `apex` is a vertex of the file. Numbers that there are none of are empty.
GIRTH_EXPORT std::string limbsCsv(const LoadedMesh& loaded, const Limbs& limbs);

/// `limb,distance,ring,median,least,unit` and a row for each station of each limb.
GIRTH_EXPORT std::string limbProfilesCsv(const LoadedMesh& loaded, const Limbs& limbs);

}  // namespace girth::io
