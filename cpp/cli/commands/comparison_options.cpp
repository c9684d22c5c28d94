#include "commands/comparison_options.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <map>
#include <string>

#include "commands/common_options.h"

namespace girth::cli {

using study::ValueScale;
using study::WordChoice;

void addComparisonOptions(CLI::App& app, ComparisonOptions& options) {
  std::string names;
  for (const std::string& name : study::descriptorNames()) {
    names += (names.empty() ? "" : ", ") + name;
  }
  app.add_option(
         "--descriptors", options.descriptors,
         "Which, with commas between: " + names + ", or sums of them such as igf+sdf and 2*igf+sdf")
      ->delimiter(',');
  app.add_option("--faces", options.fields.faces,
                 "Remesh larger models to so many triangles; 10000 by default, 0: leave all as "
                 "they are")
      ->check(CLI::Range(std::uint32_t{0}, kMostFaces));
  app.add_flag_callback(
      "--own-size", [&] { options.fields.unitArea = false; },
      "Leave models as large as they are; by default all are scaled to area 1");
  app.add_flag_callback(
      "--exact", [&] { options.fields.distances = DistanceMethod::Exact; },
      "geoaverage, geofarthest: exact distances, not by fast marching");
  app.add_option("--bins", options.signatures.bins,
                 "Compare one-dimensional fields as histograms of so many bins (the paper: 512); "
                 "by default by the exact distance of their distributions")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}));
  const std::map<std::string, ValueScale> scales{
      {"area", ValueScale::AsIs}, {"greatest", ValueScale::Greatest}, {"span", ValueScale::Span}};
  app.add_option_function<std::string>(
         "--scale",
         [&options, scales](const std::string& name) {
           options.signatures.scale = scales.at(name);
         },
         "One-dimensional fields: area, as they are (the default), greatest, each model's "
         "greatest value becomes 1, or span, its least also 0")
      ->check(CLI::IsMember({"area", "greatest", "span"}));
  app.add_option("--cells", options.signatures.jointBins,
                 "igf-sdf: cells along each axis of the joint histogram; 16 by default")
      ->check(CLI::Range(std::size_t{1}, std::size_t{64}));
  app.add_option("--words", options.signatures.vocabulary.words,
                 "Words of bags of features; 48 by default")
      ->check(CLI::Range(std::size_t{1}, std::size_t{4096}));
  app.add_flag_callback(
      "--soft-words", [&] { options.signatures.words = WordChoice::Soft; },
      "Count each feature to all words by its distances; compare does");
  app.add_flag_callback(
      "--nearest-words", [&] { options.signatures.words = WordChoice::Nearest; },
      "Count each feature to its nearest word only; retrieve does");
  app.add_option("--seed", options.signatures.vocabulary.seed,
                 "What the words are drawn with; 1 by default");
  app.add_option("--pairs", options.fields.spectrum.pairs,
                 "hks, sihks, wks: eigenpairs at most; 300 by default")
      ->check(CLI::Range(Index{2}, Index{100'000}));
  app.add_option("--sihks-eigenfunctions", options.fields.sihks.eigenfunctions,
                 "sihks: use so many of them only; all by default")
      ->check(CLI::Range(Index{1}, Index{100'000}));
  addThreadsOption(app, options.threads);
}

}  // namespace girth::cli
