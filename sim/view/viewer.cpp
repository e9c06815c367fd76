#include "sim/view/viewer.h"

#include <chrono>
#include <filesystem>
#include <system_error>
#include <thread>
#include <utility>

#include "sim/page_view/gl_headless.h"
#include "sim/picture/picture_file.h"
#include "sim/view/view_messages.h"
#include "sim/view/view_painter.h"
#include "sim/view/view_thread.h"
#include "textures/base/error.h"

namespace moontrace {

namespace {

constexpr std::size_t kMostMoments = 4000;
constexpr std::size_t kMostLines = 20;  // at one moment
// with a display that hangs, or a disk
constexpr std::chrono::seconds kWindowPatience(2), kFramesPatience(30);

/// An empty place for frames.
void MakeFolder(const std::string& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder, error)) {
    throw LackError(folder + ": no folder can be made there for frames; name another");
  }
  const bool empty = fs::is_empty(folder, error);
  if (!error && !empty) {
    throw InputError(folder + ": is not empty; name an empty folder for frames");
  }
  CheckPicturePath(FramePath(folder, 1));
}

}  // namespace

struct Viewer::State {
  std::shared_ptr<ViewMailbox> mailbox = std::make_shared<ViewMailbox>();
  std::thread thread;
  std::chrono::seconds patience = kWindowPatience;
  std::string camera;                      // ViewerOptions::camera
  std::shared_ptr<const ViewModel> model;  // that is shown
};

Viewer::Viewer(const ViewerOptions& options) : state_(std::make_shared<State>()) {
  if (!options.frames.empty()) {
    MakeFolder(options.frames);
    state_->patience = kFramesPatience;
  }
  state_->camera = options.camera;
  ViewMailbox& mailbox = *state_->mailbox;
  state_->thread = std::thread([options, box = state_->mailbox] { RunViewer(options, box); });
  std::unique_lock<std::mutex> lock(mailbox.mutex);
  const auto known = [&] { return mailbox.opened || mailbox.finished || !mailbox.failure.empty(); };
  mailbox.changed.wait(lock, known);
  if (mailbox.opened) return;
  const std::exception_ptr refused = mailbox.refused;
  const std::string failure = mailbox.failure;
  const bool finished = mailbox.finished;
  lock.unlock();
  if (finished) {
    state_->thread.join();
  } else {
    state_->thread.detach();
  }
  if (refused) std::rethrow_exception(refused);
  throw LackError(failure);
}

Viewer::~Viewer() { Finish(); }

void Viewer::Finish() {
  if (!state_->thread.joinable()) return;
  ViewMailbox& mailbox = *state_->mailbox;
  std::unique_lock<std::mutex> lock(mailbox.mutex);
  mailbox.stop = true;
  mailbox.changed.notify_all();
  const auto over = [&] { return mailbox.finished || !mailbox.failure.empty(); };
  mailbox.changed.wait_for(lock, state_->patience, over);
  const bool finished = mailbox.finished;
  lock.unlock();
  if (finished) {
    state_->thread.join();
  } else {
    state_->thread.detach();  // it stands still with its display, and keeps what it needs
  }
}

void Viewer::ShowModel(std::shared_ptr<const ViewModel> model) {
  std::optional<ViewTarget> target;
  if (!state_->camera.empty()) target = FindTarget(*model, state_->camera);
  state_->model = model;
  ViewMailbox& mailbox = *state_->mailbox;
  const std::lock_guard<std::mutex> lock(mailbox.mutex);
  mailbox.news.model = std::move(model);
  mailbox.news.look_at = target;
}

void Viewer::Show(std::shared_ptr<const ViewPage> page) {
  ViewMailbox& mailbox = *state_->mailbox;
  const std::lock_guard<std::mutex> lock(mailbox.mutex);
  mailbox.news.page = std::move(page);
  mailbox.changed.notify_all();  // the first frame waits for it
}

void Viewer::Add(const ViewMoment& moment) {
  ViewMailbox& mailbox = *state_->mailbox;
  const std::lock_guard<std::mutex> lock(mailbox.mutex);
  if (mailbox.news.moments.size() >= kMostMoments) mailbox.news.moments.pop_front();
  mailbox.news.moments.push_back(moment);
}

