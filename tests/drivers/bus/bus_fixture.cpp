#include "tests/drivers/bus/bus_fixture.hpp"

#include "tests/own_domain.hpp"

namespace drydock::bus::test {

std::uint32_t test_domain() { return drydock::test::own_domain(); }

std::vector<Measurement> take(Subscriber& subscriber, std::size_t count) {
  constexpr int wait_ms = std::chrono::milliseconds(patience).count();
  std::vector<Measurement> taken;
  while (taken.size() < count) {
    pollfd waiting{subscriber.fd(), POLLIN, 0};
    if (::poll(&waiting, 1, wait_ms) <= 0) break;
    subscriber.take_measurements([&taken](const Measurement& m) { taken.push_back(m); });
  }
  return taken;
}

std::vector<Device> all_devices(Provenance provenance, Form form) {
  return {
      {"dvl", Kind::dvl, provenance, form},         {"log", Kind::emlog, provenance, form},
      {"gnss", Kind::gnss, provenance, form},       {"imu", Kind::imu, provenance, form},
      {"depth", Kind::depth, provenance, form},     {"rudder", Kind::actuator, provenance, form},
      {"compass", Kind::attitude, provenance, form}};
}

measurement::Origin origin(Index device) {
  return {.valid_at = stamp_from_ns(1'700'000'000'123'456'789),
          .received_at = stamp_from_ns(1'700'000'000'987'654'321),
          .device_time = std::chrono::nanoseconds(77'000'000'013),
          .provenance = Provenance::emulated,
          .device = device};
}

}  // namespace drydock::bus::test
