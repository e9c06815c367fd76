#include "sim/audio/speech_messages.h"

#include <fmt/core.h>

#include "textures/base/text_file.h"

namespace moontrace::say {

std::string SpeechNotThere() {
  return "No speech, all is text: speech-dispatcher is not there; install it or start it.";
}

std::string SpeechSilent() { return "No speech, all is text: speech-dispatcher does not answer."; }

std::string SpeechGone() { return "No more speech, all is text: speech-dispatcher has ended."; }

std::string SpeechRefused(std::string_view answer) {
  return fmt::format("No speech, all is text: speech-dispatcher refused: {}.",
                     OneLine(answer, 100));
}

std::string SpeechAddressUnknown(std::string_view address) {
  return fmt::format("No speech, all is text: SPEECHD_ADDRESS must be unix_socket:PATH, and is {}.",
                     OneLine(address, 100));
}

}  // namespace moontrace::say
