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
#include "sim/console/wording.h"
#include "sim/picture/picture_file.h"
#include "sim/reading/read_text.h"
#include "sim/reading/reading_run.h"
#include "sim/reading/reading_setup.h"
#include "sim/recognise/reading_picture.h"
#include "sim/recognise/reading_view.h"
#include "sim/recognise/recognise_messages.h"
#include "sim/session/view_feed.h"
#include "sim/session/view_messages.h"
#include "sim/session/view_trial.h"
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
  setup.hand.press = options.press.value_or(ReadingPress(setup.hand, style, text.script));
  setup.press_given = options.press.has_value();
  CompleteSetup(setup, shapes, text.script, style, options.seed + page * 0x9e3779b9u);
  if (!options.picture.empty()) setup.path_spacing = style.width / 20;
  setup.stop = console.stop();
  return setup;
}

/// The page's reading is seen while it goes on.
void Watch(ReadingSetup& setup, TrialView& view, const RecogniseOptions& options,
           const TextSetup& text, std::size_t page,
           const std::shared_ptr<const TextureField>& field) {
  const auto reader = std::make_shared<const PageReader*>(nullptr);
  const auto complete = [reader, shapes = setup.knowledge.shapes, &text](TrialTexts& texts) {
    texts.reading = ReadingTexts(**reader, *shapes, text.script);
  };
  view.Begin(MakeViewPage(text.set, page, text.script, text.text, field, options.blank,
                          static_cast<std::uint32_t>(page)),
             {text.text,
              text.set.style.size,
              say::PanelPage(page, text.set.pages.size()),
              {},
              TrialTexts::Reading()},
             complete);
  setup.watch = [&view, reader](const ReadingTick& tick) {
    *reader = &tick.reader;
    view.Look(tick.time, tick.felt, {}, tick.scene);
  };
}

/// What is shown of a reading while it goes on and afterwards; null without.
struct Shown {
  TrialView* view = nullptr;
  PagePictures* pictures = nullptr;
};

void ReadPage(const RecogniseOptions& options, std::size_t page,
              const std::shared_ptr<const SignShapes>& shapes, const Shown& shown, Console& console,
              Reading& reading) {
  const TextSetup& text = reading.text;
  const TextPage& set = text.set.pages[page];
  const auto field = std::make_shared<const TextureField>(
      PageField(set, text.script, text.set.style, options.blank));
  ReadingSetup setup = SetupOf(options, reading, page, shapes, *field, console);
  if (page == 0) {
    // done as asked, with a warning where the hand cannot hold it quiet
    const auto buzz = BuzzOfDirect(setup.scene, *field, setup.hand, setup.hand.press);
    if (buzz) console.Remark(say::DirectWillBuzz(*buzz));
  }
  if (shown.view != nullptr) Watch(setup, *shown.view, options, text, page, field);
  const double done = static_cast<double>(page) / static_cast<double>(text.set.pages.size());
  setup.alive = [&console, done] { console.Alive(done); };
  ReadingResult result = RunReading(setup);
  if (result.through > 0) console.Remark(say::ReaderPressedThrough(page, result.through));
  const bool by_user = console.stop() != nullptr && *console.stop();
  if (!result.ended && !by_user) console.Remark(say::ReaderStopped(page));
  reading.score += Compare(options.blank ? std::vector<int>() : MarksOf(set, text.script),
                           MarksOf(result.tokens, text.script));
  reading.duration += result.duration;
  reading.elapsed += result.duration / result.real_time_factor;
  for (std::size_t i = 0; i < kReaderActivities; ++i) reading.seconds[i] += result.seconds[i];
  if (shown.pictures != nullptr) {
    shown.pictures->Add(ReadingPicture(set, text.script, text.set.style, options.blank,
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
  const Script& script = reading.text.script;
  for (std::size_t page = 0; page < reading.pages.size(); ++page) {
    const std::vector<ReadToken>& tokens = reading.pages[page].tokens;
    const std::vector<int> marks = MarksOf(tokens, script);  // a sign's forms by their plain form
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      const ReadToken& token = tokens[i];
      const bool known = token.kind == ReadToken::Kind::kSign;
      if (!known && token.kind != ReadToken::Kind::kUnknown) continue;
      const auto sign = static_cast<std::size_t>(marks[i]);
      json["read"].push_back({{"sign", known ? Json(script.glyphs[sign].name) : Json()},
                              {"probability", token.probability},
                              {"time_s", token.time},
                              {"page", page}});
    }
  }
  return json;
}

void SayLines(const std::string& text, Console& console) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) console.Result(say::Spoken(line));
}

