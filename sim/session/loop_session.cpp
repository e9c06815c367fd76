#include "sim/session/loop_session.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <ostream>
#include <utility>

#include "devices/hand/simulated_stylus.h"
#include "lessons/measure/intended_strokes.h"
#include "sim/loop/device_feel.h"
#include "sim/scene/coupling.h"
#include "sim/session/device_choice.h"
#include "sim/session/loop_messages.h"
#include "sim/session/view_messages.h"
#include "sim/setup/text_trial.h"
#include "sim/trial/plan.h"
#include "sim/tutor/page_messages.h"
#include "textures/base/error.h"

namespace moontrace {

namespace {

constexpr double kPress = 1;  ///< [N]

/// Height of a letter [m].
double SizeOf(const PlacedGlyph& glyph, const TextSetup& text) {
  return ScaleOf(glyph.kind, text.set.style) * text.set.style.size;
}

/// Distance of a point to a letter's em box; 0 inside.
double DistanceTo(const PlacedGlyph& glyph, const TextSetup& text, glm::dvec2 p_P) {
  const double size = SizeOf(glyph, text);
  const glm::dvec2 extent(size * text.script.glyphs[glyph.glyph].advance, size);
  const glm::dvec2 low = glyph.origin_P, high = glyph.origin_P + extent;
  return glm::length(p_P - glm::clamp(p_P, low, high));
}

const PlacedGlyph* NearestGlyph(const TextSetup& text, std::size_t page, glm::dvec2 p_P) {
  const PlacedGlyph* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const PlacedGlyph& glyph : text.set.pages[page].glyphs) {
    const double distance = DistanceTo(glyph, text, p_P);
    if (distance < least) {
      least = distance;
      nearest = &glyph;
    }
  }
  return nearest;
}

/// Where a character of the text stands now: its page, and the letter.
struct Found {
  std::size_t page = 0;
  const PlacedGlyph* glyph = nullptr;
};
Found Find(const TextSetup& text, std::size_t source) {
  Found found;
  for (std::size_t page = 0; page < text.set.pages.size(); ++page) {
    for (const PlacedGlyph& glyph : text.set.pages[page].glyphs) {
      if (glyph.source_begin > source && found.glyph != nullptr) return found;
      found = {page, &glyph};
    }
  }
  return found;
}

/// A text of one line, moved to the sheet's middle.
void Centre(Typeset& set) {
  if (set.pages.size() != 1 || set.pages[0].lines != 1) return;
  std::vector<PlacedGlyph>& glyphs = set.pages[0].glyphs;
  if (glyphs.empty()) return;
  const double size = set.style.size;
  const glm::dvec2 low = glyphs.front().origin_P;
  const glm::dvec2 high = glyphs.back().origin_P + glm::dvec2(size, size);
  const glm::dvec2 shift = 0.5 * (glm::dvec2(set.page.width, set.page.height) - low - high);
  for (PlacedGlyph& glyph : glyphs) glyph.origin_P += shift;
}

/// How much page a device can reach, its edges finite [m].
glm::dvec2 RoomOf(const DeviceLimits& limits, double scale) {
  return 2 * scale * glm::dvec2(limits.workspace_D);
}

}  // namespace

LoopSession::LoopSession(SessionRequest request, Console& console)
    : request_(std::move(request)),
      console_(console),
      simulated_(IsSimulated(request_.live.device)),
      mouse_(IsMouse(request_.live.device)),
      scene_options_(request_.text.feel.scene) {
  const double tick = 1 / rate();
  request_.text.feel.scene.tick = scene_options_.tick = tick;
  const double press = request_.press.value_or(kPress);
  std::unique_ptr<Device> device;
  if ((simulated_ || mouse_) && request_.live.scale) {
    throw UsageError(say::OnlyWithDevice("--scale"));
  }
  if (mouse_) {
    device = MouseStylus();
    limits_ = device->Limits();
  } else if (!simulated_) {
    const auto tell = [&console](std::string_view sentence) {
      console.Result(sentence);
      console.out().flush();
    };
    device = OpenNamed(request_.live.device, tick, press, tell, console.stop());
    limits_ = device->Limits();
    request_.text.room = RoomOf(limits_, scale());
  }
  text_ = SetUp(request_.text);
  const std::optional<PaperTexture>& paper = text_.set.style.texture.paper;
  if (paper) form_.paper = paper->kind;
  tilt_ = scene_options_.tilt;
  const std::string& model = request_.text.feel.model;
  scene_options_ = HeldBy(limits_, scene_options_, Scene::Load(model, scene_options_).proxy_mass());
  Scene scene = Scene::Load(model, scene_options_);
  std::unique_ptr<TextureField> field = FieldOf(0);
  scene.SetField(field.get());
  X_WP_ = scene.X_WP();
  force_bound_ = ForceBound(scene_options_, scene.proxy_mass(), 0, scene.substeps());
  for (const std::string& remark : scene.remarks()) console.Remark(remark);
  if (simulated_) device = StylusFor(0, round_);

  LoopOptions options;
  options.rate = rate();
  options.press = press;
  options.hold_to_feel = request_.live.hold_to_feel;
  DeviceSource source = [this, tick, press](const std::atomic<bool>& ending) {
    const auto tell = [this](std::string_view sentence) {
      const std::lock_guard lock(sentences_mutex_);
      sentences_.emplace_back(sentence);
    };
    return OpenNamed(request_.live.device, tick, press, tell, &ending);
  };
  loop_ = std::make_unique<Loop>(std::move(scene), std::move(field), std::move(device),
                                 std::move(source), PlaceOfDevice(), options);
}

