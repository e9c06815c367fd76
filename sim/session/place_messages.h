#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>

/// Sentences about places of a text and the way there.
namespace moontrace::say {

/// "12 mm right, 3 mm down", "under the tip". `way_P` [m].
std::string Way(glm::dvec2 way_P);
/// "bread, 2 of 5: page 2 of 3, line 1, 12 mm right." `what` empty: the line alone, of which it is
/// the beginning. Page and line from 0; no way: it is not told.
std::string PlaceIs(std::string_view what, std::size_t page, std::size_t pages, std::size_t line,
                    std::optional<glm::dvec2> way_P);
/// What stands at a place. `number` from 1.
std::string Occurrence(std::string_view wanted, std::size_t number, std::size_t of);
std::string HeadingIs(std::string_view line);
/// The beginning of a line's words.
std::string ParagraphIs(std::string_view line);
std::string LinkIs(std::string_view words);
std::string BackAt(std::string_view letter);

std::string FindWhat();
std::string NotInText(std::string_view wanted);
std::string NowhereToReturn();
std::string BackAlready();
std::string NoLineBehind();
std::string NoHeadingBehind();
std::string NoParagraphBehind();
std::string NoLinkBehind();
std::string NoSuchPage(std::string_view number, std::size_t pages);
/// An empty page.
std::string NoPlaceHere();

// Labels of a model.
std::string NoLabels();
std::string OneLabel();
std::string LabelsAre(std::size_t count);
/// "up, UP, top: you are here." `face` may be empty.
std::string LabelIs(std::string_view name, std::string_view text, std::string_view face, bool here);
std::string LabelStays(std::string_view why);
/// "up: first 16 mm out from its face, then 30 mm right, 4 mm up." `label`: as LabelIs; `way_P`
/// [m].
std::string WayToLabel(std::string_view label, glm::dvec3 way_P);
/// `text` may be empty.
std::string Touched(std::string_view geom, std::string_view text);
std::string Pressed(std::string_view geom);

}  // namespace moontrace::say
