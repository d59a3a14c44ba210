// Runs the built program as a shell would.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace adit::testing {

struct Outcome {
  int exit_code = -1;  ///< 128 + signal when it was killed
  std::string out;
  std::string err;
};

struct Surroundings {
  std::filesystem::path folder{};  ///< to run in; empty: the test's own
  long file_bytes_max = 0;         ///< RLIMIT_FSIZE; 0: none
  int signal = 0;                  ///< sent after delay_ms
  int delay_ms = 0;
  std::filesystem::path signal_when{};  ///< the signal waits until this exists
};

[[nodiscard]] Outcome run_adit(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});

/// Lines of a text, without their ends.
[[nodiscard]] std::vector<std::string> lines_of(const std::string& text);
/// Cells of a CSV line that has no quotes in it.
[[nodiscard]] std::vector<std::string> cells_of(const std::string& line);
/// Rows of a CSV text, the header among them.
[[nodiscard]] std::vector<std::vector<std::string>> rows_of(const std::string& csv);

/// A picture of a passage: a dark disc in lit, grained rock. @param u_px,v_px  the disc's middle
std::string make_passage(const std::filesystem::path& path, int u_px = 200, int v_px = 110, int width = 320,
                         int height = 240);
/// A folder with `count` passages, frame0.png and so on; the disc moves to the right.
std::string make_passages(const std::filesystem::path& folder, int count);
/// The same as a video.
std::string make_clip(const std::filesystem::path& path, int count);

}  // namespace adit::testing
