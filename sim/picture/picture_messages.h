#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "textures/fonts/script.h"
#include "textures/typeset/style.h"

namespace moontrace::say {

/// What pictures say: title, description and legend; and that there would be too many of them.

/// "groove" or "ridge".
std::string_view ReliefWord(const TypeStyle& style);
std::string TooManyPictures(std::size_t pages, std::size_t limit);
std::string PagePictureTitle(std::string_view script, std::size_t page, std::size_t pages);
std::string PagePictureWords(std::size_t signs, std::size_t lines, const TypeStyle& style);
std::string TableTitle(const Script& script);
std::string TableWords(const Script& script, std::size_t shown);

}  // namespace moontrace::say
