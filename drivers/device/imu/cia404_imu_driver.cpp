#include "drivers/device/imu/cia404_imu_driver.hpp"

#include <type_traits>
#include <utility>

#include "drivers/device/imu/imu_sample.hpp"

namespace drydock::device {

namespace {

namespace canopen = wire::canopen;

/// Epson's frames have a counter. It joins them, until it may have come round.
template <class Protocol>
constexpr bool counts = !std::is_same_v<Protocol, wire::Cia404Imu>;
constexpr std::chrono::seconds counter_round{10};

using canopen::Pdo;

constexpr std::array<Pdo, 3> real_pdos{Pdo(canopen::tpdo_id(1, 0), {0x61300120, 0x61300220}),
                                       Pdo(canopen::tpdo_id(2, 0), {0x61300320, 0x61300420}),
                                       Pdo(canopen::tpdo_id(3, 0), {0x61300520, 0x61300620})};
// Epson's third one, with the temperature, may be off.
constexpr std::array<Pdo, 2> counted_pdos{
    Pdo(canopen::tpdo_id(1, 0), {0x21000010, 0x71300110, 0x71300210, 0x71300310}),
    Pdo(canopen::tpdo_id(2, 0), {0x21000010, 0x71300410, 0x71300510, 0x71300610})};

}  // namespace

template <class Protocol>
PdoTranslator::Pdos Cia404ImuDriver<Protocol>::usual() {
  if constexpr (counts<Protocol>) return counted_pdos;
  return real_pdos;
}

template <class Protocol>
void Cia404ImuDriver<Protocol>::restart(Stamp now, Output& out) {
  join_.reset();
  node_.restart(now, out);
}

template <class Protocol>
void Cia404ImuDriver<Protocol>::receive(const wire::CanFrame& frame, Stamp received_at,
                                        Output& out) {
  for (const wire::CanFrame& usual_frame : node_.frames_of(frame, received_at, out))
    decode(usual_frame, received_at, out);
}

template <class Protocol>
void Cia404ImuDriver<Protocol>::decode(const wire::CanFrame& frame, Stamp received_at,
                                       Output& out) {
  if (const auto node = canopen::node_above(frame, canopen::tpdo_id(1, 0))) {
    first_frame_[*node] = timing_.of_frame(received_at, frame);
  }
  if (!counts<Protocol> && node_.is_known()) follow(frame, received_at, out);
  const auto message = decoder_.receive(frame);
  if (!message) return;
  if (const auto* set = std::get_if<wire::cia404_imu::ImuSet>(&*message)) {
    on(*set, timing_.of_frame(received_at, frame), out);
  } else if (const auto* heartbeat = std::get_if<canopen::Heartbeat>(&*message)) {
    node_.on(*heartbeat, received_at, out);
  } else if (const auto* emergency = std::get_if<canopen::Emergency>(&*message)) {
    node_.on(*emergency, out);
  }
}

/// Where the sets of the sensor begin, also of those of which frames are lost.
template <class Protocol>
void Cia404ImuDriver<Protocol>::follow(const wire::CanFrame& frame, Stamp at, Output& out) {
  if (canopen::node_above(frame, canopen::tpdo_id(1, 0))) {
    begun_ = true;
    join_.begins(at, out);
  } else if (canopen::node_above(frame, canopen::tpdo_id(3, 0))) {
    if (!std::exchange(begun_, false)) join_.misses();
  }
}

template <class Protocol>
void Cia404ImuDriver<Protocol>::on(const wire::cia404_imu::ImuSet& set, const Origin& end,
                                   Output& out) {
  if (!node_.accepts(set.node, end.received_at)) return;
  // All values were true together, before the first frame was sent.
  Origin origin = first_frame_[set.node];
  const Stamp begun_at = std::exchange(origin.received_at, end.received_at);
  if (counts<Protocol> && end.received_at - begun_at > counter_round)
    return out.refuse("frames with one counter came over 10 s apart", Refusal::incomplete);
  const auto sample = make_imu_sample(origin, set.rate_radps, set.specific_force_mps2, mounting_);
  if (sample && counts<Protocol>) return out.publish(*sample);
  if (sample) return join_.completes(*sample, begun_at, end.received_at, out);
  if (!believable(set.rate_radps, most_rate_radps) ||
      !believable(set.specific_force_mps2, most_force_mps2))
    out.refuse("a sample beyond 100 rad/s or 2000 m/s2 was dropped: damaged on its way");
}

template class Cia404ImuDriver<wire::Cia404Imu>;
template class Cia404ImuDriver<wire::EpsonG550>;
template class Cia404ImuDriver<wire::EpsonG552>;

}  // namespace drydock::device
