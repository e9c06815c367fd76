#include "sim/app/trace_report.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "sim/app/messages.h"
#include "sim/picture/link_messages.h"
#include "sim/session/loop_messages.h"
#include "sim/setup/typeset_report.h"

namespace moontrace {

Json TraceJson(const Trace& trace, const SceneOptions& scene, const TrialResult& all) {
  const TextSetup& text = trace.text;
  Json json = TypesetJson(text.set, text.script);
  json["text"] = text.text;
  json["rendering"] = scene.rendering == Rendering::kProxy ? "proxy" : "direct";
  json["law"] = scene.surface.law == ForceLaw::kPotential ? "potential" : "paper";
  json["blank"] = trace.blank;
  if (trace.device) json["device_profile"] = trace.device->name;
  json["guide"] = NameOf(trace.guidance.mode);
  json["help_level"] = trace.guidance.help;
  json["pages"] = trace.pages.size();
  json["pictures"] = trace.pictures;
  json["records"] = trace.records;
  json["letters"] = Json::array();
  for (std::size_t p = 0; p < trace.pages.size(); ++p) {
    const std::vector<PlacedGlyph>& glyphs = trace.text.set.pages[p].glyphs;
    for (std::size_t i = 0; i < glyphs.size(); ++i) {
      if (glyphs[i].kind == LineKind::kHead) continue;
      Json letter = {{"glyph", trace.text.script.glyphs[glyphs[i].glyph].name},
                     {"text", SourceOf(trace.text, glyphs[i])},
                     {"page", p}};
      letter.update(MetricsJson(trace.pages[p].score.letters[i]));
      json["letters"].push_back(std::move(letter));
    }
  }
  json["total"] = TotalJson(all, true);
  return json;
}

namespace {

/// The letter that was covered least, if any was missed in part.
void SayWeakest(const Trace& trace, Console& console) {
  double least = 1;
  std::size_t number = 0, weakest = 0;
  std::string_view text;
  for (std::size_t p = 0; p < trace.pages.size(); ++p) {
    const std::vector<PlacedGlyph>& glyphs = trace.text.set.pages[p].glyphs;
    for (std::size_t i = 0; i < glyphs.size(); ++i) {
      if (glyphs[i].kind == LineKind::kHead) continue;
      ++number;
      const double coverage = trace.pages[p].score.letters[i].coverage;
      if (coverage >= least) continue;
      least = coverage;
      weakest = number;
      // The numeral sign stands for no character of the text, so its name is given.
      text = SourceOf(trace.text, glyphs[i]);
      if (text.empty()) text = trace.text.script.glyphs[glyphs[i].glyph].name;
    }
  }
  if (weakest > 0) console.Result(say::WeakestLetter(text, weakest, least));
}

}  // namespace

void SayTrace(const Trace& trace, const TrialResult& all, const std::string& time,
              Console& console) {
  const TraceMetrics& total = all.score.total;
  const TypeStyle& style = trace.text.set.style;
  if (NeverTouched(total)) {
    console.Result(say::NeverTouched(all.duration));
    if (all.page_gone) console.Result(say::PageGone(*all.page_gone));
    if (all.through > 0) console.Result(say::Through(all));
  } else {
    console.Result(say::TraceOutcome(all, CountSigns(trace.text.set), trace.blank));
    if (all.through > 0) console.Result(say::Through(all));
    if (all.page_gone) console.Result(say::PageGone(*all.page_gone));
    if (FollowedNothing(total)) {
      console.Result(say::FollowedNothing());
    } else {
      console.Result(say::MeanError(total, style, trace.blank));
      console.Result(say::WorstError(total));
      console.Result(say::LeftGroove(total, style, trace.blank));
      SayWeakest(trace, console);
    }
  }
  if (style.links.reach != LinkReach::kNone) {
    const LinkCounts links = CountLinks(trace.text.set, trace.text.script);
    std::optional<std::size_t> left;
    if (all.links_left) left = all.links_left->size();
    console.Result(say::Links(links, style.links, left));
    console.Result(say::Lifts(all.lifts_within_lines, all.lines));
  }
  console.Result(say::Force(total));
  if (trace.guidance.on()) {
    console.Result(say::Guided(trace.guidance.mode, trace.guidance.help, all.mean_guidance,
                               all.guidance_work));
  }
  if (std::isfinite(all.force_bound)) console.Result(say::ForceBound(all));
  if (all.through == 0) console.Result(say::CarriedPress(all.carried_press));
  console.Result(say::Energy(all));
  console.Result(time);
  if (!trace.pictures.empty()) console.Result(say::PictureIn());
  for (const std::string& path : trace.pictures) console.Path(path);
  if (!trace.records.empty()) console.Result(say::RecordIn());
  for (const std::string& path : trace.records) console.Path(path);
}

}  // namespace moontrace
