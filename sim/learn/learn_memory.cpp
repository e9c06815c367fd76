#include "sim/learn/learn_memory.h"

#include <algorithm>
#include <exception>
#include <string_view>
#include <utility>

#include "lessons/progress/learning.h"

namespace moontrace {

namespace {
// Kinds and texts of events, in the records of all learners: never changed.
constexpr std::string_view kSaidKind = "said", kDeviceKind = "device";
constexpr std::string_view kBriefText = "brief", kFullText = "full";
}  // namespace

LearnMemory::LearnMemory(Records records, LearnerEntry learner, std::string course, bool fresh)
    : records_(std::move(records)),
      learner_(std::move(learner)),
      course_(std::move(course)),
      fresh_(fresh) {
  if (fresh_) return;
  for (const RecordedEvent& event : records_->Events(learner_.pseudonym)) {
    if (event.kind == kSaidKind) brief_ = event.text == kBriefText;
    if (event.kind == kOwnTextEvent) own_text_ = event.text;
    if (event.kind == kDeviceKind) device_ = event.text;
  }
}

void LearnMemory::Admit() {
  if (!fresh_) return;
  records_->AddLearner(learner_);
  fresh_ = false;
}

Progress LearnMemory::Recall(const Course& course) const {
  Progress progress;
  if (!records_ || fresh_) return progress;
  for (const Trial& trial : records_->Trials(learner_.pseudonym, course_)) {
    progress = Learn(course, std::move(progress), trial);
  }
  return progress;
}

std::size_t LearnMemory::trials() const {
  if (!records_ || fresh_) return 0;
  const std::vector<Trial> rows = records_->Trials(learner_.pseudonym, course_);
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [](const Trial& row) { return !row.item.empty(); }));
}

/// Throws what Records::Add throws; what is kept by then stands no longer among the held back.
void LearnMemory::Flush() {
  while (!held_back_.empty()) {
    const Row& first = held_back_.front();
    records_->Add(learner_.pseudonym, course_, first.trial, first.track);
    held_back_.erase(held_back_.begin());
  }
}

std::string LearnMemory::Keep(const Trial& trial, const std::vector<double>& track) {
  if (!records_) return {};
  held_back_.push_back({trial, track});
  try {
    Flush();
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

std::size_t LearnMemory::KeepRest() {
  if (!records_) return 0;
  try {
    Flush();
  } catch (const std::exception&) {
    // said when it first failed
  }
  return held_back_.size();
}

void LearnMemory::SetConsent(bool keeps_tracks, const std::string& version) {
  if (records_) records_->SetConsent(learner_.pseudonym, keeps_tracks, version);
  learner_.keeps_tracks = keeps_tracks;
  learner_.consent = version;
}

void LearnMemory::SetBrief(std::int64_t time, bool brief) {
  if (brief == brief_) return;
  brief_ = brief;
  Note(time, std::string(kSaidKind), std::string(brief ? kBriefText : kFullText));
}

void LearnMemory::SetOwnText(std::int64_t time, const std::string& text) {
  if (text == own_text_) return;
  own_text_ = text;
  Note(time, std::string(kOwnTextEvent), text);
}

void LearnMemory::SetDevice(std::int64_t time, const std::string& name) {
  if (name == device_) return;
  device_ = name;
  Note(time, std::string(kDeviceKind), name);
}

std::vector<std::string> DevicesOf(const std::vector<RecordedEvent>& events) {
  std::vector<std::string> devices;
  for (const RecordedEvent& event : events) {
    if (event.kind != kDeviceKind) continue;
    devices.erase(std::remove(devices.begin(), devices.end(), event.text), devices.end());
    devices.push_back(event.text);
  }
  return devices;
}

void LearnMemory::Note(std::int64_t time, const std::string& kind, const std::string& text) {
  if (!records_) return;
  try {
    records_->AddEvent(learner_.pseudonym, {time, kind, text});
  } catch (const std::exception&) {
    // an event is no trial: the next row that fails reports it
  }
}

}  // namespace moontrace
