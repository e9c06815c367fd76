#include "sim/setup/link_options.h"

#include <string>

#include "sim/picture/link_messages.h"
#include "sim/setup/help.h"
#include "sim/setup/setup_messages.h"
#include "textures/relief/groove_links.h"

namespace moontrace {

void AddOptions(CLI::App& app, LinkOptions& options) {
  BeginGroup(app, help_group::kLinks);
  AddValue(
      app, "--links", "WORD",
      [&options](const std::string& given) {
        options.reach = LinkReachOf(given);
        if (!options.reach) throw UsageError(say::NotAChoice("--links", given, kLinkReaches));
      },
      say::help::kLinks);
  AddNumber(app, "--link-depth", options.depth, 0.05, 1, 1, say::help::kLinkDepth);
  AddNumber(app, "--link-gap-mm", options.gap, 0, 1000, 1e-3, say::help::kLinkGap);
}

LinkStyle LinksOf(const LinkOptions& options, const Label& label) {
  LinkStyle links;
  links.reach = options.reach.value_or(label.links.value_or(LinkReach::kNone));
  if (links.reach == LinkReach::kNone && (options.depth || options.gap)) {
    throw UsageError(say::NeedsOther(options.depth ? "--link-depth" : "--link-gap-mm", "--links"));
  }
  links.depth = options.depth.value_or(label.link_depth.value_or(links.depth));
  links.gap = options.gap ? options.gap : label.link_gap;
  return links;
}

void KeepLinks(Typeset& set, const Script& script, Console& console) {
  LinkPages(set, script, [&console](double done) {
    console.CheckStop();
    console.Alive(done);
  });
}

}  // namespace moontrace
