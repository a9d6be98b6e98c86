#include "hil/sky/rinex.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/throw_exception.hpp>
#include <cmath>
#include <stdexcept>

#include "hil/sky/rinex_fields.hpp"

namespace drydock::sky {
namespace {

using namespace std::chrono;

/// Column positions of the two versions, counted from 0.
struct Layout {
  std::size_t year, year_width, month, day, hour, minute, second, second_width;
  std::size_t clock;         ///< first number in the first line of a record
  std::size_t continuation;  ///< first number in the other lines
};
constexpr Layout version_2{3, 2, 6, 9, 12, 15, 17, 5, 22, 3};
constexpr Layout version_3{4, 4, 9, 12, 15, 18, 21, 2, 23, 4};

constexpr std::size_t number_width = 19;
constexpr std::size_t record_lines = 8;
constexpr std::size_t label_column = 60;

/// The numbers of a record in file order, one line of the file per line here.
// clang-format off
struct At {
  enum : std::size_t {
    af0, af1, af2,
    iode, crs, delta_n, m0,
    cuc, e, cus, sqrt_a,
    toe, cic, omega0, cis,
    i0, crc, omega, omega_dot,
    idot, codes_l2, week, l2p_flag,
    accuracy, health, group_delay, iodc,
    transmission, fit_interval, spare_1, spare_2,
    count
  };
};
// clang-format on

/// A record can be used without these.
constexpr bool may_be_blank(std::size_t field) {
  return field == At::iode || field == At::codes_l2 || field == At::week || field == At::l2p_flag ||
         field == At::accuracy || field == At::group_delay || field >= At::iodc;
}

class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  boost::system::result<Navigation, RinexError> read() {
    if (rest_.size() > most_navigation_bytes)
      return RinexError{1, fmt::format("longer than {} MB, which no navigation file is",
                                       most_navigation_bytes / 1'000'000)};
    read_header();
    while (!error_ && next()) {
      if (trimmed(line_).empty()) continue;
      if (file_.version < 3) {
        read_record(version_2, trimmed(columns(line_, 0, 2)));
      } else if (line_[0] == 'G') {
        read_record(version_3, columns(line_, 1, 2));
      } else if (line_[0] >= 'A' && line_[0] <= 'Z') {
        ++file_.passed_over;
        while (rest_.starts_with(' ')) next();
      } else {
        fail("expected a satellite, as G05");
      }
    }
    if (error_) return *error_;
    return std::move(file_);
  }

 private:
  bool next() {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line_ = rest_.substr(0, end);
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    return true;
  }

  /// Keeps the first error, because later errors may follow from it.
  void fail(std::string what) {
    if (!error_) error_ = RinexError{number_, std::move(what)};
  }

  void read_header() {
    const bool any = next();
    if (!any || trimmed(columns(line_, label_column, 20)) != "RINEX VERSION / TYPE") {
      number_ = 1;
      return fail("no RINEX file: RINEX VERSION / TYPE is expected in columns 61 to 80");
    }
    const auto version = real(trimmed(columns(line_, 0, 9)));
    if (!version || !(*version >= 2 && *version < 4))
      return fail(
          fmt::format("version '{}' is not read, allowed: 2 and 3", trimmed(columns(line_, 0, 9))));
    if (columns(line_, 20, 1) != "N")
      return fail(fmt::format("file type '{}', allowed: N (GPS navigation; mixed from version 3)",
                              columns(line_, 20, 1)));
    file_.version = *version;
    while (next()) {
      const auto label = trimmed(columns(line_, label_column, 20));
      if (label == "END OF HEADER") return;
      if (label == "LEAP SECONDS") {
        file_.leap_seconds = integer<int>(trimmed(columns(line_, 0, 6)));
        if (!file_.leap_seconds) return fail("LEAP SECONDS: expected a number in columns 1 to 6");
      }
    }
    fail("the file ends before END OF HEADER");
  }

  void read_record(const Layout& layout, std::string_view satellite) {
    Ephemeris record;
    record.line = number_;
    const auto prn = integer<int>(trimmed(satellite));
    if (!prn || *prn < 1 || *prn > highest_prn)
      return fail(fmt::format("satellite '{}', allowed: 1 to {}", satellite, highest_prn));
    record.prn = static_cast<std::uint8_t>(*prn);
    record.toc = epoch(layout);
    const auto values = numbers(layout, *prn);
    if (!error_) fill(values, record);
    if (!error_ && file_.records.size() == most_navigation_records)
      fail(fmt::format("more than {} GPS records", most_navigation_records));
    if (!error_) file_.records.push_back(record);
  }

