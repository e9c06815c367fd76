#include "sim/view/view_panel.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#ifdef MOONTRACE_HAVE_IMGUI
#include <imgui.h>
#endif

namespace moontrace {

namespace {

constexpr double kKeep = 0.7;      // a change made here outweighs the values that come [s]
constexpr double kSayEvery = 0.1;  // of a dragged slider [s]
constexpr double kWidth = 21.5;    // of the panel, in heights of a letter

using Kind = PanelControl::Kind;

bool CanFocus(Kind kind) {
  return kind == Kind::kSlider || kind == Kind::kChoice || kind == Kind::kButton;
}

}  // namespace

struct ViewPanel::State {
  CanvasMouse mouse;
  std::vector<PanelControl> controls;
  std::vector<PanelValue> told, shown;  ///< one a control, what came and what is seen
  std::vector<double> kept_until;
  std::vector<std::string> said;
  struct Pending {
    std::size_t control = 0;
    bool dragged = false;
  };
  std::optional<Pending> pending;
  double said_at = -1, now = 0;
  std::deque<std::string> lines;
  std::optional<std::size_t> focus;
  bool reveal = false;  // the focused control shall be seen
  ViewColors colors;
  int width = 0;
  bool changed = true;

  void Apply();
  void Touched(std::size_t control, bool dragged);
  void SayPending();
  // the controls as they are drawn and asked, within a canvas's frame
  void Build(const PixelBox& box, const Canvas& canvas);
  void Row(std::size_t index);
  void Slider(std::size_t index);
  void Choice(std::size_t index);
  void Button(std::size_t index);
  void ShowFocus();
};

/// The values that have come are shown.
void ViewPanel::State::Apply() {
  for (std::size_t i = 0; i < std::min(told.size(), controls.size()); ++i) {
    if (kept_until[i] <= 0) shown[i] = told[i];
  }
  changed = true;
}

void ViewPanel::State::Touched(std::size_t control, bool dragged) {
  kept_until[control] = now + kKeep;
  changed = true;
  if (pending && pending->control != control) SayPending();
  pending = Pending{control, dragged};
  if (!dragged) SayPending();
}

void ViewPanel::State::SayPending() {
  if (!pending) return;
  const std::size_t control = pending->control;
  pending.reset();
  std::string line = LineOf(controls[control], shown[control]);
  const bool button = controls[control].kind == Kind::kButton;
  if (line.empty() || (!button && line == said[control])) return;
  said[control] = line;
  said_at = now;
  lines.push_back(std::move(line));
}

#ifdef MOONTRACE_HAVE_IMGUI

namespace {

constexpr float kLabelWidth = 7.2F;  // in heights of a letter

/// Of the slider's steps.
double Stepped(const PanelControl& slider, double value) {
  if (slider.step <= 0) return std::clamp(value, slider.low, slider.high);
  const double steps = std::round((value - slider.low) / slider.step);
  return std::clamp(slider.low + steps * slider.step, slider.low, slider.high);
}

ImVec4 ColorOf(const Color& color) {
  return {static_cast<float>(color.red), static_cast<float>(color.green),
          static_cast<float>(color.blue), 1};
}

void SetTheme(ImGuiStyle& style, const ViewColors& colors, float em) {
  style.WindowPadding = {0.7F * em, 0.7F * em};
  style.FramePadding = {0.5F * em, 0.22F * em};
  style.ItemSpacing = {0.45F * em, 0.42F * em};
  style.WindowBorderSize = 0;
  style.WindowRounding = 0;
  style.FrameBorderSize = 1;
  style.FrameRounding = style.GrabRounding = style.ScrollbarRounding = 0.22F * em;
  style.GrabMinSize = 0.9F * em;
  style.ScrollbarSize = 0.8F * em;
  ImVec4* const color = style.Colors;
  color[ImGuiCol_WindowBg] = color[ImGuiCol_ScrollbarBg] = ColorOf(colors.back);
  color[ImGuiCol_Text] = ColorOf(colors.text);
  color[ImGuiCol_Border] = color[ImGuiCol_Separator] = ColorOf(colors.edge);
  color[ImGuiCol_ScrollbarGrab] = color[ImGuiCol_ScrollbarGrabHovered] =
      color[ImGuiCol_ScrollbarGrabActive] = ColorOf(colors.edge);
  for (const int part : {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive,
                         ImGuiCol_Button, ImGuiCol_ButtonHovered}) {
    color[part] = ColorOf(colors.button);
  }
  for (const int part : {ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive, ImGuiCol_ButtonActive}) {
    color[part] = ColorOf(colors.chosen);
  }
}

/// How many of the buttons with these names stand side by side.
int SideBySide(const std::vector<std::string>& names) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float half = 0.5F * (ImGui::GetContentRegionAvail().x - style.ItemSpacing.x);
  const bool fit = std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return ImGui::CalcTextSize(name.c_str()).x + 2 * style.FramePadding.x <= half;
  });
  return fit ? 2 : 1;
}

}  // namespace

