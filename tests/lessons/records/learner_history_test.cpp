#include "lessons/records/learner_history.h"

#include <cmath>

#include "lessons/records/trial_fields.h"
#include "tests/lessons/records_fixture.h"

namespace moontrace {
namespace {

LearnerHistory SomeHistory() {
  LearnerHistory history;
  history.learner = {"Fledermaus \"7\"", 1'700'000'000, true, "2", false};
  history.trials = {{"learn-moon", NumberedTrial(0), {}},
                    {"own", NumberedTrial(1), {1.0 / 3, -0.0, 5e-324, 1.7e308}}};
  history.events = {{1'700'000'001, "tutor", "say: gut gemacht, <b>Ana</b>"}};
  return history;
}

std::string Refused(const std::string& text) {
  return RefusalOf<InputError>([&] { HistoryFromJson(text, "f.json"); });
}

/// The export with one piece of it replaced.
std::string With(const std::string& piece, const std::string& other) {
  std::string text = HistoryToJson(SomeHistory());
  const std::size_t at = text.find(piece);
  EXPECT_NE(at, std::string::npos) << piece;
  return text.replace(at, piece.size(), other);
}

TEST(LearnerExport, ComesBackEqualToTheBit) {
  const LearnerHistory history = SomeHistory();
  const LearnerHistory again = HistoryFromJson(HistoryToJson(history), "f.json");
  EXPECT_EQ(again.learner.pseudonym, history.learner.pseudonym);
  EXPECT_EQ(again.learner.since, history.learner.since);
  EXPECT_EQ(again.learner.keeps_tracks, history.learner.keeps_tracks);
  EXPECT_EQ(again.learner.consent, history.learner.consent);
  EXPECT_EQ(again.learner.simulated, history.learner.simulated);
  ASSERT_EQ(again.trials.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(again.trials[i].course, history.trials[i].course);
    EXPECT_EQ(again.trials[i].track, history.trials[i].track);
    for (const TrialField& field : TrialFields()) {
      EXPECT_EQ(field.get(again.trials[i].trial), field.get(history.trials[i].trial)) << field.name;
    }
  }
  EXPECT_TRUE(std::signbit(again.trials[1].track[1]));
  ASSERT_EQ(again.events.size(), 1U);
  EXPECT_EQ(again.events[0].time, history.events[0].time);
  EXPECT_EQ(again.events[0].kind, history.events[0].kind);
  EXPECT_EQ(again.events[0].text, history.events[0].text);
}

TEST(LearnerExport, SaysWhatItIsAndNamesUnits) {
  const std::string text = HistoryToJson(SomeHistory());
  EXPECT_EQ(text.find("{\"format\":\"moontrace-learner\",\"version\":1,"), 0U) << text;
  for (const char* piece :
       {"\"size_m\":0.012", "\"kind\":\"recognise\"", "\"guidance\":\"bead\"", "\"probe\":true",
        "\"mean_force_N\":0.3", "\"item\":\"j\\nn\"", "\"answer\":\"nü\\\"\""}) {
    EXPECT_NE(text.find(piece), std::string::npos) << piece;
  }
}

TEST(LearnerExport, IsRefusedWithPlaceAndCureWhereItIsBroken) {
  const std::string cure = "; use an unaltered export";
  EXPECT_EQ(Refused("{\n  x"), "f.json:2:3: not JSON" + cure);
  EXPECT_EQ(Refused(""), "f.json:1:1: not JSON" + cure);
  EXPECT_EQ(Refused("[]"), "f.json: not an export of a learner; make one by records export");
  EXPECT_EQ(Refused(With("\"version\":1", "\"version\":2")),
            "f.json: of another version than 1; update this program");
  EXPECT_EQ(Refused(With("\"item\"", "\"itme\"")), "f.json: trial 1: \"item\" is missing" + cure);
  EXPECT_EQ(Refused(With("\"step\":2", "\"step\":2,\"setp\":2")),
            "f.json: trial 1: \"setp\" is unknown, did you mean \"step\"?" + cure);
  EXPECT_EQ(Refused(With("\"step\":2", "\"step\":-2")),
            "f.json: trial 1: \"step\" cannot be -2" + cure);
  EXPECT_EQ(Refused(With("\"step\":2", "\"step\":2.5")),
            "f.json: trial 1: \"step\" is not a whole number" + cure);
  EXPECT_EQ(Refused(With("\"step\":2", "\"step\":18446744073709551615")),
            "f.json: trial 1: \"step\" is too large" + cure);
  EXPECT_EQ(Refused(With("\"recognise\"", "\"dream\"")),
            "f.json: trial 1: \"kind\" cannot be \"dream\"" + cure);
  EXPECT_EQ(Refused(With("\"probe\":true", "\"probe\":1")),
            "f.json: trial 1: \"probe\" is not true or false" + cure);
  EXPECT_EQ(Refused(With("12.7", "1e999")), "f.json: a number is out of range" + cure);
  EXPECT_EQ(Refused(With("[0.333", "[null,0.333")),
            "f.json: trial 2: \"track\" holds what is not a number" + cure);
  EXPECT_NE(Refused(With("Fledermaus", "Fleder/maus")).find("f.json: learner: learner \"Fleder/"),
            std::string::npos);
  EXPECT_EQ(Refused(With("\"events\"", "\"evens\"")), "f.json: \"events\" is missing" + cure);
}

TEST(LearnerExport, IsBoundedInDepthAndLength) {
  EXPECT_EQ(Refused(std::string(1'000'000, '[')),
            "f.json: nested more than 5 deep; use an unaltered export");
  EXPECT_EQ(Refused(With("gut gemacht", std::string(20'000, 'a'))),
            "f.json: event 1: \"text\" is longer than 10000 bytes; use an unaltered export");
  // a list of objects is read in time that grows with its length only
  std::string objects = "[{}";
  for (int i = 0; i < 500'000; ++i) objects += ",{}";
  EXPECT_EQ(Refused(objects + "]"),
            "f.json: not an export of a learner; make one by records export");
  // an object of very many members is refused in time that grows with its length only
  std::string many = "{\"format\":\"moontrace-learner\",\"version\":1";
  for (int i = 0; i < 100'000; ++i) many += ",\"" + std::to_string(i) + "\":0";
  EXPECT_EQ(Refused(many + "}"), "f.json: \"learner\" is missing; use an unaltered export");
}

TEST(ResearchExport, HoldsNoNameDateWordOrTrack) {
  const std::string text = ResearchJson(SomeHistory());
  EXPECT_EQ(text.find("{\"format\":\"moontrace-research\",\"version\":1,"), 0U) << text;
  for (const char* piece : {"Fledermaus", "17000000", "gemacht", "1.7e+308", "track\"",
                            "time_unix_s", "n\\u00fc", "nü"}) {
    EXPECT_EQ(text.find(piece), std::string::npos) << piece;
  }
  // what stays: intervals, answers that are items, kinds of events
  EXPECT_NE(text.find("\"time_s\":1,"), std::string::npos);
  EXPECT_NE(text.find("\"answer\":\"other\""), std::string::npos);
  EXPECT_NE(text.find("{\"time_s\":1,\"kind\":\"tutor\"}"), std::string::npos);
}

// So that nobody takes a program's trials for a person's, whoever they were kept for.
TEST(ResearchExport, SaysAtItsTopWhetherAnythingWasSimulated) {
  const auto says = [](bool learner, bool trial) {
    LearnerHistory history = SomeHistory();
    history.learner.simulated = learner;
    for (RecordedTrial& row : history.trials) row.trial.simulated = false;
    history.trials.back().trial.simulated = trial;
    const std::string text = ResearchJson(history);
    const std::string head = text.substr(0, text.find("\"trials\":"));
    return head.find("\"simulated\":true") != std::string::npos;
  };
  EXPECT_FALSE(says(false, false));
  EXPECT_TRUE(says(false, true));
  EXPECT_TRUE(says(true, false));
}

TEST(ResearchExport, KeepsAnswersThatWereItems) {
  LearnerHistory history = SomeHistory();
  history.trials[0].trial.answer = "n";  // of "j" beside "n"
  history.trials[1].trial.answer = "same";
  const std::string text = ResearchJson(history);
  EXPECT_NE(text.find("\"answer\":\"n\""), std::string::npos);
  EXPECT_NE(text.find("\"answer\":\"same\""), std::string::npos);
}

TEST(ResearchExport, ListsTheFieldsItHolds) {
  const std::string text = ResearchJson(SomeHistory());
  const std::string head = text.substr(0, text.find("\"trials\""));
  EXPECT_NE(head.find("\"trial_fields\":[\"course\",\"time_s\",\"lesson\",\"step\""),
            std::string::npos)
      << head;
  for (const TrialField& field : TrialFields()) {
    if (std::string(field.name) == "time_unix_s") continue;
    EXPECT_NE(head.find("\"" + std::string(field.name) + "\""), std::string::npos) << field.name;
  }
}

TEST(ResearchExport, CannotBeImported) {
  EXPECT_EQ(Refused(ResearchJson(SomeHistory())),
            "f.json: an anonymous export has no learner; import one made without --anonymous");
}

TEST(Pseudonym, IsANameThatCanBeSeen) {
  for (const char* name : {"ann", "J\xC3\xA9r\xC3\xB4me", "\xE6\x9C\x88", "a b"}) {
    EXPECT_NO_THROW(RequirePseudonym(name)) << name;
  }
  for (const char* name : {"", "  ", "a/b", "a\\b", "a\nb", "a\xC2\x9B", "a\xFF", "ann\xE2\x80\xAE",
                           "an\xE2\x80\x8Bn", "\xEE\x80\x80"}) {
    EXPECT_THROW(RequirePseudonym(name), InputError) << name;
  }
}

class RecordsImport : public RecordsTest {};

TEST_F(RecordsImport, GivesRecordsThatExportTheSame) {
  Records records = Records::Open(path_);
  const std::string text = HistoryToJson(SomeHistory());
  records.Import(HistoryFromJson(text, "f.json"), "f.json");
  EXPECT_TRUE(records.Find(SomeHistory().learner.pseudonym));
  EXPECT_EQ(records.Export(SomeHistory().learner.pseudonym), text);
}

TEST_F(RecordsImport, AddsNothingWhereTheLearnerIsThere) {
  Records records = Records::Open(path_);
  records.Import(SomeHistory(), "f.json");
  const std::string line = RefusalOf<InputError>([&] { records.Import(SomeHistory(), "f.json"); });
  EXPECT_NE(line.find("already; erase that one first"), std::string::npos);
  EXPECT_EQ(records.Trials(SomeHistory().learner.pseudonym).size(), 2U);
}

TEST_F(RecordsImport, TakesNoTracksOfWhoHasNotConsented) {
  LearnerHistory history = SomeHistory();
  history.learner.keeps_tracks = false;
  Records records = Records::Open(path_);
  records.Import(history, "f.json");
  EXPECT_EQ(records.Export(history.learner.pseudonym).find("track\""), std::string::npos);
}

}  // namespace
}  // namespace moontrace
