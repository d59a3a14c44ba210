#include "report_shots.hpp"

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "adit/io/errors.hpp"
#include "adit/io/output_file.hpp"

namespace adit::tools {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kList = "shots.json";

fs::path path_of(const fs::path& folder, std::int64_t row, const char* what) {
  return folder / (std::to_string(row) + "." + what + ".jpg");
}

std::vector<std::int64_t> write_all(const fs::path& folder, const ThinnedPictures& thinned, const char* what) {
  std::vector<std::int64_t> rows;
  for (const ThinnedPictures::Picture& picture : thinned.pictures()) {
    io::write_file(path_of(folder, picture.row, what),
                   {reinterpret_cast<const char*>(picture.jpeg.data()), picture.jpeg.size()});
    rows.push_back(picture.row);
  }
  return rows;
}

void read_all(const fs::path& folder, const Json& rows, const char* what, ThinnedPictures& thinned) {
  for (const Json& row : rows) {
    const fs::path path = path_of(folder, row.get<std::int64_t>(), what);
    std::ifstream file(path, std::ios::binary);
    std::vector<unsigned char> jpeg{std::istreambuf_iterator<char>(file), {}};
    if (jpeg.empty())
      throw io::InputError(path.string() + ": the picture is not there; remove the folder, or fly again");
    thinned.add(row.get<std::int64_t>(), std::move(jpeg));
  }
}

}  // namespace

void write_shots(const fs::path& folder, const ReportPictures& pictures) {
  io::make_folder(folder);
  const Json list{{"width_px", pictures.width_px},
                  {"height_px", pictures.height_px},
                  {"tiles", pictures.tile_names},
                  {"frames", write_all(folder, pictures.frames, "frame")},
                  {"stages", write_all(folder, pictures.stages, "stages")}};
  io::write_file(folder / kList, list.dump() + "\n");
}

bool read_shots(const fs::path& folder, ReportPictures& pictures) {
  std::ifstream file(folder / kList, std::ios::binary);
  if (!file) return false;
  try {
    const Json list = Json::parse(file);
    ReportPictures read;
    read.width_px = list.at("width_px").get<int>();
    read.height_px = list.at("height_px").get<int>();
    read.tile_names = list.at("tiles").get<std::vector<std::string>>();
    read_all(folder, list.at("frames"), "frame", read.frames);
    read_all(folder, list.at("stages"), "stages", read.stages);
    pictures = std::move(read);
    return true;
  } catch (const Json::exception&) {
    throw io::InputError((folder / kList).string() + ": damaged; remove the folder, or fly again");
  }
}

}  // namespace adit::tools
