#include "sim/trial/trial_sheet.h"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "sim/trial/record_columns.h"
#include "textures/base/digest.h"
#include "textures/base/error.h"
#include "textures/base/json_cost.h"
#include "textures/base/text_file.h"

namespace moontrace {
namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

constexpr unsigned kSchemaVersion = 1;
constexpr std::size_t kGreatestDepth = 64;
constexpr std::size_t kGreatestValues = 1'000'000;
constexpr double kNoBound = std::numeric_limits<double>::max();
constexpr std::string_view kCure = "use an unaltered copy";

/// Parses with bounds on nesting (dump and destructors recurse) and on values (each costs many
/// times its text).
Json ParseBounded(std::string_view text, const std::string& where, std::size_t greatest_depth) {
  const JsonCost cost = CostOf(text);
  if (cost.depth > greatest_depth) {
    throw InputError(fmt::format("{}: nested more than {} deep; {}", where, greatest_depth, kCure));
  }
  if (cost.values > kGreatestValues) {
    throw InputError(fmt::format("{}: more than {} values; {}", where, kGreatestValues, kCure));
  }
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    const TextPlace place = PlaceOf(text, error.byte == 0 ? 0 : error.byte - 1);
    throw InputError(fmt::format("{}:{}:{}: not JSON; {}", where, place.line, place.column, kCure));
  } catch (const Json::exception&) {
    throw InputError(fmt::format("{}: a number is out of range; {}", where, kCure));
  }
}

/// A caller's JSON text, to be embedded in ours.
Json ParseObject(const std::string& text, const std::string& name) {
  if (text.size() > kGreatestTextBytes / 2) {
    throw InputError(fmt::format("record: {} take {} bytes; at most {} can be kept", name,
                                 text.size(), kGreatestTextBytes / 2));
  }
  Json json = ParseBounded(text, "record: " + name, kGreatestDepth - 4);
  if (!json.is_object()) throw InputError("record: " + name + ": not a JSON object; pass {...}");
  return json;
}

template <typename AnyJson>
std::string Dump(const AnyJson& json, int indent = -1) {
  return json.dump(indent, ' ', false, AnyJson::error_handler_t::replace);
}

/// Digest of the document without the member that holds it.
std::uint64_t OwnDigest(Json json) {
  json["digests"].erase("trial.json");
  return DigestOf(Dump(json));
}

/// A member of the document under its dotted name, with what it must be.
class Member {
 public:
  Member(const Json& json, std::string name, const std::string& where)
      : json_(&json), name_(std::move(name)), where_(&where) {}

  bool Has(const char* key) const { return json_->is_object() && json_->contains(key); }
  Member operator[](const char* key) const {
    std::string name = name_.empty() ? key : name_ + "." + key;
    if (!Has(key)) throw InputError(fmt::format("{}: {}: missing; {}", *where_, name, kCure));
    return {(*json_)[key], std::move(name), *where_};
  }
  Member At(std::size_t i) const { return {(*json_)[i], fmt::format("{}[{}]", name_, i), *where_}; }
  std::size_t Count() const {
    if (!json_->is_array()) Fail("not a list");
    return json_->size();
  }
  double Number(double least = -kNoBound, double greatest = kNoBound) const {
    if (!json_->is_number()) Fail("not a number");
    const auto value = json_->get<double>();
    if (!(value >= least && value <= greatest)) Fail("out of range");
    return value;
  }
  std::uint64_t Unsigned(std::uint64_t greatest) const {
    if (!json_->is_number_unsigned()) Fail("not a whole number");
    const auto value = json_->get<std::uint64_t>();
    if (value > greatest) Fail("too large");
    return value;
  }
  std::string Text() const {
    if (!json_->is_string()) Fail("not a text");
    return json_->get<std::string>();
  }
  std::uint64_t Hex() const {
    const auto value = FromHex(Text());
    if (!value) Fail("not 0x and sixteen digits");
    return *value;
  }
  std::string ObjectText() const {
    if (!json_->is_object()) Fail("not an object");
    return Dump(*json_);
  }
  [[noreturn]] void Fail(std::string_view what) const {
    throw InputError(fmt::format("{}: {}: {}; {}", *where_, name_, what, kCure));
  }

 private:
  const Json* json_;
  std::string name_;
  const std::string* where_;
};

OrderedJson FormatOptions(const SceneOptions& options) {
  const Surface& surface = options.surface;
  OrderedJson json = {{"rendering", options.rendering == Rendering::kProxy ? "proxy" : "direct"},
                      {"law", surface.law == ForceLaw::kPotential ? "potential" : "paper"},
                      {"page_stiffness_n_m", surface.stiffness},
                      {"force_cap_n", surface.force_cap},
                      {"coupling_stiffness_n_m", options.coupling_stiffness},
                      {"coupling_damping_n_s_m", options.coupling_damping},
                      {"friction", options.friction},
                      {"presliding_stiffness_n_m", options.presliding_stiffness},
                      {"tick_s", options.tick},
                      {"tilt_rad", options.tilt}};
  const Box& text = options.text_P;
  if (options.label > 0) json["label"] = options.label;
  if (options.unlabelled != Unlabelled::kNothing) {
    json["unlabelled"] = options.unlabelled == Unlabelled::kPlain ? "plain" : "contacts";
  }
  if (text.min.x <= text.max.x) {
    json["text_m"] = {text.min.x, text.min.y, text.max.x, text.max.y};
  }
  return json;
}

