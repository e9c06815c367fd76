#pragma once

#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>

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
};

/// What a model gives for the text: its first label, and the room on that label's geom.
struct ModelPage {
  Label label;
  glm::dvec2 extent{0, 0};  ///< as Scene::page_extent [m]
  bool moves = false;       ///< the geom can be pushed
};
ModelPage ModelPageOf(const Scene& scene);

/// What a text is made of.
struct TextRequest {
  TextOptions text;
  StyleOptions style;
  LayoutOptions layout;
  FeelOptions feel;
  std::string command;            ///< in messages
  std::string default_text = {};  ///< where neither command line nor model bring one; empty: error
  std::optional<PageForm> form = {};  ///< none: as the others have it
  glm::dvec2 room{INFINITY};          ///< that a device can reach: pages are no larger [m]
  /// What `feel.model` gives, where it has been loaded already; none: it is loaded for this.
  std::optional<ModelPage> model_page = {};
};

/// Text, script and pages; what the command line leaves open comes from the model's first label.
/// Throws InputError (as SetText; too long; a label without text or with an unknown script) and
/// UsageError (no text).
TextSetup SetUpText(const TextRequest& request, Console& console);

/// The text that one page carries, on one line.
std::string TextOf(const TextSetup& setup, std::size_t page);
/// The characters that a sign stands for; the numeral sign stands for none.
std::string_view SourceOf(const TextSetup& setup, const PlacedGlyph& glyph);

}  // namespace moontrace