void SayReading(const Reading& reading, Console& console) {
  const ReadingScore& score = reading.score;
  const std::string text = WholeText(reading);
  if (text.empty()) {
    console.Result(say::NothingRead(reading.duration, score.signs));
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
  AddOptions(app, options.view);
  AddCamera(app, options.view);
  AddOptions(app, options.output);
}

namespace {

/// Whether signs of a line stand so far apart that the reader may take the line for ended. Of gaps
/// beyond a space and of spaces that it finds its way over: tried on seeds 1 to 4.
bool HasWideGaps(const TextSetup& text, bool followed) {
  constexpr std::size_t kSetIn = 4;          // spaces before a line
  const double most = followed ? 0.6 : 0.3;  // [em]
  const std::string wide(followed ? 3 : 2, ' ');
  const TypeStyle& style = text.set.style;
  if (style.letter_gap + style.word_gap > most * style.size) return true;
  std::istringstream lines(text.text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t from = followed ? std::min(line.find_first_not_of(' '), line.size()) : 0;
    if (from > kSetIn && from < line.size()) return true;
    if (line.find(wide, from) < line.find_last_not_of(' ') + 1) return true;
  }
  return false;
}

void SayWhatIsHard(const TextSetup& text, bool followed, Console& console) {
  if (HasWideGaps(text, followed)) console.Remark(say::ReaderMissesWideGaps());
  const TypeStyle& style = text.set.style;
  if (followed || style.lines == LineDirection::kLeftToRight) return;
  if (style.lines == LineDirection::kAlternate) {
    console.Remark(say::ReaderFollowsNoGuides());
  } else if (style.links.reach != LinkReach::kNone) {
    console.Remark(say::ReaderKnowsLinksToTheRight());
  }
}

int ReadLabel(const RecogniseOptions& options, Console& console) {
  if (!options.picture.empty()) CheckPicturePath(options.picture);
  Reading reading;
  if (!options.device.empty()) reading.device = FindProfile(options.device, ProfilesFolder());
  LayoutOptions layout = options.layout;
  if (reading.device && !layout.page_named) layout.page = SheetWithin(reading.device->limits);
  reading.text =
      SetUpText({options.text, options.style, layout, options.feel, "recognise"}, console);
  SayReplacements(reading.text.set, [&console](const std::string& line) { console.Remark(line); });
  const bool followed = IsFollowed(reading.text.set.style, reading.text.script);
  SayWhatIsHard(reading.text, followed, console);
  if (reading.device && !CanBeReadOn(reading.device->limits, followed)) {
    throw InputError(say::ReadsWhereLettersAreFelt(options.device, followed));
  }
  const std::unique_ptr<ViewFeed> feed = ViewFeed::OpenOfTrial(options.view, console);
  std::optional<TrialView> view;
  if (feed) view.emplace(*feed, console, ReadingPanel());
  if (view && !options.feel.model.empty()) view->ShowModel(reading.text.others);
  const auto shapes = KnownShapes(reading.text.script, reading.text.set.pages);
  const std::size_t pages = reading.text.set.pages.size();
  std::optional<PagePictures> pictures;
  if (!options.picture.empty()) pictures.emplace(options.picture, pages);
  for (std::size_t page = 0; page < pages; ++page) {
    ReadPage(options, page, shapes, {view ? &*view : nullptr, pictures ? &*pictures : nullptr},
             console, reading);
  }
  if (pictures) reading.pictures = pictures->Finish();
  if (options.output.json) {
    Json json = ReadingJson(reading, options);
    if (feed) json["view"] = ViewJson(*feed);
    console.Json(Dump(json));
  } else {
    SayReading(reading, console);
    if (feed) SayView(*feed, options.view, console);
  }
  if (feed) RequireView(*feed, {});
  return exit_code::kGood;
}

}  // namespace

int Run(const RecogniseOptions& options, Console& console) {
  CheckCamera(options.view, options.feel.model);
  CheckTogether(options.view);
  RecogniseOptions chosen = options;
  ChooseLabel(chosen.feel);
  return ReadLabel(chosen, console);
}

}  // namespace moontrace
