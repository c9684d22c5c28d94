#include "girth/study/write_study.h"

#include "text/json_text.h"
#include "text/number_text.h"
#include "write/csv_text.h"

namespace girth::study {

using io::formatNumber;
using io::jsonString;

namespace {

double recallOf(const RetrievalMeasures& measures, std::size_t level) {
  return static_cast<double>(level + 1) / static_cast<double>(measures.precision.size());
}

std::string descriptorJson(const StudyDescriptor& descriptor) {
  const RetrievalMeasures& mean = descriptor.mean;
  std::string precision;
  for (const double value : mean.precision) {
    precision += (precision.empty() ? "" : ",") + formatNumber(value);
  }
  return "{\"name\":" + jsonString(descriptor.name) +
         ",\"queries\":" + std::to_string(descriptor.queries) +
         ",\"nearestNeighbour\":" + formatNumber(mean.nearestNeighbour) +
         ",\"firstTier\":" + formatNumber(mean.firstTier) +
         ",\"secondTier\":" + formatNumber(mean.secondTier) +
         ",\"eMeasure\":" + formatNumber(mean.eMeasure) +
         ",\"eMeasureWithQuery\":" + formatNumber(mean.eMeasureWithQuery) +
         ",\"discountedGain\":" + formatNumber(mean.discountedGain) + ",\"precision\":[" +
         precision + "]}";
}

/// The items as a JSON array, one a line.
template <class Items, class ToText>
std::string arrayOf(const Items& items, ToText toText) {
  std::string text;
  for (const auto& item : items) text += (text.empty() ? "\n" : ",\n") + toText(item);
  return "[" + text + "]";
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
  std::string settings;
  for (const auto& [name, value] : study.settings) {
    settings += (settings.empty() ? "" : ",") + jsonString(name) + ":" + jsonString(value);
  }
  return "{\"title\":" + jsonString(study.title) + ",\"settings\":{" + settings + "},\"classes\":" +
         arrayOf(study.classes, [](const std::string& name) { return jsonString(name); }) +
         ",\"models\":" +
         arrayOf(study.models,
                 [](const StudyModel& model) {
                   return "{\"file\":" + jsonString(model.name) +
                          ",\"class\":" + std::to_string(model.ofClass) + "}";
                 }) +
         ",\"descriptors\":" + arrayOf(study.descriptors, descriptorJson) + ",\"failed\":" +
         arrayOf(study.failed,
                 [](const auto& failure) {
                   return "{\"file\":" + jsonString(failure.first) +
                          ",\"reason\":" + jsonString(failure.second) + "}";
                 }) +
         ",\"notes\":" +
         arrayOf(study.notes, [](const std::string& note) { return jsonString(note); }) + "}\n";
}

}  // namespace girth::study
