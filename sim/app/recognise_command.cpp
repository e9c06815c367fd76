#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "devices/catalogue/catalogue.h"
#include "sim/app/commands.h"
#include "sim/app/messages.h"
#include "sim/app/recognise_messages.h"
#include "sim/console/wording.h"
#include "sim/picture/drawing.h"
#include "sim/picture/moon_marks.h"
#include "sim/picture/picture_file.h"
#include "sim/reading/read_text.h"
#include "sim/reading/reading_run.h"
#include "sim/reading/reading_setup.h"
#include "sim/setup/cli_app.h"
#include "sim/setup/help.h"
#include "sim/setup/text_setup.h"
#include "sim/setup/text_trial.h"
#include "sim/setup/typeset_report.h"
#include "textures/base/error.h"
#include "textures/base/units.h"
#include "textures/base/utf8.h"
#include "textures/fonts/script.h"
#include "textures/typeset/braille_reader.h"
#include "textures/typeset/typeset.h"

namespace moontrace {
namespace {

constexpr char32_t kFirstCell = 0x2800;  ///< of Unicode's Braille patterns

/// The tip's path while it touches, searching (kTravel) or following (kStroke), a track each.
std::vector<Mark> Tracks(const std::vector<PathPoint>& path, glm::dvec2 from_P, double width) {
  std::vector<Mark> marks;
  TrackMark track;
  track.width = width;
  TracePhase phase = TracePhase::kAir;
  const auto end_track = [&] {
    track.stroke = phase == TracePhase::kStroke ? palette::kTip : palette::kAway;
    if (track.points.size() > 1) marks.emplace_back(track);
    track.points.clear();
  };
  for (const PathPoint& point : path) {
    if (!point.in_contact || point.phase != phase) end_track();
    phase = point.phase;
    if (point.in_contact && phase != TracePhase::kAir) {
      track.points.push_back(kMillimetres * (glm::dvec2(point.tip_P) - from_P));
    }
  }
  end_track();
  return marks;
}

std::vector<Mark> PrintOf(const ReadingResult& result, const Script& script, glm::dvec2 from_P,
                          double height) {
  std::vector<Mark> marks;
  for (const ReadToken& token : result.tokens) {
    const bool known = token.kind == ReadToken::Kind::kSign;
    if (!known && token.kind != ReadToken::Kind::kUnknown) continue;
    const glm::dvec2 at = kMillimetres * (FromEm(token.place, {0, -0.35}) - from_P);
    marks.emplace_back(
        TextMark{at, height, known ? TextOfSign(token.glyph, script) : "unknown", palette::kInk});
    if (!known || token.probability >= 0.99) continue;
    const double percent = std::round(100 * token.probability);
    marks.emplace_back(TextMark{at - glm::dvec2(0, 1.2 * height), 0.8 * height,
                                fmt::format("{} %", percent), palette::kInk});
  }
  return marks;
}

Box Drawn(const TextPage& page, const Script& script, const TypeStyle& style,
          const ReadingResult& result) {
  Box box = InkBounds(page, script, style);
  for (const PathPoint& point : result.path) {
    if (point.in_contact) Include(box, glm::dvec2(point.tip_P));
  }
  return box;
}

void Append(std::vector<Mark>& marks, std::vector<Mark> more) {
  std::move(more.begin(), more.end(), std::back_inserter(marks));
}

/// A page that was read by touch: the tip's paths over it, searching and following, and below each
/// place where a sign was found what it was taken for. `result.path` must have been kept.
Drawing ReadingPicture(const TextPage& page, const Script& script, const TypeStyle& style,
                       bool blank, const std::string& text, const ReadingResult& result) {
  const double size = kMillimetres * style.size;
  const double border = std::max(4.0, 0.4 * size);
  const double print = std::clamp(0.15 * size, 1.2, 2.4);
  const Box ink = Drawn(page, script, style, result);
  Drawing drawing;
  drawing.width = std::max(80.0, kMillimetres * (ink.max.x - ink.min.x) + 2 * border);
  drawing.title = say::ReadingPictureTitle(script, style);
  std::string read = TextRead(result.tokens, script);
  while (!read.empty() && read.back() == '\n') read.pop_back();
  std::replace(read.begin(), read.end(), '\n', ' ');
  drawing.description = say::ReadingPictureWords(text, read);
  const std::string words =
      fmt::format("{}. {} {}", drawing.title, drawing.description,
                  say::ReadingPictureLegend(style, IsFollowed(style.relief, script), blank));
  std::vector<TextMark> lines =
      TextBlock(words, {border, 0}, drawing.width - 2 * border, print, palette::kInk);
  const double words_height = (lines.empty() ? 0 : -lines.back().at.y) + border;
  drawing.height = kMillimetres * (ink.max.y - ink.min.y) + 2 * border + words_height;
  const glm::dvec2 from_P = ink.min - glm::dvec2(border, border + words_height) / kMillimetres;
  Append(drawing.marks, blank ? CentreLineMarks(page, script, style, from_P, palette::kPaperEdge)
                              : MoonMarks(page, script, style, from_P, palette::kGroove));
  const double width = std::clamp(0.12 * kMillimetres * style.width, 0.08, 0.5);
  Append(drawing.marks, Tracks(result.path, from_P, width));
  Append(drawing.marks, PrintOf(result, script, from_P, print));
  for (TextMark& mark : lines) {
    mark.at.y += words_height;
    drawing.marks.emplace_back(std::move(mark));
  }
  return drawing;
}

/// All pages of a text, as they were read.
struct Reading {
  TextSetup text;
  std::vector<ReadingResult> pages;
  ReadingScore score;
  std::optional<DeviceProfile> device;
  double duration = 0, elapsed = 0;                 ///< [s], simulated and not
  std::array<double, kReaderActivities> seconds{};  ///< simulated, by activity
  std::vector<std::string> pictures;
};

/// What decides one page's reading. How the page lies, the range of sizes that the reader is told
/// and all that is left to chance come from the seed alone.
ReadingSetup SetupOf(const RecogniseOptions& options, const Reading& reading, std::size_t page,
                     const std::shared_ptr<const SignShapes>& shapes, const TextureField& field,
                     Console& console) {
  const TextSetup& text = reading.text;
  const TypeStyle& style = text.set.style;
  ReadingSetup setup;
  setup.page = &text.set.pages[page];
  setup.field = &field;
  setup.model_path = options.feel.model;
  setup.scene = OnLabel(text, page, options.feel.scene);
  setup.others = text.others;
  setup.device = reading.device;
  setup.senses.unsure = options.unsure.value_or(0);
  setup.hand = ShippedHand();
  setup.hand.press = options.press.value_or(ReadingPress(setup.hand, style.relief, text.script));
  setup.press_given = options.press.has_value();
  CompleteSetup(setup, shapes, text.script, style, options.seed + page * 0x9e3779b9u);
  if (!options.picture.empty()) setup.path_spacing = style.width / 20;
  setup.stop = console.stop();
  return setup;
}

void ReadPage(const RecogniseOptions& options, std::size_t page,
              const std::shared_ptr<const SignShapes>& shapes, PagePictures* pictures,
              Console& console, Reading& reading) {
  const TextSetup& text = reading.text;
  const TextPage& set = text.set.pages[page];
  const TextureField field = PageField(set, text.script, text.set.style, options.blank);
  ReadingSetup setup = SetupOf(options, reading, page, shapes, field, console);
  const double done = static_cast<double>(page) / static_cast<double>(text.set.pages.size());
  setup.alive = [&console, done] { console.Alive(done); };
  ReadingResult result = RunReading(setup);
  if (result.through > 0) console.Remark(say::ReaderPressedThrough(page, result.through));
  if (!result.ended) console.Remark(say::ReaderStopped(page));
  reading.score += Compare(options.blank ? std::vector<int>() : MarksOf(set, text.script),
                           MarksOf(result.tokens, text.script));
  reading.duration += result.duration;
  reading.elapsed += result.duration / result.real_time_factor;
  for (std::size_t i = 0; i < kReaderActivities; ++i) reading.seconds[i] += result.seconds[i];
  if (pictures != nullptr) {
    pictures->Add(ReadingPicture(set, text.script, text.set.style, options.blank,
                                 TextOf(text, page), result));
  }
  result.path.clear();
  result.path.shrink_to_fit();
  reading.pages.push_back(std::move(result));
}

bool IsBraille(const Reading& reading) { return !reading.text.script.braille_tables.empty(); }

std::string WholeText(const Reading& reading) {
  std::string text;
  for (const ReadingResult& page : reading.pages)
    text += TextRead(page.tokens, reading.text.script);
  return text;
}

/// What cells that were read say in print, a line each; what was not known parts them.
std::string InPrint(const std::string& cells, const TextSetup& text) {
  BrailleReader reader(text.script, text.set.style);
  std::string print;
  std::vector<std::uint8_t> run;
  const auto end_run = [&] {
    print += reader.Read(run);
    run.clear();
  };
  for (const char32_t c : ToCodePoints(cells)) {
    const bool cell = c >= kFirstCell && c < kFirstCell + 0x100;
    if (cell || c == ' ') {
      run.push_back(cell ? static_cast<std::uint8_t>(c - kFirstCell) : 0);
    } else {
      end_run();
      print += ToUtf8(c);
    }
  }
  end_run();
  return print;
}

/// By what the hand was at; all but its rest at the end.
Json SecondsJson(const std::array<double, kReaderActivities>& seconds) {
  const auto of = [&seconds](ReaderActivity activity) {
    return seconds[static_cast<std::size_t>(activity)];
  };
  return {
      {"flying", of(ReaderActivity::kFlying)},       {"searching", of(ReaderActivity::kSearching)},
      {"crossing", of(ReaderActivity::kCrossing)},   {"settling", of(ReaderActivity::kSettling)},
      {"following", of(ReaderActivity::kFollowing)}, {"turning", of(ReaderActivity::kTurning)},
      {"hatching", of(ReaderActivity::kHatching)}};
}

Json ReadingJson(const Reading& reading, const RecogniseOptions& options) {
  const ReadingScore& score = reading.score;
  Json json;
  json["text"] = WholeText(reading);
  if (IsBraille(reading)) json["print"] = InPrint(WholeText(reading), reading.text);
  json["right"] = score.right;
  json["wrong"] = score.wrong;
  json["missed"] = score.missed;
  json["extra"] = score.extra;
  json["signs"] = score.signs;
  json["signs_right"] = score.signs_right;
  json["seconds_per_sign"] =
      score.signs > 0 ? OrNull(reading.duration / static_cast<double>(score.signs)) : Json();
  json["seconds"] = SecondsJson(reading.seconds);
  json["real_time_factor"] = reading.duration / std::max(reading.elapsed, 1e-9);
  json["duration_s"] = reading.duration;
  json["ended"] = std::all_of(reading.pages.begin(), reading.pages.end(),
                              [](const ReadingResult& page) { return page.ended; });
  json["simulated"] = true;
  json["device"] = reading.device ? Json(reading.device->name) : Json();
  json["unsure_mm"] = kMillimetres * options.unsure.value_or(0);
  json["through"] = std::accumulate(
      reading.pages.begin(), reading.pages.end(), std::size_t{0},
      [](std::size_t sum, const ReadingResult& page) { return sum + page.through; });
  json["seed"] = options.seed;
  json["size_mm"] = kMillimetres * reading.text.set.style.size;
  json["pictures"] = reading.pictures;
  json["read"] = Json::array();
  for (std::size_t page = 0; page < reading.pages.size(); ++page) {
    for (const ReadToken& token : reading.pages[page].tokens) {
      const bool known = token.kind == ReadToken::Kind::kSign;
      if (!known && token.kind != ReadToken::Kind::kUnknown) continue;
      json["read"].push_back(
          {{"sign", known ? Json(reading.text.script.glyphs[token.glyph].name) : Json()},
           {"probability", token.probability},
           {"time_s", token.time},
           {"page", page}});
    }
  }
  return json;
}

void SayLines(const std::string& text, Console& console) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) console.Result(line);
}

