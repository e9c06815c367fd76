#include "sim/app/gallery_command.h"

#include <gtest/gtest.h>

#include <set>

#include "sim/app/gallery_messages.h"
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
