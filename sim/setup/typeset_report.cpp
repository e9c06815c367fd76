#include "sim/setup/typeset_report.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <tuple>
#include <vector>

#include "sim/picture/sheet_messages.h"
#include "sim/setup/setup_messages.h"
#include "textures/base/units.h"
#include "textures/typeset/left_out.h"
#include "textures/typeset/rules.h"

namespace moontrace {

namespace {

const char* How(Replaced how) {
  switch (how) {
    case Replaced::kFolded:
      return "folded";
    case Replaced::kOtherScript:
      return "other-script";
    case Replaced::kTransliterated:
      return "transliterated";
    case Replaced::kNamed:
      return "named";
  }
  return "";
}

Json ReplacementsJson(const std::vector<Replacement>& replacements) {
  Json list = Json::array();
  for (const Replacement& r : replacements) {
    Json entry = {{"was", r.was}, {"became", r.became}, {"line", r.line}, {"column", r.column}};
    if (r.line == 0) entry["line"] = "running head";
    if (!r.became.empty()) entry["how"] = How(r.how);
    list.push_back(std::move(entry));
  }
  return list;
}

/// The same replacement of the same character: where it came first, and how often.
struct Repeated {
  const Replacement* first = nullptr;
  std::size_t times = 0;
};

/// In the order in which they came first, those of the running head apart: a book says of each
/// character once what became of it.
std::vector<Repeated> ByKind(const std::vector<Replacement>& list) {
  std::map<std::tuple<std::string_view, std::string_view, bool>, std::size_t> known;
  std::vector<Repeated> kinds;
  for (const Replacement& one : list) {
    const auto [at, is_new] = known.try_emplace({one.was, one.became, one.line == 0}, kinds.size());
    if (is_new) kinds.push_back({&one, 0});
    ++kinds[at->second].times;
  }
  return kinds;
}

Json StructureJson(const Typeset& set) {
  const StructureStyle& style = set.style.structure;
  Json json = {{"headings", set.structure.headings},
               {"quotations", set.structure.quotations},
               {"links", set.structure.links},
               {"heading_scale", style.heading_scale},
               {"texture", style.texture}};
  const Relief relief = style.heading_relief.value_or(set.style.relief);
  json["heading_embossed"] = relief == Relief::kEmbossed;
  return json;
}

Json RidgeJson(const Profile& profile) {
  return {{"width_mm", kMillimetres * profile.width},
          {"height_mm", kMillimetres * profile.depth},
          {"turning_force_n", TurningForce(profile, 1)}};
}

Json RulesJson(const TypeStyle& style, std::size_t count) {
  if (!style.rules.lines) return nullptr;
  Json json = RidgeJson(RuleProfile(style));
  json["count"] = count;
  return json;
}

Json MarginJson(const TypeStyle& style) {
  return style.rules.margin ? RidgeJson(MarginProfile(style)) : Json(nullptr);
}

Json TextureJson(const TypeStyle& style) {
  if (!style.texture.paper) return nullptr;
  const PaperTexture& paper = *style.texture.paper;
  Json json = {{"kind", NameOf(paper.kind)}, {"amplitude_mm", kMillimetres * paper.amplitude}};
  if (paper.kind != PaperKind::kSampled || paper.tiled) {
    json["wavelength_mm"] = kMillimetres * paper.wavelength;
  }
  if (paper.heights != nullptr) {
    json["file"] = style.texture.file;
    json["samples"] = {paper.heights->columns(), paper.heights->rows()};
    json["memory_bytes"] = paper.heights->memory_bytes();
  }
  return json;
}

Json LinksJson(const LinkStyle& links, const LinkCounts& counts, const TypeStyle& style) {
  Json json = {{"reach", NameOf(links.reach)}};
  if (links.reach == LinkReach::kNone) return json;
  json["depth"] = links.depth;
  json["gap_mm"] = kMillimetres * links.gap.value_or(style.width / 4);
  json["count"] = counts.links;
  json["missing"] = counts.missing;
  json["crossings"] = counts.crossings;
  return json;
}

void AddLinks(const TextPage& page, const Script& script, const TypeStyle& style,
              LinkCounts& counts) {
  const std::shared_ptr<const GrooveLinks> links = LinksOf(page, script, style);
  counts.links += links->links.size();
  counts.missing += links->missing;
  counts.crossings += links->crossings;
}

}  // namespace

void AddCounts(const TextPage& page, const Script& script, const TypeStyle& style,
               PageCounts& counts) {
  ++counts.pages;
  counts.lines += page.lines;
  counts.signs += page.glyphs.size();
  counts.rules += RaisedLinesOf(page, script, style).rules.size();
  AddLinks(page, script, style, counts.links);
}

std::size_t CountSigns(const Typeset& set) {
  std::size_t signs = 0;
  for (const TextPage& page : set.pages) {
    signs += static_cast<std::size_t>(
        std::count_if(page.glyphs.begin(), page.glyphs.end(),
                      [](const PlacedGlyph& glyph) { return glyph.kind != LineKind::kHead; }));
  }
  return signs;
}

LinkCounts CountLinks(const Typeset& set, const Script& script) {
  LinkCounts counts;
  for (const TextPage& page : set.pages) AddLinks(page, script, set.style, counts);
  return counts;
}

Json TypesetJson(const Typeset& set, const Script& script) {
  PageCounts counts;
  for (const TextPage& page : set.pages) AddCounts(page, script, set.style, counts);
  return TypesetJson(set, script, counts);
}

Json TypesetJson(const Typeset& set, const Script& script, const PageCounts& counts) {
  Json json;
  json["script"] = script.name;
  if (!script.remarks.empty()) json["script_remarks"] = script.remarks;
  json["size_mm"] = kMillimetres * set.style.size;
  json["width_mm"] = kMillimetres * set.style.width;
  json["depth_mm"] = kMillimetres * set.style.depth;
  json["rounding_mm"] = kMillimetres * set.style.rounding;
  json["embossed"] = set.style.relief == Relief::kEmbossed;
  json["line_pitch_mm"] = kMillimetres * set.style.line_pitch;
  json["letter_gap_mm"] = kMillimetres * set.style.letter_gap;
  json["h_form"] = set.style.h_form;
  json["grade"] = set.style.grade;
  if (set.style.older_punctuation) json["punctuation"] = "older";
  json["slant_deg"] = InDegrees(set.style.form.slant);
  json["stretch"] = set.style.form.stretch;
  if (set.style.structure.read) json["structure"] = StructureJson(set);
  json["paper"] = {{"name", set.page.name},
                   {"width_mm", kMillimetres * set.page.width},
                   {"height_mm", kMillimetres * set.page.height},
                   {"margin_mm", kMillimetres * set.page.margin}};
  json["rules"] = RulesJson(set.style, counts.rules);
  json["raised_margin"] = MarginJson(set.style);
  json["texture"] = TextureJson(set.style);
  json["links"] = LinksJson(set.style.links, counts.links, set.style);
  json["folded"] = ReplacementsJson(set.folded);
  json["missing"] = ReplacementsJson(set.missing);
  json["doubtful"] = ReplacementsJson(set.doubtful);
  json["untaught"] = ReplacementsJson(set.untaught);
  json["counts"] = {{"folded", set.folded_count},
                    {"missing", set.missing_count},
                    {"doubtful", set.doubtful_count},
                    {"untaught", set.untaught_count}};
  return json;
}

void SaySheet(const TypeStyle& style, std::size_t rules,
              const std::function<void(const std::string&)>& say_line) {
  if (style.rules.lines) {
    say_line(say::Rules(style, rules));
    say_line(say::TurnsBack("A rule", RuleProfile(style)));
  }
  if (style.rules.margin) {
    say_line(say::RaisedMargin(style));
    say_line(say::TurnsBack("The margin", MarginProfile(style)));
  }
  if (style.texture.paper) say_line(say::SheetTexture(style));
}

void SayReplacements(const Typeset& set, const std::function<void(const std::string&)>& say_line,
                     std::size_t most) {
  const auto say_all = [&say_line, most](const std::vector<Replacement>& list, std::size_t count,
                                         auto sentence) {
    const std::vector<Repeated> kinds = ByKind(list);
    std::size_t said = 0;
    for (std::size_t i = 0; i < std::min(kinds.size(), most); ++i) {
      say_line(sentence(*kinds[i].first, kinds[i].times));
      said += kinds[i].times;
    }
    if (count > said) say_line(say::MoreReplacements(count - said));
  };
  say_all(set.missing, set.missing_count, say::Missing);
  if (!LeavesOutWords(set.style.only)) say_all(set.untaught, set.untaught_count, say::Untaught);
  say_all(set.folded, set.folded_count, say::Folded);
  say_all(set.doubtful, set.doubtful_count, say::Doubtful);
}

std::string Dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace moontrace
