#include "hil/ocean/raster.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/throw_exception.hpp>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "rig_config/file_trouble.hpp"

namespace drydock::ocean {
namespace {

constexpr double most_points = 1e8;   // 400 MB
constexpr double farthest = 1e9;      // largest magnitude in a header
constexpr double deepest_m = 12'000;  // larger than every trench depth and mountain height

enum Key : std::size_t { ncols, nrows, xcorner, xcenter, ycorner, ycenter, cellsize, nodata, keys };
constexpr std::array<std::string_view, keys> key_names{"ncols",     "nrows",       "xllcorner",
                                                       "xllcenter", "yllcorner",   "yllcenter",
                                                       "cellsize",  "nodata_value"};

std::optional<double> number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool whole = error == std::errc{} && rest == word.data() + word.size();
  return whole && std::isfinite(value) ? std::optional{value} : std::nullopt;
}

std::string shown(std::string_view word) { return std::string(word.substr(0, 24)); }

class RasterReader {
 public:
  explicit RasterReader(std::string_view text) : text_(text) {}

  boost::system::result<Raster, RasterError> read() {
    if (!read_header() || !read_values()) return error_;
    return std::move(raster_);
  }

 private:
  /// The next word; empty at the end. `line_` is the line of the word.
  std::string_view word() {
    while (at_ < text_.size() && is_blank(text_[at_])) line_ += text_[at_++] == '\n';
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

  bool fail(std::string what) {
    error_ = {line_, std::move(what)};
    return false;
  }

  static std::optional<std::size_t> key_of(std::string_view word) {
    std::string lower(word.substr(0, 16));
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    const auto found = std::ranges::find(key_names, std::string_view(lower));
    if (found == key_names.end()) return std::nullopt;
    return static_cast<std::size_t>(found - key_names.begin());
  }

  bool read_header() {
    for (;;) {
      const std::size_t value_begin = at_;
      const int value_line = line_;
      const std::string_view name = word();
      if (name.empty()) return fail("the file ends before its values");
      if (number(name)) {
        at_ = value_begin;
        line_ = value_line;
        return check_header();
      }
      const auto key = key_of(name);
      if (!key)
        return fail(fmt::format("unknown header word '{}', allowed: {}", shown(name),
                                fmt::join(key_names, ", ")));
      if (header_[*key]) return fail(fmt::format("{} is there twice", key_names[*key]));
      const auto value = number(word());
      if (!value || std::abs(*value) > farthest)
        return fail(fmt::format("{} needs a number, -1e9 to 1e9", key_names[*key]));
      header_[*key] = value;
    }
  }

  bool check_header() {
    for (const Key key : {ncols, nrows, cellsize})
      if (!header_[key]) return fail(fmt::format("the header has no {}", key_names[key]));
    for (const Key corner : {xcorner, ycorner})
      if (header_[corner].has_value() == header_[corner + 1].has_value())
        return fail(fmt::format("the header needs either {} or {}", key_names[corner],
                                key_names[corner + 1]));
    const double columns = *header_[ncols], rows = *header_[nrows], spacing = *header_[cellsize];
    if (columns < 1 || rows < 1 || columns != std::floor(columns) || rows != std::floor(rows) ||
        columns * rows > most_points)
      return fail("ncols and nrows must be whole numbers of 1 or more, at most 1e8 points in all");
    if (spacing < 1e-9) return fail("cellsize must be at least 1e-9");
    raster_.columns = static_cast<std::size_t>(columns);
    raster_.rows = static_cast<std::size_t>(rows);
    raster_.spacing = spacing;
    raster_.x = header_[xcenter] ? *header_[xcenter] : *header_[xcorner] + spacing / 2;
    raster_.y = header_[ycenter] ? *header_[ycenter] : *header_[ycorner] + spacing / 2;
    return true;
  }

  bool read_values() {
    const std::size_t points = raster_.columns * raster_.rows;
    std::vector<float> from_north;
    while (from_north.size() < points) {
      const std::string_view text = word();
      if (text.empty())
        return fail(fmt::format("the file ends after {} of {} values", from_north.size(), points));
      const auto value = number(text);
      if (value && value == header_[nodata])
        return fail("a point has no value; fill the gaps of the raster first");
      if (!value || std::abs(*value) > deepest_m)
        return fail(fmt::format("'{}' is no value, -12000 to 12000 m", shown(text)));
      from_north.push_back(static_cast<float>(*value));
    }
    if (!word().empty()) return fail(fmt::format("there are more than {} values", points));
    for (std::size_t row = raster_.rows; row-- > 0;) {
      const auto begin = from_north.begin() + static_cast<std::ptrdiff_t>(row * raster_.columns);
      raster_.values.insert(raster_.values.end(), begin,
                            begin + static_cast<std::ptrdiff_t>(raster_.columns));
    }
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::array<std::optional<double>, keys> header_;
  Raster raster_;
  RasterError error_;
};

}  // namespace

void throw_exception_from_error(const RasterError& error, const boost::source_location& where) {
  boost::throw_exception(
      std::invalid_argument(fmt::format("raster line {}: {}", error.line, error.what)), where);
}

boost::system::result<Raster, RasterError> read_raster(std::string_view text) {
  return RasterReader(text).read();
}

boost::system::result<Raster, RasterError> read_raster_file(const std::string& path) {
  if (const auto why = rig_config::file_trouble(path); !why.empty())
    return RasterError{0, "cannot be read: " + why};
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return read_raster(text.view());
}

}  // namespace drydock::ocean
