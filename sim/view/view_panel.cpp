#include "sim/view/view_panel.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <deque>
#include <utility>

#include "sim/view/view_look.h"
#include "sim/view/view_text.h"
#include "textures/base/text_file.h"

namespace moontrace {

namespace {

constexpr double kKeep = 0.7;      // a change made here outweighs the values that come [s]
constexpr double kSayEvery = 0.1;  // of a dragged slider [s]
constexpr int kAux = 0, kRect = 1;

using Kind = PanelControl::Kind;

template <std::size_t N>
void Copy(char (&to)[N], const std::string& text) {
  std::memset(to, 0, N);
  std::strncpy(to, text.c_str(), N - 1);
}

bool CanFocus(Kind kind) {
  return kind == Kind::kSlider || kind == Kind::kChoice || kind == Kind::kButton;
}

}  // namespace

struct ViewPanel::State {
  std::unique_ptr<mjUI> ui = std::make_unique<mjUI>();  // 1 to 3 MB
  mjuiState mouse{};
  std::vector<PanelControl> controls;
  std::vector<PanelValue> told;
  // what the controls point to, one a control
  std::vector<mjtNum> numbers;
  std::vector<int> choices;
  struct Place {
    int section = -1, item = -1;
  };
  std::vector<Place> places;
  std::vector<double> kept_until;
  std::vector<std::string> said;
  struct Pending {
    std::size_t control = 0;
    bool dragged = false;
  };
  std::optional<Pending> pending;
  double said_at = -1;
  std::deque<std::string> lines;
  std::optional<std::size_t> focus;
  int height = 0;  // of the panel when it was drawn last [points]
  ViewColors colors;
  mjrContext* context = nullptr;  // it was prepared for
  bool redraw = true;             // the picture of the controls
  bool changed = true;            // what is shown

  void Build();
  void AddItem(std::size_t index, int section);
  std::string Fitting(const std::string& text) const;
  void Apply();
  std::optional<std::size_t> ControlOf(const mjuiItem* item) const;
  const mjuiItem& ItemOf(std::size_t control) const {
    const Place& place = places[control];
    return ui->sect[place.section].item[place.item];
  }
  PanelValue Now(std::size_t control) const { return {numbers[control], choices[control], {}}; }
  void Touched(std::size_t control, bool dragged, double now);
  void SayPending(double now);
  void ShowFocus();
  int BottomOf(std::size_t control) const {
    return height - ui->height + ui->scroll + ItemOf(control).rect.bottom;
  }
  void Reveal(std::size_t control);
};

void ViewPanel::State::AddItem(std::size_t index, int section) {
  const PanelControl& control = controls[index];
  const auto def = std::make_unique<std::array<mjuiDef, 2>>();
  std::memset(def->data(), 0, sizeof *def);
  mjuiDef& item = def->front();
  item.state = 1;
  std::string label = control.label;
  switch (control.kind) {
    case Kind::kHeading:
    case Kind::kText:
      item.type = mjITEM_STATIC;
      Copy(item.other, " ");
      break;
    case Kind::kSlider:
      item.type = mjITEM_SLIDERNUM;
      item.pdata = &numbers[index];
      std::snprintf(item.other, sizeof item.other, "%.9g %.9g", control.low, control.high);
      if (!control.unit.empty()) label += " " + control.unit;
      break;
    case Kind::kChoice: {
      item.type = mjITEM_RADIO;
      item.pdata = &choices[index];
      std::string names;
      for (const std::string& choice : control.choices) {
        if (!names.empty()) names += '\n';
        names += OneLine(choice, mjMAXUINAME - 1);
      }
      Copy(item.other, names);
      break;
    }
    case Kind::kButton:
      item.type = mjITEM_BUTTON;
      break;
  }
  Copy(item.name, OneLine(label, mjMAXUINAME - 1));
  (*def)[1].type = mjITEM_END;
  if (ui->sect[section].nitem >= mjMAXUIITEM) return;
  mjui_addToSection(ui.get(), section, def->data());
  places[index] = {section, ui->sect[section].nitem - 1};
}

void ViewPanel::State::Build() {
  std::memset(static_cast<void*>(ui.get()), 0, sizeof *ui);
  ui->rectid = kRect;
  ui->auxid = kAux;
  ui->radiocol = 2;
  SetTheme(*ui, colors);
  places.assign(controls.size(), {});
  for (std::size_t i = 0; i < controls.size(); ++i) {
    const bool heading = controls[i].kind == Kind::kHeading;
    if ((heading || ui->nsect == 0) && ui->nsect < mjMAXUISECT) {
      const auto def = std::make_unique<std::array<mjuiDef, 2>>();
      std::memset(def->data(), 0, sizeof *def);
      def->front().type = mjITEM_SECTION;
      def->front().state = 1;
      Copy(def->front().name, heading ? OneLine(controls[i].label, mjMAXUINAME - 1) : " ");
      (*def)[1].type = mjITEM_END;
      mjui_add(ui.get(), def->data());
      if (heading) continue;
    }
    AddItem(i, ui->nsect - 1);
  }
  Apply();
}

/// What there is room for behind a label.
std::string ViewPanel::State::Fitting(const std::string& text) const {
  std::string line = OneLine(text, mjMAXUINAME - 1);
  if (context == nullptr) return line;
  return RowsOf(AsciiOf(line, "?"), TextRoom(*context), 1, *context).front();
}

/// The values that have come are shown.
void ViewPanel::State::Apply() {
  for (std::size_t i = 0; i < std::min(told.size(), controls.size()); ++i) {
    if (kept_until[i] > 0) continue;
    numbers[i] = told[i].number;
    choices[i] = told[i].choice;
    if (controls[i].kind == Kind::kText && places[i].section >= 0) {
      mjuiItem& item = ui->sect[places[i].section].item[places[i].item];
      Copy(item.multi.name[0], Fitting(told[i].text));
    }
  }
  redraw = changed = true;
}

std::optional<std::size_t> ViewPanel::State::ControlOf(const mjuiItem* item) const {
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].section >= 0 && &ItemOf(i) == item) return i;
  }
  return std::nullopt;
}

