#include "run_shard.hpp"

#include <CLI/Error.hpp>
#include <cstdio>

#include "adit/io/configuration.hpp"

namespace adit::tools {
namespace {

void add_number(Fingerprint& fingerprint, double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  fingerprint.add(text);
}

void add_camera(Fingerprint& fingerprint, const CameraModel& model) {
  fingerprint.add(to_string(model.distortion_model));
  for (const double value :
       {static_cast<double>(model.width), static_cast<double>(model.height), model.focal_length_x_px,
        model.focal_length_y_px, model.principal_point_x_px, model.principal_point_y_px})
    add_number(fingerprint, value);
  for (const double value : model.distortion) add_number(fingerprint, value);
}

}  // namespace

void check_shard(const Shard& shard, const OutputOptions& outputs, const std::vector<std::string>& inputs,
                 std::int64_t limit) {
  if (!shard.is_given()) return;
  const auto refuse = [](const std::string& why) { throw CLI::ValidationError("--shard", why); };
  if (outputs.wants_pictures()) refuse("pictures and videos are made of the whole; leave out --video and --frames");
  if (!outputs.report.empty() || !outputs.folder.empty())
    refuse("a report is of the whole; leave out --report and --out");
  if (outputs.timing) refuse("times are never the same twice; leave out --timing");
  if (limit > 0) refuse("--limit counts the frames of the whole; leave it out");
  if (outputs.csv.empty() && outputs.jsonl.empty()) refuse("give a --csv FILE or --jsonl FILE for 'adit merge'");
  if (outputs.csv == "-" || outputs.jsonl == "-") refuse("parts are files; give --csv or --jsonl a name");
  for (const std::string& input : inputs)
    if (input.starts_with("/dev/")) refuse(input + " is a camera, which shows every part something else");
}

PartLabel run_label(const Shard& shard, const std::vector<std::string>& inputs,
                    std::vector<std::unique_ptr<io::FrameSource>> sources, double images_hz,
                    const LineSettings& settings) {
  PartLabel label{"run", shard, 0, "", "", ""};
  Fingerprint fingerprint;
  for (const std::string& input : inputs) fingerprint.add(input);
  fingerprint.add(io::to_yaml(settings.configuration));
  if (settings.camera) add_camera(fingerprint, settings.camera->model());
  add_number(fingerprint, images_hz);
  for (const auto& source : sources) {
    fingerprint.add(source->is_sequence() ? "sequence" : "images");
    add_number(fingerprint, static_cast<double>(source->frame_count().value_or(-1)));
    if (source->is_sequence()) {
      ++label.items;
      continue;
    }
    while (const auto frame = source->next()) {  // its pixels are not read
      fingerprint.add(frame->source);
      ++label.items;
    }
  }
  label.fingerprint = fingerprint.text();
  return label;
}

}  // namespace adit::tools
