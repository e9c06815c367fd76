#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/book/laid_lines.h"
#include "sim/console/console.h"
#include "sim/console/line_reader.h"
#include "sim/session/loop_drive.h"
#include "sim/session/session_request.h"

/// What lies under the hand before a book is open, or where none could be opened: for who can
/// neither see nor hear.
namespace moontrace {

/// A question and its answers, a line each, that lie under the hand until one is taken; without
/// answers any press or word will do.
class MoonLines : public Companion {
 public:
  /// `session` lets these lines be felt, and outlives this.
  MoonLines(LoopSession& session, std::string question, std::vector<std::string> answers)
      : session_(session), question_(std::move(question)), answers_(std::move(answers)) {}

  WordPlace words() const override { return WordPlace::kBook; }
  std::vector<std::string> Begin(PlaceWalk& /*walk*/) override { return {}; }
  std::optional<std::vector<std::string>> Obey(std::string_view line,
                                               const LoopSnapshot& now) override;
  void Arrived(std::size_t /*source*/) override {}
  std::string Marked(const LetterPlace& /*place*/) override { return {}; }
  Press Pressed(bool twice, const LoopEvent& event) override;
  bool Answered(const std::vector<std::string>& /*lines*/, const LoopSnapshot& /*now*/) override {
    return true;
  }
  bool ClearPage() override { return false; }
  std::vector<std::string> Look(const LoopSnapshot& now) override;
  bool urgent() const override { return urgent_; }
  bool trembles() const override { return false; }
  bool ended() const override { return ended_; }

  const std::optional<std::string>& taken() const { return taken_; }

 private:
  bool Take(const std::string& line);
  std::vector<std::string> Asked() const;

  LoopSession& session_;
  FeltLine line_;
  std::string question_;
  std::vector<std::string> answers_;
  std::optional<std::string> taken_;
  bool told_ = false, touched_ = false, urgent_ = false, stopped_ = false, ended_ = false;
};

/// Lays a question and what may be answered on a device, a line each, with a tremble. A press on an
/// answer, or its words typed, takes it; a press beside the lines leads on to the next page. None:
/// whoever was asked has left. `like`: device, style and layout; its text does not matter.
/// Throws InputError, LackError: nothing could be laid; Interrupted.
std::optional<std::string> ChooseByTouch(const SessionRequest& like, const std::string& question,
                                         const std::vector<std::string>& answers, LineReader& typed,
                                         Console& console);

/// Lays a sentence on a device, with a tremble, until a press or a word takes it away. Throws
/// likewise.
void TellByTouch(const SessionRequest& like, const std::string& sentence, LineReader& typed,
                 Console& console);

}  // namespace moontrace
