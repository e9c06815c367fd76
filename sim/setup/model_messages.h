#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "textures/typeset/typeset.h"

/// Sentences about text on a geom of a model.
namespace moontrace::say {

std::string PageMoves(std::string_view geom);
/// `from_middle`: the page begins there, so that it has a quarter of the face.
std::string PagesOnGeom(std::size_t pages, std::string_view geom, bool from_middle);
/// `sheet`: what is left of the one asked for.
std::string GeomIsSmaller(std::string_view geom, const PageSpec& sheet);
std::string LabelLacksText(std::string_view model, std::string_view geom);
std::string NoSuchLabel(std::string_view model, std::string_view label, std::string_view labels,
                        std::string_view nearest);
std::string LabelNeedsModel();
std::string OneLabelOnly();
std::string NoLabelHasText(std::string_view model);
/// Text that is larger than what is left of its geom. `size`: of its letters [m]; `text`: what they
/// take [m], of `pages` the first.
std::string LabelHasNoRoom(std::string_view model, std::string_view label, double size,
                           glm::dvec2 text, std::size_t pages);
std::string LabelsLieTogether(std::string_view model, std::string_view a, std::string_view b);
/// `error`: a share.
std::string LengthsErr(std::string_view label, double error);
/// Before what is said of one of several labels.
std::string OfLabel(std::string_view label, std::string_view text);
/// An error in what a label asks for.
std::string InLabel(std::string_view model, std::string_view geom, std::string_view error);

}  // namespace moontrace::say
