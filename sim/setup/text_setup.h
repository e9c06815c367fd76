#pragma once

#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "sim/setup/options.h"
#include "sim/setup/page_form.h"
#include "sim/wording/console.h"
#include "textures/script/script.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// A text set on pages, ready to be felt.
struct TextSetup {
  std::string text;
  std::string script_name;  ///< as FindScript takes it
  Script script;
  Typeset set;
};

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
