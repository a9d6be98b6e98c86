#include "drivers/wire/can/xsens.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/can/frame_protocol.hpp"
#include "drivers/wire/quantize.hpp"

namespace drydock::wire::xsens {

namespace {

constexpr double quaternion_step = 1.0 / 32767;
constexpr unsigned largest_exponent = 31;
constexpr double latitude_step = radians(1.0 / (1 << 24)),
                 longitude_step = radians(1.0 / (1 << 23));
constexpr double dop_step = 0.01;

template <std::size_t N>
std::array<double, N> load_axes(Bytes p, double step) {
  std::array<double, N> axes;
  for (std::size_t i = 0; i < N; ++i) axes[i] = load_be<std::int16_t>(p, 2 * i) * step;
  return axes;
}

template <std::size_t N>
void store_axes(CanFrame& frame, const std::array<double, N>& axes, double step) {
  for (std::size_t i = 0; i < N; ++i) {
    store_be<std::int16_t>(frame.data, 2 * i, quantize<std::int16_t>(axes[i], step));
  }
}

// Bytes of each message.
constexpr std::size_t size_of(const Error&) { return 1; }
constexpr std::size_t size_of(const SampleTime&) { return 4; }
constexpr std::size_t size_of(const GroupCounter&) { return 2; }
constexpr std::size_t size_of(const StatusWord&) { return 4; }
constexpr std::size_t size_of(const Quaternion&) { return 8; }
constexpr std::size_t size_of(const DeltaQ&) { return 8; }
constexpr std::size_t size_of(const DeltaV&) { return 7; }
constexpr std::size_t size_of(const Warning&) { return 1; }
constexpr std::size_t size_of(const UtcTime&) { return 8; }
constexpr std::size_t size_of(const LatitudeLongitude&) { return 8; }
constexpr std::size_t size_of(const GnssStatus&) { return 4; }
constexpr std::size_t size_of(const GnssDop&) { return 8; }
template <class Layout>
constexpr std::size_t size_of(const Vector<Layout>&) {
  return 6;
}
template <class Layout>
constexpr std::size_t size_of(const Scalar<Layout>&) {
  return sizeof(typename Layout::Raw);
}

bool read(Bytes p, Error& m) {
  m.code = p[0];
  return true;
}
bool read(Bytes p, SampleTime& m) {
  m.ticks = load_be<std::uint32_t>(p, 0);
  return true;
}
bool read(Bytes p, GroupCounter& m) {
  m.counter = load_be<std::uint16_t>(p, 0);
  return true;
}
bool read(Bytes p, StatusWord& m) {
  m.bits = load_be<std::uint32_t>(p, 0);
  return true;
}
bool read(Bytes p, Quaternion& m) {
  m.wxyz = load_axes<4>(p, quaternion_step);
  return true;
}
bool read(Bytes p, DeltaQ& m) {
  m.wxyz = load_axes<4>(p, quaternion_step);
  return true;
}
bool read(Bytes p, DeltaV& m) {
  m.exponent = p[6];
  if (m.exponent > largest_exponent) return false;  // 8 at 1 Hz to 17 at 400 Hz
  m.velocity_mps = load_axes<3>(p, std::ldexp(1.0, -m.exponent));
  return true;
}
template <class Layout>
bool read(Bytes p, Vector<Layout>& m) {
  m.value = load_axes<3>(p, Layout::step);
  return true;
}
template <class Layout>
bool read(Bytes p, Scalar<Layout>& m) {
  m.value = load_be<typename Layout::Raw>(p, 0) * Layout::step + Layout::zero;
  return true;
}
bool read(Bytes p, Warning& m) {
  m.code = p[0];
  return true;
}
bool read(Bytes p, UtcTime& m) {
  m = {p[0], p[1], p[2], p[3], p[4], p[5], load_be<std::uint16_t>(p, 6)};
  return true;
}
bool read(Bytes p, LatitudeLongitude& m) {
  m.latitude_rad = load_be<std::int32_t>(p, 0) * latitude_step;
  m.longitude_rad = load_be<std::int32_t>(p, 4) * longitude_step;
  return true;
}
bool read(Bytes p, GnssStatus& m) {
  m = {p[0], p[1], p[2], p[3]};
  return true;
}
bool read(Bytes p, GnssDop& m) {
  for (std::size_t i = 0; i < 4; ++i) m.ptvh[i] = load_be<std::uint16_t>(p, 2 * i) * dop_step;
  return true;
}

void write(CanFrame& frame, const Error& m) { frame.data[0] = m.code; }
void write(CanFrame& frame, const SampleTime& m) {
  store_be<std::uint32_t>(frame.data, 0, m.ticks);
}
void write(CanFrame& frame, const GroupCounter& m) {
  store_be<std::uint16_t>(frame.data, 0, m.counter);
}
void write(CanFrame& frame, const StatusWord& m) { store_be<std::uint32_t>(frame.data, 0, m.bits); }
void write(CanFrame& frame, const Quaternion& m) { store_axes(frame, m.wxyz, quaternion_step); }
void write(CanFrame& frame, const DeltaQ& m) { store_axes(frame, m.wxyz, quaternion_step); }
void write(CanFrame& frame, const DeltaV& m) {
  store_axes(frame, m.velocity_mps, std::ldexp(1.0, -m.exponent));
  frame.data[6] = m.exponent;
}
template <class Layout>
void write(CanFrame& frame, const Vector<Layout>& m) {
  store_axes(frame, m.value, Layout::step);
}
template <class Layout>
void write(CanFrame& frame, const Scalar<Layout>& m) {
  using Raw = typename Layout::Raw;
  store_be<Raw>(frame.data, 0, quantize<Raw>(m.value - Layout::zero, Layout::step));
}
void write(CanFrame& frame, const Warning& m) { frame.data[0] = m.code; }
void write(CanFrame& frame, const UtcTime& m) {
  std::ranges::copy(std::array{m.year, m.month, m.day, m.hour, m.minute, m.second},
                    frame.data.begin());
  store_be<std::uint16_t>(frame.data, 6, m.ten_thousandths);
}
void write(CanFrame& frame, const LatitudeLongitude& m) {
  store_be<std::int32_t>(frame.data, 0, quantize<std::int32_t>(m.latitude_rad, latitude_step));
  store_be<std::int32_t>(frame.data, 4, quantize<std::int32_t>(m.longitude_rad, longitude_step));
}
void write(CanFrame& frame, const GnssStatus& m) {
  std::ranges::copy(std::array{m.fix_type, m.satellites, m.flags, m.valid}, frame.data.begin());
}
void write(CanFrame& frame, const GnssDop& m) {
  for (std::size_t i = 0; i < 4; ++i)
    store_be<std::uint16_t>(frame.data, 2 * i, quantize<std::uint16_t>(m.ptvh[i], dop_step));
}

template <std::size_t I>
std::optional<Message> read_message(Bytes payload) {
  std::variant_alternative_t<I, Message> m;
  if (payload.size() < size_of(m) || !read(payload, m)) return std::nullopt;
  return Message{std::in_place_index<I>, m};
}

template <std::size_t... I>
std::optional<Message> read_at(std::size_t place, Bytes payload, std::index_sequence<I...>) {
  using Reader = std::optional<Message> (*)(Bytes);
  constexpr std::array<Reader, sizeof...(I)> readers{read_message<I>...};
  return readers[place](payload);
}

using Places = std::make_index_sequence<Identifiers::count>;

template <std::size_t... I>
constexpr auto names(std::index_sequence<I...>) {
  return std::array{std::variant_alternative_t<I, Message>::type...};
}

}  // namespace

std::optional<std::size_t> Identifiers::message_of(const CanFrame& frame) const {
  if (frame.extended != extended || frame.remote || frame.error || frame.fd) return std::nullopt;
  const auto found = std::ranges::find(ids, frame.id);
  if (found == ids.end()) return std::nullopt;
  return static_cast<std::size_t>(found - ids.begin());
}

bool Identifiers::set(std::string_view type, std::uint32_t id) {
  constexpr auto types = names(Places{});
  const auto* const found = std::ranges::find(types, type);
  if (found == types.end()) return false;
  ids[static_cast<std::size_t>(found - types.begin())] = id;
  return true;
}

bool Identifiers::sound() const {
  const std::uint32_t longest = extended ? 0x1FFFFFFF : 0x7FF;
  auto sorted = ids;
  std::ranges::sort(sorted);
  return sorted.back() <= longest && std::ranges::adjacent_find(sorted) == sorted.end();
}

CanFrame encode(const Message& message, const Identifiers& identifiers) {
  CanFrame frame;
  frame.id = identifiers.ids[message.index()];
  frame.extended = identifiers.extended;
  std::visit(
      [&](const auto& m) {
        frame.size = static_cast<std::uint8_t>(size_of(m));
        write(frame, m);
      },
      message);
  return frame;
}

}  // namespace drydock::wire::xsens

namespace drydock::wire {

std::optional<Xsens::Message> Xsens::Decoder::receive(const CanFrame& frame) {
  const auto place = identifiers_.message_of(frame);
  if (!place) return std::nullopt;
  return count_frame(counters_, frame, xsens::read_at(*place, frame.payload(), xsens::Places{}));
}

}  // namespace drydock::wire
