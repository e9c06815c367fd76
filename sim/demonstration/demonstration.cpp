#include "sim/demonstration/demonstration.h"

#include <algorithm>
#include <utility>

#include "lessons/progress/answer.h"
#include "sim/console/choice.h"
#include "sim/console/line_wrap.h"
#include "sim/console/word_messages.h"
#include "sim/demonstration/demonstration_messages.h"
#include "sim/learn/learn_messages.h"
#include "textures/base/resources.h"
#include "textures/base/text_file.h"
#include "textures/base/toml_reader.h"
#include "textures/base/units.h"

namespace moontrace {

namespace {

constexpr double kAnswering = 30;       ///< an answer is awaited [s]
constexpr double kMoreTime = 1.5;       ///< factor on every wait, each time it is asked for
constexpr double kBeforeLine = 1.2;     ///< to notice that something is said [s]
constexpr double kPerLetter = 1 / 15.;  ///< of speech, some 170 words a minute [s]
/// Time passes in words: nothing waits longer.
constexpr double kLongest = 600;  ///< [s]

Demonstration::Clock::duration Seconds(double seconds) {
  return std::chrono::duration_cast<Demonstration::Clock::duration>(
      std::chrono::duration<double>(seconds));
}

/// "t, o, i, l" is toil; what is no spelled word stays as it is.
std::string Unspelled(const std::string& given) {
  std::string word;
  bool parted = true;
  for (const char c : given) {
    const bool parts = c == ' ' || c == ',' || c == '-' || c == '.';
    if (!parts && !parted) return given;
    if (!parts) word += c;
    parted = parts;
  }
  return word.size() > 1 ? word : given;
}

bool IsRight(const DemonstrationStep& step, const std::string& given) {
  const std::string word = Unspelled(given);
  return std::any_of(step.answers.begin(), step.answers.end(), [&](const std::string& answer) {
    return Names(Course(), answer, given) || answer == word;
  });
}

bool IsOneWord(const std::string& text) {
  return text.size() > 1 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= 'a' && c <= 'z'; });
}

double SecondsFor(const std::string& line) {
  return kBeforeLine + kPerLetter * static_cast<double>(line.size());
}

std::string Trimmed(const std::string& line) {
  constexpr const char* kBlanks = " \t\r.!?";
  const auto begin = line.find_first_not_of(kBlanks);
  if (begin == std::string::npos) return line.find('?') == std::string::npos ? "" : "?";
  return LowerCase(line.substr(begin, line.find_last_not_of(kBlanks) - begin + 1));
}

constexpr std::size_t kMostBytes = std::size_t{1} << 20;

DemonstrationStep StepOf(const TomlTable& table) {
  DemonstrationStep step;
  step.show = table.String("show", "");
  const double size_mm = table.Number("size_mm", kMillimetres * step.size);
  step.size = InRange(table, "size_mm", size_mm, 1, 200) / kMillimetres;
  step.say = Sentences(table.String("say", ""));
  step.ask = table.String("ask", "");
  if (table.Has("ways")) {
    if (!step.ask.empty()) table.Fail("ways", "a question is asked; leave one of both out");
    step.ways = table.Strings("ways");
  }
  if (step.ask.empty()) {
    for (const char* key : {"answers", "right", "wrong"}) {
      if (table.Has(key)) table.Fail(key, "nothing is asked; give ask, or leave it out");
    }
  } else {
    step.answers = table.Strings("answers");
    if (step.answers.empty()) table.Fail("answers", "empty; give one answer at least");
    step.right = table.String("right");
    step.wrong = table.String("wrong");
  }
  table.FailUnknown();
  return step;
}

}  // namespace

std::vector<DemonstrationStep> ParseDemonstration(std::string_view toml, const std::string& name) {
  const TomlTable table = TomlTable::Parse(toml, name);
  std::vector<DemonstrationStep> steps;
  for (const TomlTable& step : table.Tables("steps")) steps.push_back(StepOf(step));
  if (steps.empty()) table.Fail("steps", "none; give one [[steps]] at least");
  table.FailUnknown();
  return steps;
}

std::vector<DemonstrationStep> ShippedDemonstration() {
  const std::string path = ResourcePath("lessons/demonstration.toml");
  return ParseDemonstration(ReadTextFile(path, kMostBytes), path);
}

Demonstration::Demonstration(const std::vector<DemonstrationStep>& steps, LearnStage& stage,
                             LearnTeller& teller, std::vector<std::string> help)
    : steps_(steps),
      stage_(stage),
      teller_(teller),
      help_(std::move(help)),
      poll_(stage.session().loop(), stage.session().device()) {}

