#include "lessons/records/learner_history.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "lessons/records/trial_fields.h"
#include "textures/base/error.h"
#include "textures/base/json_cost.h"
#include "textures/base/nearest_word.h"
#include "textures/base/overload.h"
#include "textures/base/text_file.h"
#include "textures/base/utf8.h"

namespace moontrace {

namespace {

using Json = nlohmann::ordered_json;  // for writing, keeps order; finding a key takes linear time
using ReadJson = nlohmann::json;      // for reading: finding a key stays quick in hostile files

constexpr const char* kFormat = "moontrace-learner";
constexpr const char* kResearchFormat = "moontrace-research";
constexpr int kVersion = 1;
constexpr std::size_t kGreatestText = std::size_t{256} << 20U;
constexpr std::size_t kGreatestValues = 20'000'000;
constexpr std::size_t kLongestPseudonym = 60;
constexpr std::size_t kLongestWords = 10'000;  // [bytes], of one text in an export
constexpr std::size_t kGreatestDepth = 5;      // {"trials": [{"track": [number]}]}
constexpr const char* kCure = "use an unaltered export";

Json JsonOf(const TrialField::Value& value, TrialField::Kind kind) {
  const auto of_whole = [kind](std::int64_t whole) {
    return kind == TrialField::Kind::kFlag ? Json(whole != 0) : Json(whole);
  };
  return std::visit(Overload{of_whole, [](double real) { return Json(real); },
                             [](const std::string& text) { return Json(text); }},
                    value);
}

Json JsonOf(const Trial& trial) {
  Json json = Json::object();
  for (const TrialField& field : TrialFields()) {
    json[field.name] = JsonOf(field.get(trial), field.kind);
  }
  return json;
}

/// The head as it is, then one line for each trial, event and document: long, but a person can look
/// at it. Who reads nothing has no list of documents, as before there were any.
std::string Lines(const Json& head, const Json& trials, const Json& events,
                  const Json& readings = {}) {
  const auto dump = [](const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  std::string text = dump(head);
  text.pop_back();  // the brace
  const auto append = [&](const char* key, const Json& rows) {
    text += fmt::format(",\n\"{}\": [", key);
    const char* separator = "\n";
    for (const Json& row : rows) {
      text += separator + dump(row);
      separator = ",\n";
    }
    text += "]";
  };
  append("trials", trials);
  append("events", events);
  if (!readings.empty()) append("readings", readings);
  return text + "}\n";
}

/// What is being read, for messages: "bob.json: trial 3".
[[noreturn]] void Refuse(const std::string& where, const std::string& what) {
  throw InputError(fmt::format("{}: {}; {}", where, what, kCure));
}

/// Bounds on nesting (destructors recurse) and on values (each costs many times its text).
ReadJson Parse(std::string_view text, const std::string& name) {
  if (text.size() > kGreatestText) {
    throw InputError(fmt::format("{}: more than {} MB; exports without tracks are smaller", name,
                                 kGreatestText >> 20U));
  }
  const JsonCost cost = CostOf(text);
  if (cost.depth > kGreatestDepth)
    Refuse(name, fmt::format("nested more than {} deep", kGreatestDepth));
  if (cost.values > kGreatestValues)
    Refuse(name, fmt::format("more than {} values", kGreatestValues));
  try {
    return ReadJson::parse(text);
  } catch (const ReadJson::parse_error& error) {
    const TextPlace place = PlaceOf(text, error.byte == 0 ? 0 : error.byte - 1);
    Refuse(fmt::format("{}:{}:{}", name, place.line, place.column), "not JSON");
  } catch (const ReadJson::exception&) {
    Refuse(name, "a number is out of range");
  }
}

/// One JSON object; every member must be asked for once, none may be left over.
class Members {
 public:
  Members(const ReadJson& json, std::string where) : where_(std::move(where)), json_(json) {
    if (!json.is_object()) Refuse(where_, "not an object");
  }

  const ReadJson& Get(const char* key, bool (ReadJson::*is)() const noexcept, const char* type) {
    known_.emplace_back(key);
    const auto found = json_.find(key);
    if (found == json_.end()) Refuse(where_, fmt::format("\"{}\" is missing", key));
    if (!((*found).*is)()) Refuse(where_, fmt::format("\"{}\" is not {}", key, type));
    return *found;
  }
  std::int64_t Whole(const char* key) {
    const ReadJson& json = Get(key, &ReadJson::is_number_integer, "a whole number");
    if (json.is_number_unsigned() && json.get<std::uint64_t>() > INT64_MAX) {
      Refuse(where_, fmt::format("\"{}\" is too large", key));
    }
    return json.get<std::int64_t>();
  }
  double Real(const char* key) { return Get(key, &ReadJson::is_number, "a number").get<double>(); }
  bool Flag(const char* key) {
    return Get(key, &ReadJson::is_boolean, "true or false").get<bool>();
  }
  std::string Words(const char* key) {
    std::string text = Get(key, &ReadJson::is_string, "a text").get<std::string>();
    if (text.size() > kLongestWords) {
      Refuse(where_, fmt::format("\"{}\" is longer than {} bytes", key, kLongestWords));
    }
    return text;
  }
  const ReadJson& List(const char* key) { return Get(key, &ReadJson::is_array, "a list"); }
  bool Has(const char* key) const { return json_.contains(key); }

  void RequireNoOther() const {
    for (const auto& item : json_.items()) {
      if (std::find(known_.begin(), known_.end(), item.key()) != known_.end()) continue;
      const std::string nearest = NearestWord(item.key(), known_);
      Refuse(where_, fmt::format("\"{}\" is unknown{}", OneLine(item.key()),
                                 nearest.empty() ? "" : ", did you mean \"" + nearest + "\"?"));
    }
  }
  const std::string& where() const { return where_; }

 private:
  std::string where_;
  const ReadJson& json_;
  std::vector<std::string> known_;
};

TrialField::Value ReadValue(Members& members, const TrialField& field) {
  switch (field.kind) {
    case TrialField::Kind::kFlag:
      return std::int64_t{members.Flag(field.name)};
    case TrialField::Kind::kWhole:
      return members.Whole(field.name);
    case TrialField::Kind::kReal:
      return members.Real(field.name);
    case TrialField::Kind::kText:
      break;
  }
  return members.Words(field.name);
}

RecordedTrial ReadTrial(const ReadJson& json, const std::string& where) {
  Members members(json, where);
  RecordedTrial row;
  row.course = members.Words("course");
  for (const TrialField& field : TrialFields()) {
    if (!field.set(row.trial, ReadValue(members, field))) {
      Refuse(where, fmt::format("\"{}\" cannot be {}", field.name,
                                OneLine(json.at(field.name).dump(), 40)));
    }
  }
  if (members.Has("track")) {
    for (const ReadJson& number : members.List("track")) {
      if (!number.is_number()) Refuse(where, "\"track\" holds what is not a number");
      row.track.push_back(number.get<double>());
    }
  }
  members.RequireNoOther();
  return row;
}

Json JsonOf(const ReadPlace& place) {
  return {{"letter", place.letter}, {"before", place.before}, {"behind", place.behind}};
}

Json JsonOf(const ReadDocument& reading) {
  Json json{{"content", reading.content},  {"path", reading.path},     {"title", reading.title},
            {"time_unix_s", reading.time}, {"length", reading.length}, {"where", reading.where}};
  json.update(JsonOf(reading.place));
  if (!reading.landmarks.empty()) json["landmarks"] = reading.landmarks;
  for (const ReadMark& mark : reading.marks) {
    Json one{{"name", mark.name}};
    one.update(JsonOf(mark.place));
    json["bookmarks"].push_back(std::move(one));
  }
  return json;
}

ReadPlace ReadPlaceOf(Members& members) {
  ReadPlace place{members.Whole("letter"), members.Words("before"), members.Words("behind")};
  if (place.letter < 0) Refuse(members.where(), "\"letter\" is below 0");
  return place;
}

ReadDocument ReadReading(const ReadJson& json, const std::string& where) {
  Members members(json, where);
  ReadDocument reading;
  reading.content = members.Words("content");
  reading.path = members.Words("path");
  reading.title = members.Words("title");
  reading.time = members.Whole("time_unix_s");
  reading.length = members.Whole("length");
  reading.where = members.Words("where");
  reading.place = ReadPlaceOf(members);
  if (members.Has("landmarks")) reading.landmarks = members.Words("landmarks");
  if (members.Has("bookmarks")) {
    for (const ReadJson& row : members.List("bookmarks")) {
      Members mark(row, where + ": bookmark");
      std::string name = mark.Words("name");
      reading.marks.push_back({std::move(name), ReadPlaceOf(mark)});
      mark.RequireNoOther();
    }
  }
  members.RequireNoOther();
  return reading;
}

LearnerEntry ReadLearner(const ReadJson& json, const std::string& name) {
  Members members(json, name + ": learner");
  LearnerEntry learner;
  learner.pseudonym = members.Words("pseudonym");
  learner.since = members.Whole("since_unix_s");
  learner.keeps_tracks = members.Flag("keeps_tracks");
  learner.consent = members.Words("consent");
  learner.simulated = members.Flag("simulated");
  members.RequireNoOther();
  try {
    RequirePseudonym(learner.pseudonym);
  } catch (const InputError& error) {
    throw InputError(members.where() + ": " + error.what());
  }
  return learner;
}

/// Version and kind of file, before anything else is asked of it.
void RequireFormat(const ReadJson& json, const std::string& name) {
  const auto format = json.is_object() ? json.find("format") : json.end();
  const bool found = json.is_object() && format != json.end();
  if (found && *format == kResearchFormat) {
    throw InputError(name +
                     ": an anonymous export has no learner; import one made without "
                     "--anonymous");
  }
  if (!found || *format != kFormat) {
    throw InputError(name + ": not an export of a learner; make one by records export");
  }
  const auto version = json.find("version");
  if (version == json.end() || *version != kVersion) {
    throw InputError(
        fmt::format("{}: of another version than {}; update this program", name, kVersion));
  }
}

}  // namespace

void RequirePseudonym(std::string_view pseudonym) {
  const std::size_t length = CountCharacters(pseudonym);
  const bool good = length >= 1 && length <= kLongestPseudonym && !FirstBadUtf8(pseudonym) &&
                    !HasHidden(pseudonym) &&
                    pseudonym.find_first_of("/\\") == std::string_view::npos &&
                    pseudonym.find_first_not_of(' ') != std::string_view::npos;
  if (good) return;
  throw InputError(fmt::format("learner \"{}\": choose a name of 1 to {} letters, without a slash",
                               OneLine(pseudonym), kLongestPseudonym));
}

std::string ShownPseudonym(std::string_view pseudonym) {
  return OneLine(pseudonym, 4 * kLongestPseudonym);  // a character takes 4 bytes at most
}

std::string HistoryToJson(const LearnerHistory& history) {
  const LearnerEntry& learner = history.learner;
  const Json head{{"format", kFormat},
                  {"version", kVersion},
                  {"learner",
                   {{"pseudonym", learner.pseudonym},
                    {"since_unix_s", learner.since},
                    {"keeps_tracks", learner.keeps_tracks},
                    {"consent", learner.consent},
                    {"simulated", learner.simulated}}}};
  Json trials = Json::array();
  for (const RecordedTrial& row : history.trials) {
    Json json{{"course", row.course}};
    json.update(JsonOf(row.trial));
    if (!row.track.empty()) json["track"] = row.track;
    trials.push_back(std::move(json));
  }
  Json events = Json::array();
  for (const RecordedEvent& event : history.events) {
    events.push_back({{"time_unix_s", event.time}, {"kind", event.kind}, {"text", event.text}});
  }
  Json readings = Json::array();
  for (const ReadDocument& reading : history.readings) readings.push_back(JsonOf(reading));
  return Lines(head, trials, events, readings);
}

LearnerHistory HistoryFromJson(std::string_view text, const std::string& name) {
  const ReadJson json = Parse(text, name);
  RequireFormat(json, name);
  Members members(json, name);
  members.Get("format", &ReadJson::is_string, "a text");
  members.Whole("version");
  LearnerHistory history;
  history.learner = ReadLearner(members.Get("learner", &ReadJson::is_object, "an object"), name);
  std::size_t number = 0;
  for (const ReadJson& row : members.List("trials")) {
    history.trials.push_back(ReadTrial(row, fmt::format("{}: trial {}", name, ++number)));
  }
  number = 0;
  for (const ReadJson& row : members.List("events")) {
    Members event(row, fmt::format("{}: event {}", name, ++number));
    const std::int64_t time = event.Whole("time_unix_s");
    history.events.push_back({time, event.Words("kind"), event.Words("text")});
    event.RequireNoOther();
  }
  number = 0;
  if (members.Has("readings")) {
    for (const ReadJson& row : members.List("readings")) {
      history.readings.push_back(ReadReading(row, fmt::format("{}: reading {}", name, ++number)));
    }
  }
  members.RequireNoOther();
  return history;
}

std::string ResearchJson(const LearnerHistory& history) {
  std::int64_t begin = history.trials.empty() ? 0 : history.trials.front().trial.time;
  std::set<std::string> items{"", "same", "different"};
  for (const RecordedTrial& row : history.trials) {
    begin = std::min(begin, row.trial.time);
    const std::string& shown = row.trial.item;
    const std::size_t first = std::min(shown.find('\n'), shown.size());
    items.insert(shown.substr(0, first));
    if (first < shown.size()) items.insert(shown.substr(first + 1));
  }
  // a person's demonstration on a simulated device is none of a person's trials either
  bool simulated = history.learner.simulated;
  Json trials = Json::array();
  for (const RecordedTrial& row : history.trials) {
    simulated = simulated || row.trial.simulated;
    Json json{{"course", row.course}, {"time_s", row.trial.time - begin}};
    json.update(JsonOf(row.trial));
    json.erase("time_unix_s");
    if (items.count(row.trial.answer) == 0) json["answer"] = "other";
    trials.push_back(std::move(json));
  }
  Json events = Json::array();
  for (const RecordedEvent& event : history.events) {
    events.push_back({{"time_s", event.time - begin}, {"kind", event.kind}});
  }
  Json fields = Json::array({"course", "time_s"});
  for (const TrialField& field : TrialFields()) {
    if (std::string_view(field.name) != "time_unix_s") fields.push_back(field.name);
  }
  const Json head{
      {"format", kResearchFormat},
      {"version", kVersion},
      {"left_out", {"pseudonym", "dates", "texts of events", "documents read", "tracks"}},
      {"trial_fields", std::move(fields)},
      {"event_fields", {"time_s", "kind"}},
      {"simulated", simulated}};
  return Lines(head, trials, events);
}

}  // namespace moontrace
