#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <set>
#include <thread>

#include "lessons/documents/html_tree.h"
#include "lessons/documents/zip_archive.h"
#include "lessons/records/records.h"
#include "sim/app/commands.h"
#include "sim/book/book_messages.h"
#include "sim/session/loop_messages.h"
#include "tests/devices/fake_hid.h"
#include "tests/sim/cli_fixture.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

class ReadCommand : public CliTest {};

std::string Fixture(const std::string& name) { return SourcePath("tests/data/documents/" + name); }

TEST_F(ReadCommand, SaysWhatADocumentIsFirst) {
  const Outcome text = RunLine({"read", Fixture("latin.txt"), "--size-mm", "8"});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_EQ(Lines(text.out).front(), "\"latin.txt\", language not told, text: 0 headings, 1 page.");
  ExpectTextFace(text.out);
  if (!CanReadHtml()) GTEST_SKIP() << "built without libgumbo";
  const Outcome page = RunLine({"read", Fixture("page.html"), "--size-mm", "8"});
  EXPECT_EQ(page.code, 0) << page.err;
  EXPECT_EQ(
      page.out.rfind("\"Tide tables of the harbour\" by Harbour Office, en, HTML: 1 heading, ", 0),
      0U)
      << page.out;
  EXPECT_NE(page.out.find("1 picture has no description, the first \"boat.jpg\"."),
            std::string::npos)
      << page.out;
  EXPECT_NE(page.out.find("Contents: 1 line.\nLevel 1: Tides\n"), std::string::npos) << page.out;
  ExpectTextFace(page.out);
}

TEST_F(ReadCommand, WritesTheTextAloneThatPageReads) {
  const Outcome text = RunLine({"read", Fixture("wrapped.txt"), "--text"});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_EQ(text.out.rfind("The Walrus and the Carpenter\n\nThe sun was shining on the sea,\n", 0),
            0U);
  EXPECT_EQ(text.err.rfind("\"wrapped.txt\", language not told, text", 0), 0U) << text.err;
  const Outcome page = RunLine({"page", text.out, "--structure", "--json"});
  const Outcome read = RunLine({"read", Fixture("wrapped.txt"), "--json"});
  EXPECT_EQ(read.Json()["signs"], page.Json()["signs"]);
  EXPECT_EQ(read.Json()["lines"], page.Json()["lines"]);
}

TEST_F(ReadCommand, TellsABookAsJson) {
  if (!CanReadZip()) GTEST_SKIP() << "built without libzip";
  const auto json = RunLine({"read", Fixture("lighthouse-3.epub"), "--json"}).Json();
  const auto& book = json["document"];
  EXPECT_EQ(book["title"], "The Lighthouse");
  EXPECT_EQ(book["format"], "EPUB");
  EXPECT_EQ(book["authors"][1], "Bo Rock");
  EXPECT_EQ(book["parts"].size(), 2U);
  EXPECT_EQ(book["contents"].back()["title"], "Tools");
  const std::size_t block = book["contents"].back()["block"];
  EXPECT_EQ(book["blocks"][block]["kind"], "heading");
  EXPECT_GT(json["pages"], 0);
}