void SayReading(const Reading& reading, Console& console) {
  const ReadingScore& score = reading.score;
  const std::string text = WholeText(reading);
  if (text.empty()) {
    console.Result(say::NothingRead(reading.duration));
  } else {
    console.Result(say::ReadingOutcome(score));
    console.Result(say::ReadingTime(score, reading.duration,
                                    reading.duration / std::max(reading.elapsed, 1e-9)));
    const std::string confusions = say::Confusions(score, reading.text.script);
    if (!confusions.empty()) console.Result(confusions);
    console.Result(say::AsRead());
    SayLines(text, console);
    if (IsBraille(reading)) {
      console.Result(say::InPrint());
      SayLines(InPrint(text, reading.text), console);
    }
  }
  if (!reading.pictures.empty()) console.Result(say::PictureIn());
  for (const std::string& path : reading.pictures) console.Path(path);
}

}  // namespace

void AddOptions(CLI::App& app, RecogniseOptions& options) {
  AddOptions(app, options.text);
  AddOptions(app, options.style);
  AddOptions(app, options.layout);
  AddOptions(app, options.feel);
  BeginGroup(app, help_group::kHand);
  AddNumber(app, "--press-n", options.press, 0.01, 20, 1, say::help::kPress);
  Redescribe(app, "--press-n", say::help::kReaderPress);
  AddSeed(app, options.seed);
  Redescribe(app, "--seed", say::help::kReaderSeed);
  AddPath(app, "--device", "NAME", options.device, say::help::kReaderDevice);
  AddNumber(app, "--unsure-mm", options.unsure, 0, 20, 1e-3, say::help::kReaderUnsure);
  AddFlag(app, "--blank", options.blank, say::help::kReaderBlank);
  BeginGroup(app, help_group::kResults);
  AddPicture(app, options.picture, say::help::kPicture);
  AddOptions(app, options.output);
}

