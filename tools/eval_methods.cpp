#include "eval_methods.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "adit/eval/bootstrap.hpp"
#include "adit/fields.hpp"
#include "adit/io/draw.hpp"
#include "adit/io/image_file.hpp"

namespace adit::tools {
namespace {

/// Noise makes single black pixels anywhere; a mean over 5 x 5 takes four fifths of it away and moves no edge far.
constexpr int kDarkestWindow_px = 5;
constexpr std::uint64_t kFrameStep = 0x9e3779b97f4a7c15ull;

GivenAnswer found_at(Pixel place) { return {{true, place, eval::kUnknown, {}}, "found"}; }

class FinderAnswerer : public Answerer {
 public:
  FinderAnswerer(const FinderConfig& config, const LampPattern& lamp) : config_(config), lamp_(lamp), plain_(config) {
    plain_.set_lamp(lamp_);
  }

  GivenAnswer answer(const ShownFrame& shown) override {
    const OpenSpace found = finder_of(shown).find(io::view_of(shown.pixels));
    GivenAnswer given;
    given.status = to_string(found.status);
    given.answer.found = found.found();
    if (!found.found()) return given;
    given.answer.place = found.centroid_px;
    given.answer.confidence = found.confidence;
    for (int i = 0; i < found.opening_count; ++i)
      given.answer.openings.push_back(found.openings[static_cast<std::size_t>(i)].centroid_px);
    return given;
  }

 private:
  OpenSpaceFinder& finder_of(const ShownFrame& shown) {
    if (!shown.calibrated) return plain_;
    // Cameras of different sets take turns; one that has gone may have left its address to another, so the figures
    // are compared.
    const CameraModel& model = shown.camera.model();
    const bool same = calibrated_ && model_.width == model.width && model_.height == model.height &&
                      model_.focal_length_x_px == model.focal_length_x_px &&
                      model_.focal_length_y_px == model.focal_length_y_px &&
                      model_.principal_point_x_px == model.principal_point_x_px &&
                      model_.principal_point_y_px == model.principal_point_y_px &&
                      model_.distortion_model == model.distortion_model && model_.distortion == model.distortion;
    if (!same) calibrated_.emplace(config_, shown.camera).set_lamp(lamp_);
    model_ = model;
    return *calibrated_;
  }

  FinderConfig config_;
  LampPattern lamp_;
  OpenSpaceFinder plain_;
  std::optional<OpenSpaceFinder> calibrated_;
  CameraModel model_;
};

class CentreAnswerer : public Answerer {
 public:
  GivenAnswer answer(const ShownFrame& shown) override {
    return found_at({0.5 * (shown.pixels.cols - 1), 0.5 * (shown.pixels.rows - 1)});
  }
};

class RandomAnswerer : public Answerer {
 public:
  explicit RandomAnswerer(std::uint64_t seed) : seed_(seed) {}
  GivenAnswer answer(const ShownFrame& shown) override {
    eval::RandomNumbers random(seed_ ^ (kFrameStep * (shown.number + 1)));
    const double u = random.share(), v = random.share();
    return found_at({u * (shown.pixels.cols - 1), v * (shown.pixels.rows - 1)});
  }

 private:
  std::uint64_t seed_;
};

/// The darkest place in grey; of several, the one nearest to the middle of the image, where openings are likeliest.
class DarkestAnswerer : public Answerer {
 public:
  GivenAnswer answer(const ShownFrame& shown) override {
    cv::Mat grey, mean;
    cv::cvtColor(io::bgr_of(shown.pixels), grey, cv::COLOR_BGR2GRAY);
    cv::boxFilter(grey, mean, CV_32F, {kDarkestWindow_px, kDarkestWindow_px});
    const Pixel middle{0.5 * (mean.cols - 1), 0.5 * (mean.rows - 1)};
    Pixel best;
    float level = 256.0f;
    double away_px = 0.0;
    for (int v = 0; v < mean.rows; ++v)
      for (int u = 0; u < mean.cols; ++u) {
        const float here = mean.at<float>(v, u);
        if (here > level) continue;
        const double d_px = std::hypot(u - middle.u_px, v - middle.v_px);
        if (here == level && d_px >= away_px) continue;
        level = here;
        away_px = d_px;
        best = {static_cast<double>(u), static_cast<double>(v)};
      }
    return found_at(best);
  }
};

Contender paper_contender(const std::string& name, FinderConfig config, int k, bool scanned) {
  config.method = Method::kPaper;
  config.cluster_count = k;
  Contender contender = finder_contender(name, config);
  contender.baseline = true;
  contender.scanned_k = scanned ? k : 0;
  return contender;
}

}  // namespace

std::vector<std::string> known_methods() {
  std::vector<std::string> names;
  FinderConfig config;
  visit_fields(config, [&names](const FieldNote& note, auto& member) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(member)>, Method>)
      for (int i = 0; i <= static_cast<int>(note.maximum); ++i) names.emplace_back(to_string(static_cast<Method>(i)));
  });
  return names;
}

Contender finder_contender(const std::string& name, const FinderConfig& config, const LampPattern& lamp) {
  return {name, false, 0, [config, lamp] { return std::make_unique<FinderAnswerer>(config, lamp); }};
}

std::vector<Contender> baselines(const FinderConfig& config, std::uint64_t seed) {
  std::vector<Contender> all;
  all.push_back({"centre", true, 0, [] { return std::make_unique<CentreAnswerer>(); }});
  all.push_back({"random", true, 0, [seed] { return std::make_unique<RandomAnswerer>(seed); }});
  all.push_back({"darkest_pixel", true, 0, [] { return std::make_unique<DarkestAnswerer>(); }});
  FinderConfig published = config;
  published.clustering = Clustering::kExact;
  all.push_back(paper_contender(kPublishedName, published, kPublishedK, false));
  published.clustering = Clustering::kLloyd;
  all.push_back(paper_contender("paper_k10_lloyd", published, kPublishedK, false));
  for (int k = kScannedFewest; k <= kScannedMost; ++k) all.push_back(paper_contender("paper_best_k", config, k, true));
  return all;
}

}  // namespace adit::tools
