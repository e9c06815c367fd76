#include "sim/session/view_trial.h"

#include <glm/geometric.hpp>
#include <thread>
#include <utility>

#include "sim/session/view_messages.h"

namespace moontrace {

namespace {
constexpr double kShowEvery = 0.005;  ///< [s]
constexpr double kLookEvery = 0.05;   ///< at the window, [s]
}  // namespace

TrialView::TrialView(ViewFeed& feed, Console& console, std::vector<PanelControl> panel)
    : feed_(feed), console_(console) {
  feed_.SetPanel(std::move(panel));
}

void TrialView::ShowModel(std::vector<LaidLabel> others) { others_ = std::move(others); }

void TrialView::Begin(std::shared_ptr<const ViewPage> page, TrialTexts texts, Complete complete) {
  page_ = page->number;
  texts_ = std::move(texts);
  complete_ = std::move(complete);
  feed_.Show(others_ ? page : WithPaperAround(*page));
  model_shown_ = false;
  begin_ = std::chrono::steady_clock::now();
  shown_ = looked_ = -1;
  frames_ = 0;
}

void TrialView::Look(double time, const TickResult& felt, const GuidanceResult& push,
                     const Scene& scene) {
  if (over_) return;
  if (others_ && !std::exchange(model_shown_, true)) {
    feed_.ShowModel(MakeViewModel(scene, *others_, texts_.text));
  }
  const bool frame = !feed_.window() && time >= static_cast<double>(frames_ + 1) / kFramesPerSecond;
  if (!frame && time < shown_ + kShowEvery) return;
  shown_ = time;
  ViewMoment moment = MomentOf(time, felt, push);
  moment.page = page_;
  if (others_) {
    ScenePose pose;
    TakePose(scene, pose);
    moment.pose = std::make_shared<const ScenePose>(std::move(pose));
  }
  feed_.Add(moment);
  if (frame) DrawFrame(time);
  if (feed_.window()) KeepTime(time);
}

void TrialView::DrawFrame(double time) {
  ++frames_;
  ShowTime(time);
  feed_.DrawFrame();
  Hear();
}

/// What is seen in a window happens as fast as it would.
void TrialView::KeepTime(double time) {
  if (time >= looked_ + kLookEvery) {
    looked_ = time;
    ShowTime(time);
    Hear();
  }
  if (over_) return;
  const std::chrono::duration<double> since_begin(time);
  std::this_thread::sleep_until(
      begin_ + std::chrono::duration_cast<std::chrono::steady_clock::duration>(since_begin));
}

void TrialView::ShowTime(double time) {
  texts_.time = say::PanelSeconds(time);
  if (complete_) complete_(texts_);
  feed_.SetValues(TrialPanelValues(texts_));
}

void TrialView::Hear() {
  feed_.Hear([this](const ViewLine& line) { Obey(line.text); },
             [this](const std::string& notice) { console_.Remark(notice); });
  if (feed_.closed()) console_.Remark(say::RunsOnUnseen());
  over_ = feed_.ended();
}

void TrialView::Obey(const std::string& line) {
  const std::optional<std::string> done = feed_.Obey(line);
  feed_.ShowLine(done ? *done : say::TakesViewWordsOnly());
  if (line != "?") return;
  feed_.ShowLine(say::ViewWordsHelp());
  feed_.ShowLine(say::ViewColoursHelp());
}

ViewMoment MomentOf(double time, const TickResult& felt, const GuidanceResult& push) {
  ViewMoment moment;
  moment.time = time;
  moment.present = true;
  moment.in_contact = felt.depth > 0;
  moment.tip_P = felt.tip_P;
  moment.proxy_P = felt.proxy_P;
  moment.force_P = felt.force_P;
  moment.guidance_P = push.force_P;
  if (glm::length(push.force_P) > 0) moment.bead_P = push.target_P;
  return moment;
}

}  // namespace moontrace
