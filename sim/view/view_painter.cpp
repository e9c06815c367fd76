#include "sim/view/view_painter.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/page_view/canvas.h"
#include "sim/page_view/page_overlay.h"
#include "sim/page_view/page_renderer.h"
#include "sim/page_view/surface_worker.h"
#include "sim/page_view/view_text.h"
#include "sim/view/model_part.h"
#include "sim/view/view_marks.h"
#include "sim/view/view_plots.h"

namespace moontrace {

namespace {

using Clock = std::chrono::steady_clock;

// a slow reader: 16 letters a second
constexpr std::chrono::milliseconds kReadLine(3000), kReadLetter(60);
constexpr int kLetter = 16, kLargeLetter = 24;  // heights [points]
constexpr int kPlotsWidth = 17;                 // in heights of a small letter
constexpr double kLeastShare = 0.6;             // of the view that a page's letters fill
constexpr int kRowGap = 8;                      // between the lower edge's lines [points]
constexpr int kGrowBy = 256;  // a window's renderer is made for a little more [points]

int RoundUp(int value) { return (value + kGrowBy - 1) / kGrowBy * kGrowBy; }

/// What a page shows at first: its letters with some room, or all of the sheet.
Box WorthSeeing(const ViewPage& page) {
  if (page.letters.empty()) return page.sheet_P;
  Box box;
  for (const ViewPage::Letter& letter : page.letters) {
    Include(box, Grown(letter.box_P, 0.5 * (letter.box_P.max.y - letter.box_P.min.y)));
  }
  return box;
}

/// That, with no more of the desk than there must be.
PageCamera FirstView(const ViewPage& page, double aspect) {
  const Box box = WorthSeeing(page);
  PageCamera camera = CameraOn(box, aspect);
  const glm::dvec2 half = 0.5 * camera.height * glm::dvec2(aspect, 1);
  const Box sheet = Grown(page.sheet_P, 0.02 * camera.height);
  for (int i = 0; i < 2; ++i) {
    const double low = sheet.min[i] + half[i], high = sheet.max[i] - half[i];
    camera.at_P[i] = low < high ? std::clamp(camera.at_P[i], low, high) : 0.5 * (low + high);
  }
  return camera;
}

}  // namespace

struct ViewPainter::State {
  bool window;
  int width, height;
  ViewLook look;
  std::optional<PageRenderer> renderer;  // of a page, or ...
  std::optional<ModelPart> part;         // ... of a model
  std::shared_ptr<const ViewModel> model;
  std::optional<Canvas> canvas;
  ViewPanel panel;
  ViewHistory history;
  std::shared_ptr<const ViewPage> page;
  PageCamera camera;
  bool camera_moved = false;  // by someone: a new page leaves it
  bool follow = false;
  ViewLayout layout;
  int letter = 0;                 // height of a small one on the canvas [points]
  std::vector<std::string> talk;  // all lines that came together, the newest last
  std::string line, typed, hint;  // the newest
  Clock::time_point read_by;
  bool reading = false;  // when it was drawn last
  bool changed = true;
  // the surface
  std::optional<SurfaceWish> wished;
  std::uint64_t wishes = 0, drawn = 0;
  std::shared_ptr<const ViewPage> drawn_page;
  Clock::time_point wished_at;
  std::optional<double> change;
  SurfaceWorker worker;

  State(bool to_window, int to_width, int to_height, const ViewLook& to_look)
      : window(to_window), width(to_width), height(to_height), look(to_look) {}

