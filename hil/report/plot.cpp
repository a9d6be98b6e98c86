#include "hil/report/plot.hpp"

#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>

namespace drydock::report {
namespace {

// Colours that stay distinct on paper, on a dark screen and for colour-blind readers (Okabe-Ito).
constexpr std::array<const char*, 6> colours{"#0072b2", "#d55e00", "#009e73",
                                             "#cc79a7", "#e69f00", "#56b4e9"};

struct TemporaryFile {
  std::string path = (std::filesystem::temp_directory_path() / "drydock-plot-XXXXXX").string();
  TemporaryFile() {
    const int fd = ::mkstemp(path.data());
    if (fd >= 0) ::close(fd);
  }
  ~TemporaryFile() { ::unlink(path.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
};

/// Quotes a text in single quotes; two of them inside are one. In double quotes gnuplot would
/// execute text in backquotes.
std::string quoted(std::string text) {
  std::erase(text, '\n');
  for (auto at = text.find('\''); at != std::string::npos; at = text.find('\'', at + 2))
    text.insert(at, 1, '\'');
  return '\'' + text + '\'';
}

std::string curve(const Curve& series, std::size_t index) {
  if (series.band) {
    return fmt::format(
        "$data{0} using 1:(-$2):2 with filledcurves fc rgb '#999999' fs transparent "
        "solid 0.35 noborder title {1}",
        index, quoted(series.label));
  }
  return fmt::format("$data{0} using 1:2 with {3} lc rgb '{1}' title {2}", index,
                     colours[index % colours.size()], quoted(series.label),
                     series.points ? "points pt 7 ps 0.35" : "lines lw 1.4");
}

bool goes_below_zero(const Figure& plot) {
  return std::ranges::any_of(plot.curves, [](const Curve& series) {
    return series.band || std::ranges::any_of(series.y, [](double y) { return y < 0; });
  });
}

/// With equal scales, the data determine the height of the picture.
int height_px(const Figure& plot) {
  if (!plot.equal_scales) return plot.log_x && plot.log_y ? 600 : 300;
  constexpr double inner_width = 600, margin = 90;  // 860 px without legend and labels
  constexpr double far = std::numeric_limits<double>::max();
  double left = far, right = -far, low = far, high = -far;
  for (const Curve& series : plot.curves)
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      left = std::min(left, series.x[i]), right = std::max(right, series.x[i]);
      low = std::min(low, series.y[i]), high = std::max(high, series.y[i]);
    }
  const double ratio = right > left ? (high - low) / (right - left) : 1;
  return static_cast<int>(std::clamp(margin + inner_width * ratio, 240.0, 600.0));
}

std::string script(const Figure& plot) {
  fmt::memory_buffer out;
  auto to = std::back_inserter(out);
  fmt::format_to(to,
                 "set term svg size 860,{} dynamic font 'sans,11' background '#ffffff'\n"
                 "set title {} font 'sans,13' noenhanced\n"
                 "set xlabel {} noenhanced\nset ylabel {} noenhanced\n"
                 "set grid lc rgb '#dddddd'\nset key outside right top noenhanced\n",
                 height_px(plot), quoted(plot.title), quoted(plot.x_label), quoted(plot.y_label));
  if (plot.equal_scales) fmt::format_to(to, "set size ratio -1\n");
  if (plot.y_limit > 0)
    fmt::format_to(to, "set yrange [{}:{}]\n", goes_below_zero(plot) ? -plot.y_limit : 0,
                   plot.y_limit);
  if (plot.y_down) fmt::format_to(to, "set yrange [] reverse\n");
  if (plot.log_x) fmt::format_to(to, "set logscale x\nset format x '10^{{%T}}'\n");
  if (plot.log_y) fmt::format_to(to, "set logscale y\nset format y '10^{{%T}}'\n");
  for (const Shade& shade : plot.shades)
    fmt::format_to(to,
                   "set object rectangle from first {:.6g}, graph 0 to first {:.6g}, graph 1 "
                   "behind fc rgb '#d55e00' fs transparent solid 0.18 noborder\n",
                   shade.from, shade.to);
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    fmt::format_to(to, "$data{} << END\n", i);
    const auto& s = plot.curves[i];
    for (std::size_t k = 0; k < s.x.size(); ++k)
      fmt::format_to(to, "{:.6g} {:.6g}\n", s.x[k], s.y[k]);
    fmt::format_to(to, "END\n");
  }
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    fmt::format_to(to, "{}{}", i == 0 ? "plot " : ", ", curve(plot.curves[i], i));
  }
  out.push_back('\n');
  return fmt::to_string(out);
}

}  // namespace

std::string render_svg(const Figure& plot) {
  const TemporaryFile file;
  {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> out{std::fopen(file.path.c_str(), "w"),
                                                              std::fclose};
    if (!out) return {};
    const auto text = script(plot);
    std::fwrite(text.data(), 1, text.size(), out.get());
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe{
      ::popen(fmt::format("gnuplot '{}' 2>/dev/null", file.path).c_str(), "r"), ::pclose};
  if (!pipe) return {};
  std::string svg;
  std::array<char, 8192> chunk{};
  while (const std::size_t n = std::fread(chunk.data(), 1, chunk.size(), pipe.get())) {
    svg.append(chunk.data(), n);
  }
  const auto begin = svg.find("<svg");
  return begin == std::string::npos ? std::string{} : svg.substr(begin);
}

}  // namespace drydock::report
