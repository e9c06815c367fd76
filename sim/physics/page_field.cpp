#include "sim/physics/page_field.h"

#include "textures/relief/glyph_group.h"

namespace moontrace {

TextureField PageField(const TextPage& page, const Script& script, const TypeStyle& style,
                       bool blank) {
  return blank ? TextureField() : TextureField(BuildTexture(page, script, style));
}

}  // namespace moontrace
