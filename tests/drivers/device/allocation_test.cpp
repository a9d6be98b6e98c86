#include "tests/drivers/device/allocation_count.hpp"
#include "tests/drivers/device/support.hpp"

namespace drydock::device::test {
namespace allocation_test {

struct Deaf final : Listener, Transmitter {
  void on_measurement(const Measurement&) override { ++heard; }
  void on_state(const Device&, const Transition&) override {}
  void send(wire::Bytes) override {}
  void send(const wire::CanFrame&) override {}
  int heard = 0;
};

/// Allocations of the device during 1000 calls of `feed(device, stamp)`, after 10 calls to settle.
template <class Feed>
std::size_t allocations_of(Kind kind, const std::string& protocol, Feed feed) {
  Deaf ears;
  DeviceOptions o;
  o.driver = options(kind, protocol);
  const auto device = *Device::make(o);
  device->connect(ears, ears);
  device->start(at_s(0));
  device->opened(at_s(0), measurement::Provenance::emulated);
  for (int i = 0; i < 10; ++i) feed(*device, at_s(0.1 * i));
  const AllocationCount count;
  for (int i = 10; i < 1010; ++i) {
    feed(*device, at_s(0.1 * i));
    device->tick(at_s(0.1 * i + 0.05));
  }
  const std::size_t allocations = count.so_far();
  EXPECT_GT(ears.heard, 900);
  return allocations;
}

TEST(Allocation, ACountedAllocationIsSeen) {
  const AllocationCount count;
  const auto seen = std::make_unique<Octets>(100);
  EXPECT_EQ(count.so_far(), 2U);
}

TEST(Allocation, NoneByTheEmLogDriver) {
  const Octets bytes = octets("$HCVHW,,,,,0.2,N,0,K*5B\r\n$VMVBW,-7.1,0.1,A,,,V,,V,,V*65\r\n");
  EXPECT_EQ(allocations_of(Kind::emlog, "nmea0183",
                           [&](Device& d, Stamp at) {
                             d.receive({bytes.data(), 30}, at);
                             d.receive({bytes.data() + 30, bytes.size() - 30}, at);
                           }),
            0U);
}

TEST(Allocation, NoneByTheDriversOfACompass) {
  const Octets bytes = octets("$HEHDT,274.07,T*19\r\n");
  EXPECT_EQ(allocations_of(Kind::attitude, "nmea0183",
                           [&](Device& d, Stamp at) { d.receive(bytes, at); }),
            0U);
  const auto heading = can_frame(0x09F11227, true, {0, 0x39, 0x30, 0xFF, 0x7F, 0xFF, 0x7F, 0xFC});
  EXPECT_EQ(allocations_of(Kind::attitude, "nmea2000",
                           [&](Device& d, Stamp at) { d.receive(heading, at); }),
            0U);
}

TEST(Allocation, NoneByTheDriverOfWaterLinkedJson) {
  const Octets lines = read_all(std::filesystem::path(DRYDOCK_SOURCE_DIR) /
                                "fixtures/water-linked-json/golden.jsonl");
  EXPECT_EQ(allocations_of(Kind::dvl, "water-linked-json",
                           [&](Device& d, Stamp at) {
                             d.receive({lines.data(), 1000}, at);
                             d.receive({lines.data() + 1000, lines.size() - 1000}, at);
                           }),
            0U);
}

/// Each read brings an ensemble that claims 4096 bytes too many, and a good one.
TEST(Allocation, NoneBehindDamagedLengths) {
  const Octets golden =
      read_all(std::filesystem::path(DRYDOCK_SOURCE_DIR) / "fixtures/pd0/golden.pd0");
  const Octets ensemble(golden.begin(), golden.begin() + (golden.at(2) | golden.at(3) << 8) + 2);
  Octets bytes = ensemble + ensemble;
  bytes.at(3) = static_cast<std::uint8_t>(bytes[3] ^ 0x10);
  EXPECT_EQ(allocations_of(Kind::dvl, "pd0", [&](Device& d, Stamp at) { d.receive(bytes, at); }),
            0U);
}

TEST(Allocation, NoneByTheNortekDvlWithBinaryRecords) {
  const Octets golden = read_all(std::filesystem::path(DRYDOCK_SOURCE_DIR) /
                                 "fixtures/nortek-ad2cp/golden.nortek-ad2cp");
  EXPECT_EQ(allocations_of(Kind::dvl, "nortek-ad2cp",
                           [&](Device& d, Stamp at) { d.receive(golden, at); }),
            0U);
}

TEST(Allocation, NoneByTheWayfinderDriver) {
  const Octets golden =
      read_all(std::filesystem::path(DRYDOCK_SOURCE_DIR) / "fixtures/wayfinder/golden.wayfinder");
  EXPECT_EQ(
      allocations_of(Kind::dvl, "wayfinder", [&](Device& d, Stamp at) { d.receive(golden, at); }),
      0U);
}

TEST(Allocation, NoneByTheGnssDriver) {
  Octets pvt(92, 0), sat(8 + 12 * 40, 0);
  pvt[20] = 3, pvt[21] = 1;
  sat[4] = 1, sat[5] = 40;
  std::uint32_t itow = 0;
  std::vector<Octets> epochs;
  for (int i = 0; i < 1010; ++i) {
    put(pvt, 0, 4, itow += 100);
    put(sat, 0, 4, itow);
    epochs.push_back(ubx(1, 0x07, pvt) + ubx(1, 0x35, sat));
  }
  std::size_t next = 0;
  EXPECT_EQ(allocations_of(Kind::gnss, "ubx",
                           [&](Device& d, Stamp at) { d.receive(epochs[next++], at); }),
            0U);
}

TEST(Allocation, NoneByTheGnssDriverOnNmea) {
  std::vector<Octets> epochs;
  for (int i = 0; i < 1010; ++i) {
    std::array<char, 8> time{};
    std::snprintf(time.data(), time.size(), "%06d", i / 60 * 100 + i % 60);
    epochs.push_back(nmea(std::string("GPGGA,") + time.data() +
                          ",4807.038,N,01131.000,E,1,08,0.9,5.4,M,46.9,M,,") +
                     nmea("GPGSA,A,3,04,05,,09,12,,,24,,,,,2.5,1.3,2.1") +
                     nmea("GPGSV,1,1,02,04,40,083,46,05,17,308,41"));
  }
  std::size_t next = 0;
  EXPECT_EQ(allocations_of(Kind::gnss, "nmea0183",
                           [&](Device& d, Stamp at) { d.receive(epochs[next++], at); }),
            0U);
}

TEST(Allocation, NoneByTheImuDrivers) {
  const auto accs = can_frame(0x08F02D80, true, {0x31, 0x79, 0x55, 0x7D, 0x0A, 0x7D, 0x80, 0x06});
  const auto ari = can_frame(0x0CF02A80, true, {0xC9, 0x81, 0xEB, 0x7C, 0x79, 0x79, 0x00, 0x06});
  EXPECT_EQ(allocations_of(Kind::imu, "aceinna",
                           [&](Device& d, Stamp at) {
                             d.receive(accs, at);
                             d.receive(ari, at);
                           }),
            0U);
  EXPECT_EQ(allocations_of(Kind::imu, "cia404-imu",
                           [&](Device& d, Stamp at) {
                             for (const std::uint32_t id : {0x181U, 0x281U, 0x381U}) {
                               d.receive(can_frame(id, false, {0, 0, 0, 0, 0, 0, 0, 0}), at);
                             }
                           }),
            0U);
}

TEST(Allocation, NoneByTheDriversOfEpsonAndXsensImus) {
  EXPECT_EQ(allocations_of(Kind::imu, "epson-g552",
                           [&](Device& d, Stamp at) {
                             for (const std::uint32_t id : {0x181U, 0x281U, 0x701U}) {
                               auto frame = can_frame(id, false, {5, 0, 0, 0, 0, 0, 0, 0});
                               if (id == 0x701U) frame.size = 1;  // heartbeat, operational
                               d.receive(frame, at);
                             }
                           }),
            0U);
  std::uint32_t ticks = 0;
  EXPECT_EQ(allocations_of(
                Kind::imu, "xsens",
                [&](Device& d, Stamp at) {
                  ticks += 1000;
                  d.receive(can_frame(0x005, false,
                                      {0, ticks >> 16 & 0xFF, ticks >> 8 & 0xFF, ticks & 0xFF}),
                            at);
                  for (const std::uint32_t id : {0x032U, 0x034U}) {
                    d.receive(can_frame(id, false, {0, 1, 0, 2, 0, 3}), at);
                  }
                }),
            0U);
}

TEST(Allocation, NoneByDepthAndActuatorDrivers) {
  const auto pressure = can_frame(0x15FD0A23, true, {0, 0, 1, 0x42, 0xB8, 0x1E, 0x00, 0xFF});
  const auto rudder = can_frame(0x09F10D11, true, {0, 0xF8, 0xFF, 0x7F, 0xD0, 7, 0xFF, 0xFF});
  EXPECT_EQ(allocations_of(Kind::depth, "nmea2000",
                           [&](Device& d, Stamp at) { d.receive(pressure, at); }),
            0U);
  const auto speed = can_frame(0x09F50323, true, {0, 0x1B, 1, 0xFF, 0xFF, 4, 0xF0, 0xFF});
  EXPECT_EQ(
      allocations_of(Kind::emlog, "nmea2000", [&](Device& d, Stamp at) { d.receive(speed, at); }),
      0U);
  const auto place = can_frame(0x09F80126, true, {0x19, 0xEE, 0x81, 0x14, 0xE4, 0xC5, 0x98, 0x4F});
  EXPECT_EQ(
      allocations_of(Kind::gnss, "nmea2000", [&](Device& d, Stamp at) { d.receive(place, at); }),
      0U);
  const auto value = can_frame(0x181, false, {0xA0, 0x86, 0x01, 0x00, 0x00});
  EXPECT_EQ(allocations_of(Kind::depth, "cia404-pressure",
                           [&](Device& d, Stamp at) { d.receive(value, at); }),
            0U);
  EXPECT_EQ(allocations_of(Kind::actuator, "nmea2000",
                           [&](Device& d, Stamp at) { d.receive(rudder, at); }),
            0U);
}

TEST(Allocation, NoneByTheDvlDriver) {
  constexpr std::size_t fixed = 12, variable = fixed + 59, track = variable + 65, end = track + 81;
  Octets out(end + 2, 0);
  put(out, 0, 2, 0x7F7F);
  put(out, 2, 2, end);
  out[5] = 3;
  put(out, 6, 2, fixed), put(out, 8, 2, variable), put(out, 10, 2, track);
  out[fixed + 25] = 0x10;
  put(out, variable, 2, 0x0080);
  put(out, track, 2, 0x0600);
  int sum = 0;
  for (std::size_t i = 0; i < end; ++i) sum += out[i];
  put(out, end, 2, sum);
  EXPECT_EQ(allocations_of(Kind::dvl, "pd0",
                           [&](Device& d, Stamp at) {
                             d.receive({out.data(), 100}, at);
                             d.receive({out.data() + 100, out.size() - 100}, at);
                           }),
            0U);
}

}  // namespace allocation_test
}  // namespace drydock::device::test
