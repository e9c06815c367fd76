#include "sim/app/commands.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "lessons/measure/nearest_stroke.h"
#include "lessons/measure/scoring.h"
#include "sim/app/messages.h"
#include "sim/app/trace_picture.h"
#include "sim/app/trace_report.h"
#include "sim/learn/learn_trace.h"
#include "sim/picture/picture_file.h"
#include "sim/session/loop_drive.h"
#include "sim/session/loop_messages.h"
#include "sim/session/loop_session.h"
#include "sim/session/view_feed.h"
#include "sim/setup/typeset_report.h"
#include "sim/trial/touch_energy.h"

namespace moontrace {

namespace {

/// A stroke is meant within a quarter em of it: halfway to the next where they are closest.
constexpr double kReachEm = 0.25;

/// The score of one page while it is traced.
class PageScore {
 public:
  PageScore(const TextSetup& text, std::size_t page, double spacing)
      : strokes_(IntendedStrokes(text.set.pages[page], text.script, text.set.style)),
        nearest_(strokes_, kReachEm * text.set.style.size),
        scorer_(strokes_, text.set.pages[page].glyphs.size()),
        spacing_(spacing) {
    for (const IntendedStroke& stroke : strokes_) result_.stroke_length += LengthOf(stroke);
  }

  /// `tick` is the time that a sample stands for [s].
  void Add(const LoopSample& sample, double tick) {
    TraceSample scored = ToScore(sample);
    nearest_.Assign(scored);
    scorer_.Add(scored);
    ++result_.ticks;
    result_.duration += tick;
    if (sample.fault) ++result_.faults;
    if (sample.through && !through_) {
      if (result_.through == 0) result_.first_through = result_.duration;
      ++result_.through;
    }
    through_ = sample.through;
    energy_.Add(sample.energy_out, sample.in_contact);
    const PathPoint point{sample.tip_P, scored.phase, sample.in_contact};
    std::vector<PathPoint>& path = result_.path;
    const bool same = !path.empty() && path.back().in_contact == point.in_contact &&
                      glm::distance(path.back().tip_P, point.tip_P) < spacing_;
    if (spacing_ > 0 && !same) path.push_back(point);
  }

  TrialResult Finish(const LoopSession& session) {
    result_.score = scorer_.Finish();
    result_.energy_out = energy_.value();
    result_.force_bound = session.force_bound();
    result_.carried_press = session.carried_press();
    result_.real_time_factor = 1;
    return std::move(result_);
  }

 private:
  std::vector<IntendedStroke> strokes_;
  NearestStroke nearest_;
  TraceScorer scorer_;
  double spacing_ = 0;
  TouchEnergy energy_;
  bool through_ = false;
  TrialResult result_;
};

void RefuseOthers(const TraceOptions& options) {
  const std::pair<bool, const char*> given[] = {
      {options.speed.has_value(), "--speed-mm-s"},
      {options.seed_given, "--seed"},
      {options.guide.mode.has_value(), "--guide"},
      {options.guide.help.has_value(), "--help-level"},
      {!options.device_profile.empty(), "--device-profile"},
      {!options.record.empty(), "--record"},
      {options.csv, "--csv"}};
  for (const auto& option : given) {
    if (option.first) throw UsageError(say::NotWithDevice(option.second));
  }
}

SessionRequest RequestOf(const TraceOptions& options) {
  SessionRequest request;
  request.text = {options.text, options.style, options.layout, options.feel, "trace"};
  request.live = options.live;
  request.press = options.press;
  request.blank = options.blank;
  return request;
}

void Report(const TraceOptions& options, const Trace& trace, double scale, Console& console) {
  const TrialResult all = Merged(trace.pages);
  if (options.output.json) {
    Json json = TraceJson(trace, options.feel.scene, all);
    json["device"] = options.live.device;
    json["scale"] = scale;
    console.Json(Dump(json));
  } else {
    SayTrace(trace, all, say::DeviceTime(all.duration), console);
  }
  if (all.ticks == 0) throw WorkFailed(say::NothingTraced());
  if (all.faults > 0) throw WorkFailed(say::Faults(all));
}

}  // namespace

int TraceWithDevice(const TraceOptions& options, Console& console) {
  RefuseOthers(options);
  SessionRequest request = RequestOf(options);
  request.aims = AimsFor(options.live.device, options.view);
  const std::unique_ptr<ViewFeed> view = ViewFeed::Open(options.view, request.aims, console);
  LoopSession session(request, console);
  Trace trace;
  trace.text = session.text();
  trace.blank = options.blank;
  const TypeStyle& style = trace.text.set.style;
  SayReplacements(trace.text.set, [&console](const std::string& line) { console.Remark(line); });
  const std::string why_not = session.loop().not_realtime();
  if (!why_not.empty() && session.device().felt()) console.Remark(say::NotRealtime(why_not));
  SayBeginning(session, console);

  const std::size_t pages = trace.text.set.pages.size();
  std::vector<PageScore> scores;
  scores.reserve(pages);
  for (std::size_t page = 0; page < pages; ++page) {
    scores.emplace_back(trace.text, page, options.picture.empty() ? 0 : style.width / 20);
  }
  DriveOptions drive;
  drive.seconds = options.live.seconds;
  drive.sizes = false;
  drive.view = view.get();
  const double tick = 1 / session.rate();
  drive.sample = [&scores, tick](const LoopSample& s) { scores.at(s.page).Add(s, tick); };
  Drive(session, drive, console);

  std::optional<PagePictures> pictures;
  if (!options.picture.empty()) pictures.emplace(options.picture, pages);
  for (std::size_t page = 0; page < pages; ++page) {
    TrialResult result = scores[page].Finish(session);
    if (pictures) {
      pictures->Add(TracePicture(trace.text.set.pages[page], trace.text.script, style,
                                 options.blank, TextOf(trace.text, page), result));
      result.path = {};
    }
    trace.pages.push_back(std::move(result));
  }
  if (pictures) trace.pictures = pictures->Finish();
  Report(options, trace, session.device().scale(), console);
  if (view && !options.output.json) SayView(*view, options.view, console);
  RequireDevice(session);
  if (view) RequireView(*view, options.live.device);
  return exit_code::kGood;
}

}  // namespace moontrace
