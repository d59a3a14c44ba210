// `adit mark`: openings marked by mouse, in a page of this machine.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <memory>
#include <thread>

#include "adit/io/errors.hpp"
#include "adit/io/frame_source.hpp"
#include "adit/io/image_file.hpp"
#include "adit/io/output_file.hpp"
#include "file_uses.hpp"
#include "interrupt.hpp"
#include "mark_server.hpp"
#include "number_in.hpp"
#include "progress.hpp"
#include "subcommands.hpp"

namespace adit::tools {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> inputs;
  std::string out;
  int port = 0;
};

/// "" where it can be read.
std::string fault_of_image(const fs::path& image) {
  try {
    (void)io::read_image(image);
    return "";
  } catch (const io::InputError& e) {
    return e.what();
  }
}

std::vector<fs::path> images_of(const std::vector<std::string>& inputs) {
  std::vector<fs::path> images;
  std::vector<std::string> faults;
  for (const auto& source : io::open_sources(inputs, {}))
    while (const auto frame = source->next()) {
      if (frame->file.empty())
        throw io::InputError(frame->source + ": a video or a camera; take images out of it first, as with ffmpeg");
      // Marks of an image that no program can read would be lost with the first that is put.
      if (const std::string fault = fault_of_image(frame->file); !fault.empty()) {
        faults.push_back(fault);
        continue;
      }
      images.push_back(frame->file);
    }
  if (images.empty()) throw io::InputError(faults.empty() ? inputs.front() + ": no image to mark" : faults.front());
  for (const std::string& fault : faults) print_line("adit: " + fault + "; it is left out");
  return images;
}

ExitCode run(const Options& options) {
  watch_signals();
  const std::vector<fs::path> images = images_of(options.inputs);
  FileUses uses;
  uses.reads_frames("IMAGES", options.inputs);
  uses.writes("--out", options.out);
  MarkFile file(options.out.empty() ? images.front().parent_path() / "openings.json" : fs::path(options.out), images);
  (void)io::PendingFile(file.path());  // before a page is promised: can marks be written there?
  {
    const MarkServer server(file, options.port);
    std::printf("%s\n", server.address().c_str());
    std::fflush(stdout);
    print_line(std::to_string(file.marked_count()) + " of " + std::to_string(images.size()) + " images are marked in " +
               file.path().string() + "; open the address in a browser, end with Ctrl-C");
    while (!is_interrupted() && !server.is_done()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  print_line(std::to_string(file.marked_count()) + " of " + std::to_string(images.size()) +
             " images are marked: " + file.path().string());
  return kSuccess;
}

}  // namespace

void add_mark(CLI::App& app, ExitCode& exit_code) {
  CLI::App* mark = app.add_subcommand("mark", "Mark openings in images by mouse, for eval");
  auto options = std::make_shared<Options>();
  mark->add_option("images", options->inputs, "Images, folders, patterns")->required()->type_name("IMAGES...");
  mark->add_option("--out", options->out, "The file of marks (openings.json beside the first image)")
      ->type_name("FILE.json");
  mark->add_option("--port", options->port, "Of the page, on 127.0.0.1 (any that is free)")
      ->type_name("N")
      ->check(NumberIn(1, 65535));
  mark->footer("Example: adit mark data/tunnel.jpg --out marks.json");
  mark->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace adit::tools