void ViewPanel::State::Slider(std::size_t index) {
  const PanelControl& control = controls[index];
  double value = shown[index].number;
  int digits = 0;
  for (double step = control.step; step > 0 && step < 0.999 && digits < 6; step *= 10) ++digits;
  const std::string format = "%." + std::to_string(digits) + "f";
  ImGui::SetNextItemWidth(-1);
  ImGui::SliderScalar("##slider", ImGuiDataType_Double, &value, &control.low, &control.high,
                      format.c_str());
  if (ImGui::IsItemActive() && mouse.left) {
    value = Stepped(control, value);
    if (value != shown[index].number) {
      shown[index].number = value;
      Touched(index, true);
    }
  }
  if (ImGui::IsItemDeactivated()) SayPending();
}

void ViewPanel::State::Choice(std::size_t index) {
  const PanelControl& control = controls[index];
  const int columns = SideBySide(control.choices);
  ImGui::BeginGroup();
  const float room = ImGui::GetContentRegionAvail().x;
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float wide = columns == 2 ? 0.5F * (room - spacing) : room;
  for (int i = 0; i < static_cast<int>(control.choices.size()); ++i) {
    if (columns == 2 && i % 2 == 1) ImGui::SameLine(0, spacing);
    const bool chosen = i == shown[index].choice;
    const ImVec4 color = ColorOf(chosen ? colors.chosen : colors.button);
    ImGui::PushStyleColor(ImGuiCol_Button, color);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, color);
    ImGui::PushID(i);
    if (ImGui::Button(control.choices[static_cast<std::size_t>(i)].c_str(), {wide, 0})) {
      shown[index].choice = i;
      Touched(index, false);
    }
    ImGui::PopID();
    ImGui::PopStyleColor(2);
  }
  ImGui::EndGroup();
}

/// Two side by side, as far as they follow each other.
void ViewPanel::State::Button(std::size_t index) {
  std::size_t first = index;
  while (first > 0 && controls[first - 1].kind == Kind::kButton) --first;
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const bool right = (index - first) % 2 == 1;
  if (right) ImGui::SameLine(0, spacing);
  const float room = ImGui::GetContentRegionAvail().x;
  if (ImGui::Button(controls[index].label.c_str(), {right ? room : 0.5F * (room - spacing), 0})) {
    Touched(index, false);
  }
}

void ViewPanel::State::Row(std::size_t index) {
  const PanelControl& control = controls[index];
  if (control.kind == Kind::kHeading) {
    ImGui::Dummy({0, 0.1F * ImGui::GetFontSize()});
    ImGui::PushStyleColor(ImGuiCol_Text, ColorOf(colors.title));
    ImGui::TextUnformatted(control.label.c_str());
    ImGui::PopStyleColor();
    ImGui::Separator();
    return;
  }
  if (control.kind == Kind::kButton) return Button(index);
  ImGui::AlignTextToFramePadding();
  std::string label = control.label;
  if (control.kind == Kind::kSlider && !control.unit.empty()) label += ", " + control.unit;
  ImGui::TextUnformatted(label.c_str());
  ImGui::SameLine(kLabelWidth * ImGui::GetFontSize());
  if (control.kind == Kind::kSlider) {
    Slider(index);
  } else if (control.kind == Kind::kChoice) {
    Choice(index);
  } else {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(shown[index].text.c_str());
    ImGui::PopTextWrapPos();
  }
}

/// Round the control that was drawn last.
void ViewPanel::State::ShowFocus() {
  constexpr float kThick = 3;
  ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  low = {low.x - 2, low.y - 2};
  high = {high.x + 2, high.y + 2};
  ImGui::GetWindowDrawList()->AddRect(low, high,
                                      ImGui::ColorConvertFloat4ToU32(ColorOf(colors.focus)), 3,
                                      ImDrawFlags_None, kThick);
  if (std::exchange(reveal, false)) ImGui::SetScrollHereY(0.5F);
}

void ViewPanel::State::Build(const PixelBox& box, const Canvas& canvas) {
  SetTheme(ImGui::GetStyle(), colors, ImGui::GetFontSize());
  ImGui::SetNextWindowPos(
      {static_cast<float>(box.x), static_cast<float>(canvas.height() - box.y - box.height)});
  ImGui::SetNextWindowSize({static_cast<float>(box.width), static_cast<float>(box.height)});
  ImGui::Begin("panel", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoNav);
  for (std::size_t i = 0; i < controls.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    Row(i);
    if (focus == i) ShowFocus();
    ImGui::PopID();
  }
  ImGui::End();
}

#else

void ViewPanel::State::Build(const PixelBox& /*box*/, const Canvas& /*canvas*/) {}

#endif

ViewPanel::ViewPanel() : state_(std::make_unique<State>()) {}
ViewPanel::~ViewPanel() = default;

