#pragma once

#include <cstddef>
#include <string>

#include "sim/trial/metrics_json.h"
#include "sim/trial/trial.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// What a record keeps besides the scene: enough to build page and field again, and to say what was
/// traced. `script` is a name or a path, as FindScript takes it; paths are written as absolute
/// ones.
struct TrialParameters {
  std::string text;
  std::string script;
  TypeStyle style;
  PageSpec paper;
  std::size_t page = 0;  ///< of the set text, from 0
  bool blank = false;
  TrialGuidance guidance{};       ///< read from the setup when written
  std::string fallback_script{};  ///< read from the script itself when written; empty = none
};

/// Adds plan and hand, for people and other programs; a replay does not need them.
std::string ParametersJson(const TrialParameters& parameters, const TrialSetup& setup);

/// Reads them back. Throws InputError naming `folder`.
TrialParameters ReadParameters(const std::string& json_text, const std::string& folder);

}  // namespace moontrace