bool IsFirst(const Member& member, std::string_view first, std::string_view second) {
  const std::string text = member.Text();
  if (text != first && text != second) member.Fail(fmt::format("neither {} nor {}", first, second));
  return text == first;
}

SceneOptions ParseOptions(const Member& scene) {
  SceneOptions options;
  options.rendering =
      IsFirst(scene["rendering"], "proxy", "direct") ? Rendering::kProxy : Rendering::kDirect;
  options.surface.law =
      IsFirst(scene["law"], "potential", "paper") ? ForceLaw::kPotential : ForceLaw::kPaper;
  options.surface.stiffness = scene["page_stiffness_n_m"].Number(0);
  options.surface.force_cap = scene["force_cap_n"].Number(0);
  options.coupling_stiffness = scene["coupling_stiffness_n_m"].Number(0);
  options.coupling_damping = scene["coupling_damping_n_s_m"].Number(0);
  options.friction = scene["friction"].Number(0);
  options.presliding_stiffness = scene["presliding_stiffness_n_m"].Number(0);
  options.tick = scene["tick_s"].Number(1e-6, 1);
  options.tilt = scene["tilt_rad"].Number(-4, 4);
  if (scene.Has("label")) options.label = scene["label"].Unsigned(100000);
  if (scene.Has("unlabelled")) {
    options.unlabelled = IsFirst(scene["unlabelled"], "plain", "contacts") ? Unlabelled::kPlain
                                                                           : Unlabelled::kContacts;
  }
  if (scene.Has("text_m")) {
    const Member text = scene["text_m"];
    if (text.Count() != 4) text.Fail("not four numbers");
    options.text_P = {{text.At(0).Number(), text.At(1).Number()},
                      {text.At(2).Number(), text.At(3).Number()}};
  }
  return options;
}

OrderedJson FormatBuild(const BuildInfo& build) {
  return {{"version", build.program_version},
          {"compiler", build.compiler},
          {"flags", build.flags},
          {"mujoco_compiled", build.mujoco_compiled},
          {"mujoco_run", build.mujoco_run},
          {"cpu", build.cpu},
          {"cpu_features", build.cpu_features}};
}

BuildInfo ParseBuild(const Member& program) {
  constexpr auto kInt = static_cast<std::uint64_t>(std::numeric_limits<int>::max());
  BuildInfo build;
  build.program_version = program["version"].Text();
  build.compiler = program["compiler"].Text();
  build.flags = program["flags"].Text();
  build.mujoco_compiled = static_cast<int>(program["mujoco_compiled"].Unsigned(kInt));
  build.mujoco_run = static_cast<int>(program["mujoco_run"].Unsigned(kInt));
  build.cpu = program["cpu"].Text();
  build.cpu_features = program["cpu_features"].Text();
  return build;
}

OrderedJson FormatSamples(const TrialSheet& sheet) {
  OrderedJson digests = OrderedJson::array();
  for (const std::uint64_t digest : sheet.sample_digests) digests.push_back(ToHex(digest));
  return {{"file", "samples.f64"},
          {"format", "little-endian IEEE 754 doubles, one row a tick"},
          {"frames", "device_*: D, the device's; *_W_*: W, the world's; all others: P, the page's"},
          {"columns", kRecordColumns},
          {"phases", {"air", "entry", "stroke", "lift", "travel"}},
          {"ticks", sheet.ticks},
          {"digest_every_ticks", kDigestEvery},
          {"running_digests", std::move(digests)}};
}

void ParseColumns(const Member& columns) {
  const std::size_t count = columns.Count();
  for (std::size_t i = 0; i < kRecordColumns.size(); ++i) {
    if (i >= count) columns.Fail(fmt::format("column {} is missing", kRecordColumns[i]));
    const std::string name = columns.At(i).Text();
    if (name == kRecordColumns[i]) continue;
    columns.At(i).Fail(fmt::format("{} stands where {} belongs", OneLine(name), kRecordColumns[i]));
  }
  if (count > kRecordColumns.size()) columns.At(kRecordColumns.size()).Fail("one column too many");
}

