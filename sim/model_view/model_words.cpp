#include "sim/model_view/model_words.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <utility>

#include "sim/model_view/visibility.h"
#include "sim/physics/felt_object.h"
#include "sim/physics/mujoco_compat.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

constexpr std::size_t kMostOthers = 12;  // geoms that are told by name

/// What became of the points of a label.
struct Looked {
  int all = 0, seen = 0, away = 0, beside = 0;
  glm::dvec2 sum{0, 0};     ///< of where they are seen
  std::vector<int> hiders;  ///< a geom for each point that is hidden
};

Looked LookFor(const ViewModel& model, const mjData& d, const Sight& sight,
               const ViewModel::Label& label) {
  Looked looked;
  for (const LabelPoint& point : PointsOf(label, d)) {
    ++looked.all;
    const auto at = sight.ShareOf(point.p_W);
    if (point.IsTurnedFrom(sight.eye_W)) {
      ++looked.away;
    } else if (!at || at->x < 0 || at->y < 0 || at->x > 1 || at->y > 1) {
      ++looked.beside;
    } else if (const int hider = HiddenBy(model, d, label, sight.eye_W, point.p_W); hider >= 0) {
      looked.hiders.push_back(hider);
    } else {
      ++looked.seen;
      looked.sum += *at;
    }
  }
  return looked;
}

std::string PlaceInPicture(glm::dvec2 share) {
  const char* up = share.y > 0.62 ? "upper" : (share.y < 0.38 ? "lower" : "");
  const char* across = share.x > 0.62 ? "right" : (share.x < 0.38 ? "left" : "");
  if (*up == '\0' && *across == '\0') return "in the middle";
  if (*up == '\0') return fmt::format("at the {}", across);
  if (*across == '\0') return share.y > 0.5 ? "at the top" : "at the bottom";
  return fmt::format("at the {} {}", up, across);
}

/// `other_name`: where the geom has none.
std::string GeomInWords(const mjModel& m, int geom, const std::string& other_name = {}) {
  const std::string own = NameOf(m, mjOBJ_GEOM, geom), &name = own.empty() ? other_name : own;
  const std::string kind = KindOfGeom(m, geom);
  const char* article = std::string_view("aeiou").find(kind[0]) < 5 ? "an" : "a";
  if (name.empty()) return fmt::format("{} {}", article, kind);
  return fmt::format("{}, {} {}", OneLine(name, 40), article, kind);
}

std::string LabelInWords(const ViewModel& model, const ViewModel::Label& label,
                         const Looked& looked) {
  const std::string on = GeomInWords(*model.m, label.drawn, label.name);
  const std::string text = OneLine(label.text, 40);
  if (looked.seen == 0) {
    std::string why = "beside the picture";
    if (looked.away >= looked.beside) why = "turned away";
    if (!looked.hiders.empty()) {
      why = fmt::format("hidden behind {}", GeomInWords(*model.m, looked.hiders.front()));
    }
    return fmt::format("Not seen: {} on {}: {}.", text, on, why);
  }
  const double share = static_cast<double>(looked.seen) / looked.all;
  const char* much = share > 0.97 ? "all of it" : (share > 0.6 ? "most of it" : "a part of it");
  return fmt::format("{} on {}: {} is seen, {}.", text, on, much,
                     PlaceInPicture(looked.sum / static_cast<double>(looked.seen)));
}

/// From where, by the sky and the model's axes.
std::string StandInWords(const Sight& sight) {
  const glm::dvec3 f = sight.forward_W;
  const double down = std::asin(std::clamp(-f.z, -1.0, 1.0)) * 57.29577951308232;
  if (down > 75) return "from above";
  if (down < -75) return "from below";
  std::string side;
  if (std::abs(f.y) >= std::abs(f.x)) {
    side = f.y > 0 ? "from the front" : "from the back";
  } else {
    side = f.x < 0 ? "from the right" : "from the left";
  }
  if (down > 15) side += " and above";
  if (down < -15) side += " and below";
  return side;
}

