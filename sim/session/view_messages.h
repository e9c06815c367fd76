#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Sentences about the view in a window; see messages.h.
namespace moontrace::say {

/// The device "mouse" without a window.
std::string MouseNeedsWindow();
/// What the mouse does, and that it cannot push a hand.
std::string MouseIsSeen();
/// Why there is no window, or none any more, as the viewer has it: a clause.
std::string ViewSays(std::string_view why);
std::string WindowClosed();
/// What runs on without its window.
std::string RunsOnUnseen();
std::string WindowOrFrames();
/// Of a trace by itself: nothing can be said to it.
std::string TakesViewWordsOnly();
/// All words that the view takes, and what its colours mean: two sentences.
std::string ViewWordsHelp();
std::string ViewColoursHelp();
std::string PictureIsSimulated();
std::string OnlyInView(std::string_view option);
/// The folder's path follows on a line of its own.
std::string FramesIn();
std::string FramesNotWhole();
/// Neither a window nor a word: nothing was shown to anybody.
std::string NothingSeen();
std::string MouseGone();
std::string ViewPictureIn();
/// How the view kept up.
std::string ViewKeptUp(std::size_t frames, double median_ms, double slowest_ms);

// What stands in the panel.
std::string PanelPage(std::size_t page, std::size_t pages);
std::string PanelState(bool stopped, bool touching);
std::string PanelSeconds(double time);

namespace help {
inline constexpr const char* kViewCommand =
    "shows a page in a window: felt with the mouse, or traced";
inline constexpr const char* kView =
    "show it in a window: page, stylus, forces, plots, and a panel that changes them.";
inline constexpr const char* kFrames =
    "draw it, without a display, as pictures into this folder, 30 a second.";
inline constexpr const char* kContrast =
    "of the view: grooves black on white, strong colours for the rest.";
inline constexpr const char* kPictureWidth =
    "width of these pictures in points; the height is 9/16 of it. Default 1280.";
inline constexpr const char* kCamera =
    "what of a model is looked at: a camera of its own, a label, geom or body, whole, or tip, "
    "which "
    "is followed. Default the label that is felt.";
inline constexpr const char* kLargeText = "of the view: large letters in panel and plots.";
inline constexpr const char* kViewPicture =
    "one picture of the view as .png, without a display, and nothing more; with --seconds N of a "
    "page that the simulated stylus has traced for so long.";
inline constexpr const char* kViewPictureWidth =
    "width of these pictures and of --picture in points; the height is 9/16 of it. Default 1280.";
inline constexpr const char* kViewText = "the text; - reads standard input. Default: some words.";
inline constexpr const char* kViewDevice =
    "what moves the tip: mouse, simulated, or a name that devices lists. Default the mouse in a "
    "window, else simulated.";
}  // namespace help

}  // namespace moontrace::say
