// `adit explain`: what the finder did to one frame, as one labelled picture.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <opencv2/imgcodecs.hpp>

#include "adit/io/errors.hpp"
#include "adit/io/image_file.hpp"
#include "adit/io/output_file.hpp"
#include "adit/io/panel.hpp"
#include "file_uses.hpp"
#include "finder_options.hpp"
#include "grey16_doubt.hpp"
#include "progress.hpp"
#include "subcommands.hpp"

namespace adit::tools {
namespace {

struct ExplainOptions {
  std::string image;
  std::string output;
  FinderOptions finder;
};

/// "frame.jpg" makes "frame-explained.png" in the current folder.
std::filesystem::path output_of(const ExplainOptions& options) {
  if (options.output.empty()) return std::filesystem::path(options.image).stem().string() + "-explained.png";
  const std::filesystem::path path = options.output;
  const std::string extension = path.extension().string();
  if (options.output != "-" && extension != ".png" && extension != ".jpg") {
    throw CLI::ValidationError("--output", "'" + options.output + "' must end in .png or .jpg");
  }
  return path;
}

void explain(const ExplainOptions& options) {
  const std::filesystem::path output = output_of(options);
  FileUses uses;
  uses.reads("IMAGE", options.image);
  uses.reads(options.finder);
  uses.writes("--output", output);
  const FinderConfig config = configuration_of(options.finder).finder;
  const std::optional<Camera> camera = camera_of(options.finder);
  io::PanelSubject subject{.name = std::filesystem::path(options.image).filename().string(),
                           .frame = io::read_image(options.image),
                           .open_space = {},
                           .stages = {},
                           .config = config,
                           .has_camera = camera.has_value()};
  OpenSpaceFinder finder = make_finder(config, camera);
  finder.set_lamp(lamp_of(options.finder));
  subject.open_space = finder.explain(io::view_of(subject.frame), subject.stages);
  std::vector<std::uint8_t> file;
  const std::string extension = output == "-" ? ".png" : output.extension().string();
  if (!cv::imencode(extension, io::explain_panel(subject), file)) {
    throw io::OutputError(output.string() + ": OpenCV cannot make a " + extension + " of the panel");
  }
  io::write_file(output, {reinterpret_cast<const char*>(file.data()), file.size()});
  if (const std::string doubt = grey16_doubt(subject.frame, config.grey16_depth_bits); !doubt.empty()) {
    print_line("adit: " + options.image + ": " + doubt);
  }
  if (output == "-") return;
  const OpenSpace& seen = subject.open_space;
  std::printf("%s: %s, confidence %.2f; panel in %s\n", options.image.c_str(),
              std::string(to_string(seen.status)).c_str(), seen.confidence, output.string().c_str());
}

}  // namespace

void add_explain(CLI::App& app, ExitCode& exit_code) {
  CLI::App* explain_app = app.add_subcommand("explain", "Draw every stage for one image, in one labelled panel");
  auto options = std::make_shared<ExplainOptions>();
  explain_app->add_option("IMAGE", options->image, "png, jpg, bmp, tif, pgm or ppm")->required()->type_name("IMAGE");
  explain_app
      ->add_option("-o,--output", options->output, "Where the panel goes [IMAGE's name + -explained.png]; - is stdout")
      ->type_name("FILE.png");
  add_finder_options(*explain_app, options->finder);
  add_lamp_option(*explain_app, options->finder);
  explain_app->footer("Example: adit explain data/tunnel.jpg -o panel.png");
  explain_app->callback([options, &exit_code] {
    explain(*options);
    exit_code = kSuccess;
  });
}

}  // namespace adit::tools
