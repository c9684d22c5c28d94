#include "girth/study/descriptor_rows.h"

#include <algorithm>
#include <set>
#include <utility>

namespace girth::study {

std::vector<std::string> termsOf(const std::vector<Descriptor>& descriptors) {
  std::set<std::string> names;
  for (const Descriptor& descriptor : descriptors) {
    for (const Descriptor::Term& term : descriptor.terms) names.insert(term.name);
  }
  return {names.begin(), names.end()};
}

DescriptorRows::DescriptorRows(Descriptor descriptor,
                               const std::map<std::string, PairDistances>& terms,
                               std::size_t models)
    : descriptor_(std::move(descriptor)), terms_(terms), part_(models) {}

bool DescriptorRows::row(std::size_t model, std::vector<double>& row,
                         const ExecutionContext& context) {
  std::fill(row.begin(), row.end(), 0.0);
  for (const Descriptor::Term& term : descriptor_.terms) {
    const PairDistances& distances = terms_.at(term.name);
    if (!distances.row(model, part_, context)) return false;
    const double factor = descriptor_.terms.size() == 1 && term.weight == 1 ? 1
                          : distances.mean() > 0 ? term.weight / distances.mean()
                                                 : 0;
    for (std::size_t i = 0; i < row.size(); ++i) row[i] += factor * part_[i];
  }
  return true;
}

}  // namespace girth::study
