#include "drivers/wire/can/sbg.hpp"

#include <algorithm>
#include <utility>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/can/frame_protocol.hpp"
#include "drivers/wire/quantize.hpp"

namespace drydock::wire::sbg {

namespace {

/// A run of identifiers that SBG's table names.
struct Block {
  std::uint32_t first, last;
};
constexpr std::array blocks{Block{0x100, 0x189}, Block{0x200, 0x209}, Block{0x220, 0x220}};

constexpr double celsius_step = 0.01, place_step = radians(1e-7);
constexpr double height_step = 0.001, undulation_step = 0.005;

void read(Bytes p, ImuInfo& m) {
  m.time_us = load_le<std::uint32_t>(p, 0);
  m.status = load_le<std::uint16_t>(p, 4);
  m.temperature_k = load_le<std::int16_t>(p, 6) * celsius_step + zero_celsius_k;
}
void read(Bytes p, EkfInfo& m) { m.time_us = load_le<std::uint32_t>(p, 0); }
template <class Layout>
void read(Bytes p, Axes<Layout>& m) {
  for (std::size_t i = 0; i < m.value.size(); ++i)
    m.value[i] = load_le<std::int16_t>(p, 2 * i) * Layout::step;
}
void read(Bytes p, EkfPosition& m) {
  m.latitude_rad = load_le<std::int32_t>(p, 0) * place_step;
  m.longitude_rad = load_le<std::int32_t>(p, 4) * place_step;
}
void read(Bytes p, EkfAltitude& m) {
  m.mean_sea_level_height_m = load_le<std::int32_t>(p, 0) * height_step;
  m.geoid_separation_m = load_le<std::int16_t>(p, 4) * undulation_step;
}

void write(CanFrame& frame, const ImuInfo& m) {
  store_le<std::uint32_t>(frame.data, 0, m.time_us);
  store_le<std::uint16_t>(frame.data, 4, m.status);
  store_le<std::int16_t>(frame.data, 6,
                         quantize<std::int16_t>(m.temperature_k - zero_celsius_k, celsius_step));
}
void write(CanFrame& frame, const EkfInfo& m) { store_le<std::uint32_t>(frame.data, 0, m.time_us); }
template <class Layout>
void write(CanFrame& frame, const Axes<Layout>& m) {
  for (std::size_t i = 0; i < m.value.size(); ++i)
    store_le<std::int16_t>(frame.data, 2 * i, quantize<std::int16_t>(m.value[i], Layout::step));
}
void write(CanFrame& frame, const EkfPosition& m) {
  store_le<std::int32_t>(frame.data, 0, quantize<std::int32_t>(m.latitude_rad, place_step));
  store_le<std::int32_t>(frame.data, 4, quantize<std::int32_t>(m.longitude_rad, place_step));
}
void write(CanFrame& frame, const EkfAltitude& m) {
  store_le<std::int32_t>(frame.data, 0,
                         quantize<std::int32_t>(m.mean_sea_level_height_m, height_step));
  store_le<std::int16_t>(frame.data, 4,
                         quantize<std::int16_t>(m.geoid_separation_m, undulation_step));
}

/// Tries one message of the list. True if the frame is of this kind, sound or cut short.
template <class M>
bool take(const CanFrame& frame, std::optional<Message>& message) {
  if (frame.id != M::id) return false;
  if (frame.size < M::size) return true;
  M m;
  read(frame.payload(), m);
  message = m;
  return true;
}

template <std::size_t... I>
bool take_any(const CanFrame& frame, std::optional<Message>& message, std::index_sequence<I...>) {
  return (take<std::variant_alternative_t<I, Message>>(frame, message) || ...);
}

bool is_plain(const CanFrame& frame) {
  return !frame.extended && !frame.remote && !frame.error && !frame.fd;
}

}  // namespace

bool is_ours(const CanFrame& frame) {
  return is_plain(frame) && std::ranges::any_of(blocks, [&](const Block& block) {
           return block.first <= frame.id && frame.id <= block.last;
         });
}

CanFrame encode(const Message& message) {
  CanFrame frame;
  std::visit(
      [&](const auto& m) {
        frame.id = m.id;
        frame.size = m.size;
        write(frame, m);
      },
      message);
  return frame;
}

}  // namespace drydock::wire::sbg

namespace drydock::wire {

std::optional<Sbg::Message> Sbg::Decoder::receive(const CanFrame& frame) {
  std::optional<Message> message;
  constexpr auto kinds = std::make_index_sequence<std::variant_size_v<Message>>{};
  if (!sbg::is_plain(frame) || !sbg::take_any(frame, message, kinds)) return std::nullopt;
  return count_frame(counters_, frame, message);
}

}  // namespace drydock::wire