  unsigned part(const char* name, std::size_t column, std::size_t width) {
    const auto text = trimmed(columns(line_, column, width));
    const auto value = integer<unsigned>(text);
    if (!value)
      fail(fmt::format("{} '{}' in columns {} to {}: expected a number", name, text, column + 1,
                       column + width));
    return value.value_or(0);
  }

  GpsTime epoch(const Layout& at) {
    unsigned y = part("year", at.year, at.year_width);
    if (at.year_width == 2) y += y < 80 ? 2000 : 1900;
    const year_month_day date{year{static_cast<int>(std::min(y, 9999U))},
                              month{part("month", at.month, 2)}, day{part("day", at.day, 2)}};
    const unsigned h = part("hour", at.hour, 2), m = part("minute", at.minute, 2);
    const auto second = real(trimmed(columns(line_, at.second, at.second_width)));
    if (error_) return {};
    if (!date.ok() || y < 1980 || y > 2199 || h > 23 || m > 59 || !second || *second < 0 ||
        *second >= 60) {
      fail("the time of the clock is none: expected year, month, day, hour, minute, second");
      return {};
    }
    return gps_time(date, hours{h} + minutes{m} + measurement::from_seconds(*second));
  }

  std::array<double, At::count> numbers(const Layout& layout, int prn) {
    std::array<double, At::count> values{};
    const int first_line = number_;
    std::size_t field = 0;
    for (std::size_t i = 0; i < record_lines && !error_; ++i) {
      if (i > 0 && !next()) {
        fail(fmt::format("the file ends within the record of G{:02} that begins in line {}", prn,
                         first_line));
        break;
      }
      std::size_t column = i == 0 ? layout.clock : layout.continuation;
      for (std::size_t n = i == 0 ? 3 : 4; n > 0; --n, ++field, column += number_width) {
        const auto text = trimmed(columns(line_, column, number_width));
        if (text.empty() && may_be_blank(field)) continue;
        const auto value = real(text);
        if (!value)
          fail(fmt::format("'{}' in columns {} to {}: expected a number", text, column + 1,
                           column + number_width));
        values[field] = value.value_or(0);
      }
    }
    return values;
  }

  void fill(const std::array<double, At::count>& v, Ephemeris& record) {
    constexpr double week_s = 604800;
    if (!(v[At::toe] >= 0 && v[At::toe] < week_s))
      return fail(fmt::format("G{:02} of line {}: toe is {} s of the week, allowed: 0 to 604800",
                              record.prn, record.line, v[At::toe]));
    if (!(v[At::health] >= 0 && v[At::health] <= 255))
      return fail(fmt::format("G{:02} of line {}: health is {}, allowed: 0 to 255", record.prn,
                              record.line, v[At::health]));
    const GpsTime week_begin = record.toc - week_of(record.toc).of_week;
    record.toe = week_begin + measurement::from_seconds(v[At::toe]);
    const double after_toc = measurement::seconds(record.toe - record.toc);
    record.toe -= std::lround(after_toc / week_s) * weeks{1};
    record.health = static_cast<unsigned>(v[At::health]);
    record.af0_s = v[At::af0], record.af1 = v[At::af1], record.af2_ps = v[At::af2];
    record.crs_m = v[At::crs], record.delta_n_radps = v[At::delta_n], record.m0_rad = v[At::m0];
    record.cuc_rad = v[At::cuc], record.e = v[At::e], record.cus_rad = v[At::cus];
    record.sqrt_a = v[At::sqrt_a];
    record.cic_rad = v[At::cic], record.omega0_rad = v[At::omega0], record.cis_rad = v[At::cis];
    record.i0_rad = v[At::i0], record.crc_m = v[At::crc], record.omega_rad = v[At::omega];
    record.omega_dot_radps = v[At::omega_dot], record.idot_radps = v[At::idot];
  }

  std::string_view rest_, line_;
  int number_ = 0;
  Navigation file_;
  std::optional<RinexError> error_;
};

}  // namespace

void throw_exception_from_error(const RinexError& error, const boost::source_location& where) {
  boost::throw_exception(std::invalid_argument(fmt::format("line {}: {}", error.line, error.what)),
                         where);
}

boost::system::result<Navigation, RinexError> read_navigation(std::string_view text) {
  return Reader(text).read();
}

}  // namespace drydock::sky
