#pragma once

/// CLI11's command line, named here and not defined: its header takes seconds to compile.
namespace CLI {  // NOLINT(readability-identifier-naming): its own name
class App;
}
