#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "lessons/documents/html_document.h"
#include "lessons/documents/html_tree.h"
#include "lessons/documents/transcribe.h"
#include "sim/book/book_messages.h"
#include "sim/book/book_walk.h"
#include "tests/devices/fake_hid.h"
#include "tests/sim/cli_fixture.h"

namespace moontrace {

/// A book on a device whose tip a test puts where it likes, remembered in a file of the test's own.
class BookWalkTest : public CliTest {
 protected:
  void Open(const std::string& html) {
    if (!CanReadHtml() || !Records::Available()) GTEST_SKIP() << "a library is missing";
    document_ = ReadHtml("<html>" + html + "</html>", "x");
    text_ = Transcribe(document_);
    Again();
  }

  /// Another text, or an edited one, in place of it.
  void Replace(const std::string& html, const std::string& path = "/books/tides.html") {
    document_ = ReadHtml("<html>" + html + "</html>", "x");
    text_ = Transcribe(document_);
    Again(path);
  }

  /// The same, by who comes back.
  void Again(const std::string& path = "/books/tides.html") {
    walk_.reset();
    places_.reset();
    session_.reset();
    memory_ = BookMemory();
    Records records = Records::Open(In("records.sqlite"));
    if (!records.Find("owl")) records.AddLearner({"owl", 0, false, "", false});
    memory_ = BookMemory(std::move(records), "owl", path, book_.title, text_.text);
    SessionRequest request;
    request.text.text.text = text_.text;
    request.text.style.structure = true;
    request.text.style.size = 0.012;
    request.text.book = true;
    request.text.turn_mark = options_.turns;
    request.live.device = RunLine({"devices", "--json"}).Json()["devices"][0]["name"];
    session_.emplace(request, console_);
    places_.emplace(*session_, [this](std::size_t page) { session_->TurnTo(page); });
    walk_.emplace(*session_, book_, memory_, options_);
    begun_ = walk_->Begin(*places_);
  }

  std::size_t Byte(const std::string& words) const { return text_.text.find(words); }

  /// The tip on the letter of a byte, touching or not.
  LoopSnapshot At(std::size_t source, bool touching = true) {
    const auto found = Find(session_->text(), {source, {0.5, 0.5}});
    if (session_->felt().index != found->page) session_->TurnTo(found->page);
    LoopSnapshot now;
    now.tip_P = glm::dvec3(found->p_P, 0);
    now.page = session_->felt().number;
    now.depth = touching ? 1e-4 : -1e-3;
    return now;
  }
  /// A word said there, and what is said on arrival.
  std::vector<std::string> Say(const std::string& line, const LoopSnapshot& at) {
    const auto said = walk_->Obey(line, at);
    if (!said) return {"not a word of the book"};
    std::vector<std::string> lines;
    for (const std::string& one : *said) {
      if (!one.empty()) lines.push_back(one);
    }
    LoopSnapshot now = at;
    now.page = session_->felt().number;
    if (const auto arrival = places_->Arrived(now)) lines.push_back(arrival->sentence);
    return lines;
  }
  static bool Begins(const std::vector<std::string>& lines, const std::string& first) {
    return !lines.empty() && lines.front().rfind(first, 0) == 0;
  }

  FakeHid fake_{"moontrace-raw"};
  std::istringstream in_;
  std::ostringstream out_, err_;
  Console console_{in_, out_, err_};
  Document document_;
  Transcription text_;
  Book book_{document_, text_, "Tides"};
  BookOptions options_;
  BookMemory memory_;
  std::optional<LoopSession> session_;
  std::optional<PlaceWalk> places_;
  std::optional<BookWalk> walk_;
  std::vector<std::string> begun_;
};

inline constexpr const char* kTides =
    "<h1>Tides</h1><p>High water comes twice a day<a href='#n1'>1</a> and ebbs. It is "
    "<a href='http://far.away/'>far</a> out at noon.</p>"
    "<h2>Moon<span epub:type='pagebreak' title='7'></span></h2><p>The moon draws the sea.</p>"
    "<h2>Sun</h2><p>The sun helps at times.</p><p id='n1'>A day of the moon.</p>";

}  // namespace moontrace
