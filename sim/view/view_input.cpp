#include "sim/view/view_input.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/view/view_messages.h"

namespace moontrace {

namespace {

using Kind = WindowEvent::Kind;
using Button = WindowEvent::Button;
using KeyName = WindowEvent::Key;

constexpr double kLightest = 0.2, kFirmest = 3, kPressStep = 0.1;  // [N]
constexpr double kZoomStep = 0.8;                                  // of a key or a notch
constexpr double kPanStep = 0.1;                                   // of the picture, of a key
constexpr double kTurnStep = 0.06;                                 // of half a turn, of a key
constexpr std::size_t kLongestLine = 400;                          // [bytes]

void AppendUtf8(std::string& text, char32_t c) {
  const auto byte = [&text](char32_t bits) { text += static_cast<char>(bits); };
  if (c < 0x80) {
    byte(c);
  } else if (c < 0x800) {
    byte(0xc0 | (c >> 6));
    byte(0x80 | (c & 0x3f));
  } else if (c < 0x10000) {
    byte(0xe0 | (c >> 12));
    byte(0x80 | ((c >> 6) & 0x3f));
    byte(0x80 | (c & 0x3f));
  } else if (c < 0x110000) {
    byte(0xf0 | (c >> 18));
    byte(0x80 | ((c >> 12) & 0x3f));
    byte(0x80 | ((c >> 6) & 0x3f));
    byte(0x80 | (c & 0x3f));
  }
}

void EraseLast(std::string& utf8) {
  while (!utf8.empty() && (static_cast<unsigned char>(utf8.back()) & 0xc0) == 0x80) {
    utf8.pop_back();
  }
  if (!utf8.empty()) utf8.pop_back();
}

}  // namespace

ViewInput::ViewInput(ViewPainter& painter, std::function<void(const PointerAim&)> pointer)
    : painter_(painter), pointer_(std::move(pointer)) {
  if (pointer_) painter_.SetHint(say::ViewPress(press_));
}

void ViewInput::Handle(const WindowEvent& event, double now) {
  switch (event.kind) {
    case Kind::kKey:
      Key(event, now);
      break;
    case Kind::kText:
      Text(event.text);
      break;
    default:
      Mouse(event, now);
      break;
  }
  painter_.SetTyped(typed_);
}

std::optional<ViewLine> ViewInput::NextLine(double now) {
  while (std::optional<std::string> line = painter_.panel().NextLine(now)) {
    lines_.push_back({std::move(*line), true});
  }
  if (lines_.empty()) return std::nullopt;
  ViewLine line = std::move(lines_.front());
  lines_.pop_front();
  if (line.text == "pause") paused_ = true;
  if (line.text == "go") paused_ = false;
  return line;
}

void ViewInput::PauseOrGo() {
  const bool pauses = painter_.panel().Has("pause");
  lines_.push_back({paused_ ? "go" : (pauses ? "pause" : "stop")});
  paused_ = !paused_;
}

void ViewInput::Text(char32_t character) {
  if (character == ' ' && typed_.empty()) {
    PauseOrGo();
  } else if (character >= 0x20 && character != 0x7f && typed_.size() < kLongestLine) {
    AppendUtf8(typed_, character);
  }
}

void ViewInput::Key(const WindowEvent& event, double now) {
  ViewPanel& panel = painter_.panel();
  const auto move = [&](int by, glm::dvec2 direction) {
    if (panel.has_focus()) return panel.ChangeFocused(by, now);
    if (painter_.shows_model()) return painter_.TurnBy(-kTurnStep * direction);
    const glm::dvec2 step = kPanStep * direction / glm::dvec2(painter_.aspect(), 1);
    painter_.Drag({0.5, 0.5}, glm::dvec2(0.5, 0.5) - step);
  };
  switch (event.key) {
    case KeyName::kEnter:
      if (typed_.empty()) return panel.PressFocused(now);
      lines_.push_back({std::exchange(typed_, {})});
      break;
    case KeyName::kEscape:
      typed_.clear();
      panel.DropFocus();
      paused_ = true;
      lines_.push_back({"stop"});
      break;
    case KeyName::kBackspace:
      return EraseLast(typed_);
    case KeyName::kTab:
      return panel.MoveFocus(event.shift ? -1 : 1);
    case KeyName::kUp:
      return move(1, {0, 1});
    case KeyName::kRight:
      return move(1, {1, 0});
    case KeyName::kDown:
      return move(-1, {0, -1});
    case KeyName::kLeft:
      return move(-1, {-1, 0});
    case KeyName::kPageUp:
      return painter_.ZoomBy(kZoomStep, {0.5, 0.5});
    case KeyName::kPageDown:
      return painter_.ZoomBy(1 / kZoomStep, {0.5, 0.5});
    case KeyName::kHome:
      return painter_.ShowWholePage();
    case KeyName::kNone:
      break;
  }
}

glm::dvec2 ViewInput::ShareAt(glm::dvec2 at) const {
  const PixelBox& page = painter_.layout().page;
  return {(at.x - page.x) / std::max(page.width, 1), (at.y - page.y) / std::max(page.height, 1)};
}

void ViewInput::Aim(bool over_page) {
  if (!pointer_ || (!over_page && !over_page_)) return;
  over_page_ = over_page;
  const std::optional<glm::dvec2> p_P = painter_.PointUnder(ShareAt(at_));
  PointerAim aim;
  aim.p_P = aimed_P_ = p_P.value_or(aimed_P_);
  aim.press = over_page && p_P && held_ == Button::kLeft ? press_ : 0;
  aim.over_page = over_page;
  pointer_(aim);
}

void ViewInput::Mouse(const WindowEvent& event, double now) {
  const ViewLayout& layout = painter_.layout();
  const bool on_page = layout.page.Has(event.at.x, event.at.y);
  const bool on_panel = layout.panel.Has(event.at.x, event.at.y);
  if (event.kind == Kind::kLeave) return Aim(false);
  if (event.kind == Kind::kPress) {
    if (on_panel && event.button == Button::kLeft) in_panel_ = true;
    if (on_page && held_ == Button::kNone) held_ = event.button;
  }
  if (in_panel_ || (on_panel && held_ == Button::kNone)) painter_.PanelEvent(event, now);
  if (event.kind == Kind::kMove) Drag(event);
  if (event.kind == Kind::kWheel && on_page) Wheel(event);
  if (event.kind == Kind::kRelease) {
    if (event.button == Button::kLeft) in_panel_ = false;
    if (event.button == held_) held_ = Button::kNone;
  }
  at_ = event.at;
  Aim(!in_panel_ && (on_page || held_ == Button::kLeft));
}

void ViewInput::Drag(const WindowEvent& event) {
  const bool free = held_ == Button::kLeft && !pointer_;
  const bool turns = held_ == Button::kMiddle || (free && painter_.shows_model());
  if (turns) {
    painter_.TurnBy((event.at - at_) /
                    static_cast<double>(std::max(painter_.layout().page.height, 1)));
  } else if (held_ == Button::kRight || free) {
    painter_.Drag(ShareAt(at_), ShareAt(event.at));
  }
}

void ViewInput::Wheel(const WindowEvent& event) {
  if (event.control || !pointer_) {
    painter_.ZoomBy(std::pow(kZoomStep, event.wheel), ShareAt(event.at));
    return;
  }
  press_ = std::clamp(press_ + kPressStep * event.wheel, kLightest, kFirmest);
  painter_.SetHint(say::ViewPress(press_));
}

}  // namespace moontrace
