#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace moontrace {

/// Bytes of a terminal without line mode, read as keys: "a", "é", "Space", "Enter", "Backspace",
/// "Tab", "Escape", "F1" to "F12", "Up", "Down", "Left", "Right", "Home", "End", "PageUp",
/// "PageDown". Pure: no terminal is needed.
///
/// An escape byte that ends what was read is the Escape key: a sequence comes in one piece, and the
/// key that stops the force must wait for nothing. Unknown sequences and control bytes are no key.
/// Bytes that are not UTF-8 are dropped.
std::vector<std::string> ReadKeys(std::string_view bytes);

/// Whether ReadKeys could ever give such a key.
bool IsKeyName(const std::string& name);

}  // namespace moontrace
