#include "sim/app/commands.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <set>
#include <sstream>

#include "sim/app/messages.h"
#include "tests/sim/cli_fixture.h"

namespace moontrace {
namespace {

class GalleryCommand : public CliTest {};

TEST_F(GalleryCommand, LeavesAPageWhereEachPictureStandsWithItsCommandAndWords) {
  const Outcome outcome = RunLine({"gallery", "--folder", In("gallery"), "--json", "--quiet"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json json = outcome.Json();
  const std::string page = ReadAll(In("gallery") + "/index.html");
  EXPECT_EQ(json["page"], In("gallery") + "/index.html");
  ASSERT_GT(json["pictures"].size(), 10U);
  std::set<std::string> files;
  for (const auto& shown : json["pictures"]) {
    const std::string file = shown["picture"], words = shown["words"];
    EXPECT_FALSE(words.empty()) << shown["title"];
    EXPECT_NE(page.find(">" + shown["title"].get<std::string>() + "</h2>"), std::string::npos);
    if (file.empty()) continue;  // lacking on this machine, said in the words
    EXPECT_TRUE(files.insert(file).second) << file;
    EXPECT_NE(page.find("<img src=\"" + file + "\" alt=\""), std::string::npos);
    EXPECT_NE(ReadAll(In("gallery") + "/" + file).find("</svg>"), std::string::npos) << file;
  }
}

/// The words of a command line, parted by a shell; empty where there is no bash.
std::vector<std::string> PartedByShell(const std::string& command) {
  const std::string file = testing::TempDir() + "moontrace_gallery_line.sh";
  WriteAll(file, "moontrace() { printf '%s\\0' \"$@\"; }\n" + command + "\n");
  std::string parted;
  if (std::FILE* shell = popen(("bash '" + file + "'").c_str(), "r"); shell != nullptr) {
    for (int c = std::fgetc(shell); c != EOF; c = std::fgetc(shell)) parted += static_cast<char>(c);
    pclose(shell);
  }
  std::filesystem::remove(file);
  std::vector<std::string> words;
  std::istringstream stream(parted);
  for (std::string word; std::getline(stream, word, '\0');) words.push_back(word);
  return words;
}

TEST_F(GalleryCommand, EachCommandDrawsItsPictureAsShown) {
  const Outcome outcome = RunLine({"gallery", "--folder", In("gallery"), "--json", "--quiet"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::filesystem::create_directory(In("again"));
  for (const auto& shown : outcome.Json()["pictures"]) {
    const std::string file = shown["picture"];
    if (file.empty()) continue;
    std::vector<std::string> args = PartedByShell(shown["command"]);
    if (args.empty()) GTEST_SKIP() << "no bash here";
    std::set<std::string> options;
    for (const std::string& arg : args) {
      if (arg.rfind("--", 0) != 0) continue;
      EXPECT_TRUE(options.insert(arg).second) << shown["command"];
    }
    EXPECT_EQ(args.back(), file);
    args.back() = In("again/" + file);
    const Outcome again = RunLine(args);
    EXPECT_EQ(again.code, 0) << shown["command"] << '\n' << again.err;
    EXPECT_EQ(ReadAll(In("again/" + file)), ReadAll(In("gallery/" + file))) << shown["command"];
  }
}

TEST_F(GalleryCommand, APlaceThatCannotBeWrittenEndsItAndNothingNewIsLeft) {
  std::filesystem::create_directories(In("gallery/02-the-signs-of-braille.svg"));
  WriteAll(In("gallery/note.txt"), "kept");
  const Outcome outcome = RunLine({"gallery", "--folder", In("gallery")});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(Lines(outcome.err).size(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find("02-the-signs-of-braille.svg"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  std::set<std::string> left;
  for (const auto& entry : std::filesystem::directory_iterator(In("gallery"))) {
    left.insert(entry.path().filename());
  }
  EXPECT_EQ(left, (std::set<std::string>{"02-the-signs-of-braille.svg", "note.txt"}));
}

TEST_F(GalleryCommand, IsHeardInOneSentence) {
  const Outcome outcome = RunLine({"gallery", "--folder", In("gallery")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  ASSERT_EQ(Lines(outcome.out).size(), 2U);
  EXPECT_EQ(Lines(outcome.out)[1], In("gallery") + "/index.html");
  ExpectTextFace(outcome.out);
}

TEST(GalleryMessages, WhatTheMachineLacksIsOneSentence) {
  EXPECT_EQ(say::ExhibitMissing("Braille, contracted", "no tables here: install liblouis-data"),
            "Not shown: Braille, contracted; no tables here: install liblouis-data.");
}

TEST_F(GalleryCommand, UnwritableFolderIsNamed) {
  WriteAll(In("file"), "");
  const Outcome outcome = RunLine({"gallery", "--folder", In("file") + "/gallery"});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(Lines(outcome.err).size(), 1U);
  EXPECT_NE(outcome.err.find(In("file")), std::string::npos);
}

}  // namespace
}  // namespace moontrace
