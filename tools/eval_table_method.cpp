// A method that is given by its answers.
#include <cmath>
#include <filesystem>
#include <locale>
#include <map>
#include <numbers>
#include <sstream>

#include "adit/io/errors.hpp"
#include "eval_csv.hpp"
#include "eval_methods.hpp"

namespace adit::tools {
namespace {

namespace fs = std::filesystem;

constexpr double kDegree = std::numbers::pi / 180.0;
/// A table made elsewhere names its frames by other folders: the last parts of the path must do, most of them first.
constexpr int kPartsMost = 4;

/// "set/frames/000000.png" of the last three parts; empty when there are not so many.
std::string tail_of(const fs::path& path, int parts) {
  std::vector<std::string> all;
  for (const fs::path& part : path.lexically_normal()) all.push_back(part.string());
  if (static_cast<int>(all.size()) < parts) return "";
  std::string tail;
  for (std::size_t i = all.size() - static_cast<std::size_t>(parts); i < all.size(); ++i) tail += "/" + all[i];
  return tail;
}

class AnswerTable {
 public:
  explicit AnswerTable(const std::string& path) : table_(path), path_(path) {
    source_ = table_.needed("source");
    status_ = table_.column("status");
    confidence_ = table_.column("confidence");
    u_px_ = table_.column("u_px");
    v_px_ = table_.column("v_px");
    azimuth_deg_ = table_.column("azimuth_deg");
    elevation_deg_ = table_.column("elevation_deg");
    openings_ = table_.column("openings");
    if (!(u_px_ && v_px_) && !azimuth_deg_)
      throw io::InputError(path +
                           ":1: columns u_px and v_px, or azimuth_deg, are needed, as 'adit run --csv' has them");
    for (std::size_t row = 0; row < table_.size(); ++row)
      for (int parts = 1; parts <= kPartsMost; ++parts)
        if (const std::string tail = tail_of(table_.text(row, source_), parts); !tail.empty())
          rows_of_[tail].push_back(row);
  }

  [[nodiscard]] GivenAnswer answer(const ShownFrame& shown) const {
    const auto row = row_of(shown.frame.image);
    if (!row) return {{}, "not_in_table"};
    const std::string status = status_ ? table_.text(*row, *status_) : "found";
    if (status != "found") return {{}, status};
    GivenAnswer given;
    given.status = status;
    given.answer.confidence = table_.number(*row, confidence_);
    const auto place = place_of(*row, shown.camera);
    if (!place) return {{}, "no_place"};
    given.answer.found = true;
    given.answer.place = *place;
    given.answer.openings = openings_of(*row, shown.camera);
    return given;
  }

 private:
  [[nodiscard]] std::optional<std::size_t> row_of(const fs::path& image) const {
    const fs::path whole = fs::weakly_canonical(image);
    for (int parts = kPartsMost; parts >= 1; --parts) {
      const auto found = rows_of_.find(tail_of(whole, parts));
      if (found == rows_of_.end()) continue;
      if (found->second.size() > 1)
        throw io::InputError(path_ + ": " + std::to_string(found->second.size()) + " rows may mean " + image.string() +
                             "; give more of its path in the column source");
      return found->second.front();
    }
    return std::nullopt;
  }

  /// "-12.31 2.05 0.93; 20.00 1.00 0.50": azimuth and elevation in degrees, and what follows is not looked at.
  [[nodiscard]] std::vector<Pixel> openings_of(std::size_t row, const Camera& camera) const {
    std::vector<Pixel> places;
    if (!openings_) return places;
    std::istringstream cell(table_.text(row, *openings_));
    for (std::string one; std::getline(cell, one, ';');) {
      double azimuth_deg = 0.0, elevation_deg = 0.0;
      std::istringstream angles(one);
      angles.imbue(std::locale::classic());
      if (!(angles >> azimuth_deg >> elevation_deg))
        throw io::InputError(table_.place(row) + ": openings: '" + one + "' is no azimuth and elevation in degrees");
      if (const auto place = camera.pixel_of(Bearing{azimuth_deg * kDegree, elevation_deg * kDegree}))
        places.push_back(*place);
    }
    return places;
  }

  [[nodiscard]] std::optional<Pixel> place_of(std::size_t row, const Camera& camera) const {
    const Pixel pixel{table_.number(row, u_px_), table_.number(row, v_px_)};
    if (std::isfinite(pixel.u_px) && std::isfinite(pixel.v_px)) return pixel;
    const double azimuth_deg = table_.number(row, azimuth_deg_);
    const double elevation_deg = table_.number(row, elevation_deg_);
    if (!std::isfinite(azimuth_deg)) return std::nullopt;
    return camera.pixel_of(
        Bearing{azimuth_deg * kDegree, std::isfinite(elevation_deg) ? elevation_deg * kDegree : 0.0});
  }

  CsvTable table_;
  std::string path_;
  std::size_t source_ = 0;
  std::optional<std::size_t> status_, confidence_, u_px_, v_px_, azimuth_deg_, elevation_deg_, openings_;
  std::map<std::string, std::vector<std::size_t>> rows_of_;
};

class TableAnswerer : public Answerer {
 public:
  explicit TableAnswerer(std::shared_ptr<const AnswerTable> table) : table_(std::move(table)) {}
  GivenAnswer answer(const ShownFrame& shown) override { return table_->answer(shown); }

 private:
  std::shared_ptr<const AnswerTable> table_;
};

}  // namespace

Contender table_contender(const std::string& name, const std::string& path) {
  const auto table = std::make_shared<const AnswerTable>(path);
  return {name, false, 0, [table] { return std::make_unique<TableAnswerer>(table); }};
}

}  // namespace adit::tools
