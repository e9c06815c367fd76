#pragma once

#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/console/console.h"
#include "sim/physics/label.h"
#include "sim/physics/scene.h"
#include "sim/setup/options.h"
#include "sim/setup/page_form.h"
#include "textures/fonts/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// A text set on pages, ready to be felt.
struct TextSetup {
  std::string text;
  std::string script_name;  ///< as FindScript takes it
  Script script;
  Typeset set;
  /// Which label of a model carries it; none: no model was named.
  std::optional<std::size_t> label = {};
  std::vector<LaidLabel> others = {};  ///< of the model, with their own texts
  bool turn_mark = false;              ///< its pages have one, see turn_mark.h
};

/// What a model gives for the text: its labels, and what they lie on.
struct ModelPage {
  std::size_t number = 0;  ///< of the label that is the page
  std::vector<Label> labels;
  std::vector<Solid> solids;  ///< one for each label
  bool moves = false;         ///< the page's geom can move
  const Label& label() const { return labels[number]; }
};
ModelPage ModelPageOf(const Scene& scene);

/// Finds the label that `--label` names, for the scene's options. Throws UsageError without a
/// model, InputError: the model does not load or has no such label.
void ChooseLabel(FeelOptions& feel);
/// All labels of a model that bring a text, as NameOf gives them. Throws as Scene::Load.
std::vector<std::string> LabelNames(const FeelOptions& feel);

/// The labels of a scene beside its page that bring a text, set as they ask for. Throws InputError
/// that begins with `model`: one without room, two on one place.
std::vector<LaidLabel> OtherLabels(const Scene& scene, const std::string& model, Console& console);

/// What the page's text covers: its strokes with their width [m]; empty without any.
Box TextBox(const TextPage& page, const Script& script, const TypeStyle& style);

/// The scene's options for that page of the text: on its label, where the label wants it.
SceneOptions OnLabel(const TextSetup& text, std::size_t page, const SceneOptions& options);

/// What a text is made of.
struct TextRequest {
  TextOptions text;
  StyleOptions style;
  LayoutOptions layout;
  FeelOptions feel;
  std::string command;            ///< in messages
  std::string default_text = {};  ///< where neither command line nor model bring one; empty: error
  /// A book: of any length, and links between letters are looked for page by page, as it is felt.
  bool book = false;
  bool turn_mark = false;             ///< each page has a mark below its end
  std::optional<PageForm> form = {};  ///< none: as the others have it
  glm::dvec2 room{INFINITY};          ///< that a device can reach: pages are no larger [m]
  /// What `feel.model` gives, where it has been loaded already; none: it is loaded for this.
  std::optional<ModelPage> model_page = {};
};

/// Text, script and pages; what the command line leaves open comes from the model's label. Throws
/// InputError (as SetText; too long; a label without text or with an unknown script, or that has no
/// room, or lies on another) and UsageError (no text).
TextSetup SetUpText(const TextRequest& request, Console& console);

/// The text that one page carries, on one line.
std::string TextOf(const TextSetup& setup, std::size_t page);
/// The characters that a sign stands for; the numeral sign stands for none.
std::string_view SourceOf(const TextSetup& setup, const PlacedGlyph& glyph);

}  // namespace moontrace
