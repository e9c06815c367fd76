#include "sim/setup/text_setup.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "sim/setup/fitted_sheet.h"
#include "sim/setup/link_options.h"
#include "sim/setup/model_messages.h"
#include "sim/setup/setup_messages.h"
#include "sim/setup/typeset_report.h"
#include "textures/base/error.h"
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
  constexpr double kMargin = 0.001;  // [m]
  PageSpec sheet = CutTo(model.extent, asked, kMargin, margin_given);
  if (sheet.width == asked.width && sheet.height == asked.height) return sheet;
  sheet.name = "model";
  if (asked.name != LayoutOptions().page.name) {
    console.Remark(say::GeomIsSmaller(model.label.geom, sheet));
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

/// The script to use; a wrong one named by the label is reported as the model's mistake.
Script ScriptFor(const TextRequest& request, const Label* label) {
  const bool of_label = label != nullptr && label->script && !request.style.script;
  if (!of_label) return ScriptOf(request.style, label);
  try {
    return ScriptOf(request.style, label);
  } catch (const InputError& error) {
    throw InputError(say::InLabel(request.feel.model, label->geom, error.what()));
  }
}

}  // namespace

ModelPage ModelPageOf(const Scene& scene) {
  return {scene.labels().front(), scene.page_extent(), scene.page_moves()};
}

TextSetup SetUpText(const TextRequest& request, Console& console) {
  constexpr double kDeviceMargin = 0.005;  // [m], from where the device strikes its own stops
  const std::optional<ModelPage> model = ModelPageFor(request);
  const Label* from = model ? &model->label : nullptr;
  if (model && model->moves) console.Remark(say::PageMoves(model->label.geom));
  TextSetup setup;
  setup.text = TextFor(request, from, console);
  setup.script = ScriptFor(request, from);
  for (const std::string& remark : setup.script.remarks) console.Remark(remark);
  setup.script_name = request.style.script.value_or(
      from != nullptr && from->script ? *from->script : setup.script.name);
  StyleOptions letters = request.style;
  LayoutOptions layout = request.layout;
  if (request.form) ApplyForm(*request.form, setup.script, from, letters, layout);
  const TypeStyle style = StyleOf(letters, layout, setup.script, from);
  PageSpec sheet = PageOf(request.layout);
  const bool margin_given = request.layout.margin.has_value();
  if (model) sheet = OnGeom(*model, sheet, margin_given, console);
  if (request.room.x < sheet.width || request.room.y < sheet.height) sheet.name = "custom";
  sheet = CutTo(request.room, sheet, kDeviceMargin, margin_given);
  setup.set = SetText(setup.text, setup.script, style, sheet);
  if (request.layout.centred && !model) {
    const bool whole = sheet.name == LayoutOptions().page.name;  // no device is to reach it
    const bool cut = whole && !request.layout.page_named;
    cut ? FitSheet(setup.set, setup.script) : CentreText(setup.set, setup.script);
  }
  const std::size_t signs = CountSigns(setup.set);
  if (signs > kMostSigns) throw InputError(say::TooLong(signs, kMostSigns));
  KeepLinks(setup.set, setup.script, console);
  if (model && setup.set.pages.size() > 1) {
    console.Remark(say::PagesOnGeom(setup.set.pages.size(), from->geom));
  }
  return setup;
}

std::string TextOf(const TextSetup& setup, std::size_t page) {
  const std::vector<PlacedGlyph>& glyphs = setup.set.pages[page].glyphs;
  if (glyphs.empty()) return {};
  const std::size_t begin = glyphs.front().source_begin;
  return OneLine(std::string_view(setup.text).substr(begin, glyphs.back().source_end - begin));
}

std::string_view SourceOf(const TextSetup& setup, const PlacedGlyph& glyph) {
  return std::string_view(setup.text)
      .substr(glyph.source_begin, glyph.source_end - glyph.source_begin);
}

}  // namespace moontrace
