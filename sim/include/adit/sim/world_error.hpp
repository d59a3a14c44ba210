// The one exception of the world's part.
#pragma once

#include <stdexcept>
#include <string>

namespace adit::sim {

/// A course, a world file or a mesh that cannot be used. what() is one line: the file (or the course), what is wrong
/// with it, and what to do.
class WorldError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace adit::sim
