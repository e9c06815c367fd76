#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

/// What the demonstration answers to words; what it tells stands in lessons/demonstration.toml.
namespace moontrace::say {

std::vector<std::string> DemonstrationHelp();
/// Of single keys (key -> word).
std::vector<std::string> DemonstrationKeysHelp(const std::map<std::string, std::string>& keys);
std::string WrongAnswer(std::string_view given);
/// An answer whose question is over.
std::string AnswerCameLate();
std::string WholeWordAsked();
std::string NothingAsked(bool paused);
std::string DemonstrationLeft();
std::string DemonstrationCutOff();
std::string DemonstrationPauses();
std::string DemonstrationGoesOn();
std::string DemonstrationSlower();

}  // namespace moontrace::say
