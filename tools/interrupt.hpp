// Ctrl-C and `kill`: the work ends after the frame at hand.
#pragma once

namespace adit::tools {

/// SIGINT and SIGTERM are remembered; a second one ends the program at once. SIGPIPE and SIGXFSZ are ignored: a reader
/// that has gone and a file that may not grow are told by the write that fails.
void watch_signals();

/// Has a signal asked to end?
[[nodiscard]] bool is_interrupted() noexcept;

}  // namespace adit::tools