void Demonstration::WaitFor(double seconds) {
  until_ = now_ + Seconds(hurries_ ? 0 : std::min(pace_ * seconds, kLongest));
}

void Demonstration::Say(const std::string& line) {
  teller_.Say(Priority::kText, line);
  last_ = line;
  WaitFor(SecondsFor(line));
}

void Demonstration::Look(Clock::time_point now) {
  now_ = now;
  poll_.Look(*this);
  if (!begun_) {
    begun_ = true;
    NextStep();
  }
  while (!over_ && !paused_ && (now_ >= until_ || hurries_)) GoOn();
  teller_.EndTurn();
}

/// The next thing of the step, or the next step.
void Demonstration::GoOn() {
  if (line_ < step().say.size()) return Say(step().say[line_++]);
  if (!step().ask.empty() && !asked_) {
    Say(step().ask);
    heard_ = until_;
    asked_ = asking_ = true;
    proposal_.Make({});  // this is what yes answers now
    return WaitFor(kAnswering);
  }
  if (!step().ways.empty() && !asked_) {
    asked_ = true;
    return WaitFor(kAnswering);
  }
  if (asking_) {
    asking_ = false;
    missed_ = &step();
    return Say(step().wrong);
  }
  ++at_;
  NextStep();
}

void Demonstration::NextStep() {
  line_ = 0;
  asking_ = asked_ = false;
  over_ = at_ >= steps_.size();
  if (over_ || step().show.empty()) return;
  told_ += LowerCase(step().show);
  lesson_action::Show show;
  show.text = step().show;
  show.size = step().size;
  stage_.Show(show);
}

/// To a word: what is waited for waits until this has been heard too.
void Demonstration::Reply(const std::string& line) {
  teller_.Say(Priority::kText, line);
  if (paused_ || hurries_) return;
  until_ = std::max(until_, now_) + Seconds(pace_ * SecondsFor(line));
}

bool Demonstration::hides() const {
  if (over_) return false;
  if (!step().ask.empty() && (!asked_ || asking_)) return true;
  for (std::size_t i = at_ + 1; i < steps_.size() && steps_[i].show.empty(); ++i) {
    if (!steps_[i].ask.empty()) return true;
  }
  return false;
}

bool Demonstration::AsksWord() const {
  return !step().answers.empty() &&
         std::all_of(step().answers.begin(), step().answers.end(),
                     [](const std::string& answer) { return CountCharacters(answer) > 1; });
}

/// A sign, or a word of signs that were shown; any word where one is asked. Other words and numbers
/// are no answers.
bool Demonstration::IsAnswer(const std::string& given) const {
  const bool word = AsksWord() && IsOneWord(Unspelled(given));
  // what is close to a word of the program, or is called so elsewhere, is rather that
  if (word && ReadLine(given, WordPlace::kDemonstration).refusal == say::WordUnknown(given, {})) {
    return true;
  }
  const std::vector<std::string> readings = ReadingsOf(given);
  return IsRight(step(), given) ||
         std::any_of(readings.begin(), readings.end(), [this](const std::string& reading) {
           const bool number = reading.find_first_of("0123456789") != std::string::npos;
           if (CountCharacters(reading) == 1) return !number;
           return reading.find_first_not_of(told_) == std::string::npos &&
                  reading.find_first_of(" \n") == std::string::npos;
         });
}

/// It was typed for the question before, whose time was over: it is right there, or what is asked
/// now could not have been heard yet.
bool Demonstration::CameLate(const std::string& given) const {
  if (missed_ == nullptr || (asking_ && IsRight(step(), given))) return false;
  return IsRight(*missed_, given) || (asking_ && now_ < heard_ && IsAnswer(given));
}

void Demonstration::TellLate() {
  Reply(say::AnswerCameLate());
  missed_ = nullptr;
  if (asking_) StillAsk();
}

void Demonstration::StillAsk() {
  Reply(step().ask);
  if (!paused_) until_ = std::max(until_, now_ + Seconds(pace_ * kAnswering));
}

/// With the line that tells the way, which is the best hint there is.
void Demonstration::AskAgain() {
  if (!step().say.empty()) Reply(step().say.back());
  StillAsk();
}

bool Demonstration::TakesWay(const std::string& given) {
  const std::optional<std::size_t> way = ChoiceOf(given, step().ways);
  if (!way) return false;
  way_ = step().ways[*way];
  over_ = true;
  return true;
}

/// The ways on, each with its number, and what is asked.
void Demonstration::TellWays() {
  for (const std::string& line : step().say) {
    if (line.front() >= '1' && line.front() <= '9') Reply(line);
  }
  Reply(step().say.back());
  if (!paused_) until_ = std::max(until_, now_ + Seconds(pace_ * kAnswering));
}

