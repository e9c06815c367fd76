#include "sim/view/view_thread.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

#include "sim/page_view/gl_headless.h"
#include "sim/page_view/surface_worker.h"
#include "sim/picture/picture_file.h"
#include "sim/view/view_input.h"
#include "sim/view/view_messages.h"
#include "sim/view/view_window.h"
#include "textures/base/output_file.h"
#include "textures/base/text_file.h"

namespace moontrace {

void TimeLog::Add(double ms) {
  kept_.at(count_++ % kept_.size()) = ms;
  slowest_ = std::max(slowest_, ms);
}

double TimeLog::Median() const {
  std::vector<double> times(
      kept_.begin(), kept_.begin() + static_cast<std::ptrdiff_t>(std::min(count_, kept_.size())));
  if (times.empty()) return 0;
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

ViewNews ViewMailbox::TakeNews() {
  const std::lock_guard<std::mutex> lock(mutex);
  return std::exchange(news, {});
}

bool ViewMailbox::Stopped() {
  const std::lock_guard<std::mutex> lock(mutex);
  return stop;
}

void ViewMailbox::Fail(const std::string& why) {
  {
    const std::lock_guard<std::mutex> lock(mutex);
    failure = why;
  }
  changed.notify_all();
}

void ViewMailbox::FrameDrawn() {
  {
    const std::lock_guard<std::mutex> lock(mutex);
    ++drawn;
  }
  changed.notify_all();
}

void ViewMailbox::Say(ViewLine line) {
  const std::lock_guard<std::mutex> lock(mutex);
  lines.push_back(std::move(line));
}

void ViewMailbox::Notice(std::string sentence) {
  const std::lock_guard<std::mutex> lock(mutex);
  notices.push_back(std::move(sentence));
}

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr double kFrame = 1.0 / 30;  // between two drawings of a window [s]
constexpr double kHiddenWait = 0.1;  // while nothing is to be seen of it [s]
constexpr double kZoomStep = 0.7;    // of the words
constexpr double kMilliseconds = 1e3;

double Now() { return Seconds(Clock::now().time_since_epoch()).count(); }

void Do(ViewWord word, ViewPainter& painter) {
  ViewLook look = painter.look();
  switch (word) {
    case ViewWord::kZoomIn:
      return painter.ZoomBy(kZoomStep, {0.5, 0.5});
    case ViewWord::kZoomOut:
      return painter.ZoomBy(1 / kZoomStep, {0.5, 0.5});
    case ViewWord::kWholePage:
      return painter.ShowWholePage();
    case ViewWord::kFollow:
    case ViewWord::kFollowOff:
      return painter.SetFollow(word == ViewWord::kFollow);
    case ViewWord::kPrintOn:
    case ViewWord::kPrintOff:
      look.print = word == ViewWord::kPrintOn;
      break;
    case ViewWord::kPlotsOn:
    case ViewWord::kPlotsOff:
      look.plots = word == ViewWord::kPlotsOn;
      break;
    case ViewWord::kPanelOn:
    case ViewWord::kPanelOff:
      look.panel = word == ViewWord::kPanelOn;
      break;
    case ViewWord::kContrastOn:
    case ViewWord::kContrastOff:
      look.high_contrast = word == ViewWord::kContrastOn;
      break;
    case ViewWord::kLargeTextOn:
    case ViewWord::kLargeTextOff:
      look.large_text = word == ViewWord::kLargeTextOn;
      break;
  }
  painter.SetLook(look);
}

void Opened(ViewMailbox& mailbox) {
  {
    const std::lock_guard<std::mutex> lock(mailbox.mutex);
    mailbox.opened = true;
  }
  mailbox.changed.notify_all();
}

void Timed(ViewMailbox& mailbox, Clock::time_point start, ViewPainter& painter) {
  const double ms = kMilliseconds * Seconds(Clock::now() - start).count();
  const std::optional<double> change = painter.TakeChange();
  const std::lock_guard<std::mutex> lock(mailbox.mutex);
  mailbox.frames.Add(ms);
  if (change) mailbox.changes.Add(*change);
}

/// A notice has no full stop.
void Tell(const std::vector<std::string>& sentences, ViewMailbox& mailbox) {
  for (const std::string& sentence : sentences) {
    mailbox.Notice(sentence.substr(0, sentence.find_last_not_of('.') + 1));
  }
}

void RunWindow(const ViewerOptions& options, const std::shared_ptr<ViewMailbox>& mailbox) {
  ViewWindow window(options.title, options.width, options.height,
                    [mailbox] { mailbox->Fail(say::ViewLost()); });
  ViewPainter painter(true, window.width(), window.height(), LookOf(options));
  ViewInput input(painter, options.pointer);
  Opened(*mailbox);
  double next = Now();
  bool minimised = false, cramped = false;
  while (!mailbox->Stopped() && !window.closed()) {
    const bool shown = window.shown();
    if (!std::exchange(minimised, !shown) && minimised) mailbox->Notice(say::ViewMinimised());
    const double wait = shown ? next - Now() : kHiddenWait;
    for (const WindowEvent& event : window.Events(std::max(wait, 0.0))) {
      input.Handle(event, Now());
    }
    while (std::optional<ViewLine> line = input.NextLine(Now())) mailbox->Say(std::move(*line));
    ViewNews news = mailbox->TakeNews();
    if (!news.lines.empty()) {
      window.SetTitle(fmt::format("{} - {}", options.title, news.lines.back()));
    }
    const bool tell = news.tell;
    Deliver(std::move(news), painter);
    if (tell) Tell(painter.Seen(), *mailbox);
    if (Now() < next) continue;
    next = std::max(next + kFrame, Now());
    if (!window.shown()) continue;
    painter.Resize(window.width(), window.height());
    if (!std::exchange(cramped, painter.cramped()) && cramped) {
      mailbox->Notice(say::ViewTooSmall());
    }
    if (!painter.changed()) continue;
    const Clock::time_point start = Clock::now();
    painter.Draw();
    window.Swap();
    Timed(*mailbox, start, painter);
  }
  const std::lock_guard<std::mutex> lock(mailbox->mutex);
  mailbox->closed = mailbox->closed || !mailbox->stop;
}

constexpr std::size_t kMostFrameBytes = std::size_t{1} << 30U;

/// A frame that looks like the one before, or came late for its time, is that picture again.
void Repeat(const std::string& folder, std::size_t number) {
  WriteWhole(FramePath(folder, number),
             ReadTextFile(FramePath(folder, number - 1), kMostFrameBytes), false);
}

void DrawFrame(const std::string& folder, std::size_t number, ViewPainter& painter,
               ViewMailbox& mailbox) {
  const Clock::time_point start = Clock::now();
  painter.Await();  // each frame is whole
  painter.Draw();
  const Raster picture = painter.Picture();
  Timed(mailbox, start, painter);
  WritePicture(FramePath(folder, number), picture, false);
}

/// Each frame when it is asked for.
void RunOffline(const ViewerOptions& options, ViewPainter& painter, ViewMailbox& mailbox) {
  for (std::size_t number = 1; number <= options.most_frames; ++number) {
    {
      std::unique_lock<std::mutex> lock(mailbox.mutex);
      mailbox.changed.wait(lock, [&] { return mailbox.stop || mailbox.asked >= number; });
      const bool wanted = mailbox.asked >= number || (number == 1 && mailbox.news.page);
      if (!wanted) return;
    }
    Deliver(mailbox.TakeNews(), painter);
    if (number > 1 && !painter.changed()) {
      Repeat(options.frames, number);
    } else {
      DrawFrame(options.frames, number, painter, mailbox);
    }
    mailbox.FrameDrawn();
  }
}

/// Each frame at its time, of what runs in real time.
void RunTimed(const ViewerOptions& options, ViewPainter& painter, ViewMailbox& mailbox) {
  {  // the first frame is of a page
    std::unique_lock<std::mutex> lock(mailbox.mutex);
    mailbox.changed.wait(lock, [&] { return mailbox.stop || mailbox.news.page; });
  }
  const Clock::time_point begin = Clock::now();
  const auto due_at = [&](std::size_t frame) {
    const Seconds after(static_cast<double>(frame) / options.frames_per_second);
    return begin + std::chrono::duration_cast<Clock::duration>(after);
  };
  for (std::size_t number = 1; number <= options.most_frames; ++number) {
    {
      std::unique_lock<std::mutex> lock(mailbox.mutex);
      mailbox.changed.wait_until(lock, due_at(number), [&] { return mailbox.stop; });
      if (mailbox.stop && (number > 1 || !mailbox.news.page)) return;
    }
    Deliver(mailbox.TakeNews(), painter);
    const bool late = Clock::now() > due_at(number + 1);
    if (number > 1 && (late || !painter.changed())) {
      Repeat(options.frames, number);
    } else {
      DrawFrame(options.frames, number, painter, mailbox);
    }
  }
}

/// Of a model, for the end.
void KeepSeen(ViewPainter& painter, ViewMailbox& mailbox) {
  std::vector<std::string> seen = painter.Seen();
  const std::lock_guard<std::mutex> lock(mailbox.mutex);
  mailbox.seen = std::move(seen);
}

void RunFrames(const ViewerOptions& options, ViewMailbox& mailbox) {
  const HeadlessGl gl;
  ViewPainter painter(false, options.width, options.height, LookOf(options));
  Opened(mailbox);
  if (options.offline) {
    RunOffline(options, painter, mailbox);
  } else {
    RunTimed(options, painter, mailbox);
  }
  KeepSeen(painter, mailbox);
}

}  // namespace

void Deliver(ViewNews news, ViewPainter& painter) {
  if (news.model) painter.ShowModel(std::move(news.model));
  if (news.page) painter.Show(std::move(news.page));
  for (const ViewMoment& moment : news.moments) painter.Add(moment);
  if (news.controls) painter.SetControls(std::move(*news.controls));
  if (news.values) painter.panel().SetValues(std::move(*news.values));
  painter.ShowLines(std::move(news.lines));
  for (const ViewWord word : news.words) Do(word, painter);
  if (news.look_at) painter.LookAt(*news.look_at);
}

ViewLook LookOf(const ViewerOptions& options) {
  ViewLook look;
  look.high_contrast = options.high_contrast;
  look.large_text = options.large_text;
  return look;
}

std::string FramePath(const std::string& folder, std::size_t number) {
  return (std::filesystem::path(folder) / fmt::format("frame-{:05}.png", number)).string();
}

void RunViewer(const ViewerOptions& options, const std::shared_ptr<ViewMailbox>& mailbox) {
  GiveWayToTheLoop();
  try {
    if (options.frames.empty()) {
      RunWindow(options, mailbox);
    } else {
      RunFrames(options, *mailbox);
    }
  } catch (const std::exception& error) {
    const std::lock_guard<std::mutex> lock(mailbox->mutex);
    if (mailbox->opened) {
      mailbox->failure = say::ViewStopped(error.what());
    } else {
      mailbox->refused = std::current_exception();
    }
  }
  {
    const std::lock_guard<std::mutex> lock(mailbox->mutex);
    mailbox->finished = true;
  }
  mailbox->changed.notify_all();
}

}  // namespace moontrace
