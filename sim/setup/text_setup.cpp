#include "sim/setup/text_setup.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "lessons/measure/intended_strokes.h"
#include "sim/console/wording.h"
#include "sim/physics/page_field.h"
#include "sim/setup/fitted_sheet.h"
#include "sim/setup/link_options.h"
#include "sim/setup/model_messages.h"
#include "sim/setup/setup_messages.h"
#include "sim/setup/typeset_report.h"
#include "textures/base/error.h"
#include "textures/base/nearest_word.h"
#include "textures/base/text_file.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

namespace {

/// Bounds time and memory: about five hours of hand time.
constexpr std::size_t kMostSigns = 20000;

/// None: no model was named, the shipped page lies there.
std::optional<ModelPage> ModelPageFor(const TextRequest& request) {
  if (request.feel.model.empty()) return std::nullopt;
  if (request.model_page) return request.model_page;
  return ModelPageOf(Scene::Load(request.feel.model, request.feel.scene));
}

/// The sheet cut to what carries it, a geom or a device's reach. A margin made for paper would
/// leave no room on a mug.
PageSpec CutTo(glm::dvec2 extent, PageSpec sheet, double margin, bool margin_given) {
  const bool cut = extent.x < sheet.width || extent.y < sheet.height;
  if (!cut) return sheet;
  if (!margin_given) sheet.margin = std::min(sheet.margin, margin);
  sheet.width = std::min(sheet.width, extent.x);
  sheet.height = std::min(sheet.height, extent.y);
  return sheet;
}

/// The sheet that a model's geom carries; a remark says where the one asked for is larger.
PageSpec OnGeom(const ModelPage& model, const PageSpec& asked, bool margin_given,
                Console& console) {
  // A plane goes on beyond its edge; elsewhere a pressed tip slips off near it.
  constexpr double kOnPlane = 0.001, kByAnEdge = 0.003;  // [m]
  const Solid& solid = model.solids[model.number];
  const double margin = solid.kind == SolidKind::kPlane ? kOnPlane : kByAnEdge;
  PageSpec sheet = CutTo(ExtentOf(model.label(), solid), asked, margin, margin_given);
  if (sheet.width == asked.width && sheet.height == asked.height) return sheet;
  sheet.name = "model";
  if (asked.name != LayoutOptions().page.name) {
    console.Remark(say::GeomIsSmaller(model.label().geom, sheet));
  }
  return sheet;
}

/// From the command line, otherwise the label, otherwise the command.
std::string TextFor(const TextRequest& request, const Label* label, Console& console) {
  const bool given = request.text.text || !request.text.file.empty();
  if (!given && label != nullptr && !label->text.empty()) return label->text;
  if (!given && !request.default_text.empty()) return request.default_text;
  if (!given && label != nullptr) {
    throw InputError(say::LabelLacksText(request.feel.model, label->geom));
  }
  return ReadText(request.text, request.command, console);  // or says that there is none
}

/// What is wrong with a text as a label alone asks for it; empty: nothing.
std::string WrongIn(const std::string& text, const Label& label, const PageSpec& sheet) {
  try {
    Script script = ScriptOf({}, &label);
    const TypeStyle style = StyleOf({}, {}, script, &label);
    SetText(text, script, style, sheet);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// Sets it in the style that command line, form and label ask for; what a label asks for by itself
/// and cannot have is the model's mistake.
void SetInStyle(const TextRequest& request, const Label* label, const PageSpec& sheet,
                TextSetup& setup) {
  StyleOptions letters = request.style;
  LayoutOptions layout = request.layout;
  try {
    if (request.form) ApplyForm(*request.form, setup.script, label, letters, layout);
    const TypeStyle style = StyleOf(letters, layout, setup.script, label);
    setup.set = SetText(setup.text, setup.script, style, sheet);
  } catch (const InputError& error) {
    const std::string what = error.what();
    if (label == nullptr || WrongIn(setup.text, *label, sheet) != what) throw;
    if (label->text != setup.text && WrongIn(setup.text, Label(), sheet) == what) throw;
    throw InputError(say::InLabel(request.feel.model, NameOf(*label), what));
  }
}

/// The script to use; a wrong one named by the label is reported as the model's mistake.
Script ScriptFor(const TextRequest& request, const Label* label) {
  const bool of_label = label != nullptr && label->script && !request.style.script;
  if (!of_label) return ScriptOf(request.style, label);
  try {
    return ScriptOf(request.style, label);
  } catch (const InputError& error) {
    throw InputError(say::InLabel(request.feel.model, NameOf(*label), error.what()));
  }
}

}  // namespace

ModelPage ModelPageOf(const Scene& scene) {
  return {scene.options().label, scene.labels(), scene.solids(), scene.page_goes()};
}

namespace {

/// A label whose text may be no larger than what it lies on: all but a page's corner on a flat
/// face, from which a text goes on over pages.
bool IsOnePage(const ModelPage& model, std::size_t number) {
  const Label& label = model.labels[number];
  const Face face = label.face.value_or(UsualFace(model.solids[number]));
  return label.middle || face == Face::kRound || number != model.number;
}

void CheckRoom(const std::string& file, const ModelPage& model, std::size_t number,
               const Typeset& set, const Box& text_P) {
  constexpr double kEdge = 0.0015;  // [m]: nearer a tip that is pressed slips off
  const Label& label = model.labels[number];
  if (!IsOnePage(model, number) || !(text_P.min.x <= text_P.max.x)) return;
  if (set.pages.size() > 1 || !HasRoom(label, model.solids[number], Grown(text_P, kEdge))) {
    throw InputError(say::LabelHasNoRoom(file, NameOf(label), set.style.size,
                                         text_P.max - text_P.min, set.pages.size()));
  }
}

/// A text on a sheet of its own, without what a command asks for.
TextSetup SetOn(const TextRequest& request, const ModelPage* model, Console& console);

/// The other labels of a model, set as they ask for; none may lie on another.
std::vector<LaidLabel> OthersOf(const FeelOptions& feel, const ModelPage& model, const Box& page_P,
                                Console& console) {
  std::vector<LaidLabel> laid;
  for (std::size_t i = 0; i < model.labels.size(); ++i) {
    if (i == model.number || model.labels[i].text.empty()) continue;
    ModelPage other = model;
    other.number = i;
    other.moves = false;
    TextRequest request;
    request.feel = feel;
    request.command = "label";
    const TextSetup text = SetOn(request, &other, console);
    const TextPage& page = text.set.pages.front();
    const Box text_P = TextBox(page, text.script, text.set.style);
    CheckRoom(feel.model, model, i, text.set, text_P);
    laid.push_back(
        {i,
         std::make_shared<const TextureField>(PageField(page, text.script, text.set.style, false)),
         text_P});
  }
  std::vector<LaidLabel> all = laid;
  all.push_back({model.number, nullptr, page_P});
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const Label &one = model.labels[all[a].label], &two = model.labels[all[b].label];
      if (!LieTogether(one, all[a].text_P, two, all[b].text_P, model.solids[all[a].label]))
        continue;
      throw InputError(say::LabelsLieTogether(feel.model, NameOf(two), NameOf(one)));
    }
  }
  return laid;
}

TextSetup SetOn(const TextRequest& request, const ModelPage* model, Console& console) {
  constexpr double kDeviceMargin = 0.005;  // [m], from where the device strikes its own stops
  const Label* from = model != nullptr ? &model->label() : nullptr;
  if (model != nullptr && model->moves) console.Remark(say::PageMoves(model->label().geom));
  TextSetup setup;
  setup.text = TextFor(request, from, console);
  setup.script = ScriptFor(request, from);
  for (const std::string& remark : setup.script.remarks) console.Remark(remark);
  setup.script_name = request.style.script.value_or(
      from != nullptr && from->script ? *from->script : setup.script.name);
  PageSpec sheet = PageOf(request.layout);
  const bool margin_given = request.layout.margin.has_value();
  if (model != nullptr) sheet = OnGeom(*model, sheet, margin_given, console);
  if (request.room.x < sheet.width || request.room.y < sheet.height) sheet.name = "custom";
  sheet = CutTo(request.room, sheet, kDeviceMargin, margin_given);
  SetInStyle(request, from, sheet, setup);
  if (request.layout.centred && !model) {
    const bool whole = sheet.name == LayoutOptions().page.name;  // no device is to reach it
    const bool cut = whole && !request.layout.page_named;
    cut ? FitSheet(setup.set, setup.script) : CentreText(setup.set, setup.script);
  }
  setup.turn_mark = request.turn_mark;
  if (request.book) return setup;
  const std::size_t signs = CountSigns(setup.set);
  if (signs > kMostSigns) throw InputError(say::TooLong(signs, kMostSigns));
  KeepLinks(setup.set, setup.script, console);
  return setup;
}

/// As SetOn; what a label cannot carry is the model's mistake.
TextSetup SetOnLabel(const TextRequest& request, const ModelPage& model, Console& console) {
  TextSetup setup;
  const Label& label = model.label();
  try {
    setup = SetOn(request, &model, console);
  } catch (const InputError& error) {
    const std::string_view what = error.what();
    if (!IsOnePage(model, model.number) || what.starts_with(request.feel.model)) throw;
    throw InputError(say::InLabel(request.feel.model, NameOf(label), what));
  }
  setup.label = model.number;
  const Box text_P = TextBox(setup.set.pages.front(), setup.script, setup.set.style);
  CheckRoom(request.feel.model, model, model.number, setup.set, text_P);
  setup.others = OthersOf(request.feel, model, text_P, console);
  if (setup.set.pages.size() > 1) {
    const bool from_middle = !label.middle && label.at == glm::dvec2(0, 0);
    console.Remark(say::PagesOnGeom(setup.set.pages.size(), label.geom, from_middle));
  }
  constexpr double kTold = 0.005;  // a length that is off by less is as it was set
  const double error = LengthErrorOf(label, model.solids[model.number], text_P);
  if (IsOnePage(model, model.number) && error > kTold) {
    console.Remark(say::LengthsErr(NameOf(label), error));
  }
  return setup;
}

}  // namespace

