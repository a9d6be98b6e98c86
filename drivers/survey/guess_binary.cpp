#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

#include "drivers/survey/guess.hpp"
#include "drivers/wire/bytes.hpp"
#include "drivers/wire/described/checksums.hpp"

namespace drydock::survey {
namespace {

using wire::Bytes;
using wire::described::Checksum;

constexpr std::size_t longest = 512, most_bytes = 1u << 18, fewest_frames = 4;

struct Frames {
  std::size_t length = 0;
  std::vector<Bytes> all;
};

/// The distance at which bytes are most often equal: the length of frames, or a multiple of it.
std::size_t period_of(Bytes capture) {
  std::size_t best = 0, most = 0;
  const std::size_t limit = std::min(longest, capture.size() / fewest_frames);
  for (std::size_t lag = 4; lag <= limit; ++lag) {
    std::size_t equal = 0;
    for (std::size_t i = 0; i + lag < capture.size(); ++i) equal += capture[i] == capture[i + lag];
    if (equal > most + most / 50) {  // a multiple of a period is no better
      best = lag;
      most = equal;
    }
  }
  return most * 8 > capture.size() ? best : 0;
}

bool is_constant(const Frames& frames, std::size_t at) {
  const std::uint8_t first = frames.all[0][at];
  const auto same = std::ranges::count_if(frames.all, [&](Bytes f) { return f[at] == first; });
  return static_cast<std::size_t>(same) * 10 >= frames.all.size() * 9;
}

/// Cuts at those places that share the two bytes of the first cut.
Frames cut(Bytes capture, std::size_t phase, std::size_t length) {
  Frames frames{length, {}};
  for (std::size_t at = phase; at + length <= capture.size();) {
    const bool synced = capture[at] == capture[phase] && capture[at + 1] == capture[phase + 1];
    if (synced) frames.all.push_back(capture.subspan(at, length));
    at += synced ? length : 1;
  }
  return frames;
}

struct Sum {
  std::string_view name;
  bool big_endian = false;
  std::size_t from = 0;  ///< the first byte that it covers
};

std::uint32_t stored(Bytes frame, std::size_t size, bool big_endian) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size; ++i)
    value = value << 8 | frame[frame.size() - (big_endian ? size - i : i + 1)];
  return value;
}

std::optional<Sum> frame_checksum(const Frames& frames) {
  const auto some = std::span(frames.all).first(std::min<std::size_t>(frames.all.size(), 64));
  std::vector<std::string_view> names{"sum-8", "xor", "sum-16", "fletcher-16"};
  for (const auto& crc : wire::described::crcs) names.push_back(crc.name);
  for (const std::string_view name : names) {
    Checksum checksum;
    Checksum::find(name, checksum);
    const std::size_t size = checksum.size();
    if (frames.length <= size + 2) continue;
    for (const std::size_t from : {0u, 1u, 2u}) {  // with the sync, behind its first byte or both
      if (frames.length <= size + from + 1) continue;
      for (const bool big : {false, true}) {
        std::size_t wrong = 0;
        for (const Bytes f : some) {
          wrong += checksum.of(f.first(f.size() - size).subspan(from)) != stored(f, size, big);
          if (wrong * 10 > some.size()) break;
        }
        if (wrong * 10 <= some.size()) return Sum{name, big, from};
      }
    }
  }
  return {};
}

bool counts(const Frames& frames, std::size_t at) {
  std::size_t steps = 0;
  for (std::size_t i = 1; i < frames.all.size(); ++i)
    steps += static_cast<std::uint8_t>(frames.all[i][at] - frames.all[i - 1][at]) == 1;
  return steps * 10 >= (frames.all.size() - 1) * 9;
}

struct Range {
  double low = 0, high = 0, step = 0;  ///< step: mean change from frame to frame
};

template <class Read>
Range range_of(const Frames& frames, Read&& read) {
  Range range{read(frames.all[0]), read(frames.all[0]), 0};
  double before = range.low;
  for (const Bytes frame : frames.all) {
    const double value = read(frame);
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
    range.step += std::abs(value - before) / static_cast<double>(frames.all.size());
    before = value;
  }
  return range;
}

