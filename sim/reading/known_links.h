#pragma once

#include <functional>
#include <memory>

#include "sim/reader/link_shapes.h"
#include "sim/reader/sign_shapes.h"
#include "textures/fonts/script.h"
#include "textures/typeset/style.h"

namespace moontrace {

/// The links between signs as a reader knows them, who knows the script and how letters are linked,
/// but no page: each pair's as if it stood alone, on lines of the usual pitch, for letters of any
/// size [m]. Of `style` the links, the groove's width and its depth are told. The result owns what
/// it needs.
std::function<std::shared_ptr<const LinkShapes>(double size)> KnownLinks(
    std::shared_ptr<const SignShapes> shapes, const Script& script, const TypeStyle& style);

}  // namespace moontrace
