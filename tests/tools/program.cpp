#include "program.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <thread>

#include "adit/io/video_file.hpp"
#include "scratch_folder.hpp"

namespace adit::testing {
namespace {

[[noreturn]] void become_adit(const std::vector<std::string>& arguments, const Surroundings& surroundings,
                              const std::filesystem::path& out, const std::filesystem::path& err) {
  std::vector<char*> argv{const_cast<char*>(ADIT_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
  ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
  if (!surroundings.folder.empty() && ::chdir(surroundings.folder.c_str()) != 0) ::_exit(126);
  if (surroundings.file_bytes_max > 0) {
    const rlimit limit{static_cast<rlim_t>(surroundings.file_bytes_max),
                       static_cast<rlim_t>(surroundings.file_bytes_max)};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ::execv(ADIT_PROGRAM, argv.data());
  ::_exit(127);
}

void send_signal(pid_t child, const Surroundings& surroundings) {
  using std::chrono::milliseconds;
  for (int i = 0; i < 3000 && !surroundings.signal_when.empty(); ++i) {
    if (std::filesystem::exists(surroundings.signal_when)) break;
    std::this_thread::sleep_for(milliseconds(20));
  }
  std::this_thread::sleep_for(milliseconds(surroundings.delay_ms));
  ::kill(child, surroundings.signal);
}

cv::Mat passage(int u_px, int v_px, int width, int height) {
  cv::Mat picture(height, width, CV_8UC3);
  cv::RNG(11).fill(picture, cv::RNG::UNIFORM, 110, 190);
  cv::circle(picture, {u_px, v_px}, height / 6, cv::Scalar(6, 8, 7), cv::FILLED);
  cv::GaussianBlur(picture, picture, {5, 5}, 0.0);
  return picture;
}

}  // namespace

Outcome run_adit(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
  const ScratchFolder scratch;
  const pid_t child = ::fork();
  if (child == 0) become_adit(arguments, surroundings, scratch / "out", scratch / "err");
  if (surroundings.signal != 0) send_signal(child, surroundings);
  int status = 0;
  ::waitpid(child, &status, 0);
  Outcome outcome;
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.out = read_text(scratch / "out");
  outcome.err = read_text(scratch / "err");
  return outcome;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : lines_of(csv)) rows.push_back(cells_of(line));
  return rows;
}

std::string make_passage(const std::filesystem::path& path, int u_px, int v_px, int width, int height) {
  EXPECT_TRUE(cv::imwrite(path.string(), passage(u_px, v_px, width, height)));
  return path.string();
}

std::string make_passages(const std::filesystem::path& folder, int count) {
  std::filesystem::create_directories(folder);
  for (int i = 0; i < count; ++i) make_passage(folder / ("frame" + std::to_string(i) + ".png"), 100 + 8 * i);
  return folder.string();
}

std::string make_clip(const std::filesystem::path& path, int count) {
  io::VideoFile video(path, 20.0);
  for (int i = 0; i < count; ++i) video.write(passage(100 + 4 * i, 110, 320, 240));
  video.commit();
  return path.string();
}

}  // namespace adit::testing
