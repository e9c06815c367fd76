#include "sim/learn/learn_print.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lessons/course/lesson_items.h"
#include "sim/learn/learn_messages.h"
#include "sim/picture/moon_marks.h"
#include "sim/picture/picture_file.h"
#include "sim/picture/picture_messages.h"
#include "textures/base/error.h"
#include "textures/base/nearest_word.h"
#include "textures/base/units.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

namespace {

// Of a sheet of A4, [m]. Between what is felt lie 6 mm at least, as guidelines of tactile graphics
// ask for swell paper; the rest is ours.
constexpr double kShort = 0.210, kLong = 0.297;
constexpr double kEdge = 0.015;      ///< around all
constexpr double kHeadSize = 0.006;  ///< of the Moon letters of title and instruction, as in books
constexpr double kHeadPitch = 0.0108;  ///< of their lines
constexpr double kApart = 0.008;       ///< between them and the lesson's own lines
constexpr double kPrint = 0.013;       ///< room for two or three lines of print at the foot
constexpr double kPrintHeight = 2.5;   ///< of their capitals [mm]
constexpr double kCorner = 16;         ///< legs of the mark in the corner [mm]
constexpr double kCornerEdge = 7;      ///< between the mark and the sheet's edges [mm]
constexpr Color kBlack{0, 0, 0};

const Lesson& LessonToPrint(const Course& course, const std::string& name) {
  if (course.lessons.empty()) throw InputError(say::NothingToPrint(course.id));
  if (name.empty()) return course.lessons.front();
  if (const auto index = LessonNamed(course, name)) return course.lessons[*index];
  std::vector<std::string> ids;
  for (const Lesson& lesson : course.lessons) ids.push_back(lesson.id);
  throw UsageError(say::NoSuchLesson(name, NearestWord(name, ids)));
}

/// What is felt in a lesson, one line an item or text.
std::string TextOfLesson(const Lesson& lesson) {
  std::vector<std::string> lines;
  const auto add = [&lines](const std::string& line) {
    const bool there = std::find(lines.begin(), lines.end(), line) != lines.end();
    if (!line.empty() && !there) lines.push_back(line);
  };
  for (const std::string& item : lesson.items) add(item);
  for (const Step& step : lesson.steps) {
    add(step.text);
    for (const std::string& item : step.items) add(item);
  }
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

/// Text in a script, at a size, on a part of a sheet.
struct Strip {
  Script script;
  Typeset set;
};

Strip SetStrip(const std::string& text, const std::string& script_name, double grade, double size,
               double width, double height) {
  StyleOptions options;
  options.script = script_name;
  options.size = size;
  if (grade != 1) options.grade = grade;
  const LayoutOptions layout;
  Strip strip;
  strip.script = ScriptOf(options, nullptr, text);
  const TypeStyle style = StyleOf(options, layout, strip.script, nullptr);
  strip.set = SetText(text, strip.script, style, {"custom", width, height, 0});
  return strip;
}

std::vector<Mark> MarksOf(const Strip& strip, std::size_t page, glm::dvec2 corner) {
  return MoonMarks(strip.set.pages[page], strip.script, strip.set.style, -corner, kBlack);
}

/// Whether a word goes on in another line, but for the place behind a hyphen.
bool BreaksAWord(const Typeset& set, const std::string& text) {
  const PlacedGlyph* before = nullptr;
  std::size_t page_before = 0;
  for (std::size_t page = 0; page < set.pages.size(); ++page) {
    for (const PlacedGlyph& glyph : set.pages[page].glyphs) {
      const bool apart = before != nullptr && (page != page_before || glyph.line != before->line);
      if (apart && glyph.source_begin == before->source_end && glyph.source_begin > 0 &&
          text[glyph.source_begin - 1] != '-') {
        return true;
      }
      before = &glyph;
      page_before = page;
    }
  }
  return false;
}

/// How a lesson is laid on sheets.
struct Sheets {
  double width = kShort, height = kLong;  ///< [m]
  Strip body;
  double head_room = 0, foot_room = 0;  ///< above and below the lesson's lines [m]
};

struct Wanted {
  const Course& course;
  const Lesson& lesson;
  std::string text;
  double size = 0;  ///< [m]
};

/// In Moon, on lines of its own; none where the course's script cannot write it.
std::optional<Strip> HeadStrip(const Course& course, const std::string& text, double width) {
  try {
    return SetStrip(text, course.script, course.grade, kHeadSize, width, kLong);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::size_t LinesOf(const std::optional<Strip>& strip) {
  return strip ? strip->set.pages.front().lines : 0;
}

double RoomFor(const std::optional<Strip>& strip) {
  return strip ? kHeadPitch * static_cast<double>(LinesOf(strip)) + kApart : 0;
}

/// Short, for fingers: of a title that explains itself behind a colon what stands before.
std::string HeadText(const Lesson& lesson, std::size_t page) {
  return lesson.title.substr(0, lesson.title.find(':')) + ", " + say::PrintedPageInMoon(page);
}

Sheets LayOut(const Wanted& wanted, double size, bool landscape) {
  Sheets sheets;
  if (landscape) std::swap(sheets.width, sheets.height);
  const double across = sheets.width - 2 * kEdge;
  // the number of a page takes no more lines than that of any other
  const double beside_corner = across - 1e-3 * (kCorner + kCornerEdge);
  sheets.head_room = RoomFor(HeadStrip(wanted.course, HeadText(wanted.lesson, 99), beside_corner));
  sheets.foot_room =
      RoomFor(HeadStrip(wanted.course, say::PrintedInstructionInMoon(), across)) + kPrint;
  const double room = sheets.height - 2 * kEdge - sheets.head_room - sheets.foot_room;
  const Lesson& lesson = wanted.lesson;
  sheets.body = SetStrip(wanted.text, lesson.script.empty() ? wanted.course.script : lesson.script,
                         lesson.grade, size, across, room);
  return sheets;
}

/// The sizes to be tried, the one that is wanted first: then the course's own below it, then less.
std::vector<double> SizesBelow(const Course& course, double wanted) {
  std::vector<double> sizes{wanted};
  for (const double size : course.sizes) {
    if (size < sizes.back()) sizes.push_back(size);
  }
  while (sizes.back() > 0.004) sizes.push_back(0.8 * sizes.back());
  return sizes;
}

/// Upright, else sideways, else in smaller letters: so that each word stands whole in its line.
/// Where no size does (a word of hundreds of letters), as the size that was wanted breaks it.
Sheets WithWholeWords(const Wanted& wanted) {
  for (const double size : SizesBelow(wanted.course, wanted.size)) {
    for (const bool landscape : {false, true}) {
      try {
        Sheets sheets = LayOut(wanted, size, landscape);
        if (!BreaksAWord(sheets.body.set, wanted.text)) return sheets;
      } catch (const InputError&) {
        continue;  // letters that are larger than the sheet
      }
    }
  }
  return LayOut(wanted, wanted.size, false);
}

/// A line across the upper right corner: found by a finger, it tells how the sheet lies, and may be
/// cut along.
Mark CornerMark(const Sheets& sheets) {
  const double right = kMillimetres * sheets.width - kCornerEdge;
  const double top = kMillimetres * sheets.height - kCornerEdge;
  return TrackMark{{{right - kCorner, top}, {right, top - kCorner}}, kBlack, 1.5, false};
}

/// The text of a page as print, for who helps: "t; i; it".
std::string PrintOf(const TextPage& page, const std::string& text) {
  std::string print;
  std::size_t line = 0, end = 0;
  for (const PlacedGlyph& glyph : page.glyphs) {
    if (!print.empty()) print += glyph.line != line ? "; " : "";
    if (!print.empty() && glyph.line == line && glyph.source_begin > end) print += ' ';
    print += text.substr(glyph.source_begin, glyph.source_end - glyph.source_begin);
    line = glyph.line;
    end = glyph.source_end;
  }
  return print;
}

/// Swell paper rises where it is black: what is to be felt is, and the helper's print at the foot.
Drawing SwellPage(const Wanted& wanted, const Sheets& sheets, std::size_t page) {
  const Typeset& set = sheets.body.set;
  const TextPage& sheet = set.pages[page];
  const std::size_t pages = set.pages.size();
  const double across = sheets.width - 2 * kEdge;
  Drawing drawing;
  drawing.width = kMillimetres * sheets.width;
  drawing.height = kMillimetres * sheets.height;
  drawing.title = wanted.lesson.title;
  drawing.description = say::PagePictureWords(sheet.glyphs.size(), sheet.lines, set.style);
  drawing.marks = MarksOf(sheets.body, page, {kEdge, kEdge + sheets.foot_room});
  const auto add = [&drawing](std::vector<Mark> marks) {
    drawing.marks.insert(drawing.marks.end(), marks.begin(), marks.end());
  };
  drawing.marks.push_back(CornerMark(sheets));
  const double beside_corner = across - 1e-3 * (kCorner + kCornerEdge);
  if (const auto head = HeadStrip(wanted.course, HeadText(wanted.lesson, page + 1), beside_corner))
    add(MarksOf(*head, 0, {kEdge, sheets.height - kEdge - kLong}));
  const double foot = kEdge + sheets.foot_room - kApart;
  if (const auto line = HeadStrip(wanted.course, say::PrintedInstructionInMoon(), across))
    add(MarksOf(*line, 0, {kEdge, foot - kLong}));
  const std::string words = say::PrintedInstruction(wanted.lesson.title, page + 1, pages,
                                                    set.style.size, PrintOf(sheet, wanted.text));
  for (const TextMark& line :
       TextBlock(words, kMillimetres * glm::dvec2(kEdge, kEdge + kPrint - 0.003),
                 kMillimetres * across, kPrintHeight, kBlack)) {
    drawing.marks.emplace_back(line);
  }
  return drawing;
}

/// What to type for the lesson behind this one.
std::string NextToPrint(const LearnOptions& options, const Course& course, const Lesson& lesson) {
  const auto number = static_cast<std::size_t>(&lesson - course.lessons.data()) + 1;
  if (number == course.lessons.size()) return say::PrintedLast();
  const std::string file = fmt::format("lesson{}{}", number + 1,
                                       std::filesystem::path(options.print).extension().string());
  const std::string own = options.course == LearnOptions().course ? "" : options.course;
  return say::PrintNext(file, number + 1, own);
}

}  // namespace

int PrintLesson(const LearnOptions& options, const Course& course, Console& console) {
  CheckPicturePath(options.print);
  const Lesson& lesson = LessonToPrint(course, options.lesson);
  const Wanted wanted{course, lesson, TextOfLesson(lesson),
                      options.size.value_or(course.sizes.empty() ? 0.02 : course.sizes.front())};
  if (wanted.text.empty()) throw InputError(say::NothingToPrint(lesson.id));
  const Sheets sheets = WithWholeWords(wanted);
  const Typeset& set = sheets.body.set;
  PagePictures pictures(options.print, set.pages.size());
  for (std::size_t page = 0; page < set.pages.size(); ++page) {
    console.CheckStop();
    pictures.Add(SwellPage(wanted, sheets, page));
  }
  const std::vector<std::string> files = pictures.Finish();
  console.Result(say::Printed(lesson.title, set.pages.size(), set.style.size));
  if (sheets.width > sheets.height) console.Result(say::PrintedSideways());
  if (set.style.size < 0.999 * wanted.size) console.Result(say::PrintedSmaller(wanted.size));
  if (BreaksAWord(set, wanted.text)) console.Result(say::PrintedBroken());
  console.Result(say::PrintedHow());
  for (const std::string& file : files) console.Path(file);
  console.Result(NextToPrint(options, course, lesson));
  return exit_code::kGood;
}

}  // namespace moontrace