TextSetup LoopSession::SetUp(const TextRequest& request) {
  TextSetup setup = SetUpText(request, console_);
  if (request_.centred) Centre(setup.set);
  return setup;
}

std::unique_ptr<TextureField> LoopSession::FieldOf(std::size_t page) const {
  return std::make_unique<TextureField>(
      PageField(text_.set.pages[page], text_.script, text_.set.style, request_.blank));
}

/// The simulated hand, on its way through a page again and again; `round` [s] is how long it takes
/// for the page once.
std::unique_ptr<Device> LoopSession::StylusFor(std::size_t page, double& round) const {
  const HandModel hand = ShippedHand();
  const TypeStyle& style = text_.set.style;
  PlanOptions options;
  SetPress(hand, style.relief, request_.press, options);
  options.repeats = true;
  const TextPage& sheet = text_.set.pages[page];
  const auto strokes = IntendedStrokes(sheet, text_.script, style);
  const GrooveLinks links = LinkPage(sheet, text_.script, style);
  const Plan plan = MakePlan(strokes, WalksOf(strokes, sheet, links), options, X_WP_);
  round = plan.duration;
  return MakeSimulatedStylus(hand, plan.path_W, scene_options_.tick, request_.seed);
}

/// The hand that the window's mouse leads; its frame is the page's.
std::unique_ptr<Device> LoopSession::MouseStylus() const {
  if (request_.aims == nullptr) throw UsageError(say::MouseNeedsWindow());
  return MakeAimedStylus(ShippedHand(), request_.aims, {0, 0, -1}, scene_options_.tick);
}

/// The page lies in the middle of what the device reaches; for one that reaches everywhere, its
/// origin is where the text begins. A device without a third axis lies in the page's plane.
DevicePlace LoopSession::PlaceOfDevice() const {
  DevicePlace place;
  if (simulated_) return place;
  if (mouse_) {
    place.R_WD = X_WP_.R;
    place.origin_W = ToWorld(X_WP_, glm::dvec3(0, 0, 0));
    return place;
  }
  place.scale = scale();
  if (!limits_.measures.z) place.R_WD = X_WP_.R;
  const PageSpec& sheet = text_.set.page;
  const std::vector<PlacedGlyph>& glyphs = text_.set.pages[0].glyphs;
  const glm::dvec2 begin = glyphs.empty() ? glm::dvec2(0, 0) : glyphs.front().origin_P;
  const bool bounded = std::isfinite(limits_.workspace_D.x) && std::isfinite(limits_.workspace_D.y);
  const glm::dvec2 middle = bounded ? 0.5 * glm::dvec2(sheet.width, sheet.height) : begin;
  place.origin_W = ToWorld(X_WP_, glm::dvec3(middle, 0));
  return place;
}

void LoopSession::Show(std::size_t page, const std::optional<PageAnchor>& anchor) {
  PageChange change;
  change.field = FieldOf(page);
  change.page = first_number_ + static_cast<std::uint32_t>(page);
  double round = round_;
  if (simulated_) {
    change.device = StylusFor(page, round);
  } else if (!mouse_) {  // a window's page stays where it is seen
    change.anchor = anchor;
  }
  loop_->ChangePage(std::move(change));
  page_ = page;
  round_ = round;
  ++shown_;
}

bool LoopSession::Turn(bool forward) {
  if (forward ? page_ + 1 >= text_.set.pages.size() : page_ == 0) return false;
  Show(forward ? page_ + 1 : page_ - 1, std::nullopt);
  return true;
}

void LoopSession::Resize(bool bigger, glm::dvec2 tip_P) {
  constexpr double kStep = 1.25;
  constexpr double kSmallest = 0.001, kGreatest = 1;  // [m], as --size-mm
  const double size = text_.set.style.size;
  SetSize(std::clamp(bigger ? size * kStep : size / kStep, kSmallest, kGreatest), tip_P);
}

void LoopSession::SetSize(double size, glm::dvec2 tip_P) {
  TextRequest request = request_.text;
  request.style.size = size;
  SetAnew(std::move(request), tip_P);
}

void LoopSession::SetForm(const PageForm& form, glm::dvec2 tip_P) {
  TextRequest request = request_.text;
  request.form = form;
  SetAnew(std::move(request), tip_P);
  form_ = form;
}

