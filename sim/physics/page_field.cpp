#include "sim/physics/page_field.h"

#include "textures/relief/glyph_group.h"

namespace moontrace {

TextureField PageField(const TextPage& page, const Script& script, const TypeStyle& style,
                       bool blank, const std::vector<PaperPatch>& marks) {
  if (blank && marks.empty()) return TextureField();
  Texture texture;
  if (!blank) texture = BuildTexture(page, script, style);
  texture.paper.insert(texture.paper.end(), marks.begin(), marks.end());
  return TextureField(texture);
}

}  // namespace moontrace
