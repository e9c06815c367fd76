#include "sim/book/book_tutor.h"

#include <gtest/gtest.h>

#include "sim/tutor/tutor_messages.h"
#include "tests/sim/book_fixture.h"
#include "tests/sim/tutor_fixture.h"

namespace moontrace {
namespace {

class BookDeskTest : public BookWalkTest, protected TutorRuntime {
 protected:
  void Begin() {
    Open(kTides);
    if (IsSkipped()) return;
    desk_.emplace("owl", "Tides", *walk_);
    tutor_.emplace(folder() + "/tutor-owl.sock");
    EXPECT_EQ(tutor_->Line(), "owl reads \"Tides\". Say where for the place, ? for the words.");
    now_ = At(Byte("draws"));
    EXPECT_EQ(Next()->said, say::TutorCame(1));
  }
  /// What the desk gives the session next.
  std::optional<Elsewhere::Line> Next() {
    std::optional<Elsewhere::Line> line;
    Eventually([&] { return (line = desk_->Next(now_)).has_value(); });
    return line;
  }
  std::optional<Elsewhere::Line> Say(const std::string& line) {
    tutor_->Send(line + "\n");
    return Next();
  }
  /// What the tutor alone is told of a line.
  std::string Answer(const std::string& line) {
    tutor_->Send(line + "\nsay end\n");
    EXPECT_EQ(Next()->said, "Tutor says: end");
    return tutor_->Line();
  }

  std::optional<BookDesk> desk_;
  std::optional<RawTutor> tutor_;
  LoopSnapshot now_;
};

TEST_F(BookDeskTest, FollowsTheReadersLineAndHearsWhatIsSaid) {
  Begin();
  if (IsSkipped()) return;
  std::string line = tutor_->Line();
  EXPECT_EQ(line.rfind("Page ", 0), 0U) << line;
  EXPECT_NE(line.find("draws"), std::string::npos) << line;
  now_ = At(Byte("ebbs"));
  desk_->Next(now_);
  line = tutor_->Line();
  EXPECT_NE(line.find("ebbs"), std::string::npos) << line;
  desk_->Told("Page 2 of 3.");
  EXPECT_EQ(tutor_->Line(), "Page 2 of 3.");
  now_.depth = -1e-3;  // in the air nothing is read
  EXPECT_EQ(Answer("where").rfind("owl: ", 0), 0U);
}

TEST_F(BookDeskTest, MovesTheReaderByTheReadersWordsAndNotByALessons) {
  Begin();
  if (IsSkipped()) return;
  tutor_->Line();  // where the hand is
  for (const char* word : {"next", "find sun", "size 20 mm", "go to 2", "contents 3", "back"}) {
    const auto line = Say(word);
    ASSERT_TRUE(line) << word;
    EXPECT_EQ(line->word, word);
    EXPECT_EQ(line->said.rfind("Tutor: ", 0), 0U) << line->said;
  }
  EXPECT_EQ(Answer("skip"), say::NotInBook("skip"));
  EXPECT_EQ(Answer("who"), "Learner: owl; 1 tutor here.");
  EXPECT_EQ(Answer("my text"), say::PassageWanted());
  const std::string words = Answer("nonsense");
  EXPECT_NE(words.find("nonsense"), std::string::npos) << words;
}

TEST_F(BookDeskTest, SendsAPassageUnderTheHandWhichAWordTakesAway) {
  Begin();
  if (IsSkipped()) return;
  const auto line = Say("my text Well read, owl");
  ASSERT_TRUE(line);
  EXPECT_EQ(line->said, say::PassageComes());
  EXPECT_TRUE(line->lies);
  EXPECT_EQ(session_->text().text, "Well read, owl");
  EXPECT_TRUE(walk_->ClearPage());
  EXPECT_EQ(session_->text().text, text_.text);
}

TEST_F(BookDeskTest, NeverUndoesTheReadersOwnStop) {
  Begin();
  if (IsSkipped()) return;
  tutor_->Line();
  EXPECT_EQ(Answer("go"), say::NothingRestsHere());
  now_.stopped = true;
  EXPECT_EQ(Answer("go"), say::LearnerStopped());
  now_.stopped = false;
  EXPECT_EQ(Say("stop")->word, "stop");
  desk_->Next(now_);  // it has not stopped yet
  now_.stopped = true;
  EXPECT_EQ(Say("go")->word, "go");
  now_.stopped = false;
  Say("pause");
  now_.stopped = true;
  desk_->Typed("stop");  // the reader, too
  EXPECT_EQ(Answer("go"), say::LearnerStopped());
}

}  // namespace
}  // namespace moontrace
