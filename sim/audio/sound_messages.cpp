#include "sim/audio/sound_messages.h"

#include <fmt/core.h>

#include <algorithm>

#include "textures/base/text_file.h"

namespace moontrace::say {

namespace {

constexpr const char* kOff = " Switched off.";

std::string_view Meaning(Earcon earcon) {
  switch (earcon) {
    case Earcon::kStrokeStart:
      return "a stroke begins here. Two pure notes, rising.";
    case Earcon::kStrokeEnd:
      return "a stroke ends here. One pure note.";
    case Earcon::kLetterDone:
      return "all of a letter has been followed. Three bells, rising.";
    case Earcon::kOffLine:
      return "the tip has left the line. One long, low reed.";
    case Earcon::kBackOn:
      return "the tip is on the line again. Three quick reeds, rising.";
    case Earcon::kLineEnd:
      return "end of a line of text, and the turn. Two bells, falling.";
    case Earcon::kPageEnd:
      return "end of the page. Four bells, falling.";
    case Earcon::kWrong:
      return "that was wrong. Two low, brassy notes, falling.";
    case Earcon::kRight:
      return "that was right. Two brassy notes, rising.";
    case Earcon::kHelpChanged:
      return "the help has changed. Three high, pure notes, level.";
    case Earcon::kSafetyStop:
      return "stopped, no force. Five brassy notes, to and fro.";
  }
  return {};
}

}  // namespace

std::string EarconName(Earcon earcon) {
  std::string name(KeyOf(earcon));
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string EarconLine(Earcon earcon, bool on) {
  return fmt::format("{}: {}{}", EarconName(earcon), Meaning(earcon), on ? "" : kOff);
}

std::string PathSoundLine(bool on) {
  return fmt::format(
      "path: the tip touches. A tone: left and right as it goes left and right, higher as it goes "
      "up the page; off the line a trembling tone grows.{}",
      on ? "" : kOff);
}

std::string OnThePath(Earcon earcon) {
  switch (earcon) {
    case Earcon::kOffLine:
      return "Off the line.";
    case Earcon::kBackOn:
      return "On the line again.";
    case Earcon::kLineEnd:
      return "End of the line: the next begins below.";
    case Earcon::kPageEnd:
      return "End of the page.";
    case Earcon::kStrokeStart:
    case Earcon::kStrokeEnd:
    case Earcon::kLetterDone:
    case Earcon::kWrong:
    case Earcon::kRight:
    case Earcon::kHelpChanged:
    case Earcon::kSafetyStop:
      break;  // touch has its tone; the others are said with what they concern
  }
  return {};
}

std::string NoSoundLibrary() {
  return "No sound, all is text: this build has no PortAudio; install portaudio19-dev and build "
         "again.";
}

std::string NoSoundOutput(std::string_view cause) {
  return fmt::format("No sound, all is text: no output can be opened: {}.", OneLine(cause, 200));
}

std::string SoundGone() { return "No more sound, all is text: the sound output has ended."; }

}  // namespace moontrace::say
