#pragma once

#include <string>
#include <string_view>

/// Sentences of speech.
namespace moontrace::say {

// Why nothing is spoken: one sentence each, said once; the lesson goes on in text.
std::string SpeechNotThere();
std::string SpeechSilent();
std::string SpeechGone();
std::string SpeechRefused(std::string_view answer);
std::string SpeechAddressUnknown(std::string_view address);

}  // namespace moontrace::say
