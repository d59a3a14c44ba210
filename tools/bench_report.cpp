#include "bench_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <opencv2/core/version.hpp>

#include "version.hpp"

namespace adit::tools {
namespace {

/// A figure of merit and what it should be on the 640 x 480 frame.
struct Ratio {
  const char* name;
  double value;
  const char* aim;
};

double ratio(double above, double below) { return below > 0.0 ? above / below : 0.0; }

std::array<Ratio, 5> ratios_of(const BenchFigures& f) {
  const double frame = f.frame.median_ms();
  return {{{"frame / copy", ratio(frame, f.copy.median_ms()), "at most 10"},
           {"OpenCV chain / frame", ratio(f.opencv.median_ms(), frame), "at least 400"},
           {"strong OpenCV chain / frame", ratio(f.strong.median_ms(), frame), "at least 12"},
           {"frame p99.9 / median", ratio(f.frame.percentile_ms(0.999), frame), "at most 3, on an idle core"},
           {"3840 x 2160 / frame", ratio(f.frame_4k.median_ms(), frame), "at most 40.5"}}};
}

std::string row(const std::string& name, const Samples& samples) {
  return fmt::format("{:<34}{:>10.4f}{:>10.4f}{:>10.4f}{:>10.4f}{:>10.4f}{:>9}\n", name, samples.median_ms(),
                     samples.percentile_ms(0.9), samples.percentile_ms(0.99), samples.percentile_ms(0.999),
                     samples.percentile_ms(1.0), samples.count());
}

std::string stage_name(std::size_t stage) { return std::string(to_string(static_cast<Stage>(stage))); }

std::string spaced(std::string name) {
  for (char& letter : name) letter = letter == '_' ? ' ' : letter;
  return name;
}

nlohmann::ordered_json summary(const Samples& samples) {
  return {{"median", samples.median_ms()},      {"p90", samples.percentile_ms(0.9)},
          {"p99", samples.percentile_ms(0.99)}, {"p999", samples.percentile_ms(0.999)},
          {"max", samples.percentile_ms(1.0)},  {"samples", samples.count()}};
}

}  // namespace

std::string table_of(const BenchFigures& f) {
  std::string core = f.core < 0 ? std::string("not tied to a core") : fmt::format("tied to core {}", f.core);
  std::string text = fmt::format(
      "adit {}, {}, OpenCV {}\n{}\ntarget {}, one thread, {}, interrupted {} times\n"
      "frame: {}, {} x {} px BGR, patch {} px, element {} px, method paper\n\n",
      ADIT_VERSION, compiler(), CV_VERSION, cpu_model(), f.target, core, f.interruptions, f.frame_name, f.size.width,
      f.size.height, f.patch_size_px, f.structuring_element_size_px);
  text += fmt::format("{:<34}{:>10}{:>10}{:>10}{:>10}{:>10}{:>9}\n",
                      f.time_kind == TimeKind::kUsed ? "ms of CPU time" : "ms", "median", "p90", "p99", "p99.9", "max",
                      "samples");
  text += row("frame, whole", f.frame);
  for (std::size_t s = 0; s < f.stages.size(); ++s) text += row("  " + spaced(stage_name(s)), f.stages[s]);
  text += row("copy of the frame (memcpy)", f.copy);
  text += row("strong OpenCV chain", f.strong);
  text += row("OpenCV chain", f.opencv);
  text += row("frame, method adit", f.adit_frame);
  text += row("frame of noise", f.noise);
  text += row("frame of 3840 x 2160, 101 px", f.frame_4k);
  for (const auto& [name, samples] : f.targets) text += row("target " + name, samples);
  text += "\n";
  for (const Ratio& r : ratios_of(f)) text += fmt::format("{:<34}{:>10.2f}   ({})\n", r.name, r.value, r.aim);
  return text;
}

std::string json_of(const BenchFigures& f) {
  nlohmann::ordered_json json;
  json["adit_version"] = ADIT_VERSION;
  json["compiler"] = compiler();
  json["opencv_version"] = CV_VERSION;
  json["cpu_model"] = cpu_model();
  json["target"] = f.target;
  json["clock"] = f.time_kind == TimeKind::kUsed ? "cpu" : "wall";
  json["core"] = f.core;
  json["interruptions"] = f.interruptions;
  json["frame"] = f.frame_name;
  json["width"] = f.size.width;
  json["height"] = f.size.height;
  json["patch_size_px"] = f.patch_size_px;
  json["structuring_element_size_px"] = f.structuring_element_size_px;
  json["frame_ms_median"] = f.frame.median_ms();
  json["frame_ms_p90"] = f.frame.percentile_ms(0.9);
  json["frame_ms_p99"] = f.frame.percentile_ms(0.99);
  json["frame_ms_p999"] = f.frame.percentile_ms(0.999);
  json["frame_ms_max"] = f.frame.percentile_ms(1.0);
  json["frame_samples"] = f.frame.count();
  json["copy_ms_median"] = f.copy.median_ms();
  json["opencv_chain_ms_median"] = f.opencv.median_ms();
  json["opencv_strong_ms_median"] = f.strong.median_ms();
  json["adit_frame_ms_median"] = f.adit_frame.median_ms();
  json["adit_frame_ms_p999"] = f.adit_frame.percentile_ms(0.999);
  json["noise_ms_median"] = f.noise.median_ms();
  json["frame_4k_ms_median"] = f.frame_4k.median_ms();
  for (std::size_t s = 0; s < f.stages.size(); ++s) json["stage_ms"][stage_name(s)] = summary(f.stages[s]);
  json["target_ms_median"] = nlohmann::ordered_json::object();
  for (const auto& [name, samples] : f.targets) json["target_ms_median"][name] = samples.median_ms();
  for (const Ratio& r : ratios_of(f)) json["ratios"][r.name] = r.value;
  return json.dump(2) + "\n";
}

}  // namespace adit::tools