namespace {

int ReadLabel(const RecogniseOptions& options, Console& console) {
  if (!options.picture.empty()) CheckPicturePath(options.picture);
  Reading reading;
  if (!options.device.empty()) reading.device = FindProfile(options.device, ProfilesFolder());
  LayoutOptions layout = options.layout;
  if (reading.device && !layout.page_named) layout.page = SheetWithin(reading.device->limits);
  reading.text =
      SetUpText({options.text, options.style, layout, options.feel, "recognise"}, console);
  SayReplacements(reading.text.set, [&console](const std::string& line) { console.Remark(line); });
  const bool followed = IsFollowed(reading.text.set.style.relief, reading.text.script);
  if (reading.device && !CanBeReadOn(reading.device->limits, followed)) {
    throw InputError(say::ReadsWhereLettersAreFelt(options.device, followed));
  }
  if (reading.text.set.style.links.reach != LinkReach::kNone) throw UsageError(say::ReadsNoLinks());
  const auto shapes =
      KnownShapes(reading.text.script, reading.text.set.style.relief, reading.text.set.pages);
  const std::size_t pages = reading.text.set.pages.size();
  std::optional<PagePictures> pictures;
  if (!options.picture.empty()) pictures.emplace(options.picture, pages);
  for (std::size_t page = 0; page < pages; ++page) {
    ReadPage(options, page, shapes, pictures ? &*pictures : nullptr, console, reading);
  }
  if (pictures) reading.pictures = pictures->Finish();
  if (options.output.json) {
    console.Json(Dump(ReadingJson(reading, options)));
  } else {
    SayReading(reading, console);
  }
  return exit_code::kGood;
}

}  // namespace

int Run(const RecogniseOptions& options, Console& console) {
  RecogniseOptions chosen = options;
  ChooseLabel(chosen.feel);
  return ReadLabel(chosen, console);
}

}  // namespace moontrace
