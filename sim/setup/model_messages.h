#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "textures/typeset/typeset.h"

/// Sentences about text on a geom of a model.
namespace moontrace::say {

std::string PageMoves(std::string_view geom);
std::string PagesOnGeom(std::size_t pages, std::string_view geom);
/// `sheet`: what is left of the one asked for.
std::string GeomIsSmaller(std::string_view geom, const PageSpec& sheet);
std::string LabelLacksText(std::string_view model, std::string_view geom);
/// An error in what a label asks for.
std::string InLabel(std::string_view model, std::string_view geom, std::string_view error);

}  // namespace moontrace::say
