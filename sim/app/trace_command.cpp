#include "sim/app/trace_command.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "devices/simulated_stylus.h"
#include "sim/app/help.h"
#include "sim/app/messages.h"
#include "sim/app/trial.h"
#include "sim/app/trial_parameters.h"
#include "sim/app/typeset_report.h"
#include "sim/scene/scene.h"
#include "sim/view/picture_file.h"
#include "sim/view/trace_picture.h"
#include "textures/error.h"
#include "textures/text_file.h"

namespace moontrace {

namespace {

/// Bounds time and memory: about five hours of hand time.
constexpr std::size_t kMostSigns = 20000;

/// Everything traced, before it is told.
struct Trace {
  std::string text;
  std::string script_name;
  Script script;
  Typeset set;
  std::vector<TrialResult> pages;
  std::vector<std::string> pictures, records;
};

/// What a model gives for the text: its first label, and the room on that label's geom.
struct ModelPage {
  Label label;
  glm::dvec2 extent{0, 0};  ///< [m]
};
std::optional<ModelPage> PageOfModel(const FeelOptions& feel) {
  if (feel.model.empty()) return std::nullopt;
  const Scene scene = Scene::Load(feel.model, feel.scene);
  return ModelPage{scene.labels().front(), scene.page_extent()};
}

/// The sheet cut to the geom that carries it. A margin made for paper would leave no room on a mug.
PageSpec CutTo(glm::dvec2 extent, PageSpec sheet, bool margin_given) {
  constexpr double kLabelMargin = 0.001;  // [m]
  const bool cut = extent.x < sheet.width || extent.y < sheet.height;
  if (cut && !margin_given) sheet.margin = kLabelMargin;
  sheet.width = std::min(sheet.width, extent.x);
  sheet.height = std::min(sheet.height, extent.y);
  return sheet;
}

/// Text, script and pages; what the command line leaves open comes from the model's first label.
Trace SetUp(const TraceOptions& options, Console& console) {
  const std::optional<ModelPage> model = PageOfModel(options.feel);
  const Label* from = model ? &model->label : nullptr;
  Trace trace;
  const bool given = options.text.text || !options.text.file.empty();
  trace.text = !given && from != nullptr && !from->text.empty()
                   ? from->text
                   : ReadText(options.text, "trace", console);
  trace.script = ScriptOf(options.style, from);
  trace.script_name = options.style.script.value_or(
      from != nullptr && from->script ? *from->script : trace.script.name);
  const TypeStyle style = StyleOf(options.style, options.layout, trace.script, from);
  PageSpec sheet = PageOf(options.layout);
  if (model) sheet = CutTo(model->extent, sheet, options.layout.margin.has_value());
  trace.set = SetText(trace.text, trace.script, style, sheet);
  const std::size_t signs = CountSigns(trace.set);
  if (signs > kMostSigns) throw InputError(say::TooLong(signs, kMostSigns));
  return trace;
}

TrialSetup SetupOf(const TraceOptions& options, const Trace& trace, std::size_t page,
                   Console& console) {
  TrialSetup setup;
  setup.script = &trace.script;
  setup.page = &trace.set.pages[page];
  setup.style = trace.set.style;
  setup.blank = options.blank;
  setup.model_path = options.feel.model;
  setup.scene = options.feel.scene;
  setup.hand = ShippedHand();
  const bool embossed = trace.set.style.relief == Relief::kEmbossed;
  setup.plan.press = options.press.value_or(embossed ? setup.hand.light_press : setup.hand.press);
  setup.plan.speed = options.speed.value_or(setup.plan.speed);
  setup.seed = options.seed;
  if (!options.picture.empty()) setup.path_spacing = trace.set.style.width / 20;
  setup.stop = console.stop();
  const auto pages = static_cast<double>(trace.set.pages.size());
  setup.alive = [&console, page, pages](double done) {
    console.Alive((static_cast<double>(page) + done) / pages);
  };
  return setup;
}

/// The text that one page carries, on one line.
std::string TextOf(const Trace& trace, std::size_t page) {
  const std::vector<PlacedGlyph>& glyphs = trace.set.pages[page].glyphs;
  if (glyphs.empty()) return {};
  const std::size_t begin = glyphs.front().source_begin;
  return OneLine(std::string_view(trace.text).substr(begin, glyphs.back().source_end - begin));
}

void TracePage(const TraceOptions& options, std::size_t page, Console& console, Trace& trace) {
  const std::size_t pages = trace.set.pages.size();
  const TrialSetup setup = SetupOf(options, trace, page, console);
  RecordRequest request;
  if (!options.record.empty()) {
    request.folder = pages == 1 ? options.record : options.record + "-" + std::to_string(page + 1);
    request.also_csv = options.csv;
    request.parameters_json = ParametersJson(
        {trace.text, trace.script_name, trace.set.style, trace.set.page, page, options.blank},
        setup);
  }
  TrialResult result = RunTrial(setup, options.record.empty() ? nullptr : &request);
  if (page == 0) {
    for (const std::string& remark : result.remarks) console.Remark(remark);
  }
  if (!options.record.empty()) trace.records.push_back(request.folder);
  if (!options.picture.empty()) {
    trace.pictures.push_back(PicturePath(options.picture, page, pages));
    WritePicture(trace.pictures.back(), TracePicture(*setup.page, trace.script, setup.style,
                                                     options.blank, TextOf(trace, page), result));
    result.path.clear();
    result.path.shrink_to_fit();
  }
  trace.pages.push_back(std::move(result));
}

/// `direct` is done as asked, and said to be beyond what the hand holds where it is.
void WarnOfDirect(const TraceOptions& options, const Trace& trace, Console& console) {
  if (options.feel.scene.rendering != Rendering::kDirect) return;
  const TextureField field =
      PageField(trace.set.pages.front(), trace.script, trace.set.style, options.blank);
  const TrialSetup setup = SetupOf(options, trace, 0, console);
  const auto stylus =
      MakeSimulatedStylus(setup.hand, {{HandPoint{}}}, setup.scene.tick, setup.seed);
  const DirectBound bound = BoundOfDirect(field, setup.scene.surface, setup.plan.press,
                                          stylus->Limits(), setup.scene.tick);
  if (!bound.Holds()) console.Remark(say::DirectWillBuzz(bound));
}

std::string_view SourceOf(const Trace& trace, const PlacedGlyph& glyph) {
  return std::string_view(trace.text)
      .substr(glyph.source_begin, glyph.source_end - glyph.source_begin);
}

Json TraceJson(const TraceOptions& options, const Trace& trace, const TrialResult& all) {
  Json json = TypesetJson(trace.set, trace.script);
  json["text"] = trace.text;
  json["rendering"] = options.feel.scene.rendering == Rendering::kProxy ? "proxy" : "direct";
  json["law"] = options.feel.scene.surface.law == ForceLaw::kPotential ? "potential" : "paper";
  json["blank"] = options.blank;
  json["seed"] = options.seed;
  json["pages"] = trace.pages.size();
  json["pictures"] = trace.pictures;
  json["records"] = trace.records;
  json["letters"] = Json::array();
  for (std::size_t p = 0; p < trace.pages.size(); ++p) {
    const std::vector<PlacedGlyph>& glyphs = trace.set.pages[p].glyphs;
    for (std::size_t i = 0; i < glyphs.size(); ++i) {
      Json letter = {{"glyph", trace.script.glyphs[glyphs[i].glyph].name},
                     {"text", SourceOf(trace, glyphs[i])},
                     {"page", p}};
      letter.update(MetricsJson(trace.pages[p].score.letters[i]));
      json["letters"].push_back(std::move(letter));
    }
  }
  json["total"] = TotalJson(all, true);
  return json;
}

/// The letter that was covered least, if any was missed in part.
void SayWeakest(const Trace& trace, Console& console) {
  double least = 1;
  std::size_t number = 0, weakest = 0;
  std::string_view text;
  for (std::size_t p = 0; p < trace.pages.size(); ++p) {
    const std::vector<PlacedGlyph>& glyphs = trace.set.pages[p].glyphs;
    for (std::size_t i = 0; i < glyphs.size(); ++i) {
      ++number;
      const double coverage = trace.pages[p].score.letters[i].coverage;
      if (coverage >= least) continue;
      least = coverage;
      weakest = number;
      // The numeral sign stands for no character of the text: its name tells it.
      text = SourceOf(trace, glyphs[i]);
      if (text.empty()) text = trace.script.glyphs[glyphs[i].glyph].name;
    }
  }
  if (weakest > 0) console.Result(say::WeakestLetter(text, weakest, least));
}

void SayTrace(const TraceOptions& options, const Trace& trace, const TrialResult& all,
              Console& console) {
  const TraceMetrics& total = all.score.total;
  const TypeStyle& style = trace.set.style;
  console.Result(say::TraceOutcome(all, CountSigns(trace.set), options.blank));
  console.Result(say::MeanError(total, style));
  console.Result(say::WorstError(total));
  console.Result(say::LeftGroove(total, style));
  SayWeakest(trace, console);
  console.Result(say::Force(total));
  console.Result(say::ForceBound(all));
  console.Result(say::Energy(all));
  console.Result(say::Time(all));
  if (!trace.pictures.empty()) console.Result(say::PictureIn());
  for (const std::string& path : trace.pictures) console.Path(path);
  if (!trace.records.empty()) console.Result(say::RecordIn());
  for (const std::string& path : trace.records) console.Path(path);
}

}  // namespace

void AddOptions(CLI::App& app, TraceOptions& options) {
  AddOptions(app, options.text);
  AddOptions(app, options.style);
  AddOptions(app, options.layout);
  AddOptions(app, options.feel);
  AddNumber(app, "--press-n", options.press, 0.01, 20, 1, say::help::kPress);
  AddNumber(app, "--speed-mm-s", options.speed, 0.1, 1000, 1e-3, say::help::kSpeed);
  AddSeed(app, options.seed);
  app.add_flag("--blank", options.blank, say::help::kBlank);
  AddPath(app, "--record", "DIR", options.record, say::help::kRecord);
  app.add_flag("--csv", options.csv, say::help::kCsv);
  AddPath(app, "--picture", "FILE", options.picture, say::help::kPicture);
  AddOptions(app, options.output);
}

int Run(const TraceOptions& options, Console& console) {
  if (options.csv && options.record.empty()) {
    throw UsageError(say::NeedsOther("--csv", "--record"));
  }
  if (!options.picture.empty()) CheckPicturePath(options.picture);
  Trace trace = SetUp(options, console);
  SayReplacements(trace.set, [&console](const std::string& line) { console.Remark(line); });
  WarnOfDirect(options, trace, console);
  for (std::size_t page = 0; page < trace.set.pages.size(); ++page) {
    TracePage(options, page, console, trace);
  }
  if (trace.set.style.relief == Relief::kEmbossed && !options.blank) {
    console.Remark(say::RidgesPushAside());
  }
  if (options.feel.scene.friction > 0.1) {
    console.Remark(say::FrictionHampers(options.feel.scene.friction));
  }
  const TrialResult all = Merged(trace.pages);
  if (options.output.json) {
    console.Json(Dump(TraceJson(options, trace, all)));
  } else {
    SayTrace(options, trace, all, console);
  }
  if (all.faults > 0) throw WorkFailed(say::Faults(all));
  return exit_code::kGood;
}

}  // namespace moontrace
