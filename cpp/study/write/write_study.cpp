#include "girth/study/write_study.h"

#include "girth/io/json_text.h"
#include "text/number_text.h"
#include "write/csv_text.h"

namespace girth::study {

using io::formatNumber;
using io::JsonList;
using io::JsonObject;
using io::jsonString;
using io::numberJson;

namespace {

double recallOf(const RetrievalMeasures& measures, std::size_t level) {
  return static_cast<double>(level + 1) / static_cast<double>(measures.precision.size());
}

std::string descriptorJson(const StudyDescriptor& descriptor) {
  const RetrievalMeasures& mean = descriptor.mean;
  JsonList precision;
  for (const double value : mean.precision) precision.add(numberJson(value));
  return JsonObject()
      .add("name", descriptor.name)
      .add("queries", descriptor.queries)
      .add("nearestNeighbour", mean.nearestNeighbour)
      .add("firstTier", mean.firstTier)
      .add("secondTier", mean.secondTier)
      .add("eMeasure", mean.eMeasure)
      .add("eMeasureWithQuery", mean.eMeasureWithQuery)
      .add("discountedGain", mean.discountedGain)
      .addJson("precision", precision.text())
      .text();
}

/// The items as a JSON array, one a line.
template <class Items, class ToText>
std::string arrayOf(const Items& items, ToText toText) {
  JsonList list(true);
  for (const auto& item : items) list.add(toText(item));
  return list.text();
}

}  // namespace

std::string measuresCsv(const RetrievalStudy& study) {
  std::string text =
      "descriptor,nn,first_tier,second_tier,e_measure,e_measure_with_query,dcg,queries\n";
  for (const StudyDescriptor& descriptor : study.descriptors) {
    const RetrievalMeasures& mean = descriptor.mean;
    text += csvText(descriptor.name);
    for (const double value : {mean.nearestNeighbour, mean.firstTier, mean.secondTier,
                               mean.eMeasure, mean.eMeasureWithQuery, mean.discountedGain}) {
      text += "," + formatNumber(value);
    }
    text += "," + std::to_string(descriptor.queries) + "\n";
  }
  return text;
}

std::string precisionRecallCsv(const RetrievalStudy& study) {
  std::string text = "descriptor,recall,precision\n";
  for (const StudyDescriptor& descriptor : study.descriptors) {
    for (std::size_t i = 0; i < descriptor.mean.precision.size(); ++i) {
      text += csvText(descriptor.name) + "," + formatNumber(recallOf(descriptor.mean, i)) + "," +
              formatNumber(descriptor.mean.precision[i]) + "\n";
    }
  }
  return text;
}

std::string studyJson(const RetrievalStudy& study) {
  JsonObject settings;
  for (const auto& [name, value] : study.settings) settings.add(name, value);
  return JsonObject()
             .add("title", study.title)
             .addJson("settings", settings.text())
             .addJson("classes", arrayOf(study.classes, jsonString))
             .addJson("models", arrayOf(study.models,
                                        [](const StudyModel& model) {
                                          return JsonObject()
                                              .add("file", model.name)
                                              .add("class", model.ofClass)
                                              .text();
                                        }))
             .addJson("descriptors", arrayOf(study.descriptors, descriptorJson))
             .addJson("failed", arrayOf(study.failed,
                                        [](const auto& failure) {
                                          return JsonObject()
                                              .add("file", failure.first)
                                              .add("reason", failure.second)
                                              .text();
                                        }))
             .addJson("notes", arrayOf(study.notes, jsonString))
             .text() +
         "\n";
}

}  // namespace girth::study