void Demonstration::Answer(const std::string& given) {
  const bool right = IsRight(step(), given), unknown = DoesNotKnow(given);
  asking_ = false;
  missed_ = nullptr;
  if (!unknown) teller_.Play(right ? Earcon::kRight : Earcon::kWrong);
  const std::string letter = AsksWord() ? given : ReadingsOf(given).back();
  if (!right && !unknown) teller_.Say(Priority::kText, say::WrongAnswer(letter));
  Say(right ? step().right : step().wrong);
}

void Demonstration::Leave() {
  over_ = true;
  teller_.Say(Priority::kText, say::DemonstrationCutOff());
  teller_.EndTurn();
}

/// An answer, or what sounds like one; false: it is for others to answer.
bool Demonstration::Takes(const std::string& given) {
  const bool unknown = DoesNotKnow(given);
  if (!asking_) {
    if (!unknown && (!IsAnswer(given) || Unspelled(given).find(' ') != std::string::npos)) {
      return false;
    }
    Reply(say::NothingAsked(paused_));
  } else if (!unknown && AsksWord() && CountCharacters(given) == 1) {
    Reply(say::WholeWordAsked());
    StillAsk();
  } else if (KnowsWithoutName(given)) {
    Reply(AsksWord() ? say::WholeWordAsked() : say::SayTheName());
    StillAsk();
  } else if (unknown || IsAnswer(given)) {
    Answer(given);
  } else {
    return false;
  }
  return true;
}

void Demonstration::Obey(const std::string& line) {
  teller_.Interrupt();
  const std::string given = Trimmed(proposal_.Taken(line));
  if (TakesWay(given)) return;
  const SaidLine said = ReadLine(given, WordPlace::kDemonstration);
  const bool sign = CountCharacters(given) == 1 && given.find_first_of("?0123456789") != 0;
  const bool word = said.word != nullptr && said.behind.empty() && !(asking_ && sign);
  if (given.empty()) {
    teller_.Say(Priority::kText, paused_   ? say::DemonstrationPauses()
                                 : asking_ ? step().ask
                                           : say::DemonstrationGoesOn());
  } else if (CameLate(given)) {
    TellLate();
  } else if (word) {
    Do(said.word->word);
  } else if (said.word != nullptr && !said.behind.empty()) {  // only "help" takes something here
    proposal_.MakeHelp(said.behind, WordPlace::kDemonstration);
    Reply(say::HelpWith(said.behind, WordPlace::kDemonstration));
  } else if (!Takes(given)) {
    proposal_.Make(said.meant);
    Reply(said.refusal.empty() ? say::NothingAsked(paused_) : said.refusal);
    if (asking_) StillAsk();
    if (Chooses()) TellWays();
  }
  teller_.EndTurn();
}

/// After a pause. What is asked is asked anew: it may have been long.
void Demonstration::GoOnAgain() {
  paused_ = false;
  until_ = asking_ ? now_ : now_ + left_;
  teller_.Say(Priority::kText, say::DemonstrationGoesOn());
  if (asking_) StillAsk();
}

void Demonstration::Do(std::string_view word) {
  if (word == "quit") {
    over_ = true;
    teller_.Say(Priority::kText, say::DemonstrationLeft());
  } else if (Chooses() && (word == "help" || word == "again")) {
    TellWays();
  } else if (word == "help") {
    for (const std::string& line : help_) Reply(line);
  } else if (word == "again" && asking_) {
    AskAgain();
  } else if (word == "again") {
    teller_.Say(Priority::kText, last_);
    WaitFor(SecondsFor(last_));
  } else if (word == "pause" || word == "stop") {
    if (!paused_) left_ = std::max(until_ - now_, Clock::duration(0));
    paused_ = true;
    teller_.Hush();
    teller_.Say(Priority::kText, say::DemonstrationPauses());
  } else if (word == "more time") {
    pace_ = std::min(pace_ * kMoreTime, 8.0);
    WaitFor(asking_ || Chooses() ? kAnswering : SecondsFor(last_));
    teller_.Say(Priority::kText, say::DemonstrationSlower());
  } else if (paused_) {  // go, next
    GoOnAgain();
  } else {
    until_ = now_;
    if (asking_) {  // skipped: what comes now is no late answer to it
      asking_ = false;
      return Say(step().wrong);
    }
    if (word == "go") teller_.Say(Priority::kText, say::DemonstrationGoesOn());
  }
}

}  // namespace moontrace
