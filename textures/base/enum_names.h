#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// Names of an enumeration whose values count up from 0, told by a `switch` with a case for each
/// value and none for `default`, so that a value that is added does not compile until it is named:
///
///     constexpr std::string_view NameOf(Relief relief) {
///       switch (relief) {
///         case Relief::kEngraved: return "engraved";
///         case Relief::kEmbossed: return "embossed";
///       }
///       return {};
///     }
///
/// How many values have a name, which is how many there are.
template <class Enum>
constexpr std::size_t CountNamed(std::string_view (*name_of)(Enum)) {
  std::size_t count = 0;
  while (!name_of(static_cast<Enum>(count)).empty()) ++count;
  return count;
}

/// All names, in the order of the values.
template <class Enum>
std::vector<std::string> AllNames(std::string_view (*name_of)(Enum)) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < CountNamed(name_of); ++i) {
    names.emplace_back(name_of(static_cast<Enum>(i)));
  }
  return names;
}

/// The value of a name; none for other words.
template <class Enum>
constexpr std::optional<Enum> ValueNamed(std::string_view name, std::string_view (*name_of)(Enum)) {
  for (std::size_t i = 0; !name_of(static_cast<Enum>(i)).empty(); ++i) {
    if (name_of(static_cast<Enum>(i)) == name) return static_cast<Enum>(i);
  }
  return std::nullopt;
}

}  // namespace moontrace