void ViewPanel::SetControls(std::vector<PanelControl> controls) {
  State& s = *state_;
  s.controls = std::move(controls);
  s.told.clear();
  PanelValue none;
  none.choice = -1;
  s.shown.assign(s.controls.size(), none);
  s.kept_until.assign(s.controls.size(), 0);
  s.said.assign(s.controls.size(), {});
  s.pending.reset();
  if (s.focus && (*s.focus >= s.controls.size() || !CanFocus(s.controls[*s.focus].kind))) {
    s.focus.reset();
  }
  s.changed = true;
}

void ViewPanel::SetValues(std::vector<PanelValue> values) {
  State& s = *state_;
  if (s.told == values) return;
  s.told = std::move(values);
  s.Apply();
}

bool ViewPanel::empty() const { return state_->controls.empty(); }

void ViewPanel::Prepare(int text_height, const ViewColors& colors) {
  state_->width = static_cast<int>(std::lround(kWidth * text_height));
  state_->colors = colors;
  state_->changed = true;
}

int ViewPanel::width() const { return empty() ? 0 : state_->width; }

bool ViewPanel::changed() const { return state_->changed; }

const CanvasMouse& ViewPanel::mouse() const { return state_->mouse; }

void ViewPanel::Draw(const PixelBox& box, const Canvas& canvas) {
  state_->changed = false;
  if (!empty() && !box.empty()) state_->Build(box, canvas);
}

void ViewPanel::Handle(const WindowEvent& event, const PixelBox& box, Canvas& canvas,
                       glm::ivec2 picture, double now) {
  State& s = *state_;
  if (empty() || box.empty()) return;
  s.now = now;
  s.mouse.at = event.at;
  s.mouse.wheel = 0;
  const bool left = event.button == WindowEvent::Button::kLeft;
  switch (event.kind) {
    case WindowEvent::Kind::kMove:
      break;
    case WindowEvent::Kind::kPress:
      if (!left) return;
      s.focus.reset();
      s.mouse.left = true;
      break;
    case WindowEvent::Kind::kRelease:
      if (!left) return;
      s.mouse.left = false;
      break;
    case WindowEvent::Kind::kWheel:
      s.mouse.wheel = event.wheel;
      break;
    default:
      return;
  }
  canvas.Begin(picture.x, picture.y, s.mouse);
  s.Build(box, canvas);
  canvas.End(false);
  s.mouse.wheel = 0;
  if (event.kind == WindowEvent::Kind::kRelease) s.SayPending();
  s.changed = true;
}

void ViewPanel::MoveFocus(int by) {
  State& s = *state_;
  const auto count = static_cast<int>(s.controls.size());
  int at = s.focus ? static_cast<int>(*s.focus) : (by > 0 ? -1 : count);
  for (int tried = 0; tried < count; ++tried) {
    at = (at + by + count) % count;
    const auto index = static_cast<std::size_t>(at);
    if (!CanFocus(s.controls[index].kind)) continue;
    s.focus = index;
    s.reveal = true;
    break;
  }
  s.changed = true;
}

void ViewPanel::DropFocus() {
  state_->changed = state_->changed || state_->focus;
  state_->focus.reset();
}

bool ViewPanel::has_focus() const { return state_->focus.has_value(); }

void ViewPanel::ChangeFocused(int by, double now) {
  State& s = *state_;
  if (!s.focus) return;
  s.now = now;
  const PanelControl& control = s.controls[*s.focus];
  if (control.kind == Kind::kSlider) {
    double& number = s.shown[*s.focus].number;
    number = std::clamp(number + by * control.step, control.low, control.high);
    s.Touched(*s.focus, true);
  } else if (control.kind == Kind::kChoice && !control.choices.empty()) {
    int& choice = s.shown[*s.focus].choice;
    choice = std::clamp(choice + by, 0, static_cast<int>(control.choices.size()) - 1);
    s.Touched(*s.focus, false);
  }
}

void ViewPanel::PressFocused(double now) {
  State& s = *state_;
  if (!s.focus) return;
  s.now = now;
  const PanelControl& control = s.controls[*s.focus];
  if (control.kind == Kind::kButton) {
    s.Touched(*s.focus, false);
  } else if (control.kind == Kind::kChoice && !control.choices.empty()) {
    int& choice = s.shown[*s.focus].choice;
    choice = (choice + 1) % static_cast<int>(control.choices.size());
    s.Touched(*s.focus, false);
  }
}

bool ViewPanel::Has(std::string_view word) const {
  const auto says = [&](const PanelControl& control) {
    return control.kind == Kind::kButton && control.word == word;
  };
  return std::any_of(state_->controls.begin(), state_->controls.end(), says);
}

std::optional<std::string> ViewPanel::NextLine(double now) {
  State& s = *state_;
  s.now = now;
  if (s.pending && now - s.said_at >= kSayEvery) s.SayPending();
  for (std::size_t i = 0; i < s.kept_until.size(); ++i) {
    if (s.kept_until[i] <= 0 || s.kept_until[i] > now || s.mouse.left) continue;
    s.kept_until[i] = 0;
    s.said[i].clear();
    s.Apply();
  }
  if (s.lines.empty()) return std::nullopt;
  std::string line = std::move(s.lines.front());
  s.lines.pop_front();
  return line;
}

}  // namespace moontrace
