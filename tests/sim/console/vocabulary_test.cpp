#include "sim/console/vocabulary.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

#include "tests/source_path.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

constexpr WordPlace kPlaces[] = {WordPlace::kLesson, WordPlace::kLoop, WordPlace::kTutor,
                                 WordPlace::kDemonstration, WordPlace::kBook};
constexpr const char* kPlaceNames[] = {"lesson", "loop", "tutor", "demonstration", "book"};

std::string NameOf(WordPlace place) { return kPlaceNames[static_cast<std::size_t>(place)]; }

/// Empty: none.
std::string Meaning(std::string_view given, WordPlace place) {
  const WordFound found = FindWord(given, place);
  return found.word != nullptr ? std::string(found.word->word) : std::string();
}

std::string Text(const std::string& path) {
  std::ifstream file(SourcePath(path), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(Vocabulary, AWordMayBePutAsPeopleDo) {
  const auto word = [](const char* line, WordPlace place) {
    const SaidLine said = ReadLine(line, place);
    return said.word == nullptr ? std::string("none") : std::string(said.word->word);
  };
  for (const WordPlace place : {WordPlace::kLesson, WordPlace::kLoop, WordPlace::kDemonstration,
                                WordPlace::kBook, WordPlace::kTutor}) {
    EXPECT_EQ(word("go on", place), "go");
    EXPECT_EQ(word("Carry on", place), "go");
    EXPECT_EQ(word("quit, please", place), "quit");
    EXPECT_EQ(word("next please", place), "next");
    EXPECT_EQ(word("exit", place), "quit");
    EXPECT_EQ(word("Bye", place), "quit");
    EXPECT_EQ(word("wait", place), "pause");
  }
  EXPECT_EQ(word("repeat", WordPlace::kLesson), "again");
  EXPECT_EQ(word("slower", WordPlace::kDemonstration), "more time");
  EXPECT_EQ(word("hint", WordPlace::kDemonstration), "again");
  EXPECT_EQ(word("slower", WordPlace::kLesson), "slower");
  EXPECT_EQ(word("hint", WordPlace::kTutor), "none");
  EXPECT_EQ(word("what?", WordPlace::kLesson), "again");
  EXPECT_EQ(word("what?", WordPlace::kBook), "none");  // which has no again
  const SaidLine say = ReadLine("say go on please", WordPlace::kTutor);
  EXPECT_EQ(say.behind, "go on please");  // a sentence stays as it is
}

TEST(Vocabulary, HasOneNumberForEachWord) {
  std::set<int> numbers;
  std::set<std::string_view> words;
  for (const TypedWord& word : Vocabulary()) {
    EXPECT_TRUE(numbers.insert(word.number).second) << word.number;
    EXPECT_TRUE(words.insert(word.word).second) << word.word;
    EXPECT_FALSE(word.help.empty()) << word.word;
    for (const WordPlace place : kPlaces) {
      const std::string meant = word.HoldsIn(place) ? std::string(word.word) : std::string();
      EXPECT_EQ(Meaning(std::to_string(word.number), place), meant);
      if (word.HoldsIn(place)) {
        EXPECT_EQ(Meaning(word.word, place), meant);
      }
    }
  }
}

TEST(Vocabulary, BeginsWithStopEverywhere) {
  for (const WordPlace place : kPlaces) {
    EXPECT_EQ(Meaning("1", place), "stop");
    for (const char* word : {"stop", "next", "go", "pause", "quit", "help"}) {
      EXPECT_EQ(Meaning(word, place), word) << NameOf(place);
    }
    EXPECT_EQ(Meaning("?", place), "help");
  }
}

TEST(Vocabulary, HasNoBeginningThatMeansTwoWords) {
  for (const TypedWord& word : Vocabulary()) {
    for (std::size_t length = 1; length <= word.word.size(); ++length) {
      const std::string_view given = word.word.substr(0, length);
      std::set<std::string> meanings;
      for (const WordPlace place : kPlaces) {
        const std::string meaning = Meaning(given, place);
        if (!meaning.empty()) meanings.insert(meaning);
      }
      EXPECT_LE(meanings.size(), 1U) << given;
    }
  }
}

/// The words of before there was one vocabulary, those that were looked at first and those that
/// came later; what each unambiguous beginning was short for.
std::map<std::string, std::string> ShortForms(const std::vector<std::vector<std::string>>& tiers) {
  std::map<std::string, std::string> forms;
  std::set<std::string> begun;
  for (const std::vector<std::string>& words : tiers) {
    std::map<std::string, std::vector<std::string>> found;
    for (const std::string& word : words) {
      for (std::size_t length = 1; length <= word.size(); ++length) {
        found[word.substr(0, length)].push_back(word);
      }
    }
    for (const auto& [given, meant] : found) {
      if (begun.insert(given).second && meant.size() == 1) forms[given] = meant[0];
    }
  }
  return forms;
}

TEST(Vocabulary, KeepsShortFormsOrListsThem) {
  const std::map<std::string, std::string> before[] = {
      ShortForms({{"stop", "next", "where", "letter", "spell", "word", "bigger", "smaller",
                   "more help", "less help", "slower", "faster", "hint", "again", "go", "pause",
                   "done", "quit", "help"},
                  {"skip", "lessons", "how am i doing"}}),
      ShortForms({{"stop", "go",       "bigger",   "smaller", "next",  "back",    "where",
                   "mark", "quit",     "size",     "depth",   "width", "spacing", "pitch",
                   "tilt", "engraved", "embossed", "form",    "paper", "pause"}}),
      ShortForms(
          {{"stop", "help",  "mode",  "depth",    "spacing",  "tilt",   "pause",    "go",    "show",
            "say",  "again", "skip",  "next",     "lesson",   "record", "playback", "where", "who",
            "quit", "width", "pitch", "engraved", "embossed", "form",   "paper",    "size"}}),
      ShortForms({{"next", "pause", "go", "again", "more time", "stop", "quit", "help"}})};
  // each is short for a word of a smaller number elsewhere; sim/README.md lists them
  const std::set<std::string> lost[] = {{"lesso", "lesson"},
                                        {"d", "f", "m", "sp"},
                                        {"d", "f", "les", "less", "m", "mo", "sp"},
                                        {"m", "mo", "mor", "more", "more "}};
  for (const WordPlace place : kPlaces) {
    const auto at = static_cast<std::size_t>(place);
    if (place == WordPlace::kBook) continue;  // there was none
    std::set<std::string> gone;
    for (const auto& [given, meant] : before[at]) {
      if (Meaning(given, place) != meant) gone.insert(given);
    }
    EXPECT_EQ(gone, lost[at]) << NameOf(place);
  }
}

TEST(Vocabulary, ReadsWordsWithWhatStandsBehind) {
  const auto read = [](std::string_view line) { return ReadLine(line, WordPlace::kTutor); };
  EXPECT_EQ(read("say Hello, J!").behind, "Hello, J!");
  EXPECT_EQ(read(" /SIZE  20 mm\t").word, WordNamed("size"));
  EXPECT_EQ(read(" /SIZE  20 mm\t").behind, "20 mm");
  EXPECT_EQ(read("next lesson").word, WordNamed("next lesson"));
  EXPECT_EQ(read("n").word, WordNamed("next"));
  EXPECT_EQ(read("").word, nullptr);
  EXPECT_EQ(read("").refusal, "");
  EXPECT_EQ(read("find next").word, WordNamed("find next"));
  EXPECT_EQ(read("find n").word, WordNamed("find"));  // a text, not a beginning
  EXPECT_EQ(read("find n").behind, "n");
  EXPECT_EQ(read("next l").refusal, "next l could be next lesson or next line.");
  EXPECT_EQ(read("next h").word, WordNamed("next heading"));
  EXPECT_EQ(read("re").word, WordNamed("record"));  // the older one
  EXPECT_EQ(read("pause now").refusal, "Say pause alone, without now.");
}

// "stop now" was refused: "Say stop alone, without now."
TEST(Vocabulary, StopsWhateverElseIsSaid) {
  for (const WordPlace place : kPlaces) {
    for (const char* line : {"stop now", "stop please", "STOP stop stop", "stop!", "stop, stop!",
                             " /stop it", "stop.", "1 stop", "1 now"}) {
      EXPECT_EQ(ReadLine(line, place).word, WordNamed("stop")) << NameOf(place) << ": " << line;
      EXPECT_EQ(ReadLine(line, place).behind, "") << line;
    }
    for (const char* line : {"stopp now", "stopping", "stop-over"}) {
      EXPECT_EQ(ReadLine(line, place).word, nullptr) << NameOf(place) << ": " << line;
    }
  }
}

// "go." and "Where?" were unknown.
TEST(Vocabulary, AClosingMarkBelongsToNoWord) {
  for (const auto& [line, word] : {std::pair("go.", "go"),
                                   {"Where?", "where"},
                                   {"next!", "next"},
                                   {"go on.", "go"},
                                   {"next line?!", "next line"},
                                   {"15.", "go"},
                                   {"pause, please!", "pause"},
                                   {"please stop", "stop"},
                                   {"Please, go!", "go"},
                                   {"halt", "stop"},
                                   {"Halt! Now", "stop"},
                                   {"?", "help"},
                                   {"find next.", "find next"}}) {
    const SaidLine said = ReadLine(line, WordPlace::kBook);
    ASSERT_NE(said.word, nullptr) << line << ": " << said.refusal;
    EXPECT_EQ(said.word->word, word) << line;
    EXPECT_EQ(said.behind, "") << line;
  }
  EXPECT_EQ(WholeWord("pause.", WordPlace::kLesson), WordNamed("pause"));
  const auto behind = [](const char* line) { return ReadLine(line, WordPlace::kBook).behind; };
  EXPECT_EQ(behind("find one."), "one.") << "a text has marks of its own";
  EXPECT_EQ(behind("find ?"), "?");
  EXPECT_EQ(behind("bookmark Why?"), "Why?");
  EXPECT_EQ(behind("size 20 mm."), "20 mm");
  EXPECT_EQ(behind("help next?"), "next");
  EXPECT_EQ(ReadLine("practise .", WordPlace::kLesson).behind, ".");
  EXPECT_EQ(ReadLine("zzz?", WordPlace::kBook).refusal, "Unknown: zzz. Say ? for the words.");
  EXPECT_EQ(ReadLine("pleasestop", WordPlace::kBook).word, nullptr);
}

TEST(Vocabulary, SaysWhyALineIsNone) {
  const auto refused = [](std::string_view line) {
    return ReadLine(line, WordPlace::kLoop).refusal;
  };
  EXPECT_EQ(refused("stopp"), "Unknown: stopp. Did you mean stop? Say ? for the words.");
  EXPECT_EQ(refused("I know nothing"), "Unknown: I know nothing. Say ? for the words.")
      << "all of it, not its first word";
  EXPECT_EQ(refused("s"), "s could be stop, smaller, size or spacing.");
  EXPECT_EQ(refused("spell"), "spell is no word here. Say ? for the words.");
  EXPECT_EQ(refused("5"), "5 is no word here. Say ? for the words.");
  EXPECT_EQ(refused("m"), "m is short for more help elsewhere: say mark.");
  EXPECT_EQ(refused("99"), "Unknown: 99. Say ? for the words.");
  EXPECT_EQ(refused("end"), "Unknown: end. Did you mean quit? Say ? for the words.");
  const auto in_lesson = [](std::string_view line) {
    return ReadLine(line, WordPlace::kLesson).refusal;
  };
  for (const char* line : {"size", "Size 20", "size 20 mm"}) {
    EXPECT_EQ(in_lesson(line), "size is no word here: say bigger or smaller.") << line;
  }
  EXPECT_EQ(in_lesson("letter t."), "Say letter alone, without t.");
}

// "yes" behind "Did you mean quit?" was unknown.
TEST(Vocabulary, WhatIsProposedIsTakenByYesInTheVeryNextLine) {
  const auto meant = [](std::string_view line) { return ReadLine(line, WordPlace::kLoop).meant; };
  EXPECT_EQ(meant("qiut"), "quit");
  EXPECT_EQ(meant("fnid the cat"), "find the cat");
  EXPECT_EQ(meant("xyzzy"), "");
  EXPECT_EQ(meant("quit"), "");
  Proposal proposal;
  EXPECT_EQ(proposal.Taken("yes"), "yes") << "nothing is proposed";
  for (const char* yes : {"yes", "Yes, please!", " y ", "ok"}) {
    proposal.Make("quit");
    EXPECT_EQ(proposal.Taken(yes), "quit") << yes;
    EXPECT_EQ(proposal.Taken(yes), yes) << "once";
  }
  proposal.Make("quit");
  EXPECT_EQ(proposal.Taken("next"), "next");
  EXPECT_EQ(proposal.Taken("yes"), "yes") << "the very next line only";
  proposal.MakeHelp("qiut", WordPlace::kLoop);
  EXPECT_EQ(proposal.Taken("yes"), "help quit");
  proposal.MakeHelp("quit", WordPlace::kLoop);
  EXPECT_EQ(proposal.Taken("yes"), "yes");
}

/// Every "7 `bigger`" of a document.
void ExpectNumbersOf(const std::string& path) {
  const std::string text = Text(path);
  static const std::regex pair(R"((\d+) `([a-z ]+))");
  std::size_t found = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), pair), end; at != end; ++at) {
    const std::string given = (*at)[2];
    const TypedWord* word = WordNamed(given);
    if (word == nullptr) word = WordNamed(given.substr(0, given.find(' ')));
    if (word == nullptr) continue;  // 21 `lessons`, but not "12 `other things`"
    ++found;
    EXPECT_EQ(std::to_string(word->number), (*at)[1]) << path << ": " << given;
  }
  EXPECT_GT(found, 30U) << path;
}

TEST(Vocabulary, IsWhatTheDocumentsSay) {
  std::string table = "| number | word | said in | what it does |\n| --- | --- | --- | --- |\n";
  for (const TypedWord& word : Vocabulary()) {
    std::string places;
    for (const WordPlace place : kPlaces) {
      if (word.HoldsIn(place)) places += (places.empty() ? "" : ", ") + NameOf(place);
    }
    const std::string said =
        std::string(word.word) + (word.behind.empty() ? "" : " ") + std::string(word.behind);
    table += "| " + std::to_string(word.number) + " | `" + said + "` | " + places + " | " +
             std::string(word.help) + " |\n";
  }
  EXPECT_NE(Text("sim/README.md").find(table), std::string::npos)
      << "the table of sim/README.md is to be:\n"
      << table;
  ExpectNumbersOf("lessons/README.md");
}

}  // namespace
}  // namespace moontrace
