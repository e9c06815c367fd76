#pragma once

#include <map>
#include <string>
#include <string_view>

namespace moontrace {

/// How a key is called where it is told: "plus", "comma", "Escape".
std::string KeyCalled(const std::string& key);

/// A sentence of a lesson for who has single keys (key -> word of learn_words.h): "say next" is
/// "press n", "Type stop and Enter" is "Press Escape". Words without a key stay as they are, and so
/// do answers, which are typed with Enter.
std::string WithKeys(std::string_view sentence, const std::map<std::string, std::string>& keys);

}  // namespace moontrace
