#include "drivers/wire/dvl/pd6.hpp"

#include <algorithm>
#include <cstring>

#include "drivers/wire/message_list.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::wire {
namespace {

constexpr std::size_t head_size = 4;  // ":BI,"

/// Reads the numbers of a line. The line is invalid if a field is no number or is out of range.
class CheckedFields {
 public:
  explicit CheckedFields(std::string_view text) : fields_(text) {}

  double number(double lowest, double highest) {
    const auto value = fields_.number();
    const bool within = value && *value >= lowest && *value <= highest;
    sound_ &= within;
    return within ? *value : lowest;
  }
  std::string_view text() { return fields_.text(); }
  void require(bool holds) { sound_ &= holds; }
  bool sound() const { return sound_ && fields_.remaining() == 0; }

 private:
  TextFields fields_;
  bool sound_ = true;
};

std::optional<double> unless_zero(double value) {
  return value != 0 ? std::optional{value} : std::nullopt;
}

/// YYMMDDHHmmsshh of this century. A clock that was never set shows no date.
std::optional<std::chrono::local_time<std::chrono::milliseconds>> clock(std::string_view digits) {
  using namespace std::chrono;
  std::array<int, 7> pair{};
  for (std::size_t i = 0; i < pair.size(); ++i) {
    pair[i] = *parse_integer(digits.substr(2 * i, 2));
  }
  const auto [year_of_century, month_of_year, day_of_month, hour, minute, second, hundredth] = pair;
  const year_month_day date{year{2000 + year_of_century},
                            month{static_cast<unsigned>(month_of_year)},
                            day{static_cast<unsigned>(day_of_month)}};
  if (!date.ok() || hour > 23 || minute > 59 || second > 59) return std::nullopt;
  return local_days{date} + hours{hour} + minutes{minute} + std::chrono::seconds{second} +
         milliseconds{10 * hundredth};
}

void read_line(CheckedFields& fields, Pd6Attitude& m) {
  m.pitch_rad = radians(fields.number(-90, 90));
  m.roll_rad = radians(fields.number(-180, 180));
  m.heading_rad = radians(fields.number(0, 360));
}

void read_line(CheckedFields& fields, Pd6Timing& m) {
  const std::string_view digits = fields.text();
  const bool whole = digits.size() == 14 &&
                     std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
  fields.require(whole);
  if (whole) m.clock = clock(digits);
  m.salinity_ppt = fields.number(0, 99.9);
  m.temperature_k = fields.number(-99.9, 99.9) + zero_celsius_k;
  // A sensor at the surface reads a little above it; at no pressure at all 10.3 m of fresh water.
  constexpr double highest_m = 10.4;
  m.depth_m = fields.number(-highest_m, 9999.9);
  m.sound_speed_mps = unless_zero(fields.number(0, 9999.9));
  m.built_in_test = static_cast<unsigned>(fields.number(0, 65535));
}

template <char Reference, char Axes>
void read_line(CheckedFields& fields, Pd6Velocity<Reference, Axes>& m) {
  constexpr double bad_mmps = -32768;
  for (std::size_t i = 0; i < m.components; ++i) {
    const double mmps = fields.number(bad_mmps, 32767);
    if (mmps > bad_mmps) m.velocity_mps[i] = mmps / 1000;
  }
  const std::string_view status = fields.text();
  fields.require(status == "A" || status == "V" || status == "I");  // I: as NavQuests write V
  m.good = status == "A";
  if (!m.good) m.velocity_mps = {};
}

template <char Reference>
void read_line(CheckedFields& fields, Pd6Distance<Reference>& m) {
  constexpr double farthest_m = 99'999'999.99;
  for (double& component : m.distance_m) component = fields.number(-farthest_m, farthest_m);
  m.range_m = unless_zero(fields.number(0, 9999.99));
  m.since_good_s = fields.number(0, 999.99);
}

template <class M>
std::optional<Pd6::Message> read_as(std::string_view text) {
  CheckedFields fields{text};
  M m;
  read_line(fields, m);
  return fields.sound() ? std::optional<Pd6::Message>{m} : std::nullopt;
}

template <class... M>
MessageList<M...> list_of(std::variant<M...>*);
using Lines = decltype(list_of(static_cast<Pd6::Message*>(nullptr)));

template <class... M>
bool is_known(MessageList<M...>, std::string_view name) {
  return ((M::type == name) || ...);
}

template <class... M>
std::optional<Pd6::Message> read_named(MessageList<M...>, std::string_view name,
                                       std::string_view fields) {
  std::optional<Pd6::Message> message;
  static_cast<void>(((M::type == name && (message = read_as<M>(fields), true)) || ...));
  return message;
}

std::string_view name_of(Bytes line) { return as_text(line).substr(1, 2); }

std::string_view fields_of(Bytes line) {
  std::string_view text = as_text(line).substr(head_size);
  while (!text.empty() && (text.back() == '\r' || text.back() == '\n')) text.remove_suffix(1);
  return text;
}

bool is_head(Bytes bytes) {
  const auto upper = [](std::uint8_t c) { return c >= 'A' && c <= 'Z'; };
  if (bytes.size() > 1 && !upper(bytes[1])) return false;
  if (bytes.size() > 2 && !upper(bytes[2])) return false;
  return bytes.size() < head_size || bytes[3] == ',';
}

bool is_text(std::uint8_t c) { return c >= 0x20 && c <= 0x7e && c != ':'; }

/// Bytes of the line with its end. 0: the line is incomplete. Empty: it has no valid end.
std::optional<std::size_t> line_size(Bytes bytes) {
  const auto* const stop = std::find_if_not(
      bytes.data() + head_size, bytes.data() + std::min(bytes.size(), Pd6::max_frame), is_text);
  const auto size = static_cast<std::size_t>(stop - bytes.data());
  if (size == Pd6::max_frame) return std::nullopt;
  if (size == bytes.size()) return 0;
  if (*stop == '\n') return size + 1;
  if (*stop != '\r' || size + 1 == Pd6::max_frame) return std::nullopt;
  if (size + 1 == bytes.size()) return 0;
  return bytes[size + 1] == '\n' ? std::optional{size + 2} : std::nullopt;
}

}  // namespace

Scan Pd6::scan(Bytes bytes) {
  if (bytes.empty()) return Scan::need_more();
  if (bytes[0] != ':') {
    const void* const start = std::memchr(bytes.data(), ':', bytes.size());
    return Scan::skip(
        start ? static_cast<std::size_t>(static_cast<const std::uint8_t*>(start) - bytes.data())
              : bytes.size());
  }
  if (!is_head(bytes)) return Scan::skip(1);
  if (bytes.size() < head_size) return Scan::need_more();
  const bool known = is_known(Lines{}, name_of(bytes));
  const Scan damaged = known ? Scan::bad_checksum() : Scan::skip(1);
  const auto size = line_size(bytes);
  if (!size) return damaged;
  if (*size == 0) return Scan::need_more();
  return !known || decode(bytes.first(*size)) ? Scan::frame(*size) : damaged;
}

std::optional<Pd6::Message> Pd6::decode(Bytes frame) {
  if (frame.size() < head_size) return std::nullopt;
  return read_named(Lines{}, name_of(frame), fields_of(frame));
}

}  // namespace drydock::wire
