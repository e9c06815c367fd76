#include "sim/study/reading_plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "sim/study/study_messages.h"

namespace moontrace {
namespace {

ReadingStudyCell Cell(const std::string& name, Estimate right, Estimate seconds) {
  ReadingStudyCell cell;
  cell.condition = name;
  cell.pages = 20;
  cell.right = right;
  cell.seconds = seconds;
  return cell;
}

std::vector<CircleMark> Dots(const Drawing& drawing) {
  std::vector<CircleMark> dots;
  for (const Mark& mark : drawing.marks) {
    if (const auto* dot = std::get_if<CircleMark>(&mark)) dots.push_back(*dot);
  }
  return dots;
}

ReadingSummary Two() {
  ReadingSummary summary;
  summary.cells = {Cell("sure", {0.98, 0.96, 1}, {5, 4, 6}),
                   Cell("poor", {0.90, 0.85, 0.95}, {10, 9, 11})};
  summary.best = 0;
  return summary;
}

TEST(ReadingPlot, HasADotForEachValueInTheOrderOfItsRows) {
  const std::vector<CircleMark> dots = Dots(ReadingPlot("T", Two()));
  ASSERT_EQ(dots.size(), 4U);  // right and seconds of each
  EXPECT_EQ(dots[0].center.y, dots[1].center.y);
  EXPECT_GT(dots[0].center.y, dots[2].center.y);
  EXPECT_GT(dots[0].center.x, dots[2].center.x);  // more are right
  EXPECT_LT(dots[1].center.x, dots[3].center.x);  // quicker
}

// An interval's ends lie as far from the dot as their values do.
TEST(ReadingPlot, BarsReachFromEndToEndOfTheIntervals) {
  const Drawing drawing = ReadingPlot("T", Two());
  const std::vector<CircleMark> dots = Dots(drawing);
  std::vector<TrackMark> bars;
  for (const Mark& mark : drawing.marks) {
    const auto* track = std::get_if<TrackMark>(&mark);
    if (track != nullptr && track->points[0].y == track->points[1].y) bars.push_back(*track);
  }
  ASSERT_EQ(bars.size(), dots.size());
  const double per_percent = (dots[0].center.x - dots[2].center.x) / 8;
  EXPECT_NEAR(bars[2].points[0].x, dots[2].center.x - 5 * per_percent, 1e-9);
  EXPECT_NEAR(bars[2].points[1].x, dots[2].center.x + 5 * per_percent, 1e-9);
}

// One page has no spread, whatever its letters tell.
TEST(ReadingPlot, OnePageHasNoInterval) {
  ReadingSummary one = Two();
  for (ReadingStudyCell& cell : one.cells) cell.pages = 1;
  const Drawing drawing = ReadingPlot("T", one), two = ReadingPlot("T", Two());
  EXPECT_EQ(Dots(drawing).size(), Dots(two).size());
  EXPECT_EQ(drawing.marks.size() + 4, two.marks.size());
  EXPECT_EQ(say::ReadingCellLine(one.cells[0]), "sure: 98 percent right; 5.00 s a sign");
  EXPECT_EQ(drawing.description.find("bars"), std::string::npos) << drawing.description;
  one.cells[0].pages = 2;
  EXPECT_NE(ReadingPlot("T", one).description.find("bars"), std::string::npos);
}

// A digit of DejaVu Sans is 0.636 of the font's size wide, a text's height 0.72 of it.
TEST(ReadingPlot, NumbersStandBelowTheMiddleOfTheirLines) {
  const Drawing drawing = ReadingPlot("T", Two());
  std::vector<double> lines;
  for (const Mark& mark : drawing.marks) {
    const auto* track = std::get_if<TrackMark>(&mark);
    if (track != nullptr && track->points[0].x == track->points[1].x) {
      lines.push_back(track->points[0].x);
    }
  }
  std::size_t numbers = 0;
  for (const Mark& mark : drawing.marks) {
    const auto* text = std::get_if<TextMark>(&mark);
    if (text == nullptr || text->text.find_first_not_of("0123456789") != std::string::npos)
      continue;
    const double width = static_cast<double>(text->text.size()) * 0.636 / 0.72 * text->height;
    ASSERT_LT(numbers, lines.size());
    EXPECT_NEAR(text->at.x + 0.5 * width, lines[numbers], 0.1) << text->text;
    ++numbers;
  }
  EXPECT_EQ(numbers, lines.size());
}

// The share never lies outside its interval, and is 100 only where all is right.
TEST(ReadingPlot, WordsRoundAShareAsItsInterval) {
  const ReadingStudyCell good = Cell("good", {0.99966, 0.99939, 1}, {5, 4, 6});
  EXPECT_EQ(say::ReadingCellLine(good),
            "good: 99.96 percent right, CI 99.93 to 100.00; 5.00 s a sign, CI 4.00 to 6.00");
  const ReadingStudyCell close = Cell("close", {0.999996, 0.999995, 1}, {5, 4, 6});
  EXPECT_NE(say::ReadingCellLine(close).find(": 99.99 percent right, CI 99.99 to 100.00"),
            std::string::npos);
  const ReadingStudyCell all = Cell("all", {1, 0.99, 1}, {5, 4, 6});
  EXPECT_NE(say::ReadingCellLine(all).find(": 100 percent right, CI 99.00"), std::string::npos);
}

TEST(ReadingPlot, TellsInWordsWhatIsToBeSeen) {
  const Drawing drawing = ReadingPlot("Title", Two());
  EXPECT_EQ(drawing.title, "Title");
  EXPECT_NE(drawing.description.find("Surest: sure, 98 percent right, 5.00 s a sign."),
            std::string::npos)
      << drawing.description;
  EXPECT_NE(drawing.description.find("Least right: poor, 90 percent"), std::string::npos);
}

TEST(ReadingPlot, NamesNoLeastRightWhereAllAreEqual) {
  ReadingSummary equal = Two();
  equal.cells[0].right.value = equal.cells[1].right.value = 1;
  EXPECT_EQ(
      say::ReadingPlotWords(equal, 2),
      "Dots: values; bars: their 95 percent intervals. Surest: sure, 100 percent right, 5.00 s "
      "a sign.");
}

TEST(ReadingPlot, ShowsAtMostAHundredRowsAndSaysSo) {
  ReadingSummary summary;
  for (int i = 0; i < 120; ++i) summary.cells.push_back(Cell("c", {1, 1, 1}, {5, 5, 5}));
  const Drawing drawing = ReadingPlot("T", summary);
  EXPECT_EQ(Dots(drawing).size(), 200U);
  EXPECT_NE(drawing.description.find("Of 120 combinations the first 100"), std::string::npos);
}

TEST(ReadingPlot, OfNothingIsAnEmptyPictureWithWords) {
  EXPECT_EQ(ReadingPlot("T", {}).description, "No page was read.");
}

}  // namespace
}  // namespace moontrace
