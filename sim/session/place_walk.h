#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/guide/guidance_path.h"
#include "sim/loop/loop_types.h"
#include "sim/session/felt_page.h"
#include "sim/session/loop_session.h"

namespace moontrace {

/// Words that lead to another place of a text: the same in the loop, in a view and in a lesson.
enum class PlaceWord : std::uint8_t {
  kFind,
  kFindNext,
  kReturn,
  kNextLine,
  kNextHeading,
  kNextParagraph,
  kNextLink,
  kGoTo
};

struct PlaceCommand {
  PlaceWord word = PlaceWord::kFind;
  std::string text = {};  ///< of kFind: what is looked for; of kGoTo: a page's number
};
/// Reads a word as the vocabulary has it, and what stands behind it. None: another word.
std::optional<PlaceCommand> PlaceCommandOf(std::string_view word, std::string_view behind);

/// Bytes of `text` where `wanted` begins, ascending, none within another. Capitals do not count,
/// nor how many blanks and line ends stand between two words.
std::vector<std::size_t> Occurrences(std::string_view text, std::string_view wanted);

/// Leads from place to place in the text that a session lets be felt: turns to the page, then says
/// the way there from the tip. Forgets all when another text lies there. One thread.
class PlaceWalk {
 public:
  using Turn = std::function<void(std::size_t page)>;
  /// `session` must outlive this; `turn` lets another page of its text be felt.
  PlaceWalk(const LoopSession& session, Turn turn);

  /// What is said at once: why there is no way. Empty: the way is said by Arrived. `now`: the
  /// newest tick.
  std::string Go(const PlaceCommand& command, const LoopSnapshot& now);

  struct Arrival {
    std::string sentence;       ///< what is there, and the way
    std::size_t source = 0;     ///< byte of the letter
    glm::dvec3 tip_P{0, 0, 0};  ///< from where [m]
    glm::dvec2 place_P{0, 0};   ///< [m]
  };
  /// A byte of the text, and what stands there in words; `return` comes back. `from` another
  /// return: to where `now` is (Here), though the hand went from somewhere else before. As Go.
  std::string GoToPlace(std::size_t source, std::string what, const LoopSnapshot& now,
                        bool from = false);
  /// Likewise, of where reading begins: nothing to return to.
  std::string Begin(std::size_t source, std::string what);
  /// Where a word about a place means: the place gone to last until the hand has come to it, and
  /// as long as it rests there; none on an empty page. As Go.
  std::optional<LetterPlace> Here(const LoopSnapshot& now);
  /// The letter of a place that a word leads to and whose way has not been told yet; none: there
  /// is none.
  std::optional<std::size_t> Going() const {
    if (!target_ || target_->begins) return std::nullopt;
    return target_->place.source;
  }
  /// Once, as soon as the page under the hand is that of the place.
  std::optional<Arrival> Arrived(const LoopSnapshot& now);

 private:
  struct Target {
    LetterPlace place;
    std::string what;     ///< that it is, in words
    bool begins = false;  ///< where reading begins: no word leads there
  };
  /// A way that was told.
  struct Way {
    LetterPlace to;
    std::size_t page = 0;      ///< of it
    glm::dvec2 tip_P{0, 0};    ///< from where [m]
    glm::dvec2 place_P{0, 0};  ///< [m]
    bool come = false;         ///< the hand has been there
  };
  std::string Lead(const PlaceCommand& command, std::size_t here, const LoopSnapshot& now);
  std::string GoTo(Target target);
  std::string Find(const std::string& wanted, std::size_t here);
  std::string FindNext();
  std::string Return();
  std::string NextRow(bool heading, const LoopSnapshot& now);
  LetterPlace StartOf(const LoopSnapshot& now) const;
  std::string NextParagraph(const LoopSnapshot& now);
  std::string NextLink(const LoopSnapshot& now);
  std::string GoToPage(const std::string& number);
  void ForgetOtherText();

  const LoopSession& session_;
  Turn turn_;
  std::string text_;    ///< that all below is of
  std::string wanted_;  ///< as it was typed
  std::vector<std::size_t> found_;
  std::size_t at_ = 0;               ///< of `found_`
  std::vector<LetterPlace> before_;  ///< where the hand was before it went anywhere, newest last
  bool returned_ = false;            ///< back there, and nowhere since
  std::optional<Target> target_;     ///< not yet told
  std::optional<Way> way_;           ///< told last
};

/// Along the straight way to a place, for a hand that can be led: 40 mm a second. `width` [m] of
/// the groove.
std::shared_ptr<const GuidancePath> PathTo(const PlaceWalk::Arrival& arrival, double width);

}  // namespace moontrace