/// The geoms that stand foremost somewhere in the picture, by rays through it: of a large one the
/// middle may lie beside it.
std::set<int> ForemostIn(const ViewModel& model, const mjData& d, const Sight& sight) {
  constexpr int kAcross = 24, kUp = 14;
  std::set<int> foremost;
  for (int i = 0; i < kAcross; ++i) {
    for (int k = 0; k < kUp; ++k) {
      const Sight::Ray ray = sight.RayUnder({(i + 0.5) / kAcross, (k + 0.5) / kUp});
      const double from[3] = {ray.from_W.x, ray.from_W.y, ray.from_W.z};
      const double along[3] = {ray.along_W.x, ray.along_W.y, ray.along_W.z};
      const int geom = FirstOnRay(*model.m, d, from, along).geom;
      if (geom >= 0) foremost.insert(geom);
    }
  }
  return foremost;
}

/// Geoms that can be named and are in the picture, without those that carry labels.
std::string OthersInWords(const ViewModel& model, const mjData& d, const Sight& sight) {
  const mjModel& m = *model.m;
  const std::set<int> foremost = ForemostIn(model, d, sight);
  std::vector<std::string> told;
  std::size_t more = 0;
  for (int geom = 0; geom < static_cast<int>(m.ngeom); ++geom) {
    const int body = m.geom_bodyid[geom];
    const bool labelled = std::any_of(model.labels.begin(), model.labels.end(),
                                      [geom](const ViewModel::Label& label) {
                                        return label.drawn == geom && !label.text.empty();
                                      });
    if (labelled || body == model.proxy_body || body == model.handle_body) continue;
    if (m.geom_group[geom] > 2) continue;  // not drawn
    const auto at = sight.ShareOf(PoseOfGeom(d, geom).p);
    const bool inside = at && at->x >= 0 && at->y >= 0 && at->x <= 1 && at->y <= 1;
    const bool plane = m.geom_type[geom] == mjGEOM_PLANE;  // its middle is any place
    if (!foremost.contains(geom) && (plane || !inside)) continue;
    if (NameOf(m, mjOBJ_GEOM, geom).empty() || told.size() >= kMostOthers) {
      ++more;
    } else {
      told.push_back(GeomInWords(m, geom));
    }
  }
  std::string line;
  for (const std::string& one : told) line += (line.empty() ? "" : "; ") + one;
  if (more > 0)
    line += fmt::format("{}{} more shape{}", line.empty() ? "" : "; ", more, more == 1 ? "" : "s");
  return line;
}

std::string TipInWords(const ViewModel& model, const Sight& sight, const SeenTip& tip) {
  const ViewModel::Label& page = model.labels[model.page];
  const std::string on = GeomInWords(*model.m, page.drawn, page.name);
  const auto at = sight.ShareOf(tip.p_W);
  const bool inside = at && at->x >= 0 && at->y >= 0 && at->x <= 1 && at->y <= 1;
  const std::string where = inside ? PlaceInPicture(*at) : "beside the picture";
  if (tip.touches) return fmt::format("The tip touches {}, {}.", on, where);
  return fmt::format("The tip is in the air, {:.0f} mm from {}, {}.",
                     1e3 * std::max(tip.height, 0.0), on, where);
}

}  // namespace

std::vector<std::string> WordsOfView(const ViewModel& model, const mjData& d, const Sight& sight,
                                     const ViewTarget& target, const std::optional<SeenTip>& tip) {
  std::vector<std::string> lines;
  if (target.kind == ViewTarget::Kind::kCamera) {
    lines.push_back(fmt::format("Seen by the camera {}, {}.",
                                OneLine(NameOf(*model.m, mjOBJ_CAMERA, target.number), 40),
                                StandInWords(sight)));
  } else {
    lines.push_back(fmt::format("Seen {}.", StandInWords(sight)));
  }
  for (const ViewModel::Label& label : model.labels) {
    if (label.text.empty() || !(label.text_P.min.x <= label.text_P.max.x)) continue;
    lines.push_back(LabelInWords(model, label, LookFor(model, d, sight, label)));
  }
  const std::string others = OthersInWords(model, d, sight);
  if (!others.empty()) lines.push_back(fmt::format("Beside: {}.", others));
  if (tip) lines.push_back(TipInWords(model, sight, *tip));
  return lines;
}

}  // namespace moontrace