void ParseSamples(const Member& samples, TrialSheet& sheet) {
  ParseColumns(samples["columns"]);
  sheet.ticks = samples["ticks"].Unsigned(kGreatestTicks);
  const Member every = samples["digest_every_ticks"];
  if (every.Unsigned(kGreatestTicks) != kDigestEvery) every.Fail("not 1000");
  const Member digests = samples["running_digests"];
  const std::size_t count = digests.Count();
  if (count != (sheet.ticks + kDigestEvery - 1) / kDigestEvery) {
    digests.Fail("not one for every 1000 ticks");
  }
  for (std::size_t i = 0; i < count; ++i) sheet.sample_digests.push_back(digests.At(i).Hex());
}

OrderedJson FormatDigests(const TrialSheet& sheet) {
  const std::uint64_t samples =
      sheet.sample_digests.empty() ? Digest().value() : sheet.sample_digests.back();
  OrderedJson digests = {
      {"method",
       "FNV-1a 64: against accident, not malice; trial.json: of its compact text with "
       "sorted keys, without this digest"},
      {"model.xml", ToHex(sheet.model_digest)},
      {"samples.f64", ToHex(samples)},
      {"events.jsonl", ToHex(sheet.events_digest)}};
  if (sheet.has_csv) digests["samples.csv"] = ToHex(sheet.csv_digest);
  return digests;
}

void ParseDigests(const Member& digests, TrialSheet& sheet) {
  sheet.model_digest = digests["model.xml"].Hex();
  sheet.events_digest = digests["events.jsonl"].Hex();
  sheet.has_csv = digests.Has("samples.csv");
  if (sheet.has_csv) sheet.csv_digest = digests["samples.csv"].Hex();
}

void CheckSchema(const Member& document, const std::string& where) {
  const Member schema = document["schema"];
  if (schema.Text() != "moontrace.trial") schema.Fail("not moontrace.trial");
  const double version = document["schema_version"].Number();
  if (version == kSchemaVersion) return;
  throw InputError(fmt::format("{}: schema version {} is not {}: use the program that wrote it",
                               where, version, kSchemaVersion));
}

}  // namespace

std::string FormatTrial(const TrialSheet& sheet) {
  for (const double value : sheet.state) {
    if (std::isfinite(value)) continue;
    throw InputError("record: the scene's state is not finite; reset the scene before recording");
  }
  OrderedJson json = {
      {"schema", "moontrace.trial"},
      {"schema_version", kSchemaVersion},
      {"program", FormatBuild(sheet.build)},
      {"start_time_utc", sheet.start_time_utc},
      {"subject", {{"kind", sheet.head.subject_kind}}},
      {"units", "SI; a name's last part gives the unit: _m, _s, _n, _n_m, _rad"},
      {"seed", sheet.head.seed},
      {"parameters", OrderedJson(ParseObject(sheet.head.parameters_json, "parameters"))},
      {"scene", FormatOptions(sheet.options)},
      {"guidance", OrderedJson::object()},
      {"safety", OrderedJson::object()},
      {"field_hash", ToHex(sheet.head.field_hash)},
      {"initial_state", sheet.state},
      {"samples", FormatSamples(sheet)},
      {"results", OrderedJson(ParseObject(sheet.result_json, "results"))},
      {"digests", FormatDigests(sheet)}};
  const Json read_back = ParseBounded(Dump(json), "record", kGreatestDepth);
  json["digests"]["trial.json"] = ToHex(OwnDigest(read_back));
  std::string text = Dump(json, 1) + "\n";
  if (text.size() > kGreatestTextBytes) {
    throw InputError(fmt::format("record: trial.json would take {} bytes; at most {} can be read",
                                 text.size(), kGreatestTextBytes));
  }
  return text;
}

TrialSheet ParseTrial(std::string_view text, const std::string& where) {
  const Json json = ParseBounded(text, where, kGreatestDepth);
  const Member document(json, "", where);
  CheckSchema(document, where);
  TrialSheet sheet;
  sheet.build = ParseBuild(document["program"]);
  sheet.start_time_utc = document["start_time_utc"].Text();
  sheet.head.subject_kind = document["subject"]["kind"].Text();
  sheet.head.seed = document["seed"].Unsigned(std::numeric_limits<std::uint64_t>::max());
  sheet.head.parameters_json = document["parameters"].ObjectText();
  sheet.options = ParseOptions(document["scene"]);
  sheet.head.field_hash = document["field_hash"].Hex();
  const Member state = document["initial_state"];
  const std::size_t count = state.Count();
  for (std::size_t i = 0; i < count; ++i) sheet.state.push_back(state.At(i).Number());
  ParseSamples(document["samples"], sheet);
  sheet.result_json = document["results"].ObjectText();
  ParseDigests(document["digests"], sheet);
  sheet.digest_holds = document["digests"]["trial.json"].Hex() == OwnDigest(json);
  return sheet;
}

std::string FormatEvent(double time, const std::string& what, const std::string& detail) {
  return Dump(OrderedJson{{"time_s", time}, {"what", what}, {"detail", detail}}) + "\n";
}

}  // namespace moontrace
