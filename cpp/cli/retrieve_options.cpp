#include "retrieve_options.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <map>
#include <string>

namespace girth::cli {

using study::ValueScale;
using study::WordChoice;

namespace {
constexpr double kPercent = 100;
}  // namespace

void addComparisonOptions(CLI::App& command, ComparisonOptions& options) {
  std::string names;
  for (const std::string& name : study::descriptorNames()) {
    names += (names.empty() ? "" : ", ") + name;
  }
  command
      .add_option("--descriptors", options.descriptors,
                  "Which, with commas between: " + names +
                      ", or sums of them such as igf+sdf and 2*igf+sdf")
      ->delimiter(',');
  command
      .add_option("--faces", options.fields.faces,
                  "Remesh larger models to so many triangles; 10000 by default, 0: leave all as "
                  "they are")
      ->check(CLI::Range(std::uint32_t{0}, std::uint32_t{100'000'000}));
  command.add_flag_callback(
      "--own-size", [&] { options.fields.unitArea = false; },
      "Leave models as large as they are; by default all are scaled to area 1");
  command.add_flag_callback(
      "--exact", [&] { options.fields.distances = DistanceMethod::Exact; },
      "geoaverage, geofarthest: exact distances, not by fast marching");
  command
      .add_option("--bins", options.signatures.bins,
                  "Compare one-dimensional fields as histograms of so many bins (the paper: 512); "
                  "by default by the exact distance of their distributions")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}));
  const std::map<std::string, ValueScale> scales{
      {"area", ValueScale::AsIs}, {"greatest", ValueScale::Greatest}, {"span", ValueScale::Span}};
  command
      .add_option_function<std::string>(
          "--scale",
          [&options, scales](const std::string& name) {
            options.signatures.scale = scales.at(name);
          },
          "One-dimensional fields: area, as they are (the default), greatest, each model's "
          "greatest "
          "value becomes 1, or span, its least also 0")
      ->check(CLI::IsMember({"area", "greatest", "span"}));
  command
      .add_option("--cells", options.signatures.jointBins,
                  "igf-sdf: cells along each axis of the joint histogram; 16 by default")
      ->check(CLI::Range(std::size_t{1}, std::size_t{64}));
  command
      .add_option("--words", options.signatures.vocabulary.words,
                  "Words of bags of features; 48 by default")
      ->check(CLI::Range(std::size_t{1}, std::size_t{4096}));
  command.add_flag_callback(
      "--soft-words", [&] { options.signatures.words = WordChoice::Soft; },
      "Count each feature to all words by its distances; compare does");
  command.add_flag_callback(
      "--nearest-words", [&] { options.signatures.words = WordChoice::Nearest; },
      "Count each feature to its nearest word only; retrieve does");
  command.add_option("--seed", options.signatures.vocabulary.seed,
                     "What the words are drawn with; 1 by default");
  command
      .add_option("--pairs", options.fields.spectrum.pairs,
                  "hks, sihks, wks: eigenpairs at most; 300 by default")
      ->check(CLI::Range(Index{2}, Index{100'000}));
  command
      .add_option("--sihks-eigenfunctions", options.fields.sihks.eigenfunctions,
                  "sihks: use so many of them only; all by default")
      ->check(CLI::Range(Index{1}, Index{100'000}));
  command
      .add_option("--threads", options.threads, "Threads; as many as there are cores by default")
      ->check(CLI::Range(1u, 1024u));
}

void addRetrieveOptions(CLI::App& command, RetrieveOptions& options) {
  command.add_option("DIR", options.folders, "Folders of models")->required();
  command
      .add_option("--classes", options.classes,
                  "A .csv with the columns file and class, or a .cla, for each folder; by default "
                  "its classes.csv, its only .cla, or else its folders are the classes")
      ->take_all()
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  addComparisonOptions(command, options);
  command
      .add_option_function<double>(
          "--axis", [&options](double percent) { options.signatures.axis = percent / kPercent; },
          "One-dimensional fields: per cent of the collection's area whose values are told apart, "
          "the greatest rest counting alike; 95 by default, 100: all")
      ->check(CLI::Range(1.0, kPercent));
  command.add_option("-o,--output", options.output, "The folder to write the report into")
      ->required();
  command.add_option(
      "--cache", options.cache,
      "The folder in which computed fields are kept; cache in the report's folder by "
      "default. Several processes may share it");
  command.add_option("--shard", options.shard,
                     "I/N: only compute the fields of share I of N, from 0, into the cache; run "
                     "without it when all are done");
  command.add_option("--title", options.title, "What the report is called");
}

}  // namespace girth::cli