TEST_F(ReadCommand, PrintsPagesForSwellPaper) {
  const std::string picture =
      testing::TempDir() + "read_print_" + std::to_string(getpid()) + ".svg";
  const Outcome outcome = RunLine(
      {"read", Fixture("latin.txt"), "--print", picture, "--page", "200x120", "--size-mm", "8"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  std::ifstream file(picture);
  const std::string svg((std::istreambuf_iterator<char>(file)), {});
  EXPECT_NE(svg.find("width=\"200mm\""), std::string::npos) << svg.substr(0, 300);
  EXPECT_NE(outcome.out.find(picture), std::string::npos) << outcome.out;
  std::filesystem::remove(picture);
}

TEST_F(ReadCommand, ReadsStandardInput) {
  const Outcome outcome = RunLine({"read", "-", "--text"}, "one\n\ntwo\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "one\n\ntwo\n");
}

TEST_F(ReadCommand, RefusesInOneLine) {
  EXPECT_EQ(RunLine({"read", "--text"}).code, 2);
  EXPECT_EQ(RunLine({"read", "--text"}).err, "read needs a file: moontrace read FILE\n");
  EXPECT_EQ(RunLine({"read", "x", "--simulate", "--device", "phantom"}).code, 2);
  EXPECT_EQ(RunLine({"read", "x", "--device", "mouse"}).code, 2);
  EXPECT_EQ(RunLine({"read", "x", "--text", "--json"}).code, 2);
  EXPECT_EQ(RunLine({"read", "x", "--text", "--print", "y.pdf"}).code, 2);
  EXPECT_EQ(RunLine({"read", Fixture("latin.txt"), "--print", "y.doc"}).code, 2);
  EXPECT_EQ(RunLine({"read", Fixture("latin.txt"), "--most-mb", "0"}).code, 2);
  const Outcome missing = RunLine({"read", Fixture("none.epub")});
  EXPECT_EQ(missing.code, 3);
  EXPECT_EQ(Lines(missing.err).size(), 1U);
  EXPECT_EQ(RunLine({"read", Fixture("../../data/moon-reference.json"), "--most-mb", "1"}).code, 0);
}

TEST_F(ReadCommand, TerminalsAreNotObeyed) {
  const Outcome outcome = RunLine({"read", "-", "--text"}, "a\x1b[2Jb\n");
  EXPECT_EQ(outcome.out, "a?[2Jb\n");
}

std::vector<std::string> Reading(const std::string& file, const std::string& records) {
  return {"read",      file,  "--device",  "simulated", "--size-mm", "8",
          "--learner", "owl", "--records", records,     "--page",    "120x90"};
}

TEST_F(ReadCommand, IsReadByWordsAndGoesOnWhereItWasLeft) {
  if (!Records::Available() || !CanReadZip()) GTEST_SKIP() << "a library is missing";
  const auto line = Reading(Fixture("lighthouse-3.epub"), In("r.sqlite"));
  const Outcome first =
      RunLine(line, "contents\nnext paragraph\ngo to 3\nbookmark tea\nwhere\nquit\n");
  EXPECT_EQ(first.code, 0) << first.err;
  ExpectTextFace(first.out);
  for (const char* said : {"owl reads for the first time; places are kept.\n",
                           "\"The Lighthouse\" by ", "\n1: First light, page 3.\n", "\nParagraph ",
                           "\nBookmark set: tea, page 3 of ", "\nKept: page 3 of "}) {
    EXPECT_NE(first.out.find(said), std::string::npos) << said << first.out;
  }
  const Outcome second = RunLine(line, "bookmarks\nquit\n");
  EXPECT_EQ(second.code, 0) << second.err;
  EXPECT_NE(second.out.find("\nYou go on: page 3 of "), std::string::npos) << second.out;
  EXPECT_NE(second.out.find("\ntea: page 3 of "), std::string::npos) << second.out;
  const Outcome list = RunLine({"read", "--records", In("r.sqlite")});
  EXPECT_EQ(list.code, 0);
  EXPECT_EQ(list.out.rfind("Read last: 1 text.\n1: The Lighthouse, page 3 of ", 0), 0U) << list.out;
  EXPECT_EQ(RunLine({"read", "--records", In("none.sqlite")}).out,
            "Nothing was read yet: say moontrace read FILE.\n");
}

TEST_F(ReadCommand, InMoonATextIsChosenOfThoseThatWereRead) {
  if (!Records::Available()) GTEST_SKIP() << "built without SQLite";
  const std::vector<std::string> line{"read",         "--device",  "simulated",
                                      "--messages",   "moon",      "--records",
                                      In("r.sqlite"), "--learner", "owl"};
  EXPECT_NE(RunLine(line, "quit\n").out.find("Nothing was read yet: "), std::string::npos);
  for (const char* name : {"sea.txt", "sky.txt"}) {
    WriteAll(In(name), std::string("All about ") + name);
    ASSERT_EQ(RunLine(Reading(In(name), In("r.sqlite")), "quit\n").code, 0);
  }
  // 1 is stop elsewhere
  EXPECT_NE(RunLine(line, "1 sky.txt\nquit\n").out.find(", in \"sky.txt\"."), std::string::npos);
  const Outcome outcome = RunLine(line, "2 sea.txt\nquit\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.rfind("read which?\n1 sky.txt\n2 sea.txt\n", 0), 0U) << outcome.out;
  EXPECT_NE(outcome.out.find("You go on: page 1 of 1, line 1, at A, in \"sea.txt\"."),
            std::string::npos)
      << outcome.out;
}

TEST_F(ReadCommand, ReadsOnWithoutPlacesWhereNobodyIsNamed) {
  const Outcome outcome =
      RunLine({"read", Fixture("latin.txt"), "--device", "simulated", "--records", In("r.sqlite")},
              "where\nquit\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("Your place is not kept: "), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out.find("Kept: "), std::string::npos) << outcome.out;
}

TEST_F(ReadCommand, EndsWithAnErrorWherePlacesCouldNotBeKept) {
  if (!Records::Available()) GTEST_SKIP() << "built without SQLite";
  const Records used = Records::Open(In("r.sqlite"));
  const Outcome outcome = RunLine(Reading(Fixture("latin.txt"), In("r.sqlite")), "where\nquit\n");
  EXPECT_EQ(outcome.code, 4) << outcome.err;
  EXPECT_EQ(Lines(outcome.err).back(), say::PlaceLost());
  EXPECT_NE(outcome.err.find("Your place is not kept:"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find(", page 1 of "), std::string::npos) << "it was read\n" << outcome.out;
}

TEST_F(ReadCommand, ATextThatTheScriptCannotWriteIsNamedWithWhatHelps) {
  WriteAll(In("ar.txt"), "\xD9\x85\xD8\xB1\xD8\xAD\xD8\xA8\xD8\xA7\n");
  for (const bool felt : {false, true}) {
    std::vector<std::string> line{"read", In("ar.txt"), "--records", In("r.sqlite")};
    if (felt) line = With(line, {"--device", "simulated"});
    const Outcome outcome = RunLine(line);
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(Lines(outcome.err).back(),
              In("ar.txt") +
                  ": nothing left to set: script moon has no sign for '\xD9\x85' (line "
                  "1, column 1); --text shows the text, --script NAME sets it in "
                  "another script");
  }
}

TEST_F(ReadCommand, ReadsStandardInputByTouchWithoutWords) {
  const Outcome outcome = RunLine(
      {"read", "-", "--device", "simulated", "--seconds", "0.2", "--records", In("r.sqlite")},
      "some words\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find(say::CannotSpeak()), std::string::npos) << outcome.err;
}

TEST_F(ReadCommand, OpensAndForgetsByTheNumberInTheList) {
  if (!Records::Available()) GTEST_SKIP() << "built without SQLite";
  for (const char* name : {"one", "two"}) {
    WriteAll(In(std::string(name) + ".txt"), std::string(name) + " text to be read, and kept.");
    ASSERT_EQ(RunLine(Reading(In(std::string(name) + ".txt"), In("r.sqlite")), "quit\n").code, 0);
  }
  const std::vector<std::string> records{"--records", In("r.sqlite")};
  const auto number_of = [&](const std::string& name) {
    const auto list = RunLine(With({"read", "--json"}, records)).Json()["readings"];
    return list[0]["title"] == name ? std::string("1") : std::string("2");
  };
  const std::string one = number_of("one.txt"), two = number_of("two.txt");
  const Outcome opened =
      RunLine(With({"read", one, "--device", "simulated", "--size-mm", "8"}, records), "quit\n");
  EXPECT_EQ(opened.code, 0) << opened.err;
  EXPECT_NE(opened.out.find(", in \"one.txt\"."), std::string::npos) << opened.out;
  const Outcome third = RunLine(With({"read", "3"}, records));
  EXPECT_EQ(third.code, 3);
  EXPECT_EQ(third.err,
            "3: no file, and no number of the list, which has 2 texts; moontrace read "
            "says it\n");
  std::filesystem::remove(In("two.txt"));
  const Outcome gone = RunLine(With({"read", number_of("two.txt")}, records));
  EXPECT_EQ(gone.code, 3);
  EXPECT_NE(gone.err.find("its file is gone"), std::string::npos) << gone.err;
  const Outcome list = RunLine(With({"read"}, records));
  EXPECT_NE(list.out.find("That file is gone; it may lie elsewhere:\n"), std::string::npos)
      << list.out;
  ExpectTextFace(list.out);
  const Outcome forgotten = RunLine(With({"read", number_of("two.txt"), "--forget"}, records));
  EXPECT_EQ(forgotten.code, 0) << forgotten.err;
  EXPECT_EQ(forgotten.out.rfind("Forgotten: the place of owl in \"two.txt\", and 0 bookmarks.", 0),
            0U)
      << forgotten.out;
  EXPECT_EQ(RunLine(With({"read", In("one.txt"), "--forget"}, records)).code, 0);
  EXPECT_EQ(RunLine(With({"read", In("one.txt"), "--forget"}, records)).code, 3);
  EXPECT_EQ(RunLine(With({"read"}, records)).out,
            "Nothing was read yet: say moontrace read FILE.\n");
  EXPECT_EQ(RunLine({"read", "--forget"}).code, 2);
}

TEST_F(ReadCommand, AnotherTextInTheFileIsSaidAndTheOldOneStaysInTheList) {
  if (!Records::Available()) GTEST_SKIP() << "built without SQLite";
  const auto line = Reading(In("book.txt"), In("r.sqlite"));
  WriteAll(In("book.txt"),
           "The tides of the harbour, told by its keeper, day by day and hour by hour.");
  ASSERT_EQ(RunLine(line, "bookmark tea\nquit\n").code, 0);
  WriteAll(In("book.txt"),
           "A letter from far away, which has nothing to do with any water at all.");
  const Outcome other = RunLine(line, "bookmarks\nquit\n");
  EXPECT_NE(other.out.find("Another text lay in this file before."), std::string::npos)
      << other.out;
  EXPECT_NE(other.out.find("No bookmark yet"), std::string::npos) << other.out;
  const Outcome list = RunLine({"read", "--records", In("r.sqlite")});
  EXPECT_EQ(list.out.rfind("Read last: 2 texts", 0), 0U) << list.out;
  EXPECT_NE(list.out.find("That file holds another text now:\n"), std::string::npos) << list.out;
}

TEST_F(ReadCommand, KeepsWhatWasFoundThoughTheHandHasNotComeThere) {
  if (!Records::Available()) GTEST_SKIP() << "built without SQLite";
  std::string book;
  for (int i = 0; i < 100; ++i) book += "Sentence " + std::to_string(i) + " of a long book. ";
  WriteAll(In("book.txt"), book);
  RunLine(Reading(In("book.txt"), In("r.sqlite")), "find 77\nquit\n");
  const ReadDocument kept = Records::OpenToRead(In("r.sqlite")).Readings("owl").at(0);
  EXPECT_EQ(kept.place.letter, static_cast<std::int64_t>(book.find("77")));
}

TEST_F(ReadCommand, ReadsToTheEndThoughNoWordCanCome) {
  WriteAll(In("short.txt"), "it");
  const Outcome outcome = RunLine(
      {"read", In("short.txt"), "--simulate", "--size-mm", "8", "--records", In("r.sqlite")}, "");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("This is the end of the text.\n"), std::string::npos) << outcome.out;
}

TEST_F(ReadCommand, SaysWhereOneIsWhenItIsInterrupted) {
  if (!Records::Available()) GTEST_SKIP() << "built without SQLite";
  WriteAll(In("book.txt"), "One text to be read.");
  std::atomic<bool> stop{false};
  std::thread later([&stop] {
    std::this_thread::sleep_for(std::chrono::milliseconds(800));
    stop = true;
  });
  auto line = Reading(In("book.txt"), In("r.sqlite"));
  line.insert(line.end(), {"--seconds", "60"});
  const Outcome outcome = RunLine(line, "", &stop);
  later.join();
  EXPECT_EQ(outcome.code, 130);
  EXPECT_NE(outcome.out.find("Kept: page 1 of 1, "), std::string::npos) << outcome.out;
}

TEST_F(ReadCommand, SaysThatAPermissionIsMissingAndHowToGiveIt) {
  const FakeHid fake("pid", "refused");
  const Outcome outcome = RunLine({"read", Fixture("latin.txt"), "--size-mm", "8"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.out.find("Not usable: openffboard, which has motors: no permission.\n"),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("\n/etc/udev/rules.d/70-moontrace-hid.rules\n"), std::string::npos)
      << outcome.out;
  EXPECT_EQ(outcome.err.find("No device with motors"), std::string::npos) << outcome.err;
}

TEST_F(ReadCommand, OfReplacedCharactersItSaysThreeAndHowManyMore) {
  std::string text = "text";
  for (char c = 'A'; c < 'A' + 7; ++c) text += std::string(" \xCC\x80").insert(1, 1, c);
  WriteAll(In("accents.txt"), text);  // letters with a grave accent
  const Outcome outcome = RunLine({"read", In("accents.txt"), "--device", "simulated", "--size-mm",
                                   "8", "--records", In("r.sqlite")},
                                  "quit\n");
  std::size_t said = 0;
  for (const std::string& one : Lines(outcome.err))
    said += one.rfind("Replaced: ", 0) == 0 ? 1U : 0U;
  EXPECT_EQ(said, 3U) << outcome.err;
  EXPECT_NE(outcome.err.find("And 4 more like these"), std::string::npos) << outcome.err;
}

class SlowReadCommand : public ReadCommand {};

/// A program that reads is killed at any moment; MOONTRACE_KILLS says how often, else 20 times.
TEST_F(SlowReadCommand, OpensAtTheSameLetterAfterKills) {
  if (!Records::Available()) GTEST_SKIP() << "built without SQLite";
  const char* asked = std::getenv("MOONTRACE_KILLS");
  const int kills = asked != nullptr ? std::atoi(asked) : 20;
  std::string book = "# One\n\n";
  for (int i = 0; i < 400; ++i) book += "Sentence " + std::to_string(i) + " of a long book. ";
  WriteAll(In("book.txt"), book);
  const auto line = Reading(In("book.txt"), In("r.sqlite"));
  ASSERT_EQ(RunLine(line, "quit\n").code, 0);
  std::mt19937 random(1);
  std::set<std::int64_t> letters;
  for (int kill_number = 0; kill_number < kills; ++kill_number) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      dup2(ends[0], STDIN_FILENO);
      close(ends[1]);
      std::ostringstream out, err;
      Console console(std::cin, out, err);
      _exit(RunCli(line, console));
    }
    close(ends[0]);
    const auto wait = [&random] {
      std::this_thread::sleep_for(std::chrono::milliseconds(random() % 200));
    };
    for (const char* word : {"next\n", "next paragraph\n", "find book\n", "next\n"}) {
      wait();
      ASSERT_GT(write(ends[1], word, strlen(word)), 0);
    }
    wait();
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    close(ends[1]);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself, " << status;
    const ReadDocument kept = Records::OpenToRead(In("r.sqlite")).Readings("owl").at(0);
    letters.insert(kept.place.letter);
    const Outcome again = RunLine(line, "quit\n");
    EXPECT_NE(again.out.find("You go on: " + kept.where + ", in "), std::string::npos)
        << kept.where << again.out << again.err;
    EXPECT_EQ(Records::OpenToRead(In("r.sqlite")).Readings("owl").at(0).place, kept.place);
  }
  EXPECT_GT(letters.size(), 2U) << "it never came on";
}

}  // namespace
}  // namespace moontrace
