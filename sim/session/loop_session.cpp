#include "sim/session/loop_session.h"

#include <algorithm>
#include <utility>

#include "sim/loop/device_feel.h"
#include "sim/physics/coupling.h"
#include "sim/setup/model_messages.h"
#include "sim/tutor/page_messages.h"
#include "textures/base/error.h"

namespace moontrace {

namespace {

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

/// Its first letter.
PageAnchor StartOf(const FeltPage& page) {
  constexpr glm::dvec2 kInLetter{0.25, 0.5};  // [em], where a hand finds it
  PageAnchor anchor;
  if (!page.set().glyphs.empty()) {
    anchor.to_P = page.set().glyphs.front().origin_P + page.text->set.style.size * kInLetter;
  }
  return anchor;
}

}  // namespace

LoopSession::LoopSession(const SessionRequest& request, Console& console)
    : console_(console),
      rate_(request.rate()),
      centred_(request.centred),
      input_taken_(request.input_taken),
      request_(request.text),
      device_(request, console) {
  request_.feel.scene.tick = 1 / rate_;
  request_.room = device_.room();
  Scene scene = SetFirst(request.blank);
  for (const std::string& remark : scene.remarks()) console.Remark(remark);
  std::unique_ptr<Device> device = device_.Take();
  if (device_.simulated()) {
    HandOnPage hand = device_.HandOn(felt_);
    device = std::move(hand.device);
    round_ = hand.round;
  }
  LoopOptions options;
  options.rate = rate_;
  options.press = device_.press();
  options.hold_to_feel = request.live.hold_to_feel;
  options.on_page = device_.on_page();
  const Pose X_WP = options.on_page ? Pose() : scene.X_WP();
  loop_ = std::make_unique<Loop>(std::move(scene), felt_.field, std::move(device),
                                 device_.Reopening(), device_.PlaceOn(text().set, X_WP), options);
}

/// The first page, and the scene that it lies in, as the device holds it.
Scene LoopSession::SetFirst(bool blank) {
  const SceneOptions& asked = request_.feel.scene;
  const std::string& model = request_.feel.model;
  std::optional<Scene> scene;
  // a model that was named says what is set on it, so it comes first
  if (!model.empty()) {
    scene.emplace(Scene::Load(model, asked));
    request_.model_page = ModelPageOf(*scene);
  }
  given_ = request_;
  const std::shared_ptr<const TextSetup> text = SetUp(request_);
  if (!scene) scene.emplace(Scene::Load(model, asked));
  const SceneOptions held = HeldBy(device_.limits(), OnLabel(*text, 0, asked), scene->proxy_mass());
  scene->SetOptions(held);
  felt_ = FeltPageOf(text, 0, blank, 0);
  scene->SetField(felt_.field.get());
  others_ = text->others;
  for (const LaidLabel& other : others_) scene->SetLabel(other);
  if (!scene->page_is_flat()) {
    const Box& text_P = scene->options().text_P;
    scene->Reset({0.5 * (text_P.min + text_P.max), 0.02});
  }
  if (!model.empty()) view_model_ = MakeViewModel(*scene, others_, text->text);
  const std::optional<PaperTexture>& paper = text->set.style.texture.paper;
  if (paper) form_.paper = paper->kind;
  tilt_ = asked.tilt;
  coupling_stiffness_ = held.coupling_stiffness;
  force_bound_ = scene->force_bound({.pushes_height = device_.limits().pushes.z});
  carried_press_ = scene->carried_press();
  return std::move(*scene);
}

std::shared_ptr<const TextSetup> LoopSession::SetUp(const TextRequest& request) {
  TextSetup setup = SetUpText(request, console_);
  if (centred_) Centre(setup.set);
  return std::make_shared<const TextSetup>(std::move(setup));
}

/// The loop goes over to a page; a simulated hand begins it.
void LoopSession::LetFeel(const FeltPage& page, const std::optional<PageAnchor>& anchor,
                          std::optional<double> tilt) {
  PageChange change;
  change.field = page.field;
  change.page = page.number;
  if (page.text->label) {
    change.text_P = OnLabel(*page.text, page.index, {}).text_P;
    if (page.text->label != text().label) {
      change.label = page.text->label;
      change.place_P = device_.PlaceOn(page.text->set, Pose());
    }
  }
  HandOnPage hand;
  if (device_.simulated()) {
    hand = device_.HandOn(page);
    change.device = std::move(hand.device);
  } else if (!device_.mouse()) {
    // a window's page stays where it is seen, and its mouse lies in the page's plane
    change.anchor = anchor;
    change.tilt = tilt;
  }
  loop_->ChangePage(std::move(change));
  round_ = hand.round;
}

void LoopSession::Show(FeltPage page, const std::optional<PageAnchor>& anchor) {
  LetFeel(page, anchor, std::nullopt);
  page.shown = felt_.shown + 1;
  felt_ = std::move(page);
}

void LoopSession::TurnTo(std::size_t index) { Show(OtherPage(felt_, index), std::nullopt); }

bool LoopSession::Turn(bool forward) {
  const std::size_t page = felt_.index;
  if (forward ? page + 1 >= text().set.pages.size() : page == 0) return false;
  TurnTo(forward ? page + 1 : page - 1);
  return true;
}

void LoopSession::Resize(bool bigger, glm::dvec2 tip_P) {
  constexpr double kStep = 1.25;
  constexpr double kSmallest = 0.001, kGreatest = 1;  // [m], as --size-mm
  const double size = text().set.style.size;
  SetSize(std::clamp(bigger ? size * kStep : size / kStep, kSmallest, kGreatest), tip_P);
}

void LoopSession::SetSize(double size, glm::dvec2 tip_P) {
  TextRequest request = request_;
  request.style.size = size;
  SetAnew(std::move(request), tip_P);
}

void LoopSession::SetForm(const PageForm& form, glm::dvec2 tip_P) {
  TextRequest request = request_;
  request.form = form;
  SetAnew(std::move(request), tip_P);
  form_ = form;
}

/// The same text by another request.
void LoopSession::SetAnew(TextRequest request, glm::dvec2 tip_P) {
  const TextOptions given = std::exchange(request.text, {});
  request.text.text = text().text == "-" ? "- " : text().text;  // standard input has been read
  const std::shared_ptr<const TextSetup> next = SetUp(request);
  const Followed followed = Follow(felt_, *next, tip_P);
  const std::size_t first = felt_.number - felt_.index;
  Show(FeltPageOf(next, followed.page, felt_.blank,
                  static_cast<std::uint32_t>(first + followed.page)),
       followed.anchor);
  request.text = given;
  request_ = std::move(request);
}

void LoopSession::ChangeText(TextRequest request, bool blank, std::size_t most_pages) {
  request.room = request_.room;
  request.feel = request_.feel;
  request.model_page = request_.model_page;
  const std::shared_ptr<const TextSetup> next = SetUp(request);
  if (next->set.pages.size() > most_pages) {
    throw InputError(say::MorePagesThan(next->set.pages.size(), most_pages));
  }
  Show(FeltPageOf(next, 0, blank, FirstFree()), std::nullopt);
  form_ = request.form.value_or(form_);
  request_ = std::move(request);
}

/// The number of the first page of a text that comes next.
std::uint32_t LoopSession::FirstFree() const {
  return static_cast<std::uint32_t>(felt_.number - felt_.index + text().set.pages.size());
}

void LoopSession::TurnToStartOf(std::size_t index) {
  const FeltPage page = OtherPage(felt_, index);
  Show(page, StartOf(page));
}

void LoopSession::LayLine(TextRequest request) {
  request.room = request_.room;
  const std::shared_ptr<const TextSetup> next = SetUp(request);
  const FeltPage page = FeltPageOf(next, 0, false, FirstFree());
  Show(page, StartOf(page));
  request_ = std::move(request);
}

void LoopSession::LayAgain(Laid laid, glm::dvec2 at_P) {
  laid.page.number = static_cast<std::uint32_t>(FirstFree() + laid.page.index);
  Show(std::move(laid.page), PageAnchor{{0, 0}, at_P, 0});
  request_ = std::move(laid.request);
  form_ = laid.form;
}

std::vector<LoopSession::LabelOf> LoopSession::labels() const {
  std::vector<LabelOf> found;
  if (!request_.model_page) return found;
  const std::vector<Label>& all = request_.model_page->labels;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto left = left_.find(i);
    std::string words = all[i].text;
    if (left != left_.end()) words = left->second.page.text->text;
    if (i == label()) words = text().text;
    if (words.empty()) continue;
    std::string face = all[i].face ? std::string(NameOf(*all[i].face)) : std::string();
    found.push_back(
        {i, NameOf(all[i]), all[i].geom, all[i].carrier, std::move(face), std::move(words)});
  }
  return found;
}

