#include "eval_work.hpp"

#include <cmath>
#include <future>
#include <map>

#include "adit/io/errors.hpp"
#include "adit/io/image_file.hpp"
#include "eval_parts.hpp"
#include "eval_pictures.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "worker_pool.hpp"

namespace adit::tools {
namespace {

/// One thread's methods.
class Jury {
 public:
  explicit Jury(const EvalWork& work) : work_(&work) {
    for (const Contender& contender : work.contenders) answerers_.push_back(contender.make());
  }

  JudgedFrame judge(EvalFrame& frame, std::uint64_t number) {
    JudgedFrame judged;
    cv::Mat pixels;
    try {
      pixels = io::read_image(frame.image);
    } catch (const io::InputError& e) {
      judged.fault = e.what();
      return judged;
    }
    if (frame.size && (frame.size->first != pixels.cols || frame.size->second != pixels.rows))
      throw io::ConfigError(frame.image.string() + ": the image is " + std::to_string(pixels.cols) + "x" +
                            std::to_string(pixels.rows) + " px, but its marks were made for " +
                            std::to_string(frame.size->first) + "x" + std::to_string(frame.size->second));
    const auto& calibration = frame.camera ? frame.camera : work_->camera;
    const Camera camera(calibration ? *calibration : pinhole(pixels.cols, pixels.rows, work_->finder.assumed_hfov_deg));
    if (camera.model().width != pixels.cols || camera.model().height != pixels.rows)
      throw io::ConfigError(frame.image.string() + ": the image is not of the size of its camera's calibration");
    complete_truth(frame, camera, work_->score);
    judged.readable = true;
    judged.width = pixels.cols;
    judged.height = pixels.rows;
    const ShownFrame shown{frame, pixels, camera, calibration.has_value(), number};
    for (const auto& answerer : answerers_) {
      Judged one{answerer->answer(shown), {}};
      one.score = eval::score_of(frame.truth, one.given.answer, camera, work_->score);
      judged.methods.push_back(std::move(one));
    }
    if (work_->pictures) add_pictures(pixels, frame.truth, camera, work_->score, judged);
    frame.truth.ranges.range_m = {};  // a megabyte a frame, and no longer needed
    return judged;
  }

 private:
  const EvalWork* work_;
  std::vector<std::unique_ptr<Answerer>> answerers_;
};

void judge_all(EvalWork& work, EvalResult& result) {
  std::int64_t total = 0;
  for (const EvalSet& set : work.sets) {
    total += static_cast<std::int64_t>(set.frames.size());
    result.frames.emplace_back(set.frames.size());
  }
  Progress progress(total, "frames", work.quiet);
  std::vector<Jury> juries;
  for (int i = 0; i < work.jobs; ++i) juries.emplace_back(work);
  WorkerPool pool(work.jobs);
  std::vector<std::future<void>> tasks;
  for (std::size_t s = 0; s < work.sets.size(); ++s)
    for (std::size_t f = 0; f < work.sets[s].frames.size(); ++f) {
      if (!work.shard.has(static_cast<std::int64_t>(tasks.size()), total)) {
        tasks.emplace_back();  // another machine's
        continue;
      }
      tasks.push_back(pool.submit([&, s, f, number = tasks.size()](int worker) {
        if (is_interrupted()) return;
        result.frames[s][f] = juries[static_cast<std::size_t>(worker)].judge(work.sets[s].frames[f], number);
      }));
    }
  std::size_t done = 0;
  for (std::size_t s = 0; s < work.sets.size(); ++s)
    for (std::size_t f = 0; f < work.sets[s].frames.size(); ++f) {
      if (!tasks[done].valid()) {
        ++done;
        continue;
      }
      tasks[done].get();
      if (const std::string& fault = result.frames[s][f].fault; !fault.empty()) {
        ++result.unreadable;
        progress.say("adit: " + fault);
      }
      progress.show(static_cast<std::int64_t>(++done));
    }
  result.interrupted = is_interrupted();
  if (result.unreadable == total && !work.shard.is_given())
    throw io::InputError("none of the " + std::to_string(total) + " frames can be judged");
}

/// Places by number, the same over all sets.
std::map<std::string, int> place_numbers(const std::vector<EvalSet>& sets) {
  std::map<std::string, int> numbers;
  for (const EvalSet& set : sets)
    for (const EvalFrame& frame : set.frames) numbers.emplace(frame.place, static_cast<int>(numbers.size()));
  return numbers;
}

/// What is needed to make lines of the table.
struct Tables {
  const EvalWork& work;
  const EvalResult& result;
  std::map<std::string, int> places;

