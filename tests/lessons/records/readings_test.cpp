#include "lessons/records/readings.h"

#include <fstream>
#include <iterator>

#include "lessons/records/learner_history.h"
#include "tests/lessons/records_fixture.h"

namespace moontrace {
namespace {

ReadDocument Book() {
  ReadDocument book;
  book.content = "0x0123456789abcdef";
  book.path = "/books/lighthouse.epub";
  book.title = "The Lighthouse";
  book.time = 1'700'000'000;
  book.length = 5000;
  book.place = {1234, "so he w",
                "ent \xc3\xbc"
                "ber"};
  book.where = "page 3 of 12";
  book.marks = {{"tea", {10, "a", "b"}}, {"1", {20, "", "c"}}};
  book.landmarks =
      "the light went round\x1e"
      "and round\x1e";
  return book;
}

class Readings : public RecordsTest {
 protected:
  std::string Bytes() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

TEST_F(Readings, AreKeptAndKeptAnewByTheirId) {
  Records records = Records::Open(path_);
  records.AddLearner(Named("owl"));
  records.AddLearner(Named("bat"));
  ReadDocument book = Book();
  book.id = records.Keep("owl", book);
  ASSERT_EQ(records.Readings("owl").size(), 1U);
  EXPECT_EQ(records.Readings("owl").front(), book);
  EXPECT_TRUE(records.Readings("bat").empty());
  book.place.letter = 1300;
  book.content = "0xedited";
  book.marks.pop_back();
  book.marks.push_back({"end", {4000, "x", "y"}});
  EXPECT_EQ(records.Keep("owl", book), book.id);
  ASSERT_EQ(records.Readings("owl").size(), 1U);
  EXPECT_EQ(records.Readings("owl").front(), book);
  // another learner's row is not touched by its number
  book.title = "stolen";
  book.marks.clear();
  records.Keep("bat", book);
  EXPECT_EQ(records.Readings("owl").front().title, "The Lighthouse");
  EXPECT_EQ(records.Readings("owl").front().marks.size(), 2U);
}

TEST_F(Readings, ComeNewestFirst) {
  Records records = Records::Open(path_);
  records.AddLearner(Named("owl"));
  for (const std::int64_t time : {5, 9, 7}) {
    ReadDocument book = Book();
    book.time = time;
    records.Keep("owl", book);
  }
  const std::vector<ReadDocument> readings = records.Readings("owl");
  ASSERT_EQ(readings.size(), 3U);
  EXPECT_EQ(readings[0].time, 9);
  EXPECT_EQ(readings[2].time, 5);
}

TEST_F(Readings, AreExportedImportedAndErasedWithTheirLearner) {
  Records records = Records::Open(path_);
  records.AddLearner(Named("owl"));
  ReadDocument book = Book();
  records.Keep("owl", book);
  const LearnerHistory history = HistoryFromJson(records.Export("owl"), "x.json");
  ASSERT_EQ(history.readings.size(), 1U);
  EXPECT_EQ(history.readings.front(), book);  // without an id
  const std::string research = records.ExportAnonymous("owl");
  for (const char* piece : {"Lighthouse", "lighthouse", "so he w", "tea"}) {
    EXPECT_EQ(research.find(piece), std::string::npos) << piece;
  }
  records.Erase("owl");
  records = Records::Open((folder_ / "other.sqlite").string());
  for (const char* piece : {"Lighthouse", "lighthouse", "so he w", "tea"}) {
    EXPECT_EQ(Bytes().find(piece), std::string::npos) << piece;
  }
  records.Import(history, "x.json");
  book.id = records.Readings("owl").front().id;
  EXPECT_EQ(records.Readings("owl").front(), book);
}

TEST_F(Readings, AreForgottenOneByOne) {
  Records records = Records::Open(path_);
  records.AddLearner(Named("owl"));
  records.AddLearner(Named("bat"));
  ReadDocument book = Book();
  const std::int64_t first = records.Keep("owl", book);
  book.title = "Tides";
  book.marks.clear();
  book.landmarks.clear();
  book.place = {};
  book.path = "/books/tides.epub";
  records.Keep("owl", book);
  EXPECT_FALSE(records.Forget("bat", first));  // not another learner's
  EXPECT_TRUE(records.Forget("owl", first));
  EXPECT_FALSE(records.Forget("owl", first));
  ASSERT_EQ(records.Readings("owl").size(), 1U);
  EXPECT_EQ(records.Readings("owl").front().title, "Tides");
  for (const char* piece : {"Lighthouse", "lighthouse", "so he w", "tea", "went round"}) {
    EXPECT_EQ(Bytes().find(piece), std::string::npos) << piece;
  }
}

TEST_F(Readings, BoundWhatTheyKeep) {
  Records records = Records::Open(path_);
  records.AddLearner(Named("owl"));
  ReadDocument book = Book();
  book.title = std::string(3999, 'a') + "\xc3\xbc";  // cut within a letter
  book.marks.clear();
  for (std::size_t i = 0; i < kMostReadMarks + 2; ++i)
    book.marks.push_back({std::to_string(i), {}});
  records.Keep("owl", book);
  const ReadDocument kept = records.Readings("owl").front();
  EXPECT_EQ(kept.title, std::string(3999, 'a') + "?");
  ASSERT_EQ(kept.marks.size(), kMostReadMarks);
  EXPECT_EQ(kept.marks.front().name, "2");
}

}  // namespace
}  // namespace moontrace
