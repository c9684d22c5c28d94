#include "commands/comparison_options.h"

#include <string>

#include "commands/common_options.h"
#include "girth/smooth_surface.h"
#include "model/model_options.h"
#include "model/persistence.h"

namespace girth::cli {

using study::ValueScale;
using study::WordChoice;

void addComparisonOptions(OptionTable& table, ComparisonOptions& options) {
  std::string names;
  for (const std::string& name : study::descriptorNames()) {
    names += (names.empty() ? "" : ", ") + name;
  }
  table
      .add("--descriptors NAME,...", options.descriptors,
           "Which: " + names + ", or sums of them such as igf+sdf and 2*igf+sdf")
      .separated();
  table
      .add("--faces N", options.fields.faces,
           "Remesh larger models to N triangles; 10000 by default, 0: none")
      .range(0, kMostFaces);
  table
      .add("--smooth STEPS", options.fields.smoothing,
           "Smooth every model first: for rough scans, about 3 steps; 0 by default")
      .range(0, kMostSmoothing);
  table.onFlag(
      "--own-size", [&] { options.fields.unitArea = false; },
      "Leave models as large as they are; by default all are scaled to area 1");
  table.onFlag(
      "--exact", [&] { options.fields.distances = DistanceMethod::Exact; },
      "geoaverage, geofarthest: exact distances, not by fast marching");
  addPersistenceShareOption(table, options.fields.persistence, "igf");
  table
      .add("--bins N", options.signatures.bins,
           "Number of bins for histograms of one-dimensional fields (the paper: 512); by default "
           "their distributions are compared exactly")
      .range(1, 1'000'000);
  table
      .onValue(
          "--value-scale SCALE",
          [&](const std::string& name) {
            options.signatures.scale = name == "greatest" ? ValueScale::Greatest
                                       : name == "span"   ? ValueScale::Span
                                                          : ValueScale::AsIs;
            return std::string();
          },
          "One-dimensional fields: area, as they are (the default), greatest, each model's "
          "greatest value becomes 1, or span, its least also 0")
      .oneOf({"area", "greatest", "span"});
  table
      .add("--cells N", options.signatures.jointBins,
           "igf-sdf: cells along each axis of the joint histogram; 16 by default")
      .range(1, 64);
  table
      .add("--words N", options.signatures.vocabulary.words,
           "Words of bags of features; 48 by default")
      .range(1, 4096);
  table.onFlag(
      "--soft-words", [&] { options.signatures.words = WordChoice::Soft; },
      "Count each feature to all words by its distances; the default of compare");
  table.onFlag(
      "--nearest-words", [&] { options.signatures.words = WordChoice::Nearest; },
      "Count each feature to its nearest word only; the default of retrieve");
  table.add("--seed N", options.signatures.vocabulary.seed,
            "Seed of the random choice of words; 1 by default");
  table
      .add("--pairs N", options.fields.spectrum.pairs,
           "hks, sihks, wks: eigenpairs at most; 300 by default")
      .range(2, 100'000);
  table
      .add("--sihks-eigenfunctions N", options.fields.sihks.eigenfunctions,
           "sihks: number of eigenpairs used; all by default")
      .range(1, 100'000);
  addThreadsOption(table, options.threads);
}

}  // namespace girth::cli
