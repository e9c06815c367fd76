#include "sim/app/commands.h"

#include <fmt/core.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "sim/app/messages.h"
#include "sim/picture/picture_file.h"
#include "sim/setup/help.h"
#include "sim/setup/typeset_report.h"
#include "sim/study/page_reading.h"
#include "sim/study/reading_plot.h"
#include "sim/study/reading_summary.h"
#include "sim/study/study_files.h"
#include "sim/study/study_messages.h"
#include "sim/study/study_protocol.h"
#include "sim/study/study_summary.h"
#include "sim/trial/metrics_json.h"
#include "textures/base/error.h"
#include "textures/base/nearest_word.h"
#include "textures/base/output_file.h"
#include "textures/base/resources.h"
#include "textures/base/units.h"

namespace moontrace {

namespace {

namespace fs = std::filesystem;

constexpr int kMostShards = 100000;
constexpr int kMostThreads = 256;

struct Shard {
  int number = 1, of = 1;
};

Shard ShardOf(const std::string& given) {
  Shard shard;
  if (given.empty()) return shard;
  const char* const end = given.data() + given.size();
  const auto k = std::from_chars(given.data(), end, shard.number);
  if (k.ec != std::errc() || k.ptr == end || *k.ptr != '/') throw UsageError(say::NotAShard(given));
  const auto n = std::from_chars(k.ptr + 1, end, shard.of);
  if (n.ec != std::errc() || n.ptr != end || shard.number < 1 || shard.of > kMostShards ||
      shard.number > shard.of) {
    throw UsageError(say::NotAShard(given));
  }
  return shard;
}

StudyProtocol ProtocolAt(const std::string& file) {
  StudyProtocol protocol = LoadStudy(file);
  if (protocol.reading) CompleteSweep(*protocol.reading, file);
  return protocol;
}

/// The names of the protocols in a folder, by the alphabet.
std::vector<std::string> StudiesIn(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() == ".toml") names.push_back(it->path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// A shipped protocol by its name, otherwise a path.
std::string ProtocolPath(const std::string& given) {
  const bool name = given.find('/') == std::string::npos && given.find('.') == std::string::npos;
  if (!name || fs::exists(given)) return given;
  const std::string folder = ResourcePath("lessons/studies");
  std::string shipped = folder + "/" + given + ".toml";
  if (!fs::exists(shipped)) {
    const std::vector<std::string> names = StudiesIn(folder);
    throw InputError(say::NoSuchStudy(given, names, NearestWord(given, names)));
  }
  return shipped;
}

int ThreadsOf(const StudyOptions& options) {
  if (options.threads) {
    if (*options.threads != std::floor(*options.threads)) throw UsageError(say::WholeThreads());
    return static_cast<int>(*options.threads);
  }
  const unsigned cores = std::thread::hardware_concurrency();
  return static_cast<int>(std::clamp(cores, 1U, static_cast<unsigned>(kMostThreads)));
}

bool IsShare(const StudyOptions& options) { return ShardOf(options.shard).of > 1; }

/// "2/4", or null of a whole study.
Json ShardJson(const StudyOptions& options) {
  const Shard shard = ShardOf(options.shard);
  return shard.of > 1 ? Json(fmt::format("{}/{}", shard.number, shard.of)) : Json();
}

/// In mm; null unless it is `known`.
Json Millimetres(bool known, double value) { return known ? Json(kMillimetres * value) : Json(); }
Json Millimetres(bool known, double low, double high) {
  return known ? Json{kMillimetres * low, kMillimetres * high} : Json();
}

/// `share`: its means compare nothing. One value has no spread. What the cell is compared with and
/// how is null of the reference itself, and where there is none.
Json CellJson(const StudyCell& cell, const std::string& reference, bool share) {
  const bool spread = !share && cell.learners > 1;
  const bool compared = !share && cell.pairs > 0;
  return Json{
      {"phase", cell.phase},
      {"condition", cell.condition},
      {"learners", cell.learners},
      {"mean_mm", Millimetres(!share, cell.mean)},
      {"sd_mm", Millimetres(spread, cell.deviation)},
      {"ci95_mm", Millimetres(spread, cell.low, cell.high)},
      {"reference", compared ? Json(reference) : Json()},
      {"pairs", compared ? Json(cell.pairs) : Json()},
      {"more_mm", Millimetres(compared, cell.more)},
      {"more_ci95_mm", Millimetres(compared && cell.pairs > 1, cell.more_low, cell.more_high)}};
}

Json SummaryJson(const StudyOptions& options, const StudySummary& summary,
                 const std::string& path) {
  Json cells = Json::array(), exclusions = Json::array();
  for (const StudyCell& cell : summary.cells) {
    cells.push_back(CellJson(cell, summary.reference, IsShare(options)));
  }
  for (const StudyExclusion& excluded : summary.exclusions) {
    exclusions.push_back({{"condition", excluded.condition},
                          {"seed", excluded.seed},
                          {"trial", excluded.trial},
                          {"phase", excluded.phase},
                          {"why", excluded.why}});
  }
  return Json{{"rows", path},
              {"shard", ShardJson(options)},
              {"trials", summary.trials},
              {"learners", summary.learners},
              {"simulated", true},
              {"cells", std::move(cells)},
              {"excluded", std::move(exclusions)}};
}

/// Phase by phase: the cells, then their order.
void SayCells(const StudySummary& summary, Console& console) {
  std::vector<StudyCell> phase;
  const auto say_order = [&phase, &console] {
    if (phase.size() > 1) {
      std::stable_sort(phase.begin(), phase.end(),
                       [](const StudyCell& a, const StudyCell& b) { return a.mean < b.mean; });
      std::vector<std::string> order;
      order.reserve(phase.size());
      for (const StudyCell& cell : phase) order.push_back(cell.condition);
      console.Result(say::StudyOrder(phase.front().phase, order));
    }
    phase.clear();
  };
  for (const StudyCell& cell : summary.cells) {
    if (!phase.empty() && phase.front().phase != cell.phase) say_order();
    console.Result(say::StudyCellLine(cell));
    if (cell.pairs > 1) console.Result(say::StudyDifferenceLine(cell, summary.reference));
    phase.push_back(cell);
  }
  say_order();
}

void Report(const StudyOptions& options, const StudySummary& summary, const std::string& outcome,
            const std::string& path, Console& console) {
  if (options.output.json) {
    console.Json(Dump(SummaryJson(options, summary, path)));
    return;
  }
  console.Result(outcome);
  if (IsShare(options)) {  // other learners in each condition: means of a share compare nothing
    console.Result(say::StudyIsAShare(options.shard));
  } else {
    SayCells(summary, console);
  }
  console.Result(say::StudyExclusions(summary.exclusions.size()));
  for (const StudyExclusion& excluded : summary.exclusions) {
    console.Result(say::StudyExclusionLine(excluded));
  }
  console.Result(say::StudyProves());
  console.Result(say::StudyRowsIn());
  console.Path(path);
}

/// One page has no spread.
Json EstimateJson(const Estimate& estimate, std::size_t pages) {
  const Json interval = pages < 2 ? Json() : Json{estimate.low, estimate.high};
  return Json{{"value", estimate.value}, {"ci95", interval}};
}

Json ReadingCellJson(const ReadingStudyCell& cell) {
  const ReadingCell& given = cell.cell;
  return Json{{"condition", cell.condition},
              {"script", given.script},
              {"relief", given.relief == Relief::kEmbossed ? "embossed" : "engraved"},
              {"device", given.device.empty() ? Json() : Json(given.device)},
              {"size_mm", kMillimetres * given.size},
              {"width_share", given.width_share},
              {"depth_share", given.depth_share},
              {"rounding_share", given.rounding_share},
              {"press_n", given.press},
              {"friction", given.friction},
              {"drift_share", given.drift_share},
              {"unsure_mm", kMillimetres * given.unsure},
              {"paper", given.paper.empty() ? Json() : Json(given.paper)},
              {"pages", cell.pages},
              {"signs", cell.signs},
              {"right_share", EstimateJson(cell.right, cell.pages)},
              {"seconds_per_sign", EstimateJson(cell.seconds, cell.pages)},
              {"wrong", cell.wrong},
              {"missed", cell.missed},
              {"extra", cell.extra},
              {"through", cell.through},
              {"without_end", cell.unended}};
}

/// Of a study of reading.
void ReportReading(const StudyOptions& options, const std::string& title,
                   const std::vector<StudyRow>& rows, const std::string& path, Console& console) {
  ReadingSummary summary = SummariseReading(rows);
  if (IsShare(options)) summary.best.reset();
  if (!options.picture.empty()) WritePicture(options.picture, ReadingPlot(title, summary));
  if (options.output.json) {
    const Json best = summary.best ? Json(summary.cells[*summary.best].condition) : Json();
    Json cells = Json::array();
    for (const ReadingStudyCell& cell : summary.cells) cells.push_back(ReadingCellJson(cell));
    console.Json(Dump(Json{{"rows", path},
                           {"shard", ShardJson(options)},
                           {"pages", rows.size()},
                           {"simulated", true},
                           {"cells", std::move(cells)},
                           {"picture", options.picture.empty() ? Json() : Json(options.picture)},
                           {"best", best}}));
    return;
  }
  console.Result(say::ReadingDone(rows.size(), summary.cells.size()));
  if (IsShare(options)) console.Result(say::StudyIsAShare(options.shard));
  for (const ReadingStudyCell& cell : summary.cells) {
    console.Result(say::ReadingCellLine(cell));
    console.Result(say::ReadingErrorsLine(cell));
  }
  if (summary.best && summary.cells.size() > 1) {
    console.Result(say::ReadingBest(summary.cells[*summary.best].condition));
  }
  console.Result(say::ReadingProves());
  if (!options.picture.empty()) {
    console.Result(say::PictureIn());
    console.Path(options.picture);
  }
  console.Result(say::StudyRowsIn());
  console.Path(path);
}

void CheckPicture(const StudyOptions& options, bool of_reading) {
  if (options.picture.empty()) return;
  if (!of_reading) throw UsageError(say::PictureOfReadingOnly());
  CheckPicturePath(options.picture);
}

int Merge(const StudyOptions& options, Console& console) {
  if (options.words.size() < 2) throw UsageError(say::NothingToMerge());
  if (options.path.empty()) throw UsageError(say::MergeNeedsOutput());
  if (options.threads) throw UsageError(say::OnlyForStudies("--threads"));
  if (!options.shard.empty()) throw UsageError(say::OnlyForStudies("--shard"));
  const std::vector<std::string> files(options.words.begin() + 1, options.words.end());
  for (const std::string& file : files) {
    std::error_code none;
    if (std::filesystem::equivalent(file, options.path, none)) {
      throw UsageError(say::MergeIntoItself(options.path));
    }
  }
  const std::vector<StudyRow> rows = MergeStudies(files);
  CheckPicture(options, !rows.empty() && rows.front().page);
  WriteWhole(options.path, StudyText(rows));
  if (!rows.empty() && rows.front().page) {
    ReportReading(options, say::MergedReading(), rows, options.path, console);
    return exit_code::kGood;
  }
  const StudySummary summary = Summarise(rows);
  Report(options, summary, say::StudyMerged(summary, files.size()), options.path, console);
  return exit_code::kGood;
}

}  // namespace

void AddOptions(CLI::App& app, StudyOptions& options) {
  AddWords(app, options.words, say::help::kStudyWords);
  AddPath(app, "--output", "FILE", options.path, say::help::kStudyOutput);
  AddNumber(app, "--threads", options.threads, 1, kMostThreads, 1, say::help::kStudyThreads);
  app.add_option("--shard", options.shard, say::help::kStudyShard)->type_name("K/N");
  AddPicture(app, options.picture, say::help::kStudyPicture);
  AddOptions(app, options.output);
}

int Run(const StudyOptions& options, Console& console) {
  if (options.words.empty()) throw UsageError(say::NoStudyNamed());
  if (options.words.front() == "merge") return Merge(options, console);
  if (options.words.size() > 1) throw UsageError(say::TooManyStudies(options.words.front()));
  const Shard shard = ShardOf(options.shard);
  const std::string file = ProtocolPath(options.words.front());
  const StudyProtocol protocol = ProtocolAt(file);
  CheckPicture(options, protocol.reading.has_value());
  StudyOutput output;
  output.path = options.path;
  if (output.path.empty()) {
    output.path = fs::path(file).stem().string();
    if (shard.of > 1) output.path += fmt::format("-{}-of-{}", shard.number, shard.of);
    output.path += ".csv";
  }
  output.shard = shard.number;
  output.shards = shard.of;
  output.threads = ThreadsOf(options);
  output.begins = [&] {
    const std::size_t places = PlacesOf(protocol, shard.number, shard.of).size();
    console.Remark(protocol.reading ? say::ReadingBegins(protocol.title, places, output.threads)
                                    : say::StudyBegins(protocol.title, places, output.threads));
  };
  output.check = [&console] { console.CheckStop(); };
  output.progress = [&console](std::size_t done, std::size_t of) {
    console.Alive(static_cast<double>(done) / static_cast<double>(of));
  };
  std::vector<StudyRow> rows;
  try {
    rows = RunStudy(protocol, output);
  } catch (const Interrupted&) {
    console.Remark(say::StudyGoesOn(output.path));
    throw;
  }
  if (protocol.reading) {
    ReportReading(options, protocol.title, rows, output.path, console);
    return exit_code::kGood;
  }
  const StudySummary summary = Summarise(rows);
  Report(options, summary, say::StudyDone(summary), output.path, console);
  return exit_code::kGood;
}

}  // namespace moontrace
