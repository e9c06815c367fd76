#include "sim/app/typeset_report.h"

#include <algorithm>
#include <vector>

#include "sim/app/messages.h"

namespace moontrace {

namespace {

constexpr std::size_t kMostSaid = 20;

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
    if (!r.became.empty()) entry["how"] = How(r.how);
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace

std::size_t CountSigns(const Typeset& set) {
  std::size_t signs = 0;
  for (const TextPage& page : set.pages) signs += page.glyphs.size();
  return signs;
}

Json TypesetJson(const Typeset& set, const Script& script) {
  constexpr double kMillimetres = 1e3;
  Json json;
  json["script"] = script.name;
  json["size_mm"] = kMillimetres * set.style.size;
  json["width_mm"] = kMillimetres * set.style.width;
  json["depth_mm"] = kMillimetres * set.style.depth;
  json["rounding_mm"] = kMillimetres * set.style.rounding;
  json["embossed"] = set.style.relief == Relief::kEmbossed;
  json["grade"] = set.style.grade;
  json["paper"] = {{"name", set.page.name},
                   {"width_mm", kMillimetres * set.page.width},
                   {"height_mm", kMillimetres * set.page.height},
                   {"margin_mm", kMillimetres * set.page.margin}};
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

void SayReplacements(const Typeset& set, const std::function<void(const std::string&)>& say_line) {
  const auto say_all = [&say_line](const std::vector<Replacement>& list, std::size_t count,
                                   auto sentence) {
    for (std::size_t i = 0; i < std::min(list.size(), kMostSaid); ++i) say_line(sentence(list[i]));
    if (count > kMostSaid) say_line(say::MoreReplacements(count - kMostSaid));
  };
  say_all(set.missing, set.missing_count, [](const Replacement& r) { return say::Missing(r); });
  say_all(set.untaught, set.untaught_count, [](const Replacement& r) { return say::Untaught(r); });
  say_all(set.folded, set.folded_count, [](const Replacement& r) { return say::Folded(r); });
  say_all(set.doubtful, set.doubtful_count, [](const Replacement& r) { return say::Doubtful(r); });
}

std::string Dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace moontrace