void Viewer::DrawFrame() {
  ViewMailbox& mailbox = *state_->mailbox;
  std::unique_lock<std::mutex> lock(mailbox.mutex);
  const std::size_t number = ++mailbox.asked;
  mailbox.changed.notify_all();
  mailbox.changed.wait(lock, [&] {
    return mailbox.drawn >= number || mailbox.finished || !mailbox.failure.empty();
  });
}

void Viewer::SetPanel(std::vector<PanelControl> controls) {
  ViewMailbox& mailbox = *state_->mailbox;
  const std::lock_guard<std::mutex> lock(mailbox.mutex);
  mailbox.news.controls = std::move(controls);
  mailbox.news.values.reset();  // of the panel before
}

void Viewer::SetPanelValues(std::vector<PanelValue> values) {
  ViewMailbox& mailbox = *state_->mailbox;
  const std::lock_guard<std::mutex> lock(mailbox.mutex);
  mailbox.news.values = std::move(values);
}

void Viewer::ShowLine(std::string_view line) {
  ViewMailbox& mailbox = *state_->mailbox;
  const std::lock_guard<std::mutex> lock(mailbox.mutex);
  std::vector<std::string>& lines = mailbox.news.lines;
  if (lines.size() >= kMostLines) lines.erase(lines.begin());
  lines.emplace_back(line);
}

std::optional<ViewLine> Viewer::NextLine() {
  return state_->mailbox->TakeFrom(&ViewMailbox::lines);
}

std::optional<std::string> Viewer::NextNotice() {
  return state_->mailbox->TakeFrom(&ViewMailbox::notices);
}

std::optional<std::string> Viewer::Obey(std::string_view line) {
  const std::optional<ViewWord> word = ViewWordOf(line);
  const std::optional<std::string> name =
      state_->model == nullptr ? std::nullopt : ViewedNameOf(line);
  if (!word && !name) return std::nullopt;
  std::optional<ViewTarget> target;
  if (name && !name->empty()) {
    try {
      target = FindTarget(*state_->model, *name);
    } catch (const InputError& error) {
      return say::ViewRefuses(error.what());
    }
  }
  ViewMailbox& mailbox = *state_->mailbox;
  const std::lock_guard<std::mutex> lock(mailbox.mutex);
  if (word) {
    mailbox.news.words.push_back(*word);
    const bool whole = *word == ViewWord::kWholePage && state_->model != nullptr;
    return whole ? say::ViewWholeModel() : say::ViewObeys(*word);
  }
  mailbox.news.tell = true;
  if (!target) return say::ViewNames(TargetNames(*state_->model));
  mailbox.news.look_at = target;
  return say::ViewLooksAt(*name);
}

bool Viewer::closed() const {
  const std::lock_guard<std::mutex> lock(state_->mailbox->mutex);
  return state_->mailbox->closed;
}

std::string Viewer::failure() const {
  const std::lock_guard<std::mutex> lock(state_->mailbox->mutex);
  return state_->mailbox->failure;
}

ViewerReport Viewer::report() const {
  const std::lock_guard<std::mutex> lock(state_->mailbox->mutex);
  const ViewMailbox& mailbox = *state_->mailbox;
  ViewerReport report;
  report.frames = mailbox.frames.count();
  report.median_frame_ms = mailbox.frames.Median();
  report.slowest_frame_ms = mailbox.frames.slowest();
  report.median_change_ms = mailbox.changes.Median();
  report.seen = mailbox.seen;
  return report;
}

std::vector<std::string> WriteViewPicture(const std::string& path, const ViewerOptions& options,
                                          const std::shared_ptr<const ViewPage>& page,
                                          const std::vector<ViewMoment>& moments,
                                          const std::vector<PanelControl>& controls,
                                          const std::vector<PanelValue>& values,
                                          const std::shared_ptr<const ViewModel>& model) {
  CheckPicturePath(path);
  ViewNews news;
  if (model != nullptr && !options.camera.empty()) {
    news.look_at = FindTarget(*model, options.camera);
  }
  const HeadlessGl gl;
  ViewLook look = LookOf(options);
  look.plots = !moments.empty();  // else they are of nothing
  ViewPainter painter(false, options.width, options.height, look);
  news.model = model;
  news.page = page;
  news.moments.assign(moments.begin(), moments.end());
  if (!controls.empty()) news.controls = controls;
  news.values = values;
  Deliver(std::move(news), painter);
  painter.Await();
  painter.Draw();
  WritePicture(path, painter.Picture());
  return painter.Seen();
}

}  // namespace moontrace
