#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>

#include "sim/loop/loop_types.h"
#include "sim/setup/text_setup.h"
#include "textures/field/field.h"

namespace moontrace {

/// A page of a text as it is felt: what leads the hand, shows and speaks is given of it. Cheap to
/// copy; what it shares never changes.
struct FeltPage {
  std::shared_ptr<const TextSetup> text;
  std::size_t index = 0;  ///< in the text, from 0
  bool blank = false;     ///< paper without grooves
  /// LoopSample::page and LoopSnapshot::page while it is felt; no page of another text has it.
  std::uint32_t number = 0;
  /// Changes whenever another page, or the same in another form, is let be felt.
  std::uint64_t shown = 0;
  std::shared_ptr<const TextureField> field;  ///< built once, for all

  const TextPage& set() const { return text->set.pages[index]; }
};

/// The page `index` of a text. Throws InputError as TextureField.
FeltPage FeltPageOf(std::shared_ptr<const TextSetup> text, std::size_t index, bool blank,
                    std::uint32_t number);
/// Another page of its text. Throws InputError as TextureField.
FeltPage OtherPage(const FeltPage& page, std::size_t index);

/// The letter that is nearest to a place.
struct NearLetter {
  std::string name;       ///< the characters it stands for, otherwise the sign's name
  std::string word;       ///< that it belongs to
  std::size_t line = 0;   ///< on the page, from 0
  bool near = false;      ///< no farther than a quarter of its size
  glm::dvec2 in_P{0, 0};  ///< the place in its em box, 0-1 each way
};
/// None on an empty page. `p_P` [m].
std::optional<NearLetter> LetterNear(const FeltPage& page, glm::dvec2 p_P);

/// A place of a text, which stays the same when the text is set anew.
struct LetterPlace {
  std::size_t source = 0;        ///< byte of the letter
  glm::dvec2 from_letter{0, 0};  ///< [em]
};
/// None on an empty page. `p_P` [m].
std::optional<LetterPlace> LetterPlaceOf(const FeltPage& page, glm::dvec2 p_P);

/// Where a place of a text lies.
struct FoundPlace {
  std::size_t page = 0;  ///< from 0
  std::size_t line = 0;  ///< on the page, from 0
  glm::dvec2 p_P{0, 0};  ///< [m]
  std::string letter;    ///< the characters that the letter there stands for
};
/// None: the text has no letters.
std::optional<FoundPlace> Find(const TextSetup& text, const LetterPlace& place);

/// The byte of the first letter that begins at `source` or behind it; none: there is none.
std::optional<std::size_t> LetterFrom(const TextSetup& text, std::size_t source);

/// The same letter where a text was set anew.
struct Followed {
  std::size_t page = 0;              ///< that the letter lies on now, from 0
  std::optional<PageAnchor> anchor;  ///< keeps its place under the tip; none: there is no letter
};
/// The letter of `page` that is nearest to `tip_P` [m], in `next`, which is the same text in
/// another size or form.
Followed Follow(const FeltPage& page, const TextSetup& next, glm::dvec2 tip_P);

}  // namespace moontrace
