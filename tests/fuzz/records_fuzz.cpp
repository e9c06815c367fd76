// Any bytes are a records file or are refused by one line; what was taken can be listed, exported
// and written to. Bytes that do not begin as a SQLite file are changes to a good one, three for
// each: two for the place, one for what stands there then. So they get past its outer shell.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "lessons/records/learner_history.h"
#include "lessons/records/records.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHead("SQLite format 3\0", 16);

/// A folder that goes with the program.
class Folder {
 public:
  Folder() {
    const fs::path memory("/dev/shm");
    path_ = (access(memory.c_str(), W_OK) == 0 ? memory : fs::temp_directory_path()) /
            "moontrace-fuzz-XXXXXX";
    if (mkdtemp(path_.data()) == nullptr) std::abort();
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string File() const { return path_ + "/records.sqlite"; }
  void Clear() const {
    for (const auto& entry : fs::directory_iterator(path_)) fs::remove_all(entry.path());
  }

 private:
  std::string path_;
};

Trial SomeTrial() {
  Trial trial;
  trial.time = 1'700'000'000;
  trial.lesson = "04-itlo";
  trial.item = std::string("i");
  trial.answer = std::string("l");
  return trial;
}

/// Two learners, trials, tracks and events of each.
std::string GoodFile(const Folder& folder) {
  folder.Clear();
  {
    Records records = Records::Open(folder.File());
    for (const char* name : {"bat", "owl"}) {
      LearnerEntry learner;
      learner.pseudonym = name;
      learner.keeps_tracks = true;
      records.AddLearner(learner);
      for (int i = 0; i < 3; ++i) records.Add(name, "learn-moon", SomeTrial(), {1.0, 2.0, 3.0 * i});
      records.AddEvent(name, {7, "tutor", "size 20"});
    }
  }
  std::ifstream file(folder.File(), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string Changed(std::string file, std::string_view changes) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(changes[at]); };
  for (std::size_t at = 0; at + 3 <= changes.size(); at += 3) {
    file[(byte(at) + 256U * byte(at + 1)) % file.size()] = static_cast<char>(byte(at + 2));
  }
  return file;
}

void RequireOneLine(std::string_view line) {
  if (line.empty() || line.find('\n') != std::string_view::npos) std::abort();
}

/// All that the commands do with a file.
void Use(const std::string& path) {
  {
    const Records records = Records::OpenToRead(path);
    for (const LearnerEntry& learner : records.Learners()) {
      RequireOneLine(ShownPseudonym(learner.pseudonym) + ".");
      records.Courses(learner.pseudonym);
      records.LastCourse(learner.pseudonym);
      records.ExportAnonymous(learner.pseudonym);
      records.Export(learner.pseudonym);
    }
  }
  Records records = Records::Open(path);
  LearnerEntry learner;
  learner.pseudonym = "newcomer";
  if (!records.Find(learner.pseudonym)) records.AddLearner(learner);
  records.Add(learner.pseudonym, "learn-moon", SomeTrial());
  if (records.Trials(learner.pseudonym).empty()) std::abort();
  records.Erase(learner.pseudonym);
}

}  // namespace
}  // namespace moontrace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace moontrace;
  if (!Records::Available()) return 0;
  static const Folder folder;
  static const std::string good = GoodFile(folder);
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const bool whole = input.substr(0, kHead.size()) == kHead;
  folder.Clear();
  std::ofstream(folder.File(), std::ios::binary)
      << (whole ? std::string(input) : Changed(good, input));
  try {
    Use(folder.File());
  } catch (const InputError& error) {
    RequireOneLine(error.what());
  } catch (const LackError& error) {
    RequireOneLine(error.what());
  }
  return 0;
}
