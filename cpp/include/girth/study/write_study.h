// A retrieval study as files: tables for programs, and one page for people.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "girth/export.h"
#include "girth/study/measures.h"

namespace girth::study {

/// A model of the collection.
struct StudyModel {
  /// For tables.
  std::string name;
  /// The number of its class in RetrievalStudy::classes.
  std::uint32_t ofClass{0};
};

/// The result of one descriptor.
struct StudyDescriptor {
  /// As it was given: "igf+sdf".
  std::string name;
  /// Over all queries.
  RetrievalMeasures mean;
  /// How many there were: models whose class has another one.
  std::size_t queries{0};
  /// A PNG of its distances, the models in their order, or empty.
  std::string matrix;
};

/// A query and the models nearest to it.
struct StudyAnswers {
  /// A number in RetrievalStudy::models.
  std::uint32_t query{0};
  /// The models nearest to it, nearest first.
  std::vector<std::uint32_t> answers;
};

/// Everything that is written.
struct RetrievalStudy {
  /// The heading of the page.
  std::string title;
  /// How it was made, each with what it is called.
  std::vector<std::pair<std::string, std::string>> settings;
  /// The models that were compared.
  std::vector<StudyModel> models;
  /// The names of the classes.
  std::vector<std::string> classes;
  /// In the order of the table.
  std::vector<StudyDescriptor> descriptors;
  /// The descriptor that the answers are those of.
  std::string shownDescriptor;
  /// For the sheet of queries and answers.
  std::vector<StudyAnswers> shown;
  /// PNGs by model; empty for those not shown.
  std::vector<std::string> thumbnails;
  /// Models that were left out, each with its reason.
  std::vector<std::pair<std::string, std::string>> failed;
  /// Sentences for the page's list of notes.
  std::vector<std::string> notes;
};

/// `descriptor,nn,first_tier,second_tier,e_measure,e_measure_with_query,dcg,queries`, one row for
/// each descriptor; shares in [0, 1] with all digits.
GIRTH_EXPORT std::string measuresCsv(const RetrievalStudy& study);

/// `descriptor,recall,precision`: 20 rows for each descriptor.
GIRTH_EXPORT std::string precisionRecallCsv(const RetrievalStudy& study);

/// Everything but the pictures as one JSON object.
GIRTH_EXPORT std::string studyJson(const RetrievalStudy& study);

/// One page without scripts that needs no other file and no network: the table, the
/// precision-recall curves, a sheet of queries and answers, the distances, and how it was made.
GIRTH_EXPORT std::string studyHtml(const RetrievalStudy& study);

}  // namespace girth::study
