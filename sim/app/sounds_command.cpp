#include "sim/app/commands.h"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <thread>
#include <vector>

#include "sim/audio/sound.h"
#include "sim/audio/sound_messages.h"
#include "sim/audio/sound_mixer.h"
#include "sim/audio/sound_synthesis.h"
#include "sim/audio/sound_table.h"
#include "sim/audio/wav.h"
#include "textures/base/error.h"
#include "textures/base/output_file.h"
#include "textures/base/units.h"

namespace moontrace {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kPathLength = 4;                   // of the example [s]
constexpr std::chrono::milliseconds kBetween{600};  // sounds
constexpr std::chrono::seconds kToOpen{5};          // an output

/// The example of the path: once round a circle on the line, then away from it and back.
PathSound ExampleAt(double t) {
  const double turns = 2 * t / kPathLength;  // 0-1 round, 1-2 away and back
  PathSound now;
  now.in_contact = t < kPathLength;
  const double angle = kTurn * turns;
  now.x = turns < 1 ? 0.5 + 0.5 * std::sin(angle) : 0.5;
  now.y = turns < 1 ? 0.5 - 0.5 * std::cos(angle) : 0;
  now.off_line = turns < 1 ? 0 : 0.5 - 0.5 * std::cos(angle);
  return now;
}

/// What is heard of `seconds` of a mixer, as a file.
Wav Rendered(Mixer& mixer, double seconds, const std::function<PathSound(double)>& path) {
  constexpr std::size_t kBlock = 48;  // 1 ms
  Wav wav{kSoundRate, 2, {}};
  const auto blocks = static_cast<std::size_t>(std::ceil(seconds * kSoundRate / kBlock));
  wav.samples.resize(2 * kBlock * blocks);
  for (std::size_t i = 0; i < blocks; ++i) {
    const double t = static_cast<double>(i * kBlock) / kSoundRate;
    mixer.Render(wav.samples.data() + 2 * kBlock * i, kBlock, path(t));
  }
  return wav;
}

double LengthOf(const EarconSound& sound) {
  return static_cast<double>(RenderEarcon(sound).size()) / kSoundRate;
}

void WriteSounds(const SoundTable& table, const std::string& folder, Console& console) {
  namespace fs = std::filesystem;
  constexpr double kTail = 0.02;  // [s]
  MakeFolder(folder);
  const auto write = [&](const std::string& name, const Wav& wav) {
    const std::string path = (fs::path(folder) / (name + ".wav")).string();
    WriteWhole(path, WavBytes(wav));
    console.Path(path);
  };
  const auto none = [](double) { return PathSound{}; };
  for (const Earcon earcon : AllEarcons()) {
    const EarconSound& sound = table.earcons[static_cast<std::size_t>(earcon)];
    if (!sound.on) continue;
    Mixer mixer(table);
    mixer.Play(earcon);
    write(std::string(KeyOf(earcon)), Rendered(mixer, LengthOf(sound) + kTail, none));
  }
  Mixer mixer(table);
  if (table.path.on) write("path", Rendered(mixer, kPathLength + kTail, ExampleAt));
}

/// Plays each sound behind its line.
class Player {
 public:
  Player(const SoundTable& table, Console& console) : sound_(table), console_(console) {
    const Clock::time_point until = Clock::now() + kToOpen;
    while (!sound_.sounding() && Clock::now() < until && !why_)
      Pause(std::chrono::milliseconds(20));
    if (!sound_.sounding() && !why_) why_ = say::NoSoundOutput("it does not answer");
  }
  void Play(Earcon earcon) {
    if (why_) return;
    sound_.Play(earcon);
    Pause(kBetween);
  }
  void PlayPath() {
    const Clock::time_point begin = Clock::now();
    double t = 0;
    while (!why_ && t < kPathLength) {
      sound_.Follow(ExampleAt(t));
      Pause(std::chrono::milliseconds(5));
      t = std::chrono::duration<double>(Clock::now() - begin).count();
    }
    sound_.Silence();
  }
  /// Why nothing is heard.
  const std::optional<std::string>& why() const { return why_; }

 private:
  void Pause(std::chrono::milliseconds time) {
    console_.CheckStop();
    std::this_thread::sleep_for(time);
    if (const auto sentence = sound_.TakeSentence()) why_ = sentence;
  }
  Sound sound_;
  Console& console_;
  std::optional<std::string> why_;
};

nlohmann::json ListJson(const SoundTable& table) {
  nlohmann::json list = nlohmann::json::array();
  list.push_back({{"name", "path"}, {"says", say::PathSoundLine(true)}, {"on", table.path.on}});
  for (const Earcon earcon : AllEarcons()) {
    const EarconSound& sound = table.earcons[static_cast<std::size_t>(earcon)];
    list.push_back({{"name", KeyOf(earcon)},
                    {"says", say::EarconLine(earcon, true)},
                    {"on", sound.on},
                    {"seconds", LengthOf(sound)}});
  }
  return {{"sounds", list}};
}

}  // namespace

void AddOptions(CLI::App& app, SoundsOptions& options) {
  AddFlag(app, "--play", options.play, say::help::kSoundsPlay);
  AddPath(app, "--wav", "DIR", options.wav, say::help::kSoundsWav);
  AddPath(app, "--sounds", "FILE", options.sounds, say::help::kSoundsFile);
  AddOptions(app, options.output);
}

int Run(const SoundsOptions& options, Console& console) {
  const SoundTable table = LoadSounds(options.sounds);
  std::optional<Player> player;
  if (options.play) player.emplace(table, console);
  if (options.output.json) console.Json(ListJson(table).dump());
  console.Result(say::PathSoundLine(table.path.on));
  console.out().flush();
  if (player) player->PlayPath();
  for (const Earcon earcon : AllEarcons()) {
    console.Result(say::EarconLine(earcon, table.earcons[static_cast<std::size_t>(earcon)].on));
    console.out().flush();
    if (player) player->Play(earcon);
  }
  if (!options.wav.empty()) WriteSounds(table, options.wav, console);
  if (player && player->why()) throw LackError(*player->why());
  return exit_code::kGood;
}

}  // namespace moontrace
