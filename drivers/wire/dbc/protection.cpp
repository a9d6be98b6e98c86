#include "drivers/wire/dbc/protection.hpp"

#include <algorithm>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/crc.hpp"

namespace drydock::wire::dbc {

namespace {

constexpr Crc j1850({8, 0x1D, 0xFF, false, 0xFF});
constexpr Crc j1850_bare({8, 0x1D, 0, false, 0});  // what AUTOSAR's profile 1 sends
constexpr Crc h2f({8, 0x2F, 0xFF, false, 0xFF});
constexpr Crc ccitt_false({16, 0x1021, 0xFFFF, false, 0});

struct Row {
  Checksum checksum;
  std::string_view name;
};
constexpr std::array rows{Row{Checksum::e2e_1_both, "e2e-1-both"},
                          Row{Checksum::e2e_1_alternating, "e2e-1-alternating"},
                          Row{Checksum::e2e_1_low, "e2e-1-low"},
                          Row{Checksum::e2e_1_nibble, "e2e-1-nibble"},
                          Row{Checksum::e2e_2, "e2e-2"},
                          Row{Checksum::e2e_5, "e2e-5"},
                          Row{Checksum::crc8_j1850, "crc8-j1850"},
                          Row{Checksum::crc8_j1850_bare, "crc8-j1850-bare"},
                          Row{Checksum::sum, "sum"},
                          Row{Checksum::sum_with_id, "sum-with-id"},
                          Row{Checksum::xor_of_bytes, "xor"}};

/// AUTOSAR's counter: the low nibble of byte 1.
unsigned nibble_counter(Bytes frame) { return frame[1] & 0xFu; }

std::uint16_t with_id(const Crc& crc, std::span<const std::uint8_t> id, Bytes data) {
  return static_cast<std::uint16_t>(crc.finish(crc.add(crc.add(crc.start(), id), data)));
}

/// The bytes of the data identifier that come before the data.
std::uint16_t profile_1(const Protection& p, Bytes frame) {
  const auto low = static_cast<std::uint8_t>(p.data_id);
  const auto high = static_cast<std::uint8_t>(p.data_id >> 8);
  const Bytes data = frame.subspan(1);
  const auto crc = [&](auto... id) {
    const std::array<std::uint8_t, sizeof...(id)> bytes{id...};
    return with_id(j1850_bare, bytes, data);
  };
  switch (p.checksum) {
    case Checksum::e2e_1_both: return crc(low, high);
    case Checksum::e2e_1_alternating: return crc(nibble_counter(frame) % 2 == 0 ? low : high);
    case Checksum::e2e_1_nibble: return crc(low, std::uint8_t{0});
    default: return crc(low);
  }
}

std::uint16_t profile_2(const Protection& p, Bytes frame) {
  const auto state = h2f.add(h2f.start(), frame.subspan(1));
  const std::array<std::uint8_t, 1> id{p.data_ids[nibble_counter(frame)]};
  return static_cast<std::uint16_t>(h2f.finish(h2f.add(state, id)));
}

std::uint16_t profile_5(const Protection& p, Bytes frame) {
  const std::array<std::uint8_t, 2> id{static_cast<std::uint8_t>(p.data_id),
                                       static_cast<std::uint8_t>(p.data_id >> 8)};
  return with_id(ccitt_false, frame.subspan(2), id);
}

std::uint16_t bare_crc(const Crc& crc, const Protection& p, Bytes frame) {
  const auto state = crc.add(crc.start(), frame.first(p.at));
  return static_cast<std::uint16_t>(crc.finish(crc.add(state, frame.subspan(p.at + 1))));
}

std::uint16_t sum_of_others(const Protection& p, Bytes frame) {
  unsigned sum = p.seed;
  for (std::size_t i = 0; i < frame.size(); ++i) sum += i == p.at ? 0u : frame[i];
  return static_cast<std::uint16_t>(sum & 0xFF);
}

std::uint16_t sum_with_id(const Protection& p, const CanFrame& frame) {
  unsigned sum = sum_of_others(p, frame.payload()) + frame.size;
  for (unsigned shift = 0; shift < 32; shift += 8) sum += frame.id >> shift & 0xFF;
  return static_cast<std::uint16_t>(sum & 0xFF);
}

std::uint16_t xor_of_others(const Protection& p, Bytes frame) {
  std::uint8_t all = p.seed;
  for (std::size_t i = 0; i < frame.size(); ++i) all ^= i == p.at ? std::uint8_t{0} : frame[i];
  return all;
}

std::uint16_t computed(const Protection& p, const CanFrame& frame) {
  switch (p.checksum) {
    case Checksum::e2e_2: return profile_2(p, frame.payload());
    case Checksum::e2e_5: return profile_5(p, frame.payload());
    case Checksum::crc8_j1850: return bare_crc(j1850, p, frame.payload());
    case Checksum::crc8_j1850_bare: return bare_crc(j1850_bare, p, frame.payload()) ^ p.seed;
    case Checksum::sum: return sum_of_others(p, frame.payload());
    case Checksum::sum_with_id: return sum_with_id(p, frame);
    case Checksum::xor_of_bytes: return xor_of_others(p, frame.payload());
    default: return profile_1(p, frame.payload());
  }
}

bool is_e2e(Checksum c) { return c <= Checksum::e2e_5; }

std::size_t place(const Protection& p) { return is_e2e(p.checksum) ? 0 : p.at; }

bool is_long_enough(const Protection& p, const CanFrame& frame) {
  const std::size_t header = p.checksum == Checksum::e2e_5 ? 3 : is_e2e(p.checksum) ? 2 : p.at + 1;
  return frame.size >= header;
}

/// Mode nibble sends four bits of the data identifier above the counter.
bool nibble_fits(const Protection& p, const CanFrame& frame) {
  return p.checksum != Checksum::e2e_1_nibble || frame.data[1] >> 4 == (p.data_id >> 8 & 0xF);
}

}  // namespace

std::optional<Checksum> checksum_named(std::string_view name) {
  const auto* const found = std::ranges::find(rows, name, &Row::name);
  return found != rows.end() ? std::optional(found->checksum) : std::nullopt;
}

std::string_view to_string(Checksum checksum) {
  return std::ranges::find(rows, checksum, &Row::checksum)->name;
}

bool is_intact(const Protection& p, const CanFrame& frame) {
  if (!is_long_enough(p, frame) || !nibble_fits(p, frame)) return false;
  if (is_profile_1(p.checksum) && nibble_counter(frame.payload()) == modulus_of_profile_1)
    return false;
  if (p.checksum == Checksum::e2e_5)
    return load_le<std::uint16_t>(frame.payload(), 0) == computed(p, frame);
  return frame.data[place(p)] == computed(p, frame);
}

bool protect(const Protection& p, CanFrame& frame) {
  if (!is_long_enough(p, frame)) return false;
  if (p.checksum == Checksum::e2e_1_nibble)
    frame.data[1] = static_cast<std::uint8_t>((frame.data[1] & 0xF) | (p.data_id >> 8 & 0xF) << 4);
  const std::uint16_t sum = computed(p, frame);
  if (p.checksum == Checksum::e2e_5) {
    store_le<std::uint16_t>(frame.data, 0, sum);
  } else {
    frame.data[place(p)] = static_cast<std::uint8_t>(sum);
  }
  return true;
}

FrameCounter::Step FrameCounter::take(unsigned counter) {
  counter %= modulus_;
  const auto last = last_;
  last_ = counter;
  if (!last) return Step::first;
  const unsigned step = (counter + modulus_ - *last) % modulus_;
  repeated_ += step == 0;
  lost_ += step > 1 ? step - 1 : 0;
  return step == 0 ? Step::repeated : step == 1 ? Step::next : Step::lost;
}

}  // namespace drydock::wire::dbc
