// The study of robustness on a small surface.
#include "girth/study/robustness.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "shapes.h"

namespace girth::study {
namespace {

RobustnessOptions small() {
  RobustnessOptions options;
  options.faces = 400;
  options.sizes = {300, 600};
  options.bridges = 1;
  return options;
}

const RobustnessRow* find(const std::vector<RobustnessRow>& rows, const std::string& figure) {
  for (const RobustnessRow& row : rows) {
    if (row.figure == figure) return &row;
  }
  return nullptr;
}

TEST(Robustness, OfABentRod) {
  const test::Shape rod = test::bentRod(12, 40);
  std::vector<NamedSurface> poses;
  poses.push_back({"turned", test::moved(rod, 5, 0.7, 3).mesh()});
  double last = 0;
  ExecutionContext context;
  context.onProgress = [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  const auto study = robustnessStudy(rod.mesh(), poses, small(), context);
  ASSERT_TRUE(study.ok());
  EXPECT_EQ(last, 1);
  const std::vector<RobustnessRow>& rows = study.value();
  ASSERT_EQ(rows.size(), 9u);
  for (const RobustnessRow& row : rows) {
    SCOPED_TRACE(row.change);
    EXPECT_TRUE(row.note.empty());
    EXPECT_GT(row.difference, 0);
    EXPECT_LT(row.difference, 0.3);
    EXPECT_EQ(row.unchanged.has_value(),
              row.figure == "8d" || row.figure == "8e" || row.figure == "8f");
    EXPECT_GT(row.unchanged.value_or(1), 0.3);
    EXPECT_EQ(row.paper.has_value(), row.figure != "9");
  }
  EXPECT_NEAR(rows[0].faces, 300, 10);
  EXPECT_EQ(find(rows, "8f")->faces, find(rows, "8d")->faces + 4);
  // A shape that is larger and turned.
  EXPECT_EQ(rows.back().change, "pose turned");
  EXPECT_LT(rows.back().difference, 0.03);
  // More noise, more difference.
  EXPECT_LT(rows[4].difference, rows[5].difference);
}

TEST(Robustness, OfTinyHandles) {
  RobustnessOptions options = small();
  options.tinyHandles = {1, 3};
  const auto study = robustnessStudy(test::bentRod(12, 40).mesh(), {}, options);
  ASSERT_TRUE(study.ok());
  const std::vector<RobustnessRow>& rows = study.value();
  ASSERT_EQ(rows.size(), 12u);
  const RobustnessRow *one = &rows[8], *three = &rows[10];
  EXPECT_EQ(one->change, "tiny handles: 1");
  EXPECT_EQ(three[1].change, "tiny handles: 3, removed");
  EXPECT_EQ(one->faces + 8, three->faces);
  EXPECT_TRUE(one->unchanged.has_value());
  for (const RobustnessRow* row : {one, three}) {
    EXPECT_GT(row->difference, 0);
    EXPECT_LT(row[1].difference, row->difference);
  }
}

TEST(Robustness, SaysWhatCannotBeDone) {
  const auto study = robustnessStudy(test::box(3, 1, 1, 6, 2, 2).mesh(), {}, small());
  ASSERT_TRUE(study.ok());
  const RobustnessRow* bridges = find(study.value(), "8f");
  ASSERT_NE(bridges, nullptr);
  EXPECT_TRUE(std::isnan(bridges->difference));
  EXPECT_FALSE(bridges->note.empty());
  EXPECT_EQ(find(study.value(), "9"), nullptr);
  RobustnessOptions wrong = small();
  wrong.stretch = std::nan("");
  const auto refused = robustnessStudy(test::box(3, 1, 1, 6, 2, 2).mesh(), {}, wrong);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::InvalidOption);
  std::atomic<bool> cancel{true};
  ExecutionContext context;
  context.cancel = &cancel;
  const auto stopped = robustnessStudy(test::box(3, 1, 1, 6, 2, 2).mesh(), {}, small(), context);
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace girth::study