void ChooseLabel(FeelOptions& feel) {
  if (feel.label.empty()) return;
  if (feel.model.empty()) throw UsageError(say::LabelNeedsModel());
  if (feel.label == "all") throw UsageError(say::OneLabelOnly());
  FeelOptions first = feel;
  first.scene.label = 0;
  first.scene.tilt = 0;
  const std::vector<Label> labels = Scene::Load(first.model, first.scene).labels();
  std::vector<std::string> names;
  std::string all;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    names.push_back(NameOf(labels[i]));
    if (names.back() == feel.label) {
      feel.scene.label = i;
      return;
    }
    all += (i > 0 ? ", " : "") + names.back();
  }
  throw InputError(say::NoSuchLabel(feel.model, feel.label, all, NearestWord(feel.label, names)));
}

std::vector<std::string> LabelNames(const FeelOptions& feel) {
  FeelOptions first = feel;
  first.scene.label = 0;
  first.scene.tilt = 0;
  std::vector<std::string> names;
  const Scene scene = Scene::Load(first.model, first.scene);
  for (const Label& label : scene.labels()) {
    if (!label.text.empty()) names.push_back(NameOf(label));
  }
  return names;
}

std::vector<LaidLabel> OtherLabels(const Scene& scene, const std::string& model, Console& console) {
  if (scene.labels().size() == 1) return {};
  FeelOptions feel;
  feel.model = model;
  return OthersOf(feel, ModelPageOf(scene), scene.options().text_P, console);
}

