#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lessons/documents/document_places.h"
#include "sim/book/book_memory.h"
#include "sim/book/laid_lines.h"
#include "sim/session/loop_drive.h"

namespace moontrace {

/// A document as it is read: what it holds, and its text. Both outlive what uses it.
struct Book {
  const Document& document;
  const Transcription& text;
  std::string title;
};

struct BookOptions {
  bool turns = false;  ///< the page is turned as the tip reaches its mark, see turn_mark.h
  /// For a hand that knows letters only: the page is turned once the tip leaves its last letter,
  /// and all ends behind the last page.
  bool alone = false;
  /// Answers are laid under the hand, and two presses give a menu of words: for who cannot hear.
  bool moon = false;
  bool known = false;  ///< words that are left out are said, as the hand comes to their marks
  std::vector<std::string> news = {};  ///< with `moon` laid under the hand at first
};

/// Leads through a book in a session: its words, where one is, what is kept.
class BookWalk : public Companion {
 public:
  /// All must outlive this.
  BookWalk(LoopSession& session, const Book& book, BookMemory& memory, const BookOptions& options);

  WordPlace words() const override { return WordPlace::kBook; }
  std::vector<std::string> Begin(PlaceWalk& walk) override;
  std::optional<std::vector<std::string>> Obey(std::string_view line,
                                               const LoopSnapshot& now) override;
  void Arrived(std::size_t source) override;
  std::string Marked(const LetterPlace& place) override;
  Press Pressed(bool twice, const LoopEvent& event) override;
  bool Answered(const std::vector<std::string>& lines, const LoopSnapshot& now) override;
  bool ClearPage() override;
  std::vector<std::string> Look(const LoopSnapshot& now) override;
  bool urgent() const override { return urgent_; }
  bool trembles() const override { return trembles_; }
  bool ended() const override { return ended_; }

  /// The line at the tip with its page and number, for who follows from elsewhere; empty: the page
  /// is not touched, or something else lies there.
  std::string LineHere(const LoopSnapshot& now) const;
  /// As the word `where`.
  std::vector<std::string> WhereIs(const LoopSnapshot& now) const { return Where(now); }
  /// Lays a passage that somebody sent under the hand, until a press or a word takes it away.
  /// False: the script cannot write it.
  bool LayPassage(const std::string& text, const LoopSnapshot& now) {
    return laid_.Lay({{text, ""}}, now.tip_P);
  }

  /// Behind the session: keeps the place, and says where it is; of a failure what was not told yet.
  std::vector<std::string> End();
  /// End could not keep it.
  bool lost() const { return lost_; }

 private:
  using Lines = std::vector<std::string>;
  void BeginInMoon();
  std::string PlaceInWords(std::size_t letter) const;
  std::optional<std::size_t> Here(const LoopSnapshot& now);
  Lines Where(const LoopSnapshot& now) const;
  Lines Contents(const std::string& number, const LoopSnapshot& now);
  Lines ListContents();
  Lines GoTo(const std::string& where, const LoopSnapshot& now);
  Lines Follow(const LoopSnapshot& now);
  Lines Bookmarks();
  std::optional<Lines> ToPrintPage(std::string_view line, const LoopSnapshot& now);
  std::string ToMark(const std::string& name, const LoopSnapshot& now);
  std::string ForgetMark(const std::string& name);
  std::string SetMark(std::size_t letter, const std::string& name);
  std::string ToBlock(std::size_t block, std::string what, const LoopSnapshot& now, bool note);
  std::string FindWord(const std::string& word, const LoopSnapshot& now);
  std::string Led(std::string refusal);
  std::string KeepNow();
  std::string Keep();
  std::string TakePassage(const std::string& given, const LoopSnapshot& now);
  void See(const LoopSnapshot& now);
  std::string Unset(const LoopSnapshot& now);
  bool BehindEnd(const LoopSnapshot& now);
  bool OnTurnMark(const LoopSnapshot& now);
  Lines TurnPage(const LoopSnapshot& now);

  LoopSession& session_;
  const Book& book_;
  BookMemory& memory_;
  BookOptions options_;
  PlaceWalk* walk_ = nullptr;

  std::size_t letter_ = 0;     ///< where one is: the letter that was touched last
  bool coming_ = false;        ///< the hand has not yet come to where reading goes on
  std::size_t strays_ = 0;     ///< looks at which it touched something else meanwhile
  bool last_touched_ = false;  ///< the last letter of the page
  /// The page that was touched beside its turn mark: LoopSnapshot::page.
  std::optional<std::uint32_t> beside_mark_;
  std::optional<std::pair<std::size_t, std::size_t>> word_;  ///< touched last: page and number
  std::optional<std::size_t> kept_;
  std::size_t kept_page_ = 0;
  LaidLines laid_;  ///< in place of the book
  struct Opening {
    std::vector<LaidLines::Line> lines;  ///< not laid yet
    glm::dvec2 at_P{0, 0};               ///< where reading begins [m]
  };
  Opening opening_;
  std::vector<LaidLines::Line> offer_;  ///< what can be chosen of what was answered last
  bool was_stopped_ = false, ended_ = false, told_failure_ = false, lost_ = false;
  bool urgent_ = false;        ///< what Look said last: not kept, or the end
  bool trembles_ = false;      ///< since the last Look
  bool turned_lines_ = false;  ///< since then, of what lies in place of the book
  std::chrono::steady_clock::time_point kept_at_{};
};

}  // namespace moontrace
