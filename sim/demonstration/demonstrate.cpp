#include "sim/demonstration/demonstrate.h"

#include <chrono>
#include <memory>
#include <string_view>
#include <vector>

#include "sim/console/vocabulary.h"
#include "sim/demonstration/demonstration.h"
#include "sim/demonstration/demonstration_messages.h"
#include "sim/learn/key_wording.h"
#include "sim/learn/learn_messages.h"
#include "sim/learn/learn_sound.h"
#include "sim/learn/learn_stage.h"
#include "sim/learn/learn_teller.h"
#include "sim/session/view_feed.h"
#include "textures/base/error.h"

namespace moontrace {

namespace {

/// What a demonstration is driven by, and what listens beside the teller; null: nothing.
struct DriveParts {
  LearnInput& input;
  bool at_terminal = false;
  ViewFeed* feed = nullptr;
  PathListener* path = nullptr;
};

/// Until it ends by itself or by a word. A pipe that has ended waits for nothing any more; a person
/// who ends input at a terminal leaves.
void Drive(Demonstration& demonstration, LearnStage& stage, const DriveParts& parts,
           std::optional<double> seconds, const Console& console) {
  constexpr int kPoll = 20;  // [ms]
  const auto begin = Demonstration::Clock::now();
  const auto obey = [&](const ViewLine& line) { demonstration.Obey(line.text); };
  while (!demonstration.over()) {
    console.CheckStop();
    const auto now = Demonstration::Clock::now();
    if (seconds && std::chrono::duration<double>(now - begin).count() >= *seconds) break;
    demonstration.Look(now);
    if (parts.path != nullptr) parts.path->Hear();
    if (parts.feed != nullptr) {
      parts.feed->Look(stage.session().felt(), demonstration.poll(), !demonstration.hides());
      parts.feed->Hear(obey, [](const std::string&) {});
      if (parts.feed->closed()) break;
    }
    if (parts.input.ended() && parts.at_terminal) demonstration.Leave();
    if (parts.input.ended() && !seconds) demonstration.Hurry();
    if (demonstration.over()) break;
    const auto line = parts.input.Next(kPoll, demonstration.asks());
    if (line) demonstration.Obey(*line);
  }
}

/// Those of the keys whose word is one here.
KeyMap KeysHere(KeyMap keys) {
  std::erase_if(keys, [](const auto& one) {
    return !WordNamed(one.second)->HoldsIn(WordPlace::kDemonstration);
  });
  return keys;
}

}  // namespace

bool IsDemonstration(const LearnOptions& options) {
  return options.live.device == "simulated" && options.records.empty() && !options.tutor &&
         options.course == LearnOptions().course;
}

std::string Demonstrate(const LearnOptions& options, const std::optional<KeyMap>& all_keys,
                        const Course& course, Console& console) {
  std::optional<KeyMap> keys;
  if (all_keys) keys = KeysHere(*all_keys);
  const std::vector<DemonstrationStep> steps = ShippedDemonstration();
  const std::unique_ptr<Speech> speech = SpeechFor(options, course);
  const std::unique_ptr<Sound> sound = SoundFor(options);
  LearnTeller teller(console, speech.get(), sound.get());
  if (keys) teller.SetWording([&keys](std::string_view line) { return WithKeys(line, *keys); });
  if (!options.learner.empty()) teller.Say(Priority::kText, say::NoNameNeeded());
  LineReader lines(console.in());
  const std::unique_ptr<ViewFeed> feed = ViewFeed::Open(options.view, nullptr, console);
  LearnStage stage({options.live, options.press, options.seed}, console);
  Demonstration demonstration(steps, stage, teller,
                              keys ? say::DemonstrationKeysHelp(*keys) : say::DemonstrationHelp());
  std::unique_ptr<PathListener> path;
  if (sound) path = std::make_unique<PathListener>(*sound, stage, teller, demonstration);
  if (feed) {
    stage.SetWatch([&feed](const LoopSample& sample) { feed->Add(sample); });
    teller.SetListener([&feed](std::string_view line) { feed->ShowLine(line); });
  }
  const std::unique_ptr<LearnInput> input = InputFor(keys, lines, {}, console);
  Drive(demonstration, stage, {*input, lines.at_terminal(), feed.get(), path.get()},
        options.live.seconds, console);
  stage.session().loop().End();
  if (feed) {
    EndView(*feed, options.view, console);
    RequireView(*feed, options.live.device);
  }
  return demonstration.way();
}

}  // namespace moontrace