  void take(std::size_t set, std::size_t contender, std::vector<eval::ScoredFrame>& scored) const {
    for (std::size_t f = 0; f < result.frames[set].size(); ++f) {
      const JudgedFrame& judged = result.frames[set][f];
      const EvalFrame& frame = work.sets[set].frames[f];
      if (!judged.readable) continue;
      // Sequences of different sets are different ones.
      const int sequence =
          frame.sequence < 0 ? -1 : static_cast<int>(set) + static_cast<int>(work.sets.size()) * frame.sequence;
      scored.push_back({judged.methods[contender].score, places.at(frame.place), sequence, frame.yaw_rad});
    }
  }

  /// Hits of a contender on a set, and its median error to break ties.
  [[nodiscard]] std::pair<int, double> merit(std::size_t set, std::size_t contender) const {
    int hits = 0;
    std::vector<double> errors;
    for (const JudgedFrame& judged : result.frames[set]) {
      if (!judged.readable) continue;
      const eval::FrameScore& score = judged.methods[contender].score;
      hits += score.verdict == eval::Verdict::kHit ? 1 : 0;
      if (!std::isnan(score.error_rad)) errors.push_back(score.error_rad);
    }
    if (errors.empty()) return {hits, 0.0};
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::nth_element(errors.begin(), middle, errors.end());
    return {hits, -*middle};
  }

  /// Of those that were scanned, the one with the most hits on a set.
  [[nodiscard]] std::size_t best_scanned(std::size_t set) const {
    std::size_t best = work.contenders.size();
    for (std::size_t c = 0; c < work.contenders.size(); ++c)
      if (work.contenders[c].scanned_k > 0 && (best == work.contenders.size() || merit(set, c) > merit(set, best)))
        best = c;
    return best;
  }

  [[nodiscard]] MethodResult method(const std::vector<std::size_t>& sets, std::size_t contender) const {
    MethodResult line;
    line.name = work.contenders[contender].name;
    line.baseline = work.contenders[contender].baseline;
    std::vector<eval::ScoredFrame> scored;
    const bool scanned = work.contenders[contender].scanned_k > 0;
    if (scanned) line.about = "K =";
    for (const std::size_t set : sets) {
      line.contender.push_back(scanned ? best_scanned(set) : contender);
      if (scanned)
        line.about.append(line.contender.size() == 1 ? " " : "; ")
            .append(std::to_string(work.contenders[line.contender.back()].scanned_k));
      take(set, line.contender.back(), scored);
    }
    if (scanned) line.about += sets.size() == 1 ? " (tuned on this set itself)" : " (each tuned on its own set)";
    line.figures = eval::figures_of(scored, work.bootstrap);
    return line;
  }

  [[nodiscard]] SetResult set(const std::string& name, const std::vector<std::size_t>& sets) const {
    SetResult table{name, sets, {}};
    bool scanned_told = false;
    for (std::size_t c = 0; c < work.contenders.size(); ++c) {
      if (work.contenders[c].scanned_k > 0 && std::exchange(scanned_told, true)) continue;
      table.methods.push_back(method(sets, c));
    }
    return table;
  }
};

}  // namespace

EvalResult evaluate(EvalWork& work) {
  EvalResult result;
  if (work.parts.empty()) {
    judge_all(work, result);
  } else {
    take_eval_parts(work, result);
  }
  if (result.interrupted || work.shard.is_given()) return result;
  const Tables tables{work, result, place_numbers(work.sets)};
  std::vector<std::size_t> all;
  for (std::size_t s = 0; s < work.sets.size(); ++s) {
    result.sets.push_back(tables.set(work.sets[s].name, {s}));
    all.push_back(s);
  }
  if (all.size() > 1) result.sets.push_back(tables.set("all sets", all));
  return result;
}

}  // namespace adit::tools
