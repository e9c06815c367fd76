#include "lessons/documents/open_document.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "lessons/documents/html_tree.h"
#include "tests/lessons/documents/document_file.h"
#include "tests/source_path.h"

namespace moontrace {
namespace {

class OpenDocumentFile : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string Path(const std::string& name) const { return folder_ + "/" + name; }
  std::string Write(const std::string& name, const std::string& bytes) const {
    std::ofstream(Path(name), std::ios::binary) << bytes;
    return Path(name);
  }

 private:
  std::string folder_ = testing::TempDir() + "open_document_" + std::to_string(getpid());
};

std::string Refused(const std::string& path) {
  const std::string line = RefusalOf([&] { OpenDocument(path, {}); });
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_EQ(line.rfind(path, 0), 0U) << line;
  return line.substr(std::min(path.size() + 2, line.size()));
}

TEST_F(OpenDocumentFile, TellsKindsApartByWhatTheyHold) {
  const Document latin = OpenDocument(SourcePath("tests/data/documents/latin.txt"), {});
  EXPECT_EQ(latin.format, DocumentFormat::kText);
  EXPECT_EQ(latin.encoding, "Windows-1252");
  EXPECT_EQ(CountOf(latin, LeftOut::kGuessedCoding), 1U);
  ASSERT_EQ(latin.blocks.size(), 2U);
  EXPECT_EQ(latin.blocks[0].text,
            "Gr\xC3\xBC\xC3\x9F"
            "e \xE2\x80\x93 aus K\xC3\xB6ln");
  if (!CanReadHtml()) GTEST_SKIP() << "built without libgumbo";
  EXPECT_EQ(OpenDocument(Write("page", "<!DOCTYPE html><p>x"), {}).format, DocumentFormat::kHtml);
  EXPECT_EQ(OpenDocument(Write("part.htm", "<p>x"), {}).format, DocumentFormat::kHtml);
  EXPECT_EQ(OpenDocument(Write("notes.txt", "1 <p> 2"), {}).format, DocumentFormat::kText);
}

TEST_F(OpenDocumentFile, RefusesInOneLineWhatItCannotRead) {
  EXPECT_EQ(Refused(Write("a.pdf", "%PDF-1.7 x")), "is a PDF; save it as EPUB, HTML or plain text");
  EXPECT_EQ(Refused(Write("a.doc", "\xD0\xCF\x11\xE0 x")),
            "is a document of an older Word; save it as EPUB, HTML or plain text");
  // as Chromium saves a page as one file
  EXPECT_EQ(Refused(Write("a.mhtml",
                          "From: <Saved by Blink>\r\nSubject: T\r\nMIME-Version: 1.0\r\n"
                          "Content-Type: multipart/related;\r\n\ttype=\"text/html\";\r\n\r\n--b\r\n"
                          "Content-Transfer-Encoding: quoted-printable\r\n\r\n<p>caf=C3=A9</p>")),
            "is a web archive (MHTML); save it as EPUB, HTML or plain text");
  EXPECT_EQ(Refused(Write("a.fb2",
                          "<?xml version='1.0'?><FictionBook><body><section><title><p>One</p>"
                          "</title><p>x</p></section></body></FictionBook>")),
            "is a FictionBook; save it as EPUB, HTML or plain text");
  EXPECT_EQ(Refused(Write("a.bin", std::string("\x7f"
                                               "ELF\0\0\0",
                                               7))),
            "is no text; save it as EPUB, HTML or plain text");
  EXPECT_EQ(Refused(Write("book.txt.gz", "\x1F\x8B\x08 x")),
            "is packed; unpack it first by gunzip, and read what that gives");
  EXPECT_EQ(Refused(Write("empty.txt", "")), "holds no text; name another file");
  EXPECT_EQ(Refused(Write("blank.txt", " \n\n")), "holds no text; name another file");
  EXPECT_EQ(Refused(Path("none.txt")),
            "cannot be opened (No such file or directory): check the path");
  EXPECT_EQ(Refused(std::filesystem::path(Path("none.txt")).parent_path().string()),
            "is a folder; name a file in it");
}

TEST_F(OpenDocumentFile, NeverWaitsForAPipeAndReadsNoHugeFile) {
  const std::string pipe = Path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(Refused(pipe), "is no regular file; name one, not a pipe or a device");
  const std::string huge = Write("huge.txt", "a");
  std::filesystem::resize_file(huge, std::uintmax_t{500} << 20U);
  EXPECT_EQ(Refused(huge), "holds more than 64 MB; split it, or raise --most-mb");
  OpenOptions small;
  small.limits.most_bytes = std::size_t{1} << 20U;
  EXPECT_NE(RefusalOf([&] {
              ReadDocument(std::string((std::size_t{1} << 20U) + 1, 'a'), "x", small);
            }).find("more than 1 MB"),
            std::string::npos);
}

}  // namespace
}  // namespace moontrace
