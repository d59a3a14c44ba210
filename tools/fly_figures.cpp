#include "fly_figures.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "adit/io/output_file.hpp"

extern char** environ;

namespace adit::tools {
namespace {

namespace fs = std::filesystem;

/// Text inside gnuplot's single quotes.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? "''" : c == '\n' ? "'.\"\\n\".'" : std::string(1, c);
  return out + "'";
}

std::string terminal(bool svg, int width, int height) {
  char text[160];
  std::snprintf(text, sizeof text, "set terminal %s size %d,%d font 'DejaVu Sans,%d' background rgb 'white'\n",
                svg ? "svg" : "pngcairo", width, height, svg ? 13 : 12);
  return text;
}

constexpr const char* kLook =
    "set datafile separator ','\n"
    "set encoding utf8\n"
    "set border lw 1.2 lc rgb '#444444'\n"
    "set grid lc rgb '#dddddd' lw 1 lt 1\n"
    "set tics nomirror\n";

std::string fig3(const fs::path& table, const std::string& title) {
  const std::string t = quoted(table.string());
  return std::string(kLook) + "set multiplot layout 1,2 title " + quoted(title) +
         " font ',14' noenhanced\n"
         "stats " +
         t +
         " using (column('x_m')) name 'X' nooutput\n"
         "stats " +
         t +
         " using (column('y_m')) name 'Y' nooutput\n"
         "stats " +
         t +
         " using (column('z_m')) name 'Z' nooutput\n"
         "stats " +
         t +
         " using (column('stamp_s')) name 'T' nooutput\n"
         "span = (X_max-X_min > Y_max-Y_min ? X_max-X_min : Y_max-Y_min) + 2\n"
         "zfloor = Z_min - 0.25*(Z_max-Z_min) - 1.0\n"
         "set xrange [0.5*(X_min+X_max)-0.5*span : 0.5*(X_min+X_max)+0.5*span]\n"
         "set yrange [0.5*(Y_min+Y_max)-0.5*span : 0.5*(Y_min+Y_max)+0.5*span]\n"
         "set zrange [zfloor : Z_max+0.25*(Z_max-Z_min)+1.0]\n"
         "set xyplane at zfloor\n"
         "set view 52,32,1.0,1.0\n"
         "set xlabel 'x [m]' offset 0,-0.5\nset ylabel 'y [m]' offset 0.5,-0.5\nset zlabel 'z [m]' rotate by 90 "
         "offset -1,0\n"
         "set ztics offset 0.5,0\n"
         "set key at screen 0.02,0.92 left top samplen 2\n"
         "stats " +
         t +
         " using (abs(column('sx'))) name 'S' nooutput\n"
         "half = exists('S_max') ? (S_max > 0.25 ? 1.3*S_max : 0.3) : 1\n"
         "splot " +
         t +
         " using (column('x_m')):(column('y_m')):(zfloor) with lines lw 1.5 lc rgb '#bbbbbb' title 'on the ground', "
         "'' using (column('x_m')):(column('y_m')):(column('z_m')) with lines lw 2.5 lc rgb '#0060ad' title 'path', "
         "'' every 1000000::0::0 using (column('x_m')):(column('y_m')):(column('z_m')) with points pt 7 ps 1.4 lc rgb "
         "'#2ca02c' title 'start', "
         "'' every ::T_records-1::T_records-1 using (column('x_m')):(column('y_m')):(column('z_m')) with points pt 5 "
         "ps 1.4 lc rgb '#d62728' title 'end'\n"
         "unset zlabel\nset autoscale\nset xrange [0:T_max]\nset yrange [-half:half]\n"
         "set xlabel 'time [s]' offset 0,0\nset ylabel 's_x' offset 0,0\n"
         "set key top right inside horizontal samplen 2 box lc rgb '#dddddd' opaque\n"
         "clip(a) = abs(a) < 80 ? tan(a*pi/180) : NaN\n"
         "plot " +
         t +
         " using (column('stamp_s')):(clip(column('passage_azimuth_deg'))) with lines lw 1.2 lc rgb '#ff9f50' title "
         "'passage 5 m ahead', '' using (column('stamp_s')):(column('sx')) with lines lw 1.4 lc rgb '#0060ad' title "
         "'s_x (right is positive)'\n"
         "unset multiplot\n";
}

struct MapView {
  double x_min_m, x_max_m, y_min_m, y_max_m;
  [[nodiscard]] double span_m() const { return std::max(x_max_m - x_min_m, y_max_m - y_min_m); }
};

std::string fig4(const fs::path& table, const fs::path& png, const std::string& title, const sim::OccupancyPicture& m,
                 const MapView& view) {
  const std::string t = quoted(table.string());
  const double arrow_m = std::clamp(0.03 * view.span_m(), 0.6, 8.0);
  char numbers[400];
  std::snprintf(numbers, sizeof numbers, "set xrange [%.2f:%.2f]\nset yrange [%.2f:%.2f]\nL = %.3f\ngap = %.3f\n",
                view.x_min_m, view.x_max_m, view.y_min_m, view.y_max_m, arrow_m, 0.9 * arrow_m);
  char place[200];
  std::snprintf(place, sizeof place, " binary filetype=png origin=(%.4f,%.4f) dx=%.4f dy=%.4f with rgbimage notitle, ",
                m.x_min_m, m.y_min_m, m.cell_m, m.cell_m);
  // An arrow wherever the vehicle has gone on by `gap` since the last one.
  return std::string(kLook) + numbers + "set title " + quoted(title) +
         " noenhanced\nset size ratio -1\nset xlabel 'x [m]'\nset ylabel 'y [m]'\nunset grid\n"
         "set object 1 rectangle from graph 0,0 to graph 1,1 behind fillcolor rgb '#cdcdcd' fillstyle solid noborder\n"
         "set key outside bottom center horizontal samplen 3\n"
         "px = 1e9\npy = 1e9\n"
         "due(x,y) = ((x-px)**2+(y-py)**2 > gap**2 ? (px=x, py=y, 1) : 0)\n"
         "plot " +
         quoted(png.string()) + place + t +
         " using (column('x_m')):(column('y_m')) with lines lw 1 lc rgb '#7f9fbf' title 'path', "
         "'' using (due(column('x_m'),column('y_m')) ? column('x_m') : NaN):(column('y_m')):"
         "(1.5*L*cos((column('yaw_deg')-column('azimuth_deg'))*pi/180)):"
         "(1.5*L*sin((column('yaw_deg')-column('azimuth_deg'))*pi/180)) with vectors head size screen 0.009,20 filled "
         "lw 1.8 lc rgb '#2ca02c' title 'direction command', "
         "px=1e9, py=1e9, "
         "'' using (due(column('x_m'),column('y_m')) ? column('x_m') : NaN):(column('y_m')):"
         "(0.8*L*cos(column('yaw_deg')*pi/180)):(0.8*L*sin(column('yaw_deg')*pi/180)) with vectors head size "
         "screen 0.009,20 filled lw 2.4 lc rgb '#d62728' title 'pose'\n";
}

/// Runs gnuplot on a script; what it says goes nowhere. Returns why it failed, "" when it did not.
std::string run_gnuplot(const fs::path& script) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::string name = "gnuplot", argument = script.string();
  char* arguments[] = {name.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int error = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return std::string("gnuplot cannot be started (") + std::strerror(error) + "); is it installed?";
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  return "gnuplot failed on " + script.string() + "; run it by hand to see why";
}

MapView view_of(const fs::path& table) {
  // The way flown with a margin: rays that look far into side passages would make the picture small.
  std::ifstream rows(table);
  std::string line;
  std::getline(rows, line);
  MapView view{1e9, -1e9, 1e9, -1e9};
  while (std::getline(rows, line)) {
    double stamp = 0.0, x = 0.0, y = 0.0;
    if (std::sscanf(line.c_str(), "%*d,%lf,%lf,%lf", &stamp, &x, &y) != 3) continue;
    view = {std::min(view.x_min_m, x), std::max(view.x_max_m, x), std::min(view.y_min_m, y), std::max(view.y_max_m, y)};
  }
  constexpr double kMargin_m = 7.0;
  return {view.x_min_m - kMargin_m, view.x_max_m + kMargin_m, view.y_min_m - kMargin_m, view.y_max_m + kMargin_m};
}

/// The picture of a course that runs north is narrower than its title: how it ended then has a line of its own.
std::string fitted(std::string title, int width_px) {
  constexpr int kLetter_px = 9;
  const auto end = title.rfind(": ");
  if (end != std::string::npos && static_cast<int>(title.size()) * kLetter_px > width_px) title[end + 1] = '\n';
  return title;
}

}  // namespace

