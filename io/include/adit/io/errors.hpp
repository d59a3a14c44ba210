// What can go wrong with files. Each message is one line that names the file or field, the value, and what to do.
#pragma once

#include <stdexcept>

namespace adit::io {

/// An input is missing, empty, truncated or not what it claims to be.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A configuration, a setting or a calibration is wrong.
struct ConfigError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An output cannot be written: no such folder, no permission, no space.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace adit::io
