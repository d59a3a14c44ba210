// What the program tells the shell. docs/manual.md lists the same numbers.
#pragma once

namespace adit::tools {

enum ExitCode : int {
  kSuccess = 0,
  kUnexpected = 1,        ///< a fault of the program
  kUsage = 2,             ///< an option is missing, unknown or has no such value
  kBadConfiguration = 3,  ///< a configuration, a setting or a calibration is wrong
  kBadInput = 4,          ///< an input is missing or cannot be read
  kSomeUnreadable = 5,    ///< the work was done, but some of its frames could not be read
  kOutputNotWritten = 6,  ///< no space, no permission, no such folder
  kInterrupted = 130,     ///< SIGINT or SIGTERM; what was written is whole
};

}  // namespace adit::tools