/// A label's own text, set as it asks for.
LoopSession::Laid LoopSession::Lay(std::size_t label) {
  Laid laid{given_, {}, {}};
  TextRequest& request = laid.request;
  request.text = {};
  request.default_text.clear();
  request.form.reset();
  request.feel.scene.label = request.model_page->number = label;
  request.model_page->moves = false;  // said of the first one
  const std::shared_ptr<const TextSetup> set = SetUp(request);
  laid.page = FeltPageOf(set, 0, felt_.blank, 0);
  const std::optional<PaperTexture>& paper = set->set.style.texture.paper;
  if (paper) laid.form.paper = paper->kind;
  return laid;
}

void LoopSession::GoToLabel(std::size_t number) {
  const std::size_t before = label();
  if (number == before || !request_.model_page) return;
  const auto left = left_.find(number);
  Laid next = left != left_.end() ? left->second : Lay(number);
  next.page.number = static_cast<std::uint32_t>(FirstFree() + next.page.index);
  // what was felt on the page until now stays there
  const LaidLabel stays{before, felt_.field, OnLabel(text(), felt_.index, {}).text_P};
  left_[before] = Lies();
  others_.push_back(stays);
  const Box text_P = OnLabel(*next.page.text, next.page.index, {}).text_P;
  Show(next.page, StartOf(next.page));
  std::erase_if(others_, [&](const LaidLabel& other) {
    return other.label == number || (other.label == before && other.field != stays.field);
  });
  const Label& label = next.request.model_page->label();
  view_model_ = WithPage(*view_model_, stays, label, {number, felt_.field, text_P}, text().text);
  request_ = std::move(next.request);
  form_ = next.form;
}

void LoopSession::GoOn() {
  if (device_.simulated()) Show(felt_, std::nullopt);
  loop_->GoOn();
}

void LoopSession::Tilt(double tilt) {
  if (!device_.limits().measures.z) throw InputError(say::NoTiltInPlane());
  LetFeel(felt_, std::nullopt, tilt);
  tilt_ = tilt;
}

}  // namespace moontrace