std::string draw_figures(const fs::path& folder, const FigureTitle& title, const sim::OccupancyPicture& map) {
  const fs::path table = folder / "flight.csv";
  const MapView view = view_of(table);
  const double shape = (view.y_max_m - view.y_min_m) / (view.x_max_m - view.x_min_m);
  const int width = shape > 1.0 ? std::max(560, static_cast<int>(1000 / shape)) : 1000;
  const int height = shape > 1.0 ? 1080 : std::max(420, static_cast<int>(900 * shape) + 150);
  for (const bool svg : {false, true}) {
    const std::string extension = svg ? ".svg" : ".png";
    for (const int figure : {3, 4}) {
      if (figure == 4 && map.width == 0) continue;
      io::PendingFile picture(folder / ("fig" + std::to_string(figure) + extension));
      const std::string body =
          figure == 3 ? fig3(table, title.text) : fig4(table, folder / "map.png", fitted(title.text, width), map, view);
      const std::string text = terminal(svg, figure == 3 ? 1400 : width, figure == 3 ? 560 : height) + "set output " +
                               quoted(picture.temporary_path().string()) + "\n" + body;
      const fs::path script = folder / ("fig" + std::to_string(figure) + ".gnuplot");
      io::write_file(script, text);
      if (const std::string why = run_gnuplot(script); !why.empty()) return why;
      picture.commit();
      std::error_code ignored;
      fs::remove(script, ignored);
    }
  }
  return "";
}

}  // namespace adit::tools
