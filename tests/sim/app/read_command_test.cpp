#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "lessons/documents/html_tree.h"
#include "lessons/documents/zip_archive.h"
#include "sim/app/commands.h"
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
  EXPECT_EQ(RunLine({"read"}).code, 2);
  EXPECT_EQ(RunLine({"read"}).err, "read needs a file: moontrace read FILE\n");
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

}  // namespace
}  // namespace moontrace
