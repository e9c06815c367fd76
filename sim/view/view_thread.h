#pragma once

#include <memory>

#include "sim/view/view_mailbox.h"
#include "sim/view/view_painter.h"
#include "sim/view/viewer_options.h"

namespace moontrace {

/// What a viewer's thread does: opens a window, or OpenGL without a display, and draws until it is
/// stopped, the window is closed, or all frames are written. Tells the mailbox how it went; throws
/// nothing. If the display is lost it never returns.
void RunViewer(const ViewerOptions& options, const std::shared_ptr<ViewMailbox>& mailbox);

/// Brings the painter what was told.
void Deliver(ViewNews news, ViewPainter& painter);

/// How the view looks at first.
ViewLook LookOf(const ViewerOptions& options);

/// The path of a frame, from 1.
std::string FramePath(const std::string& folder, std::size_t number);

}  // namespace moontrace