  void MakeCanvas();
  void MakeRenderer();
  void Arrange();
  void WishSurface();
  void TakeSurface();
  bool StillFits() const;
  void Follow();
  void DrawTalk(int x, int y, int room);
  void DrawText();
  void DrawOver(const ViewMarks& marks);
};

void ViewPainter::State::MakeRenderer() {
  RendererSize size{std::max(width, 1), std::max(height, 1)};
  if (window) size = {RoundUp(size.width), RoundUp(size.height)};
  renderer.reset();  // its memory first
  if (model != nullptr) {
    ModelPart larger(model, size.width, size.height);
    if (part) larger.Continue(*part);
    part.emplace(std::move(larger));
    if (page) part->ShowPage(*page);
    part->scene().Aim(window);
    return;
  }
  renderer.emplace(size);
  renderer->Aim(window);
  wished.reset();  // the new one has no surface
  drawn = 0;
  drawn_page.reset();
}

/// Letters of the height that the look wants.
void ViewPainter::State::MakeCanvas() {
  canvas.reset();
  canvas.emplace(look.large_text ? kLargeLetter : kLetter);
  letter = canvas->TextHeight(false);
}

/// Brings renderer and layout up to date with size and look.
void ViewPainter::State::Arrange() {
  const bool fits = model != nullptr ? part && part->Holds(width, height)
                                     : renderer && renderer->size().width >= width &&
                                           renderer->size().height >= height;
  if (!fits) MakeRenderer();
  if (!canvas || letter != (look.large_text ? kLargeLetter : kLetter)) MakeCanvas();
  panel.Prepare(letter, ColorsOf(look));
  const int rows = canvas->TextHeight(true) + letter + 2 * kRowGap;
  const int text_height = window || !line.empty() ? rows : 0;
  const int plots_width = look.plots ? kPlotsWidth * (letter + kLetter) / 2 : 0;
  layout = LayoutOf(width, height, look.panel ? panel.width() : 0, plots_width, text_height);
  const PageShade shade = look.high_contrast ? HighContrastShade() : PageShade{};
  if (renderer) renderer->SetDesk(shade.desk);
}

void ViewPainter::State::WishSurface() {
  if (!page || part || layout.page.empty()) return;
  SurfaceWish wish;
  wish.page = page;
  wish.width = static_cast<std::size_t>(layout.page.width);
  wish.height = static_cast<std::size_t>(layout.page.height);
  wish.view_P =
      VisibleBox(camera, static_cast<double>(wish.width) / static_cast<double>(wish.height));
  if (look.high_contrast) wish.shade = HighContrastShade();
  const bool same = wished && wished->page == wish.page && wished->view_P == wish.view_P &&
                    wished->width == wish.width && wished->height == wish.height &&
                    wished->shade.ambient == wish.shade.ambient;
  if (same) return;
  if (wished_at == Clock::time_point{}) wished_at = Clock::now();
  wish.number = ++wishes;
  wished = wish;
  worker.Wish(std::move(wish));
}

void ViewPainter::State::TakeSurface() {
  std::optional<SurfaceWorker::Surface> surface = worker.Take();
  if (!surface || !renderer) return;
  renderer->SetSurface(surface->raster, surface->of.view_P);
  drawn = surface->of.number;
  drawn_page = surface->of.page;
  changed = true;
}

/// Whether the view of the page before shows the new one well enough: so letters that grow are seen
/// to grow.
bool ViewPainter::State::StillFits() const {
  if (layout.page.empty()) return false;
  const double aspect = static_cast<double>(layout.page.width) / layout.page.height;
  const Box seen = VisibleBox(camera, aspect), box = WorthSeeing(*page);
  return Contains(seen, box.min) && Contains(seen, box.max) &&
         CameraOn(box, aspect).height > kLeastShare * camera.height;
}

/// The tip stays within the middle of the picture.
void ViewPainter::State::Follow() {
  const std::optional<ViewMoment>& now = history.newest();
  if (!follow || !now || !now->present || layout.page.empty()) return;
  const double aspect = static_cast<double>(layout.page.width) / layout.page.height;
  const glm::dvec2 off = glm::dvec2(now->tip_P) - camera.at_P;
  const double most = 0.3 * camera.height;
  if (std::abs(off.x) > most * aspect || std::abs(off.y) > most) {
    camera.at_P = glm::dvec2(now->tip_P);
  }
}

/// One row of large letters, or small ones: while they are read as many as it takes, upwards over
/// a quarter of the page at most, and then the newest.
void ViewPainter::State::DrawTalk(int x, int y, int room) {
  const ViewColors colors = ColorsOf(look);
  reading = Clock::now() < read_by;
  const bool one = !reading || talk.size() == 1;
  if (one && canvas->TextWidth(line, true) <= room) {
    return WriteText(line, x, y, room, true, colors.text, *canvas);
  }
  const int row = letter + kRowGap / 2;
  const int most = reading ? std::max(layout.page.height / 4 / row, 1) : 1;
  const auto width_of = [this](std::string_view text) { return canvas->TextWidth(text, false); };
  const std::vector<std::string> told = one ? std::vector<std::string>{line} : talk;
  const std::vector<std::string> rows =
      NewestRowsOf(told, room, static_cast<std::size_t>(most), width_of);
  const int top = y + static_cast<int>(rows.size()) * row;
  canvas->Fill({layout.text.x, y, layout.text.width, top - y}, colors.back);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    WriteText(rows[i], x, top - static_cast<int>(i + 1) * row, room, false, colors.text, *canvas);
  }
}

