#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <sstream>
#include <utility>

#include "devices/catalogue/catalogue.h"
#include "sim/app/commands.h"
#include "sim/app/messages.h"
#include "sim/app/reading_picture.h"
#include "sim/app/recognise_messages.h"
#include "sim/picture/picture_file.h"
#include "sim/reading/read_text.h"
#include "sim/reading/reading_run.h"
#include "sim/setup/cli_app.h"
#include "sim/setup/help.h"
#include "sim/setup/text_setup.h"
#include "sim/setup/text_trial.h"
#include "sim/setup/typeset_report.h"
#include "textures/base/error.h"
#include "textures/base/random.h"
#include "textures/base/units.h"

namespace moontrace {
namespace {

/// All pages of a text, as they were read.
struct Reading {
  TextSetup text;
  std::vector<ReadingResult> pages;
  ReadingScore score;
  std::optional<DeviceProfile> device;
  double duration = 0, elapsed = 0;  ///< [s], simulated and not
  std::vector<std::string> pictures;
};

constexpr double kGreatestTurn = 3 * kDegree;
/// The hand is put on the text's upper left corner, to within so many sizes.
constexpr double kPutWithin = 0.5;

/// A profile that gives a reader depth, and pushes it back.
DeviceProfile ReadableProfile(const std::string& name) {
  DeviceProfile profile = FindProfile(name, ProfilesFolder());
  const DeviceLimits& limits = profile.limits;
  if (!glm::all(limits.measures) || !glm::all(limits.pushes)) {
    throw InputError(say::ReadsOnThreeAxesOnly(name));
  }
  return profile;
}

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
  setup.scene = options.feel.scene;
  setup.device = reading.device;
  setup.senses.unsure = options.unsure.value_or(0);
  setup.hand = ShippedHand();
  PlanOptions plan;
  SetPress(setup.hand, style.relief, options.press, plan);
  setup.hand.press = plan.press;
  setup.knowledge = KnowledgeOf(shapes, text.script, setup.hand, setup.muscle, setup.senses);
  setup.knowledge.width = style.width;
  setup.knowledge.depth = style.depth;
  setup.knowledge.device_stiffness = setup.scene.rendering == Rendering::kProxy
                                         ? setup.scene.coupling_stiffness
                                         : std::numeric_limits<double>::infinity();
  Random random(options.seed + page * 0x9e3779b9u);
  setup.hand_seed = random.Bits();
  setup.reader_seed = random.Bits();
  setup.knowledge.least_size = style.size * std::exp2(-random.Uniform());
  setup.knowledge.greatest_size = 2 * setup.knowledge.least_size;
  setup.page_turn = kGreatestTurn * (2 * random.Uniform() - 1);
  const Box& area = setup.page->text_area_P;
  const glm::dvec2 off(2 * random.Uniform() - 1, 2 * random.Uniform() - 1);
  setup.start_P = glm::dvec2(area.min.x, area.max.y) + kPutWithin * style.size * off;
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
  if (pictures != nullptr) {
    pictures->Add(ReadingPicture(set, text.script, text.set.style, options.blank,
                                 TextOf(text, page), result));
  }
  result.path.clear();
  result.path.shrink_to_fit();
  reading.pages.push_back(std::move(result));
}

std::string WholeText(const Reading& reading) {
  std::string text;
  for (const ReadingResult& page : reading.pages)
    text += TextRead(page.tokens, reading.text.script);
  return text;
}

Json ReadingJson(const Reading& reading, const RecogniseOptions& options) {
  const ReadingScore& score = reading.score;
  Json json;
  json["text"] = WholeText(reading);
  json["right"] = score.right;
  json["wrong"] = score.wrong;
  json["missed"] = score.missed;
  json["extra"] = score.extra;
  json["signs"] = score.signs;
  json["signs_right"] = score.signs_right;
  json["seconds_per_sign"] =
      score.signs > 0 ? OrNull(reading.duration / static_cast<double>(score.signs)) : Json();
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
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) console.Result(line);
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
  AddSeed(app, options.seed);
  Redescribe(app, "--seed", say::help::kReaderSeed);
  AddPath(app, "--device", "NAME", options.device, say::help::kReaderDevice);
  AddNumber(app, "--unsure-mm", options.unsure, 0, 20, 1e-3, say::help::kReaderUnsure);
  AddFlag(app, "--blank", options.blank, say::help::kReaderBlank);
  BeginGroup(app, help_group::kResults);
  AddPicture(app, options.picture, say::help::kPicture);
  AddOptions(app, options.output);
}

int Run(const RecogniseOptions& options, Console& console) {
  if (!options.picture.empty()) CheckPicturePath(options.picture);
  Reading reading;
  reading.text =
      SetUpText({options.text, options.style, options.layout, options.feel, "recognise"}, console);
  SayReplacements(reading.text.set, [&console](const std::string& line) { console.Remark(line); });
  if (reading.text.set.style.relief == Relief::kEmbossed) {
    throw UsageError(say::ReadsGroovesOnly());
  }
  if (!options.device.empty()) reading.device = ReadableProfile(options.device);
  const Script& script = reading.text.script;
  const auto shapes = std::make_shared<const SignShapes>(script, WrittenGlyphs(script));
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

}  // namespace moontrace
