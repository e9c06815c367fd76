#include "sim/session/view_messages.h"

#include <fmt/core.h>

#include "sim/console/wording.h"
#include "sim/view/view_words.h"
#include "textures/base/text_file.h"

namespace moontrace::say {

std::string MouseNeedsWindow() { return "--device mouse needs a window: add --view"; }

std::string MouseIsSeen() {
  return "The mouse moves the stylus: its button presses, its wheel says how hard. "
         "Forces are seen, not felt.";
}

std::string ViewSays(std::string_view why) {
  std::string line = OneLine(why, 300);
  if (!line.empty() && line[0] >= 'a' && line[0] <= 'z') {
    line[0] = static_cast<char>(line[0] - 'a' + 'A');
  }
  return line.append(".");
}

std::string WindowClosed() { return "Window closed: this ends."; }

std::string RunsOnUnseen() { return "Window closed: the rest runs without it."; }

std::string WindowOrFrames() { return "--view opens a window, --frames draws without: take one"; }

std::string TakesViewWordsOnly() { return "It runs by itself: only the view takes words here."; }

std::string ViewWordsHelp() {
  return fmt::format("Words of the view: {}.", Joined(ViewWords(), ", "));
}

std::string ViewColoursHelp() {
  return "In the view blue is the force on the hand, orange the push, purple the letter and stroke "
         "that are meant; the tip's way is green on the stroke and red beside it.";
}

std::string PictureIsSimulated() {
  return "--picture shows the simulated stylus: leave out --device";
}

std::string OnlyInView(std::string_view option) {
  return fmt::format("{} goes with --picture alone: leave out the other", option);
}

std::string FramesIn() { return "Pictures in"; }

std::string FramesNotWhole() { return "pictures are missing: their writing ended before its time"; }

std::string NothingSeen() {
  return "nothing was seen: no window opens here, and no word came; --frames and --picture draw "
         "without a display";
}

std::string MouseGone() { return "the window went away, and the mouse that moved the tip with it"; }

std::string ViewPictureIn() { return "Picture in"; }

std::string ViewKeptUp(std::size_t frames, double median_ms, double slowest_ms) {
  return fmt::format("View: {} frames, {:.1f} ms each, {:.1f} ms the slowest.", frames, median_ms,
                     slowest_ms);
}

std::string PanelPage(std::size_t page, std::size_t pages) {
  return fmt::format("{} of {}", page + 1, pages);
}

std::string PanelState(bool stopped, bool touching) {
  if (stopped) return "stopped";
  return touching ? "touching" : "in the air";
}

std::string PanelSeconds(double time) { return fmt::format("{:.1f} s", time); }

}  // namespace moontrace::say
