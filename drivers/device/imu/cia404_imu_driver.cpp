#include "drivers/device/imu/cia404_imu_driver.hpp"

#include "drivers/device/imu/imu_sample.hpp"

namespace drydock::device {

namespace {

namespace canopen = wire::canopen;

/// Three frames take 1.5 ms at 250 kbit/s, and traffic of higher priority may come between. If
/// frames are further apart they belong to two samples, and frames between them were lost.
constexpr std::chrono::milliseconds longest_set{5};

}  // namespace

template <class Protocol>
void Cia404ImuDriver<Protocol>::receive(const wire::CanFrame& frame, Stamp received_at,
                                        Output& out) {
  if (node_.is_of_another(frame)) return;
  if (const auto node = canopen::node_above(frame, canopen::tpdo_id(1, 0))) {
    first_frame_[*node] = timing_.of_frame(received_at, frame);
  }
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

template <class Protocol>
void Cia404ImuDriver<Protocol>::on(const wire::cia404_imu::ImuSet& set, const Origin& end,
                                   Output& out) {
  if (!node_.accepts(set.node, end.received_at)) return;
  // All values were true together, before the first frame was sent.
  Origin origin = first_frame_[set.node];
  if (end.received_at - origin.received_at > longest_set) {
    out.report("frames of one sample came over 5 ms apart: some were lost, or the host was late");
    return;
  }
  origin.received_at = end.received_at;
  const auto sample = make_imu_sample(origin, set.rate_radps, set.specific_force_mps2, mounting_);
  if (sample) return out.publish(*sample);
  if (!believable(set.rate_radps, most_rate_radps) ||
      !believable(set.specific_force_mps2, most_force_mps2))
    out.refuse("a sample beyond 100 rad/s or 2000 m/s2 was dropped: damaged on its way");
}

template class Cia404ImuDriver<wire::Cia404Imu>;
template class Cia404ImuDriver<wire::EpsonG550>;
template class Cia404ImuDriver<wire::EpsonG552>;

}  // namespace drydock::device
