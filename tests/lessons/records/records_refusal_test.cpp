// What the records refuse, each by one line that says what, where and how to mend it, with the file
// left as it was.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <functional>

#include "lessons/records/database.h"
#include "tests/lessons/records_fixture.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

std::string BytesOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void WriteBytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// What `work` returns in a process of its own.
std::string InChild(const std::function<std::string()>& work) {
  int ends[2] = {};
  EXPECT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    std::string answer;
    try {
      answer = work();
    } catch (const std::exception& error) {
      answer = error.what();
    }
    const ssize_t written = write(ends[1], answer.data(), answer.size());
    _exit(written == static_cast<ssize_t>(answer.size()) ? 0 : 1);
  }
  close(ends[1]);
  std::string answer;
  char block[4096];
  for (ssize_t got = 0; (got = read(ends[0], block, sizeof block)) > 0;) {
    answer.append(block, static_cast<std::size_t>(got));
  }
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  return answer;
}

/// Root may do everything: whoever asks for permissions must be somebody else.
void BecomeNobody() {
  constexpr unsigned kNobody = 65534;
  if (geteuid() == 0 && (setgid(kNobody) != 0 || setuid(kNobody) != 0)) {
    throw std::runtime_error("cannot become nobody");
  }
}

class RecordsRefusal : public RecordsTest {
 protected:
  /// Records of a learner with some trials.
  void Fill(int trials = 20) {
    Records records = Records::Open(path_);
    records.AddLearner(Named("bat"));
    for (int i = 0; i < trials; ++i) records.Add("bat", "learn-moon", NumberedTrial(i));
  }

  /// Refused by both ways of opening, by a line that begins with the path and holds `words`, and
  /// left as it was.
  void ExpectRefused(const std::string& words) {
    const std::string before = BytesOf(path_);
    for (const bool write : {true, false}) {
      const std::string line = RefusalOf<InputError>([&] {
        const Records records = write ? Records::Open(path_) : Records::OpenToRead(path_);
        for (const LearnerEntry& learner : records.Learners()) records.Trials(learner.pseudonym);
      });
      EXPECT_EQ(line.find(path_ + ": "), 0U) << line;
      EXPECT_NE(line.find(words), std::string::npos) << line;
    }
    EXPECT_EQ(BytesOf(path_), before);
  }
};

