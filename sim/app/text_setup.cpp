#include "sim/app/text_setup.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "sim/app/messages.h"
#include "sim/app/model_messages.h"
#include "sim/app/typeset_report.h"
#include "sim/scene/scene.h"
#include "textures/error.h"
#include "textures/text_file.h"

namespace moontrace {

namespace {

/// Bounds time and memory: about five hours of hand time.
constexpr std::size_t kMostSigns = 20000;

/// What a model gives for the text: its first label, and the room on that label's geom.
struct ModelPage {
  Label label;
  glm::dvec2 extent{0, 0};  ///< [m]
  bool moves = false;       ///< the geom can be pushed
};
std::optional<ModelPage> PageOfModel(const FeelOptions& feel) {
  if (feel.model.empty()) return std::nullopt;
  const Scene scene = Scene::Load(feel.model, feel.scene);
  return ModelPage{scene.labels().front(), scene.page_extent(), scene.page_moves()};
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

}  // namespace

TextSetup SetUpText(const TextRequest& request, Console& console) {
  constexpr double kLabelMargin = 0.001;   // [m]
  constexpr double kDeviceMargin = 0.005;  // [m], from where the device strikes its own stops
  const std::optional<ModelPage> model = PageOfModel(request.feel);
  const Label* from = model ? &model->label : nullptr;
  if (model && model->moves) console.Remark(say::PageMoves(model->label.geom));
  TextSetup setup;
  const bool given = request.text.text || !request.text.file.empty();
  if (!given && from != nullptr && !from->text.empty()) {
    setup.text = from->text;
  } else if (!given && !request.default_text.empty()) {
    setup.text = request.default_text;
  } else {
    setup.text = ReadText(request.text, request.command, console);  // or says that there is none
  }
  setup.script = ScriptOf(request.style, from);
  setup.script_name = request.style.script.value_or(
      from != nullptr && from->script ? *from->script : setup.script.name);
  StyleOptions letters = request.style;
  LayoutOptions layout = request.layout;
  if (request.form) ApplyForm(*request.form, setup.script, from, letters, layout);
  const TypeStyle style = StyleOf(letters, layout, setup.script, from);
  PageSpec sheet = PageOf(request.layout);
  const bool margin_given = request.layout.margin.has_value();
  if (model) sheet = CutTo(model->extent, sheet, kLabelMargin, margin_given);
  if (request.room.x < sheet.width || request.room.y < sheet.height) sheet.name = "custom";
  sheet = CutTo(request.room, sheet, kDeviceMargin, margin_given);
  setup.set = SetText(setup.text, setup.script, style, sheet);
  const std::size_t signs = CountSigns(setup.set);
  if (signs > kMostSigns) throw InputError(say::TooLong(signs, kMostSigns));
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