/// The same text by another request.
void LoopSession::SetAnew(TextRequest request, glm::dvec2 tip_P) {
  const TextOptions given = std::exchange(request.text, {});
  request.text.text = text_.text == "-" ? "- " : text_.text;  // standard input has been read
  TextSetup next = SetUp(request);

  const PlacedGlyph* letter = NearestGlyph(text_, page_, tip_P);
  const Found found = Find(next, letter != nullptr ? letter->source_begin : 0);
  std::optional<PageAnchor> anchor;
  if (letter != nullptr && found.glyph != nullptr) {
    const double ratio = next.set.style.size / text_.set.style.size;
    anchor = PageAnchor{letter->origin_P, found.glyph->origin_P, ratio};
  }
  std::swap(text_, next);
  try {
    Show(found.page, anchor);
  } catch (...) {
    std::swap(text_, next);
    throw;
  }
  request.text = given;
  request_.text = std::move(request);
}

void LoopSession::ChangeText(TextRequest request, bool blank) {
  request.room = request_.text.room;
  request.feel = request_.text.feel;
  TextSetup next = SetUp(request);
  const std::uint32_t number = first_number_ + static_cast<std::uint32_t>(text_.set.pages.size());
  const std::uint32_t number_before = std::exchange(first_number_, number);
  const bool blank_before = std::exchange(request_.blank, blank);
  std::swap(text_, next);
  try {
    Show(0, std::nullopt);
  } catch (...) {
    std::swap(text_, next);
    request_.blank = blank_before;
    first_number_ = number_before;
    throw;
  }
  form_ = request.form.value_or(form_);
  request_.text = std::move(request);
  mark_.reset();
}

void LoopSession::GoOn() {
  if (simulated_) Show(page_, std::nullopt);
  loop_->GoOn();
}

void LoopSession::Tilt(double tilt) {
  if (!limits_.measures.z) throw InputError(say::NoTiltInPlane());
  PageChange change;
  change.field = FieldOf(page_);
  change.page = number();
  double round = round_;
  if (simulated_) {
    change.device = StylusFor(page_, round);  // its arm is tilted with the page, its path stays
  } else {
    if (!mouse_) change.tilt = tilt;  // it lies in the page's plane
  }
  loop_->ChangePage(std::move(change));
  round_ = round;
  tilt_ = tilt;
}

std::optional<NearLetter> LoopSession::Near(glm::dvec2 tip_P) const {
  const PlacedGlyph* glyph = NearestGlyph(text_, page_, tip_P);
  if (glyph == nullptr) return std::nullopt;
  NearLetter found;
  found.name = SourceOf(text_, *glyph);
  if (found.name.empty()) found.name = text_.script.glyphs[glyph->glyph].name;
  std::size_t begin = glyph->source_begin, end = glyph->source_end;
  for (const PlacedGlyph& other : text_.set.pages[page_].glyphs) {
    if (other.word != glyph->word) continue;
    begin = std::min(begin, other.source_begin);
    end = std::max(end, other.source_end);
  }
  found.word = text_.text.substr(begin, end - begin);
  found.line = glyph->line;
  const double size = SizeOf(*glyph, text_);
  found.near = DistanceTo(*glyph, text_, tip_P) <= 0.25 * size;
  found.in_P = glm::clamp((tip_P - glyph->origin_P) / size, glm::dvec2(0), glm::dvec2(1));
  return found;
}

std::vector<std::string> LoopSession::TakeSentences() {
  const std::lock_guard lock(sentences_mutex_);
  return std::exchange(sentences_, {});
}

std::string LoopSession::Where(const LoopSnapshot& now) const {
  const glm::dvec3 tip_P = now.tip_P;
  const bool pushes = !mouse_ && glm::any(limits_.pushes);
  const say::Feeling feeling{now.depth > 0, pushes, now.stopped, glm::length(now.force_P)};
  const std::optional<NearLetter> letter = Near(tip_P);
  const std::size_t pages = text_.set.pages.size();
  if (!letter) return say::Where("", 0, page_, pages, feeling);
  return say::Where(letter->near ? letter->name : "", letter->line, page_, pages, feeling);
}

void LoopSession::SetMark(glm::dvec3 tip_P) {
  const PlacedGlyph* letter = NearestGlyph(text_, page_, tip_P);
  if (letter == nullptr) return;
  mark_ =
      Mark{letter->source_begin, (glm::dvec2(tip_P) - letter->origin_P) / SizeOf(*letter, text_)};
}

std::string LoopSession::WayToMark(const LoopSnapshot& now) {
  if (!mark_) return say::NoMark();
  const Found found = Find(text_, mark_->source);
  if (found.glyph == nullptr) return say::NoMark();
  const bool turned = found.page != page_;
  if (turned) Show(found.page, std::nullopt);
  const glm::dvec2 mark_P =
      found.glyph->origin_P + SizeOf(*found.glyph, text_) * mark_->from_letter;
  return say::WayToMark(
      SourceOf(text_, *found.glyph), found.page, text_.set.pages.size(),
      turned ? std::nullopt : std::optional<glm::dvec2>(mark_P - glm::dvec2(now.tip_P)));
}

}  // namespace moontrace
