#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace moontrace {

/// Offset of the first byte that does not belong to well-formed UTF-8 (Unicode, table 3-7: no
/// overlong forms, no surrogates, nothing above U+10FFFF); nothing when all of it does.
std::optional<std::size_t> FirstBadUtf8(std::string_view bytes) noexcept;

/// Throws InputError (file:line:column, the encoding where its mark tells it, cure) unless the
/// bytes are UTF-8.
void RequireUtf8(std::string_view bytes, const std::string& file_name);

}  // namespace moontrace