void ViewPanel::State::Touched(std::size_t control, bool dragged, double now) {
  kept_until[control] = now + kKeep;
  redraw = changed = true;
  if (pending && pending->control != control) SayPending(now);
  pending = Pending{control, dragged};
  if (!dragged) SayPending(now);
}

void ViewPanel::State::SayPending(double now) {
  if (!pending) return;
  const std::size_t control = pending->control;
  pending.reset();
  std::string line = LineOf(controls[control], Now(control));
  const bool button = controls[control].kind == Kind::kButton;
  if (line.empty() || (!button && line == said[control])) return;
  said[control] = line;
  said_at = now;
  lines.push_back(std::move(line));
}

/// Scrolls as far as it must so that all of a control is seen.
void ViewPanel::State::Reveal(std::size_t control) {
  constexpr int kMargin = 12;
  const int bottom = BottomOf(control), top = bottom + ItemOf(control).rect.height;
  if (bottom < kMargin) ui->scroll += kMargin - bottom;
  if (top > height - kMargin) ui->scroll -= top - (height - kMargin);
  ui->scroll = std::clamp(ui->scroll, 0, std::max(ui->height - height, 0));
}

ViewPanel::ViewPanel() : state_(std::make_unique<State>()) {}
ViewPanel::~ViewPanel() = default;

void ViewPanel::SetControls(std::vector<PanelControl> controls) {
  State& s = *state_;
  s.controls = std::move(controls);
  s.told.clear();
  s.numbers.assign(s.controls.size(), 0);
  s.choices.assign(s.controls.size(), -1);
  s.kept_until.assign(s.controls.size(), 0);
  s.said.assign(s.controls.size(), {});
  s.pending.reset();
  if (s.focus && (*s.focus >= s.controls.size() || !CanFocus(s.controls[*s.focus].kind))) {
    s.focus.reset();
  }
  const int scroll = s.ui->scroll;
  s.Build();
  s.ui->scroll = scroll;
  if (s.context != nullptr) Prepare(*s.context, s.colors);
}

void ViewPanel::SetValues(std::vector<PanelValue> values) {
  State& s = *state_;
  if (s.told == values) return;
  s.told = std::move(values);
  s.Apply();
}

bool ViewPanel::empty() const { return state_->controls.empty(); }

void ViewPanel::Prepare(mjrContext_& context, const ViewColors& colors) {
  State& s = *state_;
  s.context = &context;
  s.colors = colors;
  if (empty()) return;
  SetTheme(*s.ui, colors);
  s.Apply();
  mjui_resize(s.ui.get(), &context);
  mjr_addAux(kAux, s.ui->width, s.ui->maxheight, s.ui->spacing.samples, &context);
  s.redraw = s.changed = true;
}

int ViewPanel::width() const { return empty() ? 0 : state_->ui->width; }

bool ViewPanel::changed() const { return state_->changed; }

void ViewPanel::Draw(const PixelBox& box, const mjrContext_& context) {
  State& s = *state_;
  s.changed = false;
  if (empty() || box.empty()) return;
  s.height = box.height;
  const mjrRect rect = {box.x, box.y, box.width, box.height};
  s.mouse.nrect = 2;
  s.mouse.rect[0] = s.mouse.rect[kRect] = rect;
  if (s.redraw) mjui_update(-1, -1, s.ui.get(), &s.mouse, &context);
  s.redraw = false;
  FillBox(box, s.colors.back);
  mjui_render(s.ui.get(), &s.mouse, &context);
  s.ShowFocus();
}

