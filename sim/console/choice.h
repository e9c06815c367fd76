#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// Which of some numbered choices a line means, from 0: by the choice's word or its beginning of
/// two letters or more, by its number in figures or words, among other words too ("paper please",
/// "the second one"). None: it names none of them, or more than one.
std::optional<std::size_t> ChoiceOf(std::string_view line, const std::vector<std::string>& choices);

}  // namespace moontrace
