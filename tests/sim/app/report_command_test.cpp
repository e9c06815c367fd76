#include <pugixml.hpp>

#include "lessons/records/database.h"
#include "lessons/records/learner_history.h"
#include "lessons/records/records.h"
#include "tests/sim/cli_fixture.h"

namespace moontrace {
namespace {

constexpr std::int64_t kNoon = 1'699'963'200;  // of 2023-11-14, UTC
constexpr std::int64_t kDay = 86'400;

class ReportCommand : public CliTest {
 protected:
  void SetUp() override {
    if (!Records::Available()) GTEST_SKIP() << "built without SQLite";
    setenv("TZ", "UTC", 1);
    std::filesystem::create_directories(In("small"));
    WriteAll(In("small/course.toml"),
             "title = \"Small & <quick>\"\nlanguage = \"en\"\nscript = \"moon\"\n"
             "sizes_mm = [20, 10]\nlessons = [\"one\"]\n");
    WriteAll(In("small/one.toml"),
             "title = \"One\"\nnew = [\"n\", \"u\", \"l\"]\n[[steps]]\nkind = \"trace\"\n"
             "[[steps]]\nkind = \"recognise\"\n");
    Add("bat", false);
    Add("robot", true);
  }

  /// 30 answers on three days, every fifth n taken for u; six traces, half of them guided. In one
  /// transaction, as imported.
  void Add(const std::string& name, bool simulated) {
    LearnerHistory history;
    history.learner.pseudonym = name;
    history.learner.simulated = simulated;
    Trial trial;
    trial.lesson = "one";
    trial.simulated = simulated;
    trial.size = 0.02;
    for (int i = 0; i < 30; ++i) {
      trial.step = 1;
      trial.kind = StepKind::kRecognise;
      trial.time = kNoon + i / 10 * kDay + i;
      trial.item = i % 2 == 0 ? "l" : "n";
      trial.answer = i % 10 == 5 ? "u" : trial.item;
      trial.right = trial.answer == trial.item;
      trial.latency = 2;
      history.trials.push_back({"small", trial, {}});
      if (i % 5 != 0) continue;
      Trial trace = trial;
      trace.step = 0;
      trace.kind = StepKind::kTrace;
      trace.answer = "";
      trace.coverage = i < 15 ? 0.75 : 1;
      trace.duration = 4;
      trace.error_widths = 0.25;
      trace.help = i < 15 ? 0 : 5;
      trace.guidance = i < 15 ? GuidanceMode::kOff : GuidanceMode::kRail;
      history.trials.push_back({"small", trace, {}});
    }
    Records::Open(path_).Import(history, "test");
  }

  Outcome Report(const std::vector<std::string>& args) const {
    return RunLine(With(With({"report"}, args), {"--records", path_, "--course", In("small")}));
  }

  std::int64_t Count(const std::string& where) const {
    return Database(path_, false)
        .Number(
            "SELECT count(*) FROM trial JOIN learner ON learner.id = trial.learner "
            "WHERE pseudonym = 'bat' AND " +
            where);
  }

