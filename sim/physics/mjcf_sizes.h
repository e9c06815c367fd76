#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace moontrace {

/// Refuses XML of more tags than a model within RequireModestSizes can have, before it is parsed.
/// Throws InputError of one line that begins with `name`.
void RequireFewTags(std::string_view xml, const std::string& name);

/// Refuses a model for which MuJoCo would take more memory or time than a label on it needs: it
/// checks little itself before it takes them, and an overflow ends the program. Bounded (all ours,
/// each some hundred times what the shipped models ask for, together about 1 GB and 10 s of one
/// core): elements, replicated and composed ones counted as often as they will be made; samples of
/// height fields and textures, those of PNG files too; files that it names, which must be regular;
/// what `size`, `option` and `visual` set aside. `folder`: where the model lies. Includes are
/// expanded already. Throws InputError of one line that begins with `name`: element, attribute, the
/// bound.
void RequireModestSizes(const pugi::xml_node& root, const std::string& folder,
                        const std::string& name);

}  // namespace moontrace
