#include <algorithm>

#include "drivers/wire/dvl/pd6.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::wire {
namespace {

constexpr double bad_mmps = -32768;

/// Writes one line. Numbers are padded with blanks to the widths of the document.
class Line {
 public:
  explicit Line(std::span<std::uint8_t> out) : out_(out) {}

  void name(std::string_view letters) {
    out_.text(":");
    out_.text(letters);
  }
  void text(std::string_view field) {
    out_.text(",");
    out_.text(field);
  }
  void number(double value, std::size_t width, int decimals) { put(value, width, decimals, false); }
  void signed_number(double value, std::size_t width, int decimals) {
    put(value, width, decimals, true);
  }
  std::size_t finish() {
    out_.text("\r\n");
    return out_.size();
  }

 private:
  void put(double value, std::size_t width, int decimals, bool plus) {
    std::array<std::uint8_t, 64> digits;
    FieldWriter number{digits};
    number.number(value, decimals);
    std::string_view shown = as_text(number.written());
    const bool below_zero = shown.starts_with('-');
    const bool rounds_to_zero = shown.find_first_not_of("-0.") == shown.npos;
    if (below_zero && rounds_to_zero) shown.remove_prefix(1);
    const bool sign = plus && !shown.starts_with('-');
    out_.text(",");
    for (std::size_t i = shown.size() + (sign ? 1 : 0); i < width; ++i) out_.text(" ");
    if (sign) out_.text("+");
    out_.text(shown);
  }

  FieldWriter out_;
};

void write(Line& line, const Pd6Attitude& m) {
  line.signed_number(degrees(m.pitch_rad.value_or(0)), 6, 2);
  line.signed_number(degrees(m.roll_rad.value_or(0)), 6, 2);
  line.number(degrees(m.heading_rad.value_or(0)), 6, 2);
}

void write_clock(Line& line, std::chrono::local_time<std::chrono::milliseconds> clock) {
  using namespace std::chrono;
  const auto midnight = floor<days>(clock);
  const year_month_day date{midnight};
  const hh_mm_ss time{clock - midnight};
  const std::array<long, 7> pairs{static_cast<int>(date.year()) % 100,
                                  static_cast<unsigned>(date.month()),
                                  static_cast<unsigned>(date.day()),
                                  time.hours().count(),
                                  time.minutes().count(),
                                  time.seconds().count(),
                                  time.subseconds().count() / 10};
  std::array<char, 14> digits;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    digits[2 * i] = static_cast<char>('0' + pairs[i] / 10 % 10);
    digits[2 * i + 1] = static_cast<char>('0' + pairs[i] % 10);
  }
  line.text({digits.data(), digits.size()});
}

void write(Line& line, const Pd6Timing& m) {
  if (m.clock) {
    write_clock(line, *m.clock);
  } else {
    line.text("00000000000000");
  }
  line.number(m.salinity_ppt, 4, 1);
  line.signed_number(m.temperature_k.value_or(zero_celsius_k) - zero_celsius_k, 5, 1);
  line.number(m.depth_m, 6, 1);
  line.number(m.sound_speed_mps.value_or(0), 6, 1);
  line.number(m.built_in_test, 3, 0);
}

/// A velocity beyond the range of the wire must not become the mark of a bad velocity.
template <char Reference, char Axes>
void write(Line& line, const Pd6Velocity<Reference, Axes>& m) {
  for (std::size_t i = 0; i < m.components; ++i) {
    const auto& velocity = m.velocity_mps[i];
    const double mmps =
        velocity ? std::clamp(*velocity * 1e3, bad_mmps + 1, -bad_mmps - 1) : bad_mmps;
    line.signed_number(mmps, 6, 0);
  }
  line.text(m.good ? "A" : "V");
}

template <char Reference>
void write(Line& line, const Pd6Distance<Reference>& m) {
  for (const double component : m.distance_m) line.signed_number(component, 12, 2);
  line.number(m.range_m.value_or(0), 7, 2);
  line.number(m.since_good_s, 6, 2);
}

}  // namespace

std::size_t encode(const Pd6::Message& message, std::span<std::uint8_t> out) {
  Line line{out};
  std::visit(
      [&line](const auto& m) {
        line.name(m.type);
        write(line, m);
      },
      message);
  return line.finish();
}

}  // namespace drydock::wire