  const std::string path_ = In("records.sqlite");
};

// A joystick renders 13.4 mm (SmallestLetter): its lessons end at 20 of 20 and 10 mm, and so are
// judged by that.
TEST_F(ReportCommand, JudgesByTheSmallestSizeOfTheNewestDeviceThatIsFelt) {
  const auto worked_with = [this](std::int64_t time, const char* device) {
    Records::Open(path_).AddEvent("bat", {time, "device", device});
    return Report({"bat"}).out;
  };
  const auto holds = [](const std::string& out, const char* words) {
    return out.find(words) != std::string::npos;
  };
  EXPECT_TRUE(holds(worked_with(kNoon, "openffboard-2"), "20 mm, the smallest size."));
  EXPECT_TRUE(holds(worked_with(kNoon + 1, "mouse"), "20 mm, the smallest size."));
  EXPECT_TRUE(holds(worked_with(kNoon + 2, "moontrace-raw"), "10 mm, the smallest size."));
}

TEST_F(ReportCommand, TellsAllInPlainLines) {
  const Outcome outcome = Report({"bat"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "bat is at lesson 1, One, step 2 of 2: 0 of 1 lesson done, 0 of 3 signs sure at\n"
            "10 mm, the smallest size.\n"
            "Next: go on with lesson 1, One, and practise l and n.\n"
            "Hard: l, traced well 0 of the last 2; n taken for u, 3 times.\n"
            "Still to come: u.\n"
            "n: not yet sure, now at 20 mm, 8 of the last 10 right, last seen 2023-11-16.\n"
            "l: not yet sure, now at 20 mm, 10 of the last 10 right, last seen 2023-11-16.\n"
            "Practise l: traced well 0 of the last 2; now at 20 mm.\n"
            "Practise n: named right 8 of the last 10, traced well 0 of the last 1, taken for\n"
            "u, 3 times; now at 20 mm.\n"
            "Signs named right without help, by day: 90 percent from 2023-11-14 to\n"
            "2023-11-16.\n"
            "Letters named right in a second, without help, by day: 0.5 letters from\n"
            "2023-11-14 to 2023-11-16.\n"
            "Smallest letters named right without help, by day: 20 mm from 2023-11-14 to\n"
            "2023-11-16.\n"
            "Signs named: 27 of 30 right, 90 percent.\n"
            "Confused: n taken for u, 3 times.\n"
            "Letters per second: 0.5, named right without help.\n"
            "Traced without help: 0.25 letters per second, 75 percent covered, mean error\n"
            "0.25 groove widths.\n"
            "Smallest size at which a sign is sure: none yet; the course begins at 20 mm.\n"
            "Week of 2023-11-13: 33 trials without help, signs 90 percent right, 75 percent\n"
            "covered, 0.5 letters per second, smallest 20 mm; 3 with help.\n"
            "2023-11-14: 12 trials without help, signs 90 percent right, 75 percent covered,\n"
            "0.5 letters per second, smallest 20 mm.\n"
            "2023-11-15: 11 trials without help, signs 90 percent right, 75 percent covered,\n"
            "0.5 letters per second, smallest 20 mm; 1 with help.\n"
            "2023-11-16: 10 trials without help, signs 90 percent right, 0.5 letters per\n"
            "second, smallest 20 mm; 2 with help.\n"
            "Without help: 33 trials, signs 90 percent right, 75 percent covered.\n"
            "With help: 3 trials, 100 percent covered; none of them counts above.\n"
            "Conditions: Small & <quick>, 20 mm to 10 mm, 36 trials on 3 days.\n"
            "Sure means, without help and at true size: 80 percent of the last 5 named right;\n"
            "at the largest size also traces 90 percent covered, with a mean error of at most\n"
            "0.5 groove widths.\n");
  ExpectTextFace(outcome.out);
}

TEST_F(ReportCommand, SaysOfASimulatedLearnerThatItIsOne) {
  const std::string words =
      "A simulated learner: this shows that the program works, not how people learn.";
  EXPECT_EQ(Lines(Report({"robot"}).out).at(4), words);  // behind three sentences
  EXPECT_EQ(Report({"bat"}).out.find("simulated"), std::string::npos);
  Report({"robot", "--html", In("r.html")});
  EXPECT_NE(ReadAll(In("r.html")).find(words), std::string::npos);
  EXPECT_EQ(Report({"robot", "--json"}).Json()["simulated"], true);
  EXPECT_EQ(Report({"bat", "--json"}).Json()["simulated"], false);
}

// What the database counts by its own language.
TEST_F(ReportCommand, GivesTheNumbersOfTheDatabase) {
  const auto json = Report({"bat", "--json"}).Json();
  const std::string alone = "help = 0 AND scaled = 0 AND item <> ''";
  const std::string named = alone + " AND kind = 'recognise'";
  EXPECT_EQ(json["unguided"]["trials"], Count(alone));
  EXPECT_EQ(json["guided"]["trials"], Count("help > 0"));
  EXPECT_EQ(json["unguided"]["answers"], Count(named));
  EXPECT_EQ(json["unguided"]["named_right"], Count(named + " AND right_answer = 1"));
  EXPECT_EQ(json["unguided"]["traces"], Count(alone + " AND kind = 'trace'"));
  EXPECT_EQ(json["confusions"][0]["times"], Count(named + " AND item = 'n' AND answer = 'u'"));
  for (std::size_t day = 0; day < 3; ++day) {
    const std::string on = " AND date(time_unix_s, 'unixepoch') = '" +
                           json["days"][day]["day"].get<std::string>() + "'";
    EXPECT_EQ(json["days"][day]["unguided"]["trials"], Count(alone + on));
    EXPECT_EQ(json["days"][day]["guided"]["trials"], Count("help > 0" + on));
  }
  EXPECT_EQ(json["days"].size(), 3U);
}

TEST_F(ReportCommand, WritesATableWithARowForEachTrial) {
  const Outcome outcome = Report({"bat", "--csv", In("bat.csv")});
  EXPECT_NE(outcome.out.find("Report in:\n" + In("bat.csv") + "\n"), std::string::npos);
  const std::vector<std::string> lines = Lines(ReadAll(In("bat.csv")));
  EXPECT_EQ(lines.size(), 1U + static_cast<std::size_t>(Count("item <> ''")));
  EXPECT_EQ(lines[0].find("learner,course,time_unix_s,"), 0U);
  EXPECT_EQ(lines[1].find("bat,small,1699963200,one,1,recognise,l,0.02,off,0,"), 0U) << lines[1];
}

/// The text of an element and of all within it.
std::string TextOf(const pugi::xml_node& node) {
  std::string text = node.value();
  for (const pugi::xml_node& child : node.children()) text += TextOf(child);
  return text;
}

class ReportPageTest : public ReportCommand {
 protected:
  void SetUp() override {
    ReportCommand::SetUp();
    if (IsSkipped()) return;
    ASSERT_EQ(Report({"bat", "--html", In("bat.html")}).code, 0);
    const pugi::xml_parse_result read = page_.load_file(In("bat.html").c_str());
    ASSERT_TRUE(read) << read.description();
  }
  pugi::xml_document page_;
};

TEST_F(ReportPageTest, HasALanguageATitleAndHeadingsInOrder) {
  const pugi::xml_node html = page_.child("html");
  EXPECT_STREQ(html.attribute("lang").value(), "en");
  EXPECT_EQ(TextOf(html.child("head").child("title")), "bat, Small & <quick>");
  EXPECT_EQ(page_.select_nodes("//h1").size(), 1U);
  EXPECT_EQ(page_.select_nodes("//h3|//h4|//h5|//h6|//img|//script|//link").size(), 0U);
  std::vector<std::string> headings;
  for (const auto& heading : page_.select_nodes("//h2")) headings.push_back(TextOf(heading.node()));
  EXPECT_EQ(headings, (std::vector<std::string>{
                          "Signs", "What to practise", "Signs named right without help, by day",
                          "Letters named right in a second, without help, by day",
                          "Smallest letters named right without help, by day",
                          "Answers without help", "What is confused with what",
                          "All answers to single signs", "Speed and size", "Progress over weeks",
                          "Progress over days", "Without and with help", "Conditions"}));
}

TEST_F(ReportPageTest, TellsEveryPlotInWordsBesideIt) {
  const auto plots = page_.select_nodes("//svg");
  ASSERT_EQ(plots.size(), 3U);
  for (const auto& plot : plots) {
    const pugi::xml_node svg = plot.node();
    EXPECT_STREQ(svg.attribute("role").value(), "img");
    const std::string title = svg.child("title").attribute("id").value();
    const std::string words = svg.child("desc").attribute("id").value();
    EXPECT_EQ(svg.attribute("aria-labelledby").value(), title + " " + words);
    EXPECT_EQ(TextOf(svg.child("title")), TextOf(svg.parent().child("h2")));
    EXPECT_EQ(TextOf(svg.child("desc")), TextOf(svg.parent().child("p")));
  }
  EXPECT_EQ(TextOf(plots[0].node().child("desc")), "90 percent from 2023-11-14 to 2023-11-16.");
  EXPECT_EQ(plots[0].node().select_nodes(".//circle").size(), 3U);
}

TEST_F(ReportPageTest, HoldsAllAnswersAsATable) {
  const auto texts = [this](const char* path) {
    std::vector<std::string> all;
    for (const auto& found : page_.select_nodes(path)) all.push_back(TextOf(found.node()));
    return all;
  };
  using Texts = std::vector<std::string>;
  EXPECT_EQ(texts("//details//thead/tr"), Texts({"Shownlnu"}));
  EXPECT_EQ(texts("//details//tbody/tr"), Texts({"l1500", "n0123"}));
  // What lines tell one after the other stands in tables too.
  EXPECT_EQ(texts("//section[h2='Signs']//tbody/tr/th"), Texts({"n", "l"}));
  EXPECT_EQ(texts("//section[h2='Progress over days']//tbody/tr/th"),
            Texts({"2023-11-14", "2023-11-15", "2023-11-16"}));
  EXPECT_EQ(texts("//section[h2='Progress over weeks']//tbody/tr/th"), Texts({"2023-11-13"}));
  const auto tables = page_.select_nodes("//table");
  for (const auto& table : tables) EXPECT_NE(TextOf(table.node().child("caption")), "");
  EXPECT_EQ(tables.size(), 4U);
}

// Who prints the page gets what the lines say: all but what lies behind.
TEST_F(ReportPageTest, TellsWhatThePlainLinesTell) {
  std::string page = TextOf(page_.child("html").child("body"));
  const std::vector<std::string> lines = Lines(Report({"bat"}).out);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NE(page.find(lines[i].substr(0, 60)), std::string::npos) << lines[i];
  }
  EXPECT_NE(ReadAll(In("bat.html")).find("@media print"), std::string::npos);
  EXPECT_EQ(page_.select_nodes("//section[@class='behind']").size(), 1U);
}

TEST_F(ReportCommand, KeepsForeignTextFromBeingMarkup) {
  Trial trial;
  trial.time = kNoon;
  trial.lesson = "one";
  trial.step = 1;
  trial.kind = StepKind::kRecognise;
  trial.item = "n";
  trial.answer = "<script>alert('&')</script>\x1b\"";
  Records::Open(path_).Add("bat", "small", trial);
  Report({"bat", "--html", In("bat.html")});
  const std::string html = ReadAll(In("bat.html"));
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(html.find('\x1b'), std::string::npos);
  EXPECT_NE(html.find("&lt;script&gt;alert('&amp;')&lt;/script&gt;?&quot;"), std::string::npos);
  EXPECT_TRUE(pugi::xml_document().load_string(html.c_str()));
}

TEST_F(ReportCommand, TakesItsLearnerAsLearnDoes) {
  const Outcome usual = Report({"bat"});
  const Outcome named = Report({"--learner", "bat"});
  EXPECT_EQ(named.code, 0) << named.err;
  EXPECT_EQ(named.out, usual.out);
}

TEST_F(ReportCommand, NeedsNoNameWhereThereIsOneLearner) {
  const Outcome alone = Report({});
  EXPECT_EQ(alone.code, 0) << alone.err;
  EXPECT_EQ(alone.out, Report({"bat"}).out);
}

TEST_F(ReportCommand, RefusesWhatIsNoUse) {
  const auto refused = [](const Outcome& outcome, int code, const std::string& words) {
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(Lines(outcome.err).size(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  };
  refused(RunLine({"report", "--records", In("none")}), 2, "report lacks a learner");
  refused(Report({"bat", "--learner", "owl"}), 2, "two learners");
  refused(Report({"bat", "--html", "a", "--csv", "b"}), 2, "ask for one at a time");
  refused(Report({"bit"}), 3, "did you mean bat?");
  refused(RunLine({"report", "bat", "--records", path_, "--course", "learn-moon"}), 3,
          "bat has no trials of learn-moon");
  refused(RunLine({"report", "bat", "--records", path_}), 3, "name its folder by --course");
  refused(RunLine({"report", "bat", "--records", In("none")}), 3, "no records there yet");
  refused(Report({"bat", "--html", In("no/such/f")}), 4, "No such file");
  LearnerEntry owl;
  owl.pseudonym = "owl";
  Records::Open(path_).AddLearner(owl);
  refused(RunLine({"report", "owl", "--records", path_}), 3, "owl has no trials yet");
}

// Before, the course was loaded without it: what was asked was no item, and the report left it out.
TEST_F(ReportCommand, KnowsTheLearnersOwnNameAsAWord) {
  Trial trial;
  trial.time = kNoon + 90 * kDay;
  trial.lesson = "05-r-u";
  trial.kind = StepKind::kRecognise;
  trial.item = "Rosa";
  trial.size = 0.025;
  trial.answer = "Rosa";
  trial.right = true;
  LearnerEntry rosa;
  rosa.pseudonym = "Rosa";
  Records records = Records::Open(path_);
  records.AddLearner(rosa);
  records.Add("Rosa", "learn-moon", trial);
  const auto met = RunLine({"report", "Rosa", "--records", path_, "--json"}).Json()["met"];
  ASSERT_EQ(met.size(), 1U);
  EXPECT_EQ(met[0]["item"], "Rosa");
  EXPECT_EQ(met[0]["last_right"], 1);
}

TEST_F(ReportCommand, TakesTheCourseLastLearnt) {
  Trial trial;
  trial.time = kNoon + 90 * kDay;
  trial.lesson = "04-e-s";
  trial.item = "i";
  Records::Open(path_).Add("bat", "learn-moon", trial);
  const Outcome outcome = RunLine({"report", "bat", "--records", path_, "--json"});
  EXPECT_EQ(outcome.Json()["course"], "learn-moon");
}

}  // namespace
}  // namespace moontrace
