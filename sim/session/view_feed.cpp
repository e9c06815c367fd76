#include "sim/session/view_feed.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "sim/session/device_choice.h"
#include "sim/session/view_messages.h"
#include "textures/base/error.h"

namespace moontrace {

std::unique_ptr<ViewFeed> ViewFeed::OpenOfTrial(const ViewOptions& options, Console& console) {
  if (options.frames.empty()) return Open(options, nullptr, console);
  CheckTogether(options);
  ViewerOptions viewer = ViewerOf(options);
  viewer.offline = true;
  return std::make_unique<ViewFeed>(viewer);
}

std::unique_ptr<ViewFeed> ViewFeed::Open(const ViewOptions& options,
                                         const std::shared_ptr<Mailbox<StylusAim>>& aims,
                                         Console& console) {
  CheckTogether(options);
  if (!options.asked()) return nullptr;
  ViewerOptions viewer = ViewerOf(options);
  if (aims != nullptr) {
    viewer.pointer = [aims](const PointerAim& aim) {
      aims->Put({glm::dvec3(aim.p_P, 0), aim.over_page ? aim.press : 0});
    };
  }
  try {
    return std::make_unique<ViewFeed>(viewer);
  } catch (const LackError& error) {
    if (!options.window || aims != nullptr) throw;
    console.Remark(say::ViewSays(error.what()));
    return nullptr;
  }
}

void ViewFeed::Look(const FeltPage& page, const LoopPoll& poll, bool print) {
  if (ended()) return;
  if (shown_ != page.shown || print_ != print) {
    viewer_.Show(print ? ViewPageOf(page) : WithoutPrint(*ViewPageOf(page)));
    shown_ = page.shown;
    print_ = print;
  }
  ViewMoment moment = MomentOf(poll.newest());
  moment.lateness_us = poll.lateness_us();
  if (ScenePose pose; model_ && poll.TakePose(pose)) {
    moment.pose = std::make_shared<const ScenePose>(std::move(pose));
  }
  viewer_.Add(moment);
}

void ViewFeed::Add(const LoopSample& sample) {
  if (!ended()) viewer_.Add(MomentOf(sample));
}

void ViewFeed::SetPanel(std::vector<PanelControl> controls) {
  values_.clear();
  viewer_.SetPanel(std::move(controls));
}

void ViewFeed::SetValues(std::vector<PanelValue> values) {
  if (values == values_) return;
  values_ = values;
  viewer_.SetPanelValues(std::move(values));
}

void ViewFeed::Hear(const Heard& obey, const Remarked& remark) {
  while (const std::optional<ViewLine> line = viewer_.NextLine()) obey(*line);
  const std::string notice = TakeNotice();
  if (!notice.empty()) remark(notice);
}

ViewerReport ViewFeed::Finish() {
  viewer_.Finish();
  std::error_code error;  // it was empty when the view began
  if (!window() && std::filesystem::is_empty(frames_, error)) return {};
  return viewer_.report();
}

/// Empty: there is none.
std::string ViewFeed::TakeNotice() {
  if (const std::optional<std::string> notice = viewer_.NextNotice()) return say::ViewSays(*notice);
  if (failed_) return {};
  const std::string why = viewer_.failure();
  if (why.empty()) return {};
  failed_ = true;
  return say::ViewSays(why);
}

std::shared_ptr<Mailbox<StylusAim>> AimsFor(const std::string& device, const ViewOptions& options) {
  if (!IsMouse(device)) return nullptr;
  if (!options.window) throw UsageError(say::MouseNeedsWindow());
  return std::make_shared<Mailbox<StylusAim>>();
}

void RequireView(const ViewFeed& feed, const std::string& device) {
  if (!feed.failed()) return;
  if (!feed.window()) throw LackError(say::FramesNotWhole());
  if (IsMouse(device)) throw LackError(say::MouseGone());
}

namespace {

ViewerReport FinishTelling(ViewFeed& feed, const ViewOptions& options, Console& console) {
  ViewerReport report = feed.Finish();
  if (!options.frames.empty() && report.frames > 0) {
    console.Result(say::FramesIn());
    console.Path(options.frames);
  }
  for (const std::string& sentence : report.seen) console.Result(sentence);
  return report;
}

}  // namespace

void EndView(ViewFeed& feed, const ViewOptions& options, Console& console) {
  FinishTelling(feed, options, console);
}

void SayView(ViewFeed& feed, const ViewOptions& options, Console& console) {
  const ViewerReport report = FinishTelling(feed, options, console);
  if (!feed.window() && report.frames == 0) return;
  console.Result(say::ViewKeptUp(report.frames, report.median_frame_ms, report.slowest_frame_ms));
}

Json ViewJson(ViewFeed& feed) {
  const ViewerReport report = feed.Finish();
  Json json = {{"frames", report.frames},
               {"median_frame_ms", report.median_frame_ms},
               {"slowest_frame_ms", report.slowest_frame_ms},
               {"median_change_ms", report.median_change_ms}};
  if (!report.seen.empty()) json["seen"] = report.seen;
  return json;
}

std::shared_ptr<const ViewPage> ViewPageOf(const FeltPage& page) {
  const TextSetup& text = *page.text;
  return MakeViewPage(text.set, page.index, text.script, text.text, page.field, page.blank,
                      page.number);
}

ViewMoment MomentOf(const LoopSnapshot& snapshot) {
  ViewMoment moment;
  moment.time = snapshot.time;
  moment.page = snapshot.page;
  moment.present = snapshot.present;
  moment.in_contact = snapshot.depth > 0;
  moment.stopped = snapshot.stopped;
  moment.tip_P = snapshot.tip_P;
  moment.proxy_P = snapshot.proxy_P;
  moment.force_P = snapshot.force_P;
  moment.guidance_P = snapshot.guidance_P;
  if (snapshot.guided) moment.bead_P = snapshot.target_P;
  moment.heat = std::max({snapshot.heat.x, snapshot.heat.y, snapshot.heat.z});
  return moment;
}

ViewMoment MomentOf(const LoopSample& sample) {
  ViewMoment moment;
  moment.time = sample.time;
  moment.page = sample.page;
  moment.present = true;
  moment.in_contact = sample.in_contact;
  moment.tip_P = moment.proxy_P = sample.tip_P;
  moment.force_P = sample.force_P;
  moment.guidance_P = sample.guidance_P;
  return moment;
}

}  // namespace moontrace