void ViewPainter::State::DrawText() {
  reading = false;
  if (layout.text.empty()) return;
  const ViewColors colors = ColorsOf(look);
  const PixelBox& box = layout.text;
  canvas->Fill(box, colors.back);
  const int x = box.x + kRowGap, room = box.width - 2 * kRowGap;
  const int hint_width = canvas->TextWidth(hint, false);
  const int low = box.y + kRowGap / 2;
  DrawTalk(x, low + letter + kRowGap / 2, room);
  WriteText(hint, x + room - hint_width, low, hint_width, false, colors.text, *canvas);
  // of a long line the end is what is being typed
  std::string writing = typed.empty() ? std::string() : "> " + typed + "_";
  const int left = room - hint_width - kRowGap;
  while (!writing.empty() && canvas->TextWidth(writing, false) > left) DropFirst(writing);
  WriteText(writing, x, low, left, false, colors.text, *canvas);
}

/// All that stands over and round the page. Twice, since controls know where they are, how far they
/// scroll, and what the mouse is over only behind a first time.
void ViewPainter::State::DrawOver(const ViewMarks& marks) {
  canvas->Begin(width, height, panel.mouse());
  panel.Draw(layout.panel, *canvas);
  canvas->End(false);
  canvas->Begin(width, height, panel.mouse());
  if (part && !layout.page.empty()) {
    part->DrawPrint(layout.page, *canvas);
  } else if (page && !layout.page.empty()) {
    DrawPageOverlay(marks, camera, layout.page, *canvas);
  } else {
    canvas->Fill(layout.page, ColorsOf(look).back);
  }
  if (!layout.plots.empty()) DrawPlots(history, look, layout.plots, *canvas);
  DrawText();
  canvas->Fill(layout.panel, ColorsOf(look).back);
  panel.Draw(layout.panel, *canvas);
  canvas->End(true);
}

ViewPainter::ViewPainter(bool window, int width, int height, const ViewLook& look)
    : state_(std::make_unique<State>(window, width, height, look)) {
  state_->Arrange();
}

ViewPainter::~ViewPainter() = default;

void ViewPainter::Show(std::shared_ptr<const ViewPage> page) {
  State& s = *state_;
  const bool first = !s.page;
  s.page = std::move(page);
  s.history.Show(s.page);
  if (s.part && s.page) s.part->ShowPage(*s.page);
  if (s.page && (first || (!s.camera_moved && !s.StillFits())))
    s.camera = FirstView(*s.page, aspect());
  s.changed = true;
}

void ViewPainter::ShowModel(std::shared_ptr<const ViewModel> model) {
  State& s = *state_;
  s.model = std::move(model);
  s.part.reset();
  s.MakeRenderer();
  s.changed = true;
}

void ViewPainter::Add(const ViewMoment& moment) {
  if (state_->part) state_->part->Add(moment);
  state_->history.Add(moment);
  state_->changed = true;
}

void ViewPainter::ShowLines(std::vector<std::string> lines) {
  if (lines.empty()) return;
  State& s = *state_;
  const bool first = s.line.empty();
  s.line = lines.back();
  s.read_by = Clock::now() + kReadLine;
  for (const std::string& line : lines) s.read_by += kReadLetter * line.size();
  s.talk = std::move(lines);
  if (first) s.Arrange();
  s.changed = true;
}

void ViewPainter::SetTyped(std::string_view typed) {
  state_->changed = state_->changed || state_->typed != typed;
  state_->typed = typed;
}

void ViewPainter::SetHint(std::string_view hint) {
  state_->changed = state_->changed || state_->hint != hint;
  state_->hint = hint;
}

void ViewPainter::SetControls(std::vector<PanelControl> controls) {
  State& s = *state_;
  s.panel.SetControls(std::move(controls));
  s.Arrange();
  if (s.page && !s.camera_moved) s.camera = FirstView(*s.page, aspect());
  s.changed = true;
}

ViewPanel& ViewPainter::panel() { return state_->panel; }
const ViewLook& ViewPainter::look() const { return state_->look; }
const ViewLayout& ViewPainter::layout() const { return state_->layout; }

bool ViewPainter::cramped() const {
  const State& s = *state_;
  return (s.look.panel && !s.panel.empty() && s.layout.panel.empty()) ||
         (s.window && s.layout.text.empty());
}

bool ViewPainter::shows_model() const { return state_->part.has_value(); }
const PageCamera& ViewPainter::camera() const { return state_->camera; }

void ViewPainter::SetLook(const ViewLook& look) {
  State& s = *state_;
  if (s.look == look) return;
  s.look = look;
  s.Arrange();
  s.changed = true;
}

void ViewPainter::Resize(int width, int height) {
  State& s = *state_;
  if (width < 1 || height < 1 || (width == s.width && height == s.height)) return;
  s.width = width;
  s.height = height;
  s.Arrange();
  if (s.page && !s.camera_moved) s.camera = FirstView(*s.page, aspect());
  s.changed = true;
}

