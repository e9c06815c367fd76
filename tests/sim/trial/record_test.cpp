#include "sim/trial/record.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "sim/trial/record_columns.h"
#include "tests/sim/record_fixture.h"

namespace moontrace::test {
namespace {

namespace fs = std::filesystem;

bool SameBits(const RecordRow& a, const RecordRow& b) {
  const RecordColumns x = ToColumns(a);
  const RecordColumns y = ToColumns(b);
  return std::memcmp(x.data(), y.data(), kRowBytes) == 0;
}

void ExpectOneLineWith(const std::string& line, const std::string& part) {
  EXPECT_NE(line.find(part), std::string::npos) << line;
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
}

std::vector<std::string> NamesIn(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

/// Files that a process of ours may write are held to `bytes` while this lives: the same as a full
/// disk, for any user.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    handler_ = ::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

class RecordTest : public testing::Test {
 protected:
  TempFolder temp_;
  TextureField field_ = GrooveField();
  Scene scene_ = SceneAtRest(field_, RubbingOptions());
  std::string folder_ = temp_ / "trial";

  std::string ReadRefusal() const {
    return LineOf<InputError>([&] { ReadRecord(folder_); });
  }
  std::string OpenRefusal(const std::string& folder) const {
    return LineOf<InputError>([&] { Recorder(folder, HeadFor(field_), scene_); });
  }
  std::string OpenLack(const std::string& folder) const {
    return LineOf<LackError>([&] { Recorder(folder, HeadFor(field_), scene_); });
  }
};

TEST_F(RecordTest, ReadsBackWhatWasWritten) {
  const std::vector<double> state = scene_.State();
  const std::vector<RecordRow> rows = RecordTicks(folder_, field_, scene_, 0, 2500);
  const Record record = ReadRecord(folder_);
  EXPECT_EQ(record.rows.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) ASSERT_TRUE(SameBits(record.rows[i], rows[i])) << i;
  ASSERT_EQ(record.state.size(), state.size());
  EXPECT_EQ(std::memcmp(record.state.data(), state.data(), 8 * state.size()), 0);
  EXPECT_EQ(record.model_xml, scene_.model_xml());
  EXPECT_EQ(record.options.friction, 0.1);
  EXPECT_EQ(record.options.tilt, 0.2);
  EXPECT_EQ(record.head.parameters_json, R"({"size_mm":12,"text":"MOON"})");
  EXPECT_EQ(record.head.seed, 18446744073709551615U);
  EXPECT_EQ(record.head.field_hash, field_.Hash());
  EXPECT_EQ(record.result_json, R"({"coverage":0.5})");
  EXPECT_EQ(record.altered, "");
}

TEST_F(RecordTest, KeepsEveryBitOfStrangeRows) {
  std::vector<RecordRow> rows(3);
  rows[0].input.time = -0.0;
  rows[0].input.p_D = {std::numeric_limits<double>::quiet_NaN(), 5e-324, -1e308};
  rows[1].input.v_D = {std::numeric_limits<double>::infinity(), -0.0, 1.0 / 3.0};
  rows[1].input.velocity_known = true;
  rows[1].input.buttons = 0xffffffffU;
  rows[2].output.fault = true;
  rows[2].output.energy_out = -1e-9;
  Recorder recorder(folder_, HeadFor(field_), scene_);
  for (const RecordRow& row : rows) recorder.Add(row);
  recorder.Finish("{}", false);
  const Record record = ReadRecord(folder_);
  ASSERT_EQ(record.rows.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(SameBits(record.rows[i], rows[i])) << i;
  EXPECT_EQ(record.rows[1].input.buttons, 0xffffffffU);
  EXPECT_TRUE(record.rows[1].input.velocity_known);
  EXPECT_TRUE(record.rows[2].output.fault);
}

TEST_F(RecordTest, MayHoldNoTickAtAll) {
  Recorder(folder_, HeadFor(field_), scene_).Finish("{}", true);
  EXPECT_TRUE(ReadRecord(folder_).rows.empty());
}

TEST_F(RecordTest, OfTheSameInputsHasTheSameBytesButForTheTime) {
  RecordTicks(folder_, field_, scene_, 0, 1500, true);
  Scene again = SceneAtRest(field_, RubbingOptions());
  const std::string other = temp_ / "other";
  RecordTicks(other, field_, again, 0, 1500, true);
  for (const char* name : {"/samples.f64", "/model.xml", "/events.jsonl", "/samples.csv"}) {
    EXPECT_EQ(ReadBytes(folder_ + name), ReadBytes(other + name)) << name;
    EXPECT_FALSE(ReadBytes(other + name).empty()) << name;
  }
  nlohmann::json a = nlohmann::json::parse(ReadBytes(folder_ + "/trial.json"));
  nlohmann::json b = nlohmann::json::parse(ReadBytes(other + "/trial.json"));
  a["start_time_utc"] = b["start_time_utc"];
  a["digests"]["trial.json"] = b["digests"]["trial.json"];
  EXPECT_EQ(a, b);
}

TEST_F(RecordTest, SaysWhatTheColumnsAreAndHowItWasMade) {
  RecordTicks(folder_, field_, scene_, 0, 10);
  const nlohmann::json json = nlohmann::json::parse(ReadBytes(folder_ + "/trial.json"));
  EXPECT_EQ(json["schema_version"], 1);
  EXPECT_EQ(json["samples"]["columns"].size() * 8 * 10, fs::file_size(folder_ + "/samples.f64"));
  EXPECT_EQ(json["samples"]["ticks"], 10);
  EXPECT_EQ(json["subject"]["kind"], "simulated");
  EXPECT_EQ(json["scene"]["friction"], 0.1);
  EXPECT_GE(json["program"]["mujoco_run"], 222);
  EXPECT_NE(json["program"]["flags"], "");
  const std::string time = json["start_time_utc"];
  EXPECT_EQ(time.size(), std::string("2025-01-31T12:00:00Z").size());
  EXPECT_EQ(time.back(), 'Z');
}

TEST_F(RecordTest, AsTextHasUnitsInTheNamesAndEveryDigit) {
  const std::vector<RecordRow> rows = RecordTicks(folder_, field_, scene_, 0, 300, true);
  std::istringstream csv(ReadBytes(folder_ + "/samples.csv"));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line.substr(0, 30), "time_s,device_x_m,device_y_m,d");
  for (const RecordRow& row : rows) {
    const RecordColumns columns = ToColumns(row);
    ASSERT_TRUE(std::getline(csv, line));
    std::istringstream cells(line);
    for (const double value : columns) {
      std::string cell;
      std::getline(cells, cell, ',');
      EXPECT_EQ(std::stod(cell), value);
    }
  }
  EXPECT_FALSE(std::getline(csv, line));
}

TEST_F(RecordTest, StandsUnderItsNameOnlyOnceFinished) {
  Recorder recorder(folder_, HeadFor(field_), scene_);
  recorder.Add({});
  EXPECT_FALSE(fs::exists(folder_));
  recorder.Finish("{}", false);
  EXPECT_TRUE(fs::exists(folder_ + "/trial.json"));
  EXPECT_EQ(NamesIn(temp_.path()), std::vector<std::string>{"trial"});
}

TEST_F(RecordTest, IsRemovedWhenAbandoned) {
  {
    Recorder recorder(folder_, HeadFor(field_), scene_);
    for (int i = 0; i < 5000; ++i) recorder.Add({});
  }
  EXPECT_TRUE(NamesIn(temp_.path()).empty());
}

TEST_F(RecordTest, IsRemovedWhenTheResultsAreNoJson) {
  Recorder recorder(folder_, HeadFor(field_), scene_);
  EXPECT_THROW(recorder.Finish("{", false), InputError);
  EXPECT_TRUE(NamesIn(temp_.path()).empty());
}

TEST_F(RecordTest, GoesIntoAnEmptyFolderAndWithASlashAtTheEnd) {
  fs::create_directory(folder_);
  RecordTicks(folder_ + "/", field_, scene_, 0, 10);
  EXPECT_EQ(ReadRecord(folder_).rows.size(), 10U);
}

TEST_F(RecordTest, RefusesAFolderThatIsTaken) {
  fs::create_directory(folder_);
  WriteBytes(folder_ + "/mine", "x");
  ExpectOneLineWith(OpenRefusal(folder_), "exists and is not an empty folder");
  ExpectOneLineWith(OpenRefusal(folder_ + "/mine"), "exists and is not an empty folder");
  fs::create_directory_symlink(temp_.path(), temp_ / "link");
  ExpectOneLineWith(OpenRefusal(temp_ / "link"), "exists and is not an empty folder");
  ExpectOneLineWith(OpenRefusal(""), "no folder is named");
  EXPECT_EQ(ReadBytes(folder_ + "/mine"), "x");
  EXPECT_FALSE(fs::exists(folder_ + ".partial"));
}

TEST_F(RecordTest, DoesNotReplaceWhatAppearedMeanwhile) {
  Recorder recorder(folder_, HeadFor(field_), scene_);
  fs::create_directory(folder_);
  WriteBytes(folder_ + "/mine", "x");
  EXPECT_THROW(recorder.Finish("{}", false), InputError);
  EXPECT_EQ(NamesIn(temp_.path()), std::vector<std::string>{"trial"});
  EXPECT_EQ(ReadBytes(folder_ + "/mine"), "x");
}

TEST_F(RecordTest, RefusesToDisturbAnotherRecording) {
  Recorder first(folder_, HeadFor(field_), scene_);
  ExpectOneLineWith(OpenRefusal(folder_), "another recording runs");
  ExpectOneLineWith(LineOf<InputError>([&] { CheckRecordFolder(folder_); }),
                    "another recording runs");
  first.Finish("{}", false);
  EXPECT_TRUE(ReadRecord(folder_).rows.empty());
}

TEST_F(RecordTest, ReplacesWhatAKilledOneLeftBehind) {
  const pid_t child = fork();
  if (child == 0) {
    Recorder recorder(folder_, HeadFor(field_), scene_);
    for (int i = 0; i < 5000; ++i) recorder.Add({});
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  ASSERT_TRUE(fs::exists(folder_ + ".partial/samples.f64"));
  CheckRecordFolder(folder_);
  RecordTicks(folder_, field_, scene_, 0, 10);
  EXPECT_EQ(ReadRecord(folder_).rows.size(), 10U);
  EXPECT_EQ(NamesIn(temp_.path()), std::vector<std::string>{"trial"});
}

TEST_F(RecordTest, ReplacesNothingThatNoRecordingWrote) {
  fs::create_directory(folder_ + ".partial");
  WriteBytes(folder_ + ".partial/samples.f64", "x");
  WriteBytes(folder_ + ".partial/mine", "x");
  const std::string words = "is no recording's; move it or name another folder";
  ExpectOneLineWith(OpenRefusal(folder_), words);
  ExpectOneLineWith(LineOf<InputError>([&] { CheckRecordFolder(folder_); }), words);
  EXPECT_EQ(ReadBytes(folder_ + ".partial/mine"), "x");
  EXPECT_EQ(ReadBytes(folder_ + ".partial/samples.f64"), "x");
  fs::remove_all(folder_ + ".partial");
  fs::create_directory(temp_ / "elsewhere");
  fs::create_directory_symlink(temp_ / "elsewhere", folder_ + ".partial");
  ExpectOneLineWith(OpenRefusal(folder_), words);
  EXPECT_TRUE(fs::is_empty(temp_ / "elsewhere"));
}

TEST_F(RecordTest, NamesAFolderThatCannotBeWritten) {
  WriteBytes(temp_ / "file", "");
  ExpectOneLineWith(OpenLack(temp_ / "file/trial"), "cannot be made (Not a directory)");
  ExpectOneLineWith(OpenLack(temp_ / "none/trial"), "cannot be made (No such file or directory)");
  ExpectOneLineWith(OpenLack("/proc/trial"), "cannot be made");  // not even root can
}

TEST_F(RecordTest, EndsInOneLineOnAFullDiskAndLeavesNothing) {
  Recorder recorder(folder_, HeadFor(field_), scene_);
  std::string line;
  {
    const FileSizeLimit limit(100000);
    for (int i = 0; i < 3000 && line.empty(); ++i) {
      line = LineOf<LackError>([&] { recorder.Add({}); });
    }
  }
  ExpectOneLineWith(line, "samples.f64: no room to write");
  EXPECT_TRUE(NamesIn(temp_.path()).empty());
  EXPECT_EQ(LineOf<LackError>([&] { recorder.Add({}); }), line);
  EXPECT_EQ(LineOf<LackError>([&] { recorder.AddEvent(0, "", ""); }), line);
  EXPECT_EQ(LineOf<LackError>([&] { recorder.Finish("{}", false); }), line);
  EXPECT_TRUE(NamesIn(temp_.path()).empty());
}

TEST_F(RecordTest, NoticesAFullDiskAtTheLastMoment) {
  Recorder recorder(folder_, HeadFor(field_), scene_);
  recorder.Add({});  // stays in the buffer
  std::string line;
  {
    const FileSizeLimit limit(kRowBytes - 1);
    line = LineOf<LackError>([&] { recorder.Finish("{}", false); });
  }
  ExpectOneLineWith(line, "samples.f64: no room to write");
  EXPECT_TRUE(NamesIn(temp_.path()).empty());
}

TEST_F(RecordTest, NoticesAFullDiskAtTheStart) {
  std::string line;
  {
    const FileSizeLimit limit(10);
    line = OpenLack(folder_);
  }
  ExpectOneLineWith(line, "model.xml: no room to write");
  EXPECT_TRUE(NamesIn(temp_.path()).empty());
}

TEST_F(RecordTest, SaysHowManyTicksAreLeftWhenCutShort) {
  RecordTicks(folder_, field_, scene_, 0, 2500);
  fs::resize_file(folder_ + "/samples.f64", 1200 * kRowBytes + 5);
  ExpectOneLineWith(ReadRefusal(), "cut short: 1200 whole ticks of 2500");
  fs::resize_file(folder_ + "/samples.f64", 2500 * kRowBytes + 5);
  ExpectOneLineWith(ReadRefusal(), "5 bytes beyond its 2500 ticks");
}

TEST_F(RecordTest, NamesTheTicksWithinWhichItWasAltered) {
  RecordTicks(folder_, field_, scene_, 0, 2500);
  const std::size_t proxy_x = 12 * 8;
  FlipBit(folder_ + "/samples.f64", 1234 * kRowBytes + proxy_x, 0);
  ExpectOneLineWith(ReadRefusal(), "samples.f64: altered within ticks 1000 to 1999");
  FlipBit(folder_ + "/samples.f64", 1234 * kRowBytes + proxy_x, 0);
  EXPECT_EQ(ReadRefusal(), "");
  FlipBit(folder_ + "/samples.f64", 2500 * kRowBytes - 1, 7);
  ExpectOneLineWith(ReadRefusal(), "samples.f64: altered within ticks 2000 to 2499");
}

TEST_F(RecordTest, LetsAlteredSamplesThroughWhenTolerant) {
  RecordTicks(folder_, field_, scene_, 0, 2500);
  FlipBit(folder_ + "/samples.f64", 1234 * kRowBytes, 0);
  const Record record = ReadRecord(folder_, true);
  EXPECT_EQ(record.rows.size(), 2500U);
  ExpectOneLineWith(record.altered, "altered within ticks 1000 to 1999");
}

TEST_F(RecordTest, NamesTheTickOfAFlagThatIsNone) {
  RecordTicks(folder_, field_, scene_, 0, 100);
  const std::size_t buttons = 8 * 8;
  FlipBit(folder_ + "/samples.f64", 77 * kRowBytes + buttons, 0);
  const std::string line = LineOf<InputError>([&] { ReadRecord(folder_, true); });
  ExpectOneLineWith(line, "altered: tick 77, column buttons");
}

TEST_F(RecordTest, NamesTheFileThatWasAltered) {
  for (const std::string name : {"model.xml", "events.jsonl", "samples.csv"}) {
    const std::string folder = temp_ / ("altered-" + name);
    RecordTicks(folder, field_, scene_, 0, 10, true);
    FlipBit(folder + "/" + name, 20, 1);
    ExpectOneLineWith(LineOf<InputError>([&] { ReadRecord(folder, true); }), name + ": altered");
  }
}

TEST_F(RecordTest, NoticesAnAlteredParameter) {
  RecordTicks(folder_, field_, scene_, 0, 10);
  nlohmann::json json = nlohmann::json::parse(ReadBytes(folder_ + "/trial.json"));
  json["scene"]["page_stiffness_n_m"] = 999.0;
  WriteBytes(folder_ + "/trial.json", json.dump());
  ExpectOneLineWith(ReadRefusal(), "trial.json: altered");
}

TEST_F(RecordTest, NamesAMissingFile) {
  ExpectOneLineWith(ReadRefusal(), "no such folder");
  for (const std::string name : {"trial.json", "model.xml", "events.jsonl", "samples.f64"}) {
    const std::string folder = temp_ / ("missing-" + name);
    RecordTicks(folder, field_, scene_, 0, 10);
    fs::remove(folder + "/" + name);
    ExpectOneLineWith(LineOf<InputError>([&] { ReadRecord(folder); }), name + ": missing");
    ASSERT_EQ(::mkfifo((folder + "/" + name).c_str(), 0600), 0);  // reading it would never end
    ExpectOneLineWith(LineOf<InputError>([&] { ReadRecord(folder); }), name + ": not a readable");
  }
}

TEST_F(RecordTest, MayLoseItsTextCopy) {
  RecordTicks(folder_, field_, scene_, 0, 10, true);
  fs::remove(folder_ + "/samples.csv");
  EXPECT_EQ(ReadRefusal(), "");
}

}  // namespace
}  // namespace moontrace::test
