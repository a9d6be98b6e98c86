#include "drivers/guess/bus_guess.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "drivers/guess/guess_checksum.hpp"
#include "drivers/guess/guess_numbers.hpp"

namespace drydock::guess {
namespace {

using wire::Bytes;
using wire::CanFrame;

constexpr std::size_t most_kept = 4096, most_ids = 1024;
constexpr std::uint32_t bit_of_29_bits = 0x80000000;

/// Bits of a byte from the lowest to the highest that changes.
struct Bits {
  unsigned first = 0, count = 8;

  unsigned value(std::uint8_t byte) const { return byte >> first & ((1u << count) - 1); }
};

std::uint8_t changing(const Frames& frames, std::size_t at) {
  std::uint8_t mask = 0;
  for (const Bytes frame : frames)
    mask = static_cast<std::uint8_t>(mask | (frame[at] ^ frames[0][at]));
  return mask;
}

Bits bits_of(std::uint8_t mask) {
  const auto first = static_cast<unsigned>(std::countr_zero(mask));
  return {first, static_cast<unsigned>(std::bit_width(mask)) - first};
}

bool counts(const Frames& frames, std::size_t at, const Bits& bits) {
  if (bits.count < 2) return false;
  std::size_t steps = 0;
  for (std::size_t i = 1; i < frames.size(); ++i)
    steps += ((bits.value(frames[i][at]) - bits.value(frames[i - 1][at])) &
              ((1u << bits.count) - 1)) == 1;
  return frames.size() > 1 && steps * 10 >= (frames.size() - 1) * 9;
}

std::string signal(std::string_view name, std::size_t start, std::size_t bits, bool big, bool sign,
                   double low, double high) {
  return fmt::format(" SG_ {} : {}|{}@{}{} (1,0) [{:.6g}|{:.6g}] \"\" Vector__XXX\n", name, start,
                     bits, big ? 0 : 1, sign ? '-' : '+', low, high);
}

/// Bytes that are no number: the bits of each that change.
std::string bits_signal(const Frames& frames, std::size_t at) {
  const Bits bits = bits_of(changing(frames, at));
  unsigned low = 255, high = 0;
  for (const Bytes frame : frames) {
    low = std::min(low, bits.value(frame[at]));
    high = std::max(high, bits.value(frame[at]));
  }
  const std::string_view what = counts(frames, at, bits) ? "counter" : "byte";
  return signal(fmt::format("{}_{}", what, at), 8 * at + bits.first, bits.count, false, false, low,
                high);
}

struct Content {
  Frames frames;
  std::size_t shortest = 64, longest = 0;

  explicit Content(const std::vector<CanFrame>& all) {
    for (const CanFrame& frame : all) {
      frames.push_back(frame.payload());
      shortest = std::min<std::size_t>(shortest, frame.size);
      longest = std::max<std::size_t>(longest, frame.size);
    }
  }
};

bool is_real(const Guessed& one) { return one.type == "f32" || one.type == "f64"; }

/// As VFrameFormat numbers them; 0, its default: 11 bits without CAN FD.
int frame_format(bool extended, bool fd) { return (fd ? 14 : 0) + (extended ? 1 : 0); }

std::string number_name(const Guessed& one) { return fmt::format("number_{}", one.at); }

}  // namespace

void BusGuess::take(const CanFrame& frame, Time time) {
  if (frame.error || frame.remote || frame.size == 0) return;
  const std::uint32_t dbc_id = frame.id | (frame.extended ? bit_of_29_bits : 0);
  if (ids_.size() >= most_ids && !ids_.contains(dbc_id)) return;
  Id& id = ids_[dbc_id];
  if (id.frames.size() < most_kept) id.frames.push_back(frame);
  if (id.count++ == 0) id.first = time;
  id.last = time;
  id.fd = id.fd || frame.fd;
}

std::optional<double> BusGuess::Id::period_ms() const {
  if (!first || !last || count < 2 || *last <= *first) return {};
  return std::chrono::duration<double, std::milli>(*last - *first).count() /
         static_cast<double>(count - 1);
}

std::string BusGuess::message_text(std::uint32_t dbc_id, const Id& id) {
  const Content content(id.frames);
  const bool extended = (dbc_id & bit_of_29_bits) != 0;
  std::string text = fmt::format("\nBO_ {} id_{:0{}X}: {} Vector__XXX\n", dbc_id,
                                 dbc_id & ~bit_of_29_bits, extended ? 8 : 3, content.longest);
  for (const Guessed& one : guess_numbers(content.frames, 0, content.shortest)) {
    if (one.looks == Guessed::Looks::number)
      text += signal(number_name(one), 8 * one.at + (one.big_endian ? 7 : 0), 8 * one.size,
                     one.big_endian, one.type[0] != 'u', one.low, one.high);
    else if (changing(content.frames, one.at) != 0)
      text += bits_signal(content.frames, one.at);
  }
  return text;
}

std::string BusGuess::notes_text(std::uint32_t dbc_id, const Id& id) {
  const Content content(id.frames);
  std::vector<std::uint8_t> masks;
  for (std::size_t at = 0; at < content.shortest; ++at)
    masks.push_back(changing(content.frames, at));
  const auto period = id.period_ms();
  std::string text =
      fmt::format("CM_ BO_ {} \"{} frames{}; bits that change: {}; the first: {}\";\n", dbc_id,
                  id.count, period ? fmt::format(", one in {:.4g} ms", *period) : std::string(),
                  hex_of(masks), hex_of(content.frames[0]));
  if (period && *period >= 0.5 && *period < 60'000)
    text += fmt::format("BA_ \"GenMsgCycleTime\" BO_ {} {:.0f};\n", dbc_id, *period);
  if (const int format = frame_format((dbc_id & bit_of_29_bits) != 0, id.fd); format != 0)
    text += fmt::format("BA_ \"VFrameFormat\" BO_ {} {};\n", dbc_id, format);
  for (const Guessed& one : guess_numbers(content.frames, 0, content.shortest))
    if (one.looks == Guessed::Looks::number && is_real(one))
      text += fmt::format("SIG_VALTYPE_ {} {} : {};\n", dbc_id, number_name(one), one.size / 4);
  return text;
}

std::string BusGuess::dbc() const {
  if (ids_.empty()) return {};
  std::string messages, notes;
  for (const auto& [dbc_id, id] : ids_) {
    messages += message_text(dbc_id, id);
    notes += notes_text(dbc_id, id);
  }
  constexpr std::string_view says_so =
      "A guess from a capture: nothing here is certain. Compare it with the maker's manual, and "
      "give each signal its name, factor and unit. docs/sensors/described.md";
  return fmt::format(
      "VERSION \"\"\n\nNS_ :\n\nBS_:\n\nBU_:\n{}\nCM_ \"{}\";\n"
      "BA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 60000;\n"
      "BA_DEF_ BO_ \"VFrameFormat\" INT 0 15;\n"
      "BA_DEF_DEF_ \"GenMsgCycleTime\" 0;\nBA_DEF_DEF_ \"VFrameFormat\" 0;\n{}",
      messages, says_so, notes);
}

}  // namespace drydock::guess
