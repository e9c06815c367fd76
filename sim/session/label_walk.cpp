#include "sim/session/label_walk.h"

#include <algorithm>
#include <utility>

#include "sim/session/place_messages.h"
#include "textures/base/error.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

/// Of a letter, where a hand finds it: a little inside, half way up [em].
constexpr glm::dvec2 kInLetter{0.25, 0.5};
/// A tip that is farther than this below a flat face has the object between [m].
constexpr double kBehind = 0.002;
/// So long is a touch no accident [s].
constexpr double kTouch = 0.15;

bool Holds(std::string_view whole, std::string_view piece, bool part) {
  const std::string all = LowerCase(whole), wanted = LowerCase(piece);
  return part ? all.find(wanted) != std::string::npos : all == wanted;
}

}  // namespace

std::vector<std::string> LabelWalk::List() const {
  const std::vector<LoopSession::LabelOf> labels = session_.labels();
  if (labels.empty()) return {say::NoLabels()};
  std::vector<std::string> lines = {say::LabelsAre(labels.size())};
  for (const LoopSession::LabelOf& label : labels) {
    lines.push_back(
        say::LabelIs(label.name, label.text, label.face, label.number == session_.label()));
  }
  return lines;
}

std::string LabelWalk::GoTo(std::size_t number) {
  const std::size_t here = session_.label();
  if (number != here) {
    try {
      session_.GoToLabel(number);
    } catch (const InputError& error) {
      return say::LabelStays(error.what());
    }
    before_.push_back(here);
  }
  going_ = true;
  return {};
}

std::string LabelWalk::Next() {
  const std::vector<LoopSession::LabelOf> labels = session_.labels();
  if (labels.empty()) return say::NoLabels();
  if (labels.size() == 1) return say::OneLabel();
  const auto behind = std::find_if(labels.begin(), labels.end(), [this](const auto& label) {
    return label.number > session_.label();
  });
  return GoTo(behind != labels.end() ? behind->number : labels.front().number);
}

std::optional<std::string> LabelWalk::Find(std::string_view wanted, bool part) {
  const std::vector<LoopSession::LabelOf> labels = session_.labels();
  if (wanted.empty() || labels.size() < 2) return std::nullopt;
  // names go before texts: two buttons may say the same
  using Of = LoopSession::LabelOf;
  for (const auto& of : {&Of::name, &Of::geom, &Of::text, &Of::face}) {
    for (const LoopSession::LabelOf& label : labels) {
      if (Holds(label.*of, wanted, part)) return GoTo(label.number);
    }
  }
  return std::nullopt;
}

std::optional<std::string> LabelWalk::Return() {
  if (before_.empty()) return std::nullopt;
  const std::size_t number = before_.back();
  std::string refusal = GoTo(number);
  if (refusal.empty()) before_.resize(before_.size() - 2);  // GoTo has added one
  return refusal;
}

std::optional<PlaceWalk::Arrival> LabelWalk::Arrived(const LoopSnapshot& now) {
  const FeltPage& page = session_.felt();
  if (!going_ || now.page != page.number) return std::nullopt;
  going_ = false;
  PlaceWalk::Arrival arrival;
  arrival.tip_P = now.tip_P;
  if (!page.set().glyphs.empty()) {
    const double size = session_.text().set.style.size;
    arrival.place_P = page.set().glyphs.front().origin_P + size * kInLetter;
  }
  const std::vector<LoopSession::LabelOf> labels = session_.labels();
  const auto here = std::find_if(labels.begin(), labels.end(), [this](const auto& label) {
    return label.number == session_.label();
  });
  if (here == labels.end()) return std::nullopt;
  arrival.sentence = say::LabelIs(here->name, here->text, here->face, false);
  if (session_.device().simulated()) return arrival;
  const double out = IsFree(now) ? 0 : -now.tip_P.z;
  arrival.sentence =
      say::WayToLabel(arrival.sentence, {arrival.place_P - glm::dvec2(now.tip_P), out});
  return arrival;
}

bool LabelWalk::IsFree(const LoopSnapshot& now) const {
  return session_.device().on_page() || now.tip_P.z > -kBehind;
}

std::string LabelWalk::Touched(const LoopSnapshot& now) const {
  const std::vector<LoopSession::LabelOf> labels = session_.labels();
  if (now.geom < 0 || labels.empty()) return {};
  bool several = false;
  const LoopSession::LabelOf* touched = nullptr;
  for (const LoopSession::LabelOf& label : labels) {
    several |= label.carrier != labels.front().carrier;
    if (label.carrier != now.geom) continue;
    const bool better = touched == nullptr || label.number == session_.label();
    if (better) touched = &label;
  }
  if (touched != nullptr) return several ? say::Touched(touched->geom, touched->text) : "";
  return say::Touched(NameOfGeom(now.geom), "");
}

/// As the model's labels name it, or the model.
std::string LabelWalk::NameOfGeom(int geom) const {
  for (const LoopSession::LabelOf& label : session_.labels()) {
    if (label.carrier == geom) return label.geom;
  }
  std::string name = NameOf(*session_.view_model()->m, mjOBJ_GEOM, geom);
  return name.empty() ? "something without a name" : name;
}

std::string LabelWalk::TouchedAnew(const LoopSnapshot& now) {
  if (now.geom != geom_) {
    geom_ = now.geom;
    since_ = now.time;
  }
  if (geom_ < 0 || geom_ == told_ || now.time - since_ < kTouch) return {};
  told_ = geom_;
  return Touched(now);
}

std::string LabelWalk::PressedAnew(const LoopSnapshot& now) {
  constexpr double kPressed = 0.9, kReleased = 0.5;  // of its way
  if (now.geom < 0 || now.gives < kReleased) pressed_ = false;
  if (pressed_ || now.gives < kPressed || session_.labels().empty()) return {};
  pressed_ = true;
  return say::Pressed(NameOfGeom(now.geom));
}

}  // namespace moontrace