/// A float of a sensor is finite, of a usual size, and seldom jumps over its whole range.
bool is_float(const Frames& frames, std::size_t at, bool big) {
  for (const Bytes frame : frames.all) {
    const float x = big ? wire::load_be<float>(frame, at) : wire::load_le<float>(frame, at);
    if (!std::isfinite(x) || (x != 0 && (std::abs(x) < 1e-6F || std::abs(x) > 1e7F))) return false;
  }
  return true;
}

bool is_smooth(const Range& range) {
  return range.high > range.low && range.step < (range.high - range.low) / 4;
}

std::optional<std::string> number_at(const Frames& frames, std::size_t at, std::size_t end,
                                     std::size_t& size) {
  for (const bool big : {false, true}) {
    const std::string_view order = big ? ", order = \"big\"" : "";
    const auto text = [&](std::string_view type, const Range& range) {
      return fmt::format("  {{ at = {}, type = \"{}\", name = \"at_{}\"{} }},  # {:.6g} to {:.6g}",
                         at, type, at, order, range.low, range.high);
    };
    if (at + 4 <= end && is_float(frames, at, big)) {
      const Range range = range_of(frames, [&](Bytes f) {
        return double{big ? wire::load_be<float>(f, at) : wire::load_le<float>(f, at)};
      });
      size = 4;
      if (range.high > range.low) return text("f32", range);
    }
    if (at + 2 > end) continue;
    const Range range = range_of(frames, [&](Bytes f) {
      return static_cast<double>(big ? wire::load_be<std::int16_t>(f, at)
                                     : wire::load_le<std::int16_t>(f, at));
    });
    size = 2;
    if (is_smooth(range) && range.high - range.low > 255) return text("i16", range);
  }
  return {};
}

std::string fields_text(const Frames& frames, std::size_t end) {
  std::string out;
  for (std::size_t at = 2; at < end;) {
    std::size_t size = 1;
    const std::uint8_t first = frames.all[0][at];
    if (is_constant(frames, at)) {
      out += fmt::format("  # byte {}: always {} (0x{:02X})\n", at, first, first);
    } else if (counts(frames, at)) {
      out += fmt::format("  {{ at = {}, type = \"u8\", name = \"counter_{}\" }},\n", at, at);
    } else if (const auto number = number_at(frames, at, end, size)) {
      out += *number + "\n";
    } else {
      const Range range = range_of(frames, [&](Bytes f) { return static_cast<double>(f[at]); });
      out += fmt::format("  {{ at = {}, type = \"u8\", name = \"at_{}\" }},  # {} to {}\n", at, at,
                         range.low, range.high);
      size = 1;
    }
    at += size;
  }
  return out;
}

std::string frame_text(const Frames& frames, const std::optional<Sum>& sum) {
  Checksum checksum;
  if (sum) Checksum::find(sum->name, checksum);
  const Bytes one = frames.all[0];
  return fmt::format(
      "\n[protocol]\n{}{}{}\n[[protocol.binary]]             # {} frames\nname = \"frame\"\n"
      "sync = \"{:02X} {:02X}\"\nlength = {}\nfields = [\n{}]\n",
      sum ? fmt::format("checksum = \"{}\"\n", sum->name) : "# no checksum was found\n",
      sum && sum->big_endian ? "checksum_order = \"big\"\n" : "",
      sum && sum->from > 0 ? fmt::format("checksum_from = {}\n", sum->from) : "", frames.all.size(),
      one[0], one[1], frames.length, fields_text(frames, frames.length - checksum.size()));
}

}  // namespace

std::string guess_binary(Bytes capture) {
  capture = capture.first(std::min(capture.size(), most_bytes));
  const std::size_t length = period_of(capture);
  if (length == 0) return {};
  std::optional<Frames> best;
  for (std::size_t phase = 0; phase < length && phase + length < capture.size(); ++phase) {
    Frames frames = cut(capture, phase, length);
    if (frames.all.size() < fewest_frames || !is_constant(frames, 0)) continue;
    if (const auto sum = frame_checksum(frames)) return frame_text(frames, sum);
    if (!best || frames.all.size() > best->all.size()) best = std::move(frames);
  }
  return best ? frame_text(*best, {}) : std::string();
}

}  // namespace drydock::survey