TEST_F(RecordsRefusal, OfAMissingFileWhereOneIsToBeRead) {
  const std::string line = RefusalOf<InputError>([&] { Records::OpenToRead(path_); });
  EXPECT_EQ(line, path_ + ": no records there yet; learn first or name another by --records");
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(RecordsRefusal, OfAFileFromTheFuture) {
  Fill();
  Database(path_, true).Run("PRAGMA user_version = 5");
  ExpectRefused("of a newer Moontrace (version 5 of records, here 4); update this program");
}

TEST_F(RecordsRefusal, OfWhatIsNoDatabase) {
  WriteBytes(path_, std::string(5000, 'x'));
  ExpectRefused("not a records file; name another by --records");
  WriteBytes(path_, "short");
  ExpectRefused("not a records file");
}

TEST_F(RecordsRefusal, OfAnotherProgramsDatabase) {
  Database(path_, true).Run("CREATE TABLE learner (name TEXT)");
  ExpectRefused("not a records file");
}

TEST_F(RecordsRefusal, OfAFileCutShort) {
  Fill();
  fs::resize_file(path_, fs::file_size(path_) / 2);
  ExpectRefused("the records are damaged; put a copy in their place");
}

TEST_F(RecordsRefusal, OfAFileWithADamagedPage) {
  Fill();
  const std::string good = BytesOf(path_);
  // every page but the first, which holds the head
  for (std::size_t page = 1; page < good.size() / 4096; ++page) {
    std::string bad = good;
    bad.replace(page * 4096, 512, std::string(512, '\xa5'));
    WriteBytes(path_, bad);
    ExpectRefused("the records are damaged");
  }
  WriteBytes(path_, good);
  EXPECT_EQ(Records::Open(path_).Trials("bat").size(), 20U);
}

TEST_F(RecordsRefusal, OfAVersionThatNoProgramWrote) {
  Fill();
  for (const char* version : {"-1", "0", "-2147483648"}) {
    Database(path_, true).Run(std::string("PRAGMA user_version = ") + version);
    ExpectRefused("not a records file");
  }
}

// What SQL of a stranger's runs when it is read or written: no schema but ours is taken.
TEST_F(RecordsRefusal, OfATableOrColumnThatIsNotOurs) {
  const char* const hostile[] = {
      "CREATE VIEW spy AS SELECT * FROM learner",
      "ALTER TABLE trial RENAME TO old; CREATE VIEW trial AS SELECT * FROM old",
      "CREATE TRIGGER t AFTER INSERT ON trial BEGIN DELETE FROM trial; END",
      "CREATE TABLE more (x)",
      "ALTER TABLE learner ADD COLUMN more TEXT",
      "DROP INDEX trial_of_learner",
      "DROP INDEX trial_of_learner; CREATE INDEX trial_of_learner ON trial (abs(learner))",
      ("DROP TABLE event; CREATE TABLE event (id INTEGER PRIMARY KEY, learner INTEGER NOT NULL, "
       "time_unix_s INTEGER AS (randomblob(900000000)), kind TEXT NOT NULL, text TEXT NOT NULL)"),
      "DROP TABLE event; CREATE VIRTUAL TABLE event USING fts5(learner, time_unix_s, kind, text)",
  };
  for (const char* sql : hostile) {
    fs::remove(path_);
    Fill();
    try {
      Database(path_, true).Run(sql);
    } catch (const InputError&) {
      continue;  // this SQLite knows no such table
    }
    ExpectRefused("the records are damaged (their tables are others)");
  }
}

TEST_F(RecordsRefusal, OfATextTooLongToBeOurs) {
  Fill();
  Database(path_, true).Run("UPDATE trial SET answer = printf('%.*c', 2000000, 'a') WHERE id = 3");
  ExpectRefused("the records are damaged");
}

TEST_F(RecordsRefusal, OfATrialThatNoProgramWrote) {
  Fill();
  Database(path_, true).Run("UPDATE trial SET kind = 'trance' WHERE id = 7");
  ExpectRefused("trial 7: \"trance\" is no kind; put a copy");
}

TEST_F(RecordsRefusal, OfATableThatIsMissing) {
  Fill();
  Database(path_, true).Run("DROP TABLE trial");
  ExpectRefused("the records are damaged");
}

TEST_F(RecordsRefusal, OfASecondWriter) {
  Records first = Records::Open(path_);
  first.AddLearner(Named("bat"));
  const std::string line = path_ + ": another program writes these records; close it and try again";
  EXPECT_EQ(InChild([&] {
              Records::Open(path_);
              return std::string("opened");
            }),
            line);
  EXPECT_EQ(RefusalOf<LackError>([&] { Records::Open(path_); }), line);
  // and the first one goes on
  first.Add("bat", "c", NumberedTrial(1));
  EXPECT_EQ(first.Trials("bat").size(), 1U);
}

// Another name of the same file has a lock file of its own: the file itself is what is locked.
TEST_F(RecordsRefusal, OfASecondWriterByAnotherNameOfTheFile) {
  Records first = Records::Open(path_);
  first.AddLearner(Named("bat"));
  const std::string other = (folder_ / "other.sqlite").string();
  fs::create_hard_link(path_, other);
  const std::string line = other + ": another program writes these records; close it and try again";
  EXPECT_EQ(RefusalOf<LackError>([&] { Records::Open(other); }), line);
  EXPECT_EQ(InChild([&] {
              Records::Open(other);
              return std::string("opened");
            }),
            line);
  first.Add("bat", "c", NumberedTrial(1));
  EXPECT_EQ(first.Trials("bat").size(), 1U);
}

TEST_F(RecordsRefusal, OfASymbolicLinkToTheFileOrItsLock) {
  Fill(1);
  const std::string link = (folder_ / "link.sqlite").string();
  fs::create_symlink(path_, link);
  const std::string line = link + ": is a symbolic link; name the file that it leads to";
  EXPECT_EQ(RefusalOf<InputError>([&] { Records::Open(link); }), line);
  EXPECT_EQ(RefusalOf<InputError>([&] { Records::OpenToRead(link); }), line);
  // one that leads nowhere would be made there
  const std::string away = (folder_ / "away.sqlite").string();
  fs::create_symlink("elsewhere.sqlite", away);
  RefusalOf<InputError>([&] { Records::Open(away); });
  EXPECT_FALSE(fs::exists(folder_ / "elsewhere.sqlite"));
  fs::remove(path_ + "-lock");
  fs::create_symlink("victim", path_ + "-lock");
  EXPECT_EQ(RefusalOf<InputError>([&] { Records::Open(path_); }),
            path_ + "-lock: is a symbolic link; name the file that it leads to");
  EXPECT_FALSE(fs::exists(folder_ / "victim"));
}

TEST_F(RecordsRefusal, EndsWithTheFirstWriter) {
  InChild([&] {
    Records::Open(path_).AddLearner(Named("bat"));
    return std::string();
  });
  EXPECT_EQ(Records::Open(path_).Learners().size(), 1U);
}

TEST_F(RecordsRefusal, OfAFileThatMayOnlyBeRead) {
  Fill(1);
  fs::permissions(folder_, fs::perms::all);
  fs::permissions(path_, static_cast<fs::perms>(0444));
  fs::remove(path_ + "-lock");
  const std::string line = InChild([&] {
    BecomeNobody();
    Records::Open(path_);
    return std::string("opened");
  });
  EXPECT_EQ(line, path_ +
                      ": these records can only be read; give write permission to file and "
                      "folder");
  EXPECT_EQ(InChild([&] {
              BecomeNobody();
              return std::to_string(Records::OpenToRead(path_).Trials("bat").size());
            }),
            "1");
}

TEST_F(RecordsRefusal, OfAFolderThatMayOnlyBeRead) {
  Fill(1);
  fs::remove(path_ + "-lock");
  fs::permissions(path_, static_cast<fs::perms>(0444));
  fs::permissions(folder_, static_cast<fs::perms>(0555));
  const std::string line = InChild([&] {
    BecomeNobody();
    Records::Open(path_);
    return std::string("opened");
  });
  EXPECT_EQ(line, path_ + ": these records can only be read; give write permission to the folder");
  const std::string other = (folder_ / "new.sqlite").string();
  EXPECT_EQ(InChild([&] {
              BecomeNobody();
              Records::Open(other);
              return std::string("opened");
            }),
            other + ": cannot be made: Permission denied; name another place by --records");
  EXPECT_EQ(InChild([&] {
              BecomeNobody();
              return std::to_string(Records::OpenToRead(path_).Trials("bat").size());
            }),
            "1");
}

TEST_F(RecordsRefusal, OfAFileThatMayNotBeRead) {
  Fill(1);
  fs::permissions(folder_, fs::perms::all);
  fs::permissions(path_, fs::perms::none);
  EXPECT_EQ(InChild([&] {
              BecomeNobody();
              Records::OpenToRead(path_);
              return std::string("opened");
            }),
            path_ +
                ": the records cannot be opened; give read and write permission to file and "
                "folder");
}

// A limit on file sizes stands for a full disk: the write fails in the same way.
TEST_F(RecordsRefusal, OfATrialForWhichThereIsNoRoomLosesNoEarlierOne) {
  Fill(3);
  const std::string answer = InChild([&] {
    Records records = Records::Open(path_);
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{fs::file_size(path_) + 3 * 4096, RLIM_INFINITY};
    setrlimit(RLIMIT_FSIZE, &limit);
    int added = 0;
    try {
      for (; added < 10'000; ++added) records.Add("bat", "learn-moon", NumberedTrial(3 + added));
    } catch (const LackError& error) {
      // what is there can still be read
      if (records.Trials("bat").size() != static_cast<std::size_t>(3 + added)) return std::string();
      return std::to_string(added) + error.what();
    }
    return std::string("no error");
  });
  const std::size_t added = std::strtoul(answer.c_str(), nullptr, 10);
  EXPECT_GT(added, 0U);
  EXPECT_EQ(answer, std::to_string(added) + path_ +
                        ": no room left for the records; make room on the disk and go on");
  Records records = Records::Open(path_);
  EXPECT_EQ(records.Trials("bat").size(), 3 + added);
  records.Add("bat", "learn-moon", NumberedTrial(0));
}

TEST_F(RecordsRefusal, TakesAnEmptyFileForANewOne) {
  WriteBytes(path_, "");
  Records::Open(path_).AddLearner(Named("bat"));
  EXPECT_EQ(Records::OpenToRead(path_).Learners().size(), 1U);
}

class SlowRecordsRefusal : public RecordsRefusal {};

// Beyond 64 MB tracks are left out of the check at opening; the rest is not.
TEST_F(SlowRecordsRefusal, OfALargeFileWithADamagedPage) {
  Fill();
  const std::string good = BytesOf(path_);
  Database(path_, true).Run("INSERT INTO track VALUES (1, zeroblob(70000000))");
  EXPECT_EQ(Records::Open(path_).Trials("bat").size(), 20U);
  std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
  // the first page that holds trials
  file.seekp(static_cast<std::streamoff>(good.find("04-jnz") / 4096 * 4096));
  file << std::string(512, '\xa5') << std::flush;
  const std::string line = RefusalOf<InputError>([&] { Records::Open(path_); });
  EXPECT_NE(line.find("the records are damaged"), std::string::npos) << line;
}

}  // namespace
}  // namespace moontrace
