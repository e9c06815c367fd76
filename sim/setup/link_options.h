#pragma once

#include <optional>

#include "sim/console/console.h"
#include "sim/physics/label.h"
#include "sim/setup/cli_app.h"
#include "textures/typeset/style.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// `--links`, `--link-depth`, `--link-gap-mm`, as given.
struct LinkOptions {
  std::optional<LinkReach> reach;
  std::optional<double> depth;  ///< share of the letters' depth
  std::optional<double> gap;    ///< [m]
};
void AddOptions(CLI::App& app, LinkOptions& options);

/// The links asked for: command line before label before none. Throws UsageError for a depth or a
/// gap where there are no links.
LinkStyle LinksOf(const LinkOptions& options, const Label& label);

/// Finds the links of all pages, where any are asked for, and keeps them there for all who read
/// them; with a sign of life from time to time. Throws Interrupted.
void KeepLinks(Typeset& set, const Script& script, Console& console);

}  // namespace moontrace