void ViewPainter::PanelEvent(const WindowEvent& event, double now) {
  State& s = *state_;
  s.panel.Handle(event, s.layout.panel, *s.canvas, {s.width, s.height}, now);
}

double ViewPainter::aspect() const {
  const PixelBox& page = state_->layout.page;
  return page.empty() ? 1 : static_cast<double>(page.width) / page.height;
}

void ViewPainter::SetCamera(const PageCamera& camera) {
  if (!state_->page) return;  // nothing was seen that could be moved
  state_->camera = camera;
  state_->camera_moved = state_->changed = true;
}

void ViewPainter::Drag(glm::dvec2 from, glm::dvec2 to) {
  State& s = *state_;
  if (s.part) {
    s.part->Shift((to - from) * glm::dvec2(aspect(), 1), aspect());
    s.changed = true;
    return;
  }
  PageCamera camera = s.camera;
  camera.at_P +=
      moontrace::PointUnder(camera, aspect(), from) - moontrace::PointUnder(camera, aspect(), to);
  SetCamera(camera);
}

void ViewPainter::TurnBy(glm::dvec2 by) {
  constexpr double kLean = 3.5, kMostLean = 1.2;  // [rad]
  State& s = *state_;
  if (s.part) {
    s.part->Turn(by, aspect());
    s.changed = true;
    return;
  }
  PageCamera camera = s.camera;
  camera.lean = std::clamp(camera.lean - kLean * by.y, 0.0, kMostLean);
  SetCamera(camera);
}

void ViewPainter::ZoomBy(double factor, glm::dvec2 share) {
  State& s = *state_;
  if (!s.part) return SetCamera(Zoomed(s.camera, aspect(), share, factor));
  s.part->Zoom(share, factor, aspect());
  s.changed = true;
}

void ViewPainter::LookAt(const ViewTarget& target) {
  State& s = *state_;
  if (!s.part) return;
  s.part->LookAt(target, aspect());
  s.changed = true;
}

std::optional<glm::dvec2> ViewPainter::PointUnder(glm::dvec2 share) {
  State& s = *state_;
  if (s.part) return s.part->PointUnder(share, aspect());
  return moontrace::PointUnder(s.camera, aspect(), share);
}

std::vector<std::string> ViewPainter::Seen() {
  return state_->part ? state_->part->Seen(aspect()) : std::vector<std::string>();
}

void ViewPainter::ShowWholePage() {
  State& s = *state_;
  if (s.part) return LookAt({});
  s.follow = false;
  if (s.page) s.camera = CameraOn(s.page->sheet_P, aspect());
  s.camera_moved = false;
  s.changed = true;
}

void ViewPainter::SetFollow(bool follow) {
  state_->follow = follow;
  if (state_->part) state_->part->SetFollow(follow);
  state_->camera_moved = state_->camera_moved || follow;
  state_->changed = true;
}

bool ViewPainter::changed() {
  State& s = *state_;
  if (s.drawn != s.wishes) s.TakeSurface();
  const bool read = s.reading && Clock::now() >= s.read_by;
  return s.changed || read || s.panel.changed();
}

void ViewPainter::Draw() {
  State& s = *state_;
  s.Follow();
  s.WishSurface();
  s.TakeSurface();
  const PixelBox& box = s.layout.page;
  ViewMarks marks;
  if (s.part) {
    s.part->scene().Aim(s.window);
    const ModelPart::Letters letters{static_cast<double>(s.letter),
                                     static_cast<double>(s.canvas->TextHeight(true))};
    if (!box.empty()) s.part->Draw(s.page.get(), s.history, s.look, box, letters);
  } else {
    s.renderer->Aim(s.window);
  }
  if (s.page && !s.part && !box.empty()) {
    // while the grooves are still those of the page before, marks would be of other letters
    if (s.drawn_page == s.page) {
      marks = MarksOf(*s.page, s.history, s.camera, aspect(), s.look.print, box.height, s.letter,
                      s.canvas->TextHeight(true));
    }
    s.renderer->Draw(s.camera, marks, box.x, box.y, box.width, box.height);
  }
  s.DrawOver(marks);
  s.changed = false;
  if (s.drawn == s.wishes && s.wished_at != Clock::time_point{}) {
    mjr_finish();
    s.change = std::chrono::duration<double, std::milli>(Clock::now() - s.wished_at).count();
    s.wished_at = {};
  }
}

Raster ViewPainter::Picture() {
  return state_->part ? state_->part->scene().Picture() : state_->renderer->Picture();
}

void ViewPainter::Await() {
  state_->Follow();
  state_->WishSurface();
  state_->worker.Await();
}

std::optional<double> ViewPainter::TakeChange() {
  return std::exchange(state_->change, std::nullopt);
}

}  // namespace moontrace
