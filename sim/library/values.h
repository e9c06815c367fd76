#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "sim/library/handles.h"
#include "textures/field/field.h"
#include "textures/fonts/script.h"
#include "textures/objects/solid_contact.h"
#include "textures/typeset/typeset.h"

namespace moontrace {

/// What stands behind the handles of the C interface: values that nothing changes.

struct ScriptValue {
  explicit ScriptValue(Script given) : script(std::make_shared<const Script>(std::move(given))) {}
  std::shared_ptr<const Script> script;
};

/// A text that was set. Pages share it.
struct TextValue {
  std::string source;
  std::shared_ptr<const Script> script;  ///< with guide lines, where the style has them
  Typeset set;
};

struct PageValue {
  std::shared_ptr<const TextValue> text;
  std::size_t number = 0;  ///< of its pages
  TextPage sheet;          ///< with the links between its letters
  std::shared_ptr<const TextureField> field;
  Box text_P;  ///< all that is raised or engraved, but the paper's own texture [m]
};

/// A page on a solid.
struct ObjectValue {
  std::shared_ptr<const TextureField> field;
  Solid solid;
  LabelOnSolid label;
  Box text_P;  ///< [m]
};

using ScriptTable = HandleTable<ScriptValue, 1>;
using TextTable = HandleTable<std::shared_ptr<const TextValue>, 2>;
using PageTable = HandleTable<PageValue, 3>;
using ObjectTable = HandleTable<ObjectValue, 6>;

/// In messages.
inline constexpr const char* kScript = "script";
inline constexpr const char* kText = "text";
inline constexpr const char* kPage = "page";
inline constexpr const char* kObject = "object";

}  // namespace moontrace
