#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "lessons/measure/scoring.h"
#include "textures/fonts/script.h"
#include "textures/typeset/style.h"

namespace moontrace::say {

/// What pictures say: title, description and legend; and that there would be too many of them.

std::string TooManyPictures(std::size_t pages, std::size_t limit);
std::string PagePictureTitle(std::string_view script, std::size_t page, std::size_t pages);
std::string PagePictureWords(std::size_t signs, std::size_t lines, const TypeStyle& style);
std::string TracePictureTitle(std::string_view script, const TypeStyle& style, bool blank);
std::string TracePictureWords(std::string_view text, const TraceMetrics& total);
/// `rings`: there are some.
std::string TracePictureLegend(const TypeStyle& style, bool blank, bool rings);
std::string TableTitle(const Script& script);
std::string TableWords(const Script& script, std::size_t shown);

}  // namespace moontrace::say