void ViewPanel::State::ShowFocus() {
  if (!focus || places[*focus].section < 0) return;
  const mjrRect& item = ItemOf(*focus).rect;
  FrameBox({item.left, BottomOf(*focus), item.width, item.height}, 3, colors.focus);
}

void ViewPanel::Handle(const WindowEvent& event, const PixelBox& box, const mjrContext_& context,
                       double now) {
  State& s = *state_;
  if (empty() || box.empty()) return;
  mjuiState& mouse = s.mouse;
  mouse.nrect = 2;
  mouse.rect[0] = mouse.rect[kRect] = {box.x, box.y, box.width, box.height};
  mouse.dx = event.at.x - mouse.x;
  mouse.dy = event.at.y - mouse.y;
  mouse.x = event.at.x;
  mouse.y = event.at.y;
  mouse.sx = mouse.sy = 0;
  mouse.mouserect = box.Has(mouse.x, mouse.y) ? kRect : 0;
  const bool left = event.button == WindowEvent::Button::kLeft;
  switch (event.kind) {
    case WindowEvent::Kind::kMove:
      mouse.type = mjEVENT_MOVE;
      break;
    case WindowEvent::Kind::kPress:
      if (!left) return;
      s.focus.reset();
      mouse.type = mjEVENT_PRESS;
      mouse.left = 1;
      mouse.button = mjBUTTON_LEFT;
      mouse.buttontime = now;
      mouse.dragrect = mouse.mouserect;
      mouse.dragbutton = mjBUTTON_LEFT;
      break;
    case WindowEvent::Kind::kRelease:
      if (!left) return;
      mouse.type = mjEVENT_RELEASE;
      mouse.left = 0;
      mouse.button = mjBUTTON_LEFT;
      break;
    case WindowEvent::Kind::kWheel:
      mouse.type = mjEVENT_SCROLL;
      mouse.sy = event.wheel;
      break;
    default:
      return;
  }
  if (const mjuiItem* item = mjui_event(s.ui.get(), &mouse, &context)) {
    if (const std::optional<std::size_t> control = s.ControlOf(item)) {
      s.Touched(*control, mouse.left != 0 && item->type == mjITEM_SLIDERNUM, now);
    }
  }
  s.changed = true;
  if (mouse.type == mjEVENT_RELEASE) {
    mouse.dragrect = mouse.dragbutton = 0;
    s.SayPending(now);
  }
}

void ViewPanel::MoveFocus(int by) {
  State& s = *state_;
  const auto count = static_cast<int>(s.controls.size());
  int at = s.focus ? static_cast<int>(*s.focus) : (by > 0 ? -1 : count);
  for (int tried = 0; tried < count; ++tried) {
    at = (at + by + count) % count;
    const auto index = static_cast<std::size_t>(at);
    if (!CanFocus(s.controls[index].kind) || s.places[index].section < 0) continue;
    s.focus = index;
    mjuiSection& section = s.ui->sect[s.places[index].section];
    if (section.state == 0) {
      section.state = 1;
      if (s.context != nullptr) mjui_resize(s.ui.get(), s.context);
      s.redraw = true;
    }
    s.Reveal(index);
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
  const PanelControl& control = s.controls[*s.focus];
  if (control.kind == Kind::kSlider) {
    double& number = s.numbers[*s.focus];
    number = std::clamp(number + by * control.step, control.low, control.high);
    s.Touched(*s.focus, true, now);
  } else if (control.kind == Kind::kChoice && !control.choices.empty()) {
    int& choice = s.choices[*s.focus];
    choice = std::clamp(choice + by, 0, static_cast<int>(control.choices.size()) - 1);
    s.Touched(*s.focus, false, now);
  }
}

void ViewPanel::PressFocused(double now) {
  State& s = *state_;
  if (!s.focus) return;
  const PanelControl& control = s.controls[*s.focus];
  if (control.kind == Kind::kButton) {
    s.Touched(*s.focus, false, now);
  } else if (control.kind == Kind::kChoice && !control.choices.empty()) {
    int& choice = s.choices[*s.focus];
    choice = (choice + 1) % static_cast<int>(control.choices.size());
    s.Touched(*s.focus, false, now);
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
  if (s.pending && now - s.said_at >= kSayEvery) s.SayPending(now);
  for (std::size_t i = 0; i < s.kept_until.size(); ++i) {
    if (s.kept_until[i] <= 0 || s.kept_until[i] > now || s.mouse.left != 0) continue;
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