Box TextBox(const TextPage& page, const Script& script, const TypeStyle& style) {
  Box box;
  for (const IntendedStroke& stroke : IntendedStrokes(page, script, style)) {
    const double half = std::max(0.5 * stroke.width, stroke.dot_radius);
    for (const std::vector<Piece>* pieces : {&stroke.spine_P, &stroke.outline_P}) {
      for (const Piece& piece : *pieces) Include(box, Grown(BoundsOf(piece), half));
    }
  }
  return box;
}

SceneOptions OnLabel(const TextSetup& text, std::size_t page, const SceneOptions& options) {
  SceneOptions on_label = options;
  if (!text.label) return on_label;
  on_label.label = *text.label;
  on_label.text_P = TextBox(text.set.pages[page], text.script, text.set.style);
  return on_label;
}

TextSetup SetUpText(const TextRequest& request, Console& console) {
  const std::optional<ModelPage> model = ModelPageFor(request);
  return model ? SetOnLabel(request, *model, console) : SetOn(request, nullptr, console);
}

std::string TextOf(const TextSetup& setup, std::size_t page) {
  const std::vector<PlacedGlyph>& glyphs = setup.set.pages[page].glyphs;
  if (glyphs.empty()) return {};
  const std::size_t begin = glyphs.front().source_begin;
  return OneLine(say::Unbroken(setup.text.substr(begin, glyphs.back().source_end - begin)));
}

std::string_view SourceOf(const TextSetup& setup, const PlacedGlyph& glyph) {
  return std::string_view(setup.text)
      .substr(glyph.source_begin, glyph.source_end - glyph.source_begin);
}

}  // namespace moontrace
