#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/session/loop_session.h"

namespace moontrace {

/// The line of a text, from line end to line end, whose letter is near a place; none: no letter is.
struct TouchedLine {
  std::string text;
  std::size_t number = 0;  ///< from 0
};
/// `p_P` [m].
std::optional<TouchedLine> LineAt(const FeltPage& felt, glm::dvec2 p_P);

/// Which line a hand has felt: it slid along it for some of a letter's height, and for none since.
/// One thread.
class FeltLine {
 public:
  /// At each look. `touching`: the tip is on the paper.
  void See(const FeltPage& felt, glm::dvec2 p_P, bool touching);
  bool Is(std::size_t line) const { return line_ == line && slid_; }

 private:
  std::optional<std::size_t> line_;
  double begin_ = 0;  ///< where the tip came to it [m]
  bool slid_ = false;
};

/// Lines that lie under the hand in place of a text, such as an answer or a menu: who cannot hear
/// turns their pages by presses, and chooses by one. One thread.
class LaidLines {
 public:
  struct Line {
    std::string shown;
    std::string word;  ///< said by a press on the line; empty: it only tells
  };

  /// `session` must outlive this.
  explicit LaidLines(LoopSession& session) : session_(session) {}

  /// The first line comes under the tip. `tip_P`: where the hand is in the text [m], to come back
  /// to; not looked at if lines lie there already. False: the script cannot write them.
  bool Lay(std::vector<Line> lines, glm::dvec2 tip_P);
  bool lies() const { return text_.has_value(); }
  /// The text lies there again; false: it did.
  bool Clear();
  /// The text, whatever lies in its place.
  const TextSetup& text() const { return text_ ? *text_->page.text : session_.text(); }

  struct Press {
    bool turned = false;  ///< another page of the lines
    std::string word;     ///< that was chosen; empty: none
  };
  /// A press on a line with a word chooses it, any other leads on to the next page; behind the
  /// last one, and by two presses, the text comes back. `tip_P` [m]: a tip in the air chooses none.
  Press Pressed(bool twice, glm::dvec3 tip_P);

 private:
  LoopSession& session_;
  std::vector<Line> lines_;
  std::optional<LoopSession::Laid> text_;  ///< that lay there before
  glm::dvec2 tip_P_{0, 0};                 ///< [m]
};

}  // namespace moontrace
