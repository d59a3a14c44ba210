#include "eval_gallery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "adit/io/errors.hpp"
#include "adit/io/output_file.hpp"
#include "base64.hpp"
#include "eval_report.hpp"
#include "pages.hpp"

namespace adit::tools {
namespace {

namespace fs = std::filesystem;

/// Which answer a person looks at first: of the last method asked for.
std::size_t chief_row(const SetResult& set) {
  std::size_t chief = 0;
  for (std::size_t row = 0; row < set.methods.size(); ++row)
    if (!set.methods[row].baseline) chief = row;
  return chief;
}

int rank_of(eval::Verdict verdict) {
  switch (verdict) {
    case eval::Verdict::kMiss:
    case eval::Verdict::kAnsweredNone:
      return 0;
    case eval::Verdict::kRefusedOpen:
      return 1;
    case eval::Verdict::kNotCounted:
      return 2;
    case eval::Verdict::kRefusedNone:
      return 3;
    case eval::Verdict::kHit:
      return 4;
  }
  return 5;
}

struct Card {
  int rank;
  double error_rad;
  std::string html;
};

/// The worst first: a wrong heading before a needless refusal.
std::string cards_of(const EvalWork& work, const EvalResult& result, const fs::path& thumbs) {
  std::vector<Card> cards;
  for (const SetResult& set : result.sets) {
    if (set.sets.size() > 1) continue;
    const std::size_t s = set.sets.front();
    const std::size_t chief = set.methods[chief_row(set)].contender.front();
    for (std::size_t f = 0; f < result.frames[s].size(); ++f) {
      const JudgedFrame& judged = result.frames[s][f];
      if (!judged.readable) continue;
      std::string picture = "data:image/jpeg;base64,";
      if (thumbs.empty()) {
        picture += base64_of(judged.thumbnail.data(), judged.thumbnail.size());
      } else {
        const std::string name = fmt::format("{:02}_{:05}.jpg", s, f);
        io::write_file(thumbs / name,
                       {reinterpret_cast<const char*>(judged.thumbnail.data()), judged.thumbnail.size()});
        picture = "thumbs/" + name;
      }
      const eval::FrameScore& score = judged.methods[chief].score;
      cards.push_back({rank_of(score.verdict), std::isnan(score.error_rad) ? 0.0 : score.error_rad,
                       frame_card(work.sets[s].frames[f], judged, set, picture)});
    }
  }
  std::stable_sort(cards.begin(), cards.end(), [](const Card& a, const Card& b) {
    return a.rank != b.rank ? a.rank < b.rank : a.error_rad > b.error_rad;
  });
  std::string html;
  for (const Card& card : cards) html += card.html;
  return html;
}

std::string diagrams_of(const EvalResult& result) {
  std::string html;
  const SetResult& all = result.sets.back();
  for (std::size_t row = 0; row < all.methods.size(); ++row)
    if (!all.methods[row].figures.reliability.empty())
      html += reliability_diagram(all.methods[row].name, all.methods[row].figures, method_colour(row));
  return html;
}

/// Which methods are drawn, and by whose failures the frames are ordered.
std::string methods_of(const SetResult& set) {
  const std::size_t chief = chief_row(set);
  std::string boxes, choices;
  for (std::size_t row = 0; row < set.methods.size(); ++row) {
    const MethodResult& m = set.methods[row];
    boxes += fmt::format(
        "<label><input type=\"checkbox\" name=\"show\" value=\"{}\"{}><i style=\"background:{}\"></i>"
        "{}</label>\n",
        row, m.baseline ? "" : " checked", method_colour(row), html_of(m.name));
    choices += fmt::format("<option value=\"{}\"{}>{}</option>", row, row == chief ? " selected" : "", html_of(m.name));
  }
  return boxes + "<label>failures of <select id=\"chief\">" + choices + "</select> first</label>\n";
}

std::string sets_of(const EvalResult& result) {
  std::string html;
  for (const SetResult& set : result.sets)
    if (set.sets.size() == 1) html += "<option>" + html_of(set.name) + "</option>";
  return html;
}

std::string items_of(const std::vector<std::string>& texts) {
  std::string html;
  for (const std::string& text : texts) html += "<li>" + html_of(text) + "</li>";
  return html;
}

}  // namespace

const char* method_colour(std::size_t row) noexcept {
  // Told apart on dark rock, most of them by the colour-blind too.
  constexpr std::array kColours{"#ff5a4f", "#35c4ff", "#ffd23f", "#7cf27c", "#ff8ef3",
                                "#ff9f40", "#c9b6ff", "#ffffff", "#9be7d8", "#d7b98e"};
  return kColours[row % kColours.size()];
}

void write_gallery(const fs::path& path, const EvalWork& work, const EvalResult& result, const ReportOrigin& origin) {
  const bool one_file = path.extension() == ".html";
  const fs::path thumbs = one_file ? fs::path() : path / "thumbs";
  if (!one_file) io::make_folder(thumbs);
  const std::string page =
      filled_page(gallery_page(), {{"@PICTURES@", one_file ? "" : "'self' file:"},
                                   {"@CSS@", std::string(look_css())},
                                   {"@COMMAND@", html_of(origin.command)},
                                   {"@SUMMARY@", html_of(eval_text(work, result))},
                                   {"@DIAGRAMS@", diagrams_of(result)},
                                   {"@METHODS@", methods_of(result.sets.back())},
                                   {"@SETS@", sets_of(result)},
                                   {"@CARDS@", cards_of(work, result, thumbs)},
                                   {"@VERSION@", "adit " + html_of(origin.version)},
                                   {"@CHANGED_HEAD@", origin.changed.empty() ? "All settings are the defaults."
                                                                             : "Settings that are not the defaults:"},
                                   {"@CHANGED@", items_of(origin.changed)},
                                   {"@SETTINGS@", html_of(origin.settings)},
                                   {"@JS@", std::string(gallery_js())}});
  io::write_file(one_file ? path : path / "index.html", page);
}

}  // namespace adit::tools
