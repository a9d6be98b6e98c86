#include "drivers/device/device.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include "tests/drivers/device/support.hpp"

namespace drydock::device::test {
namespace device_test {

struct Desk final : Listener, Transmitter {
  void on_measurement(const Measurement& m) override { heard.push_back(m); }
  void on_state(const Device&, const Transition& change) override { changes.push_back(change); }
  void send(wire::Bytes) override {}
  void send(const wire::CanFrame& frame) override { sent.push_back(frame); }

  std::vector<Measurement> heard;
  std::vector<Transition> changes;
  std::vector<wire::CanFrame> sent;
};

std::unique_ptr<Device> device(Kind kind, const std::string& protocol, Desk& desk,
                               bool on_bus = false, std::uint8_t address = 0) {
  DeviceOptions o;
  o.name = "sensor";
  o.driver = options(kind, protocol);
  o.driver.device = 3;
  o.driver.address = address;
  o.life_cycle.reopen_when_quiet = !on_bus;
  auto made = *Device::make(o);
  made->connect(desk, desk);
  made->start(at_s(0));
  made->opened(at_s(0), measurement::Provenance::replayed);
  return made;
}

const Octets vhw = octets("$HCVHW,,,,,0.2,N,0,K*5B\r\n");

TEST(Device, MeasurementsCarryDeviceAndProvenanceOfTheLink) {
  Desk desk;
  const auto log = device(Kind::emlog, "nmea0183", desk);
  log->receive(vhw, at_s(1));
  ASSERT_EQ(desk.heard.size(), 1U);
  EXPECT_EQ(measurement::origin_of(desk.heard[0]).device, 3);
  EXPECT_EQ(measurement::origin_of(desk.heard[0]).provenance, measurement::Provenance::replayed);
}

/// Flips bit 12 of the length: 4096 bytes more are claimed.
Octets with_damaged_length(Octets ensemble) {
  ensemble.at(3) = static_cast<std::uint8_t>(ensemble[3] ^ 0x10);
  return ensemble;
}

Octets golden_ensemble() {
  const Octets golden =
      read_all(std::filesystem::path(DRYDOCK_SOURCE_DIR) / "fixtures/pd0/golden.pd0");
  return {golden.begin(), golden.begin() + (golden.at(2) | golden.at(3) << 8) + 2};
}

TEST(Device, AnEnsembleBehindADamagedLengthIsNotLostWithTheLink) {
  Desk desk;
  const auto dvl = device(Kind::dvl, "pd0", desk);
  dvl->receive(with_damaged_length(golden_ensemble()), at_s(1));
  dvl->receive(golden_ensemble(), at_s(1.2));
  EXPECT_TRUE(desk.heard.empty());
  dvl->link_lost(at_s(1.3), "the port is gone");
  ASSERT_EQ(desk.heard.size(), 1U);
  EXPECT_EQ(measurement::origin_of(desk.heard[0]).received_at, at_s(1.2));
  const Health health = dvl->health(at_s(1.4));
  EXPECT_EQ(health.held_bytes, 0U);
  EXPECT_EQ(health.stream.bytes_in, health.stream.bytes_good + health.stream.bytes_skipped);
}

TEST(Device, AnEnsembleBehindADamagedLengthIsNotLostWhenTheClockIsSet) {
  Desk desk;
  const auto dvl = device(Kind::dvl, "pd0", desk);
  dvl->receive(with_damaged_length(golden_ensemble()), at_s(1));
  dvl->receive(golden_ensemble(), at_s(1.2));
  dvl->clock_stepped(std::chrono::hours{1}, at_s(3601.3));
  ASSERT_EQ(desk.heard.size(), 1U);
  EXPECT_EQ(measurement::origin_of(desk.heard[0]).received_at, at_s(1.2));
}

TEST(Device, OneLinePerChangeOfStateAndNoMore) {
  Desk desk;
  const auto log = device(Kind::emlog, "nmea0183", desk);
  for (int i = 0; i < 100; ++i) log->receive(vhw, at_s(0.1 * i));
  log->tick(at_s(20));
  std::vector<State> to;
  for (const Transition& change : desk.changes) to.push_back(change.to);
  EXPECT_EQ(to, (std::vector{State::opening, State::waiting, State::streaming, State::stale}));
}

TEST(Device, NoiseIsNoMessage) {
  Desk desk;
  const auto log = device(Kind::emlog, "nmea0183", desk);
  log->receive(octets("~~~~~~~~~~~~~~~~"), at_s(1));
  EXPECT_EQ(log->state(), State::waiting);
}

TEST(Device, RateIsThatOfTheArrivals) {
  Desk desk;
  const auto log = device(Kind::emlog, "nmea0183", desk);
  for (int i = 0; i < 50; ++i) log->receive(vhw, at_s(0.2 * i));
  const Health health = log->health(at_s(10));
  EXPECT_NEAR(health.rate_hz.value(), 5, 1e-6);
  EXPECT_EQ(health.messages, 50U);
  EXPECT_NEAR(measurement::seconds(health.age.value()), 0.2, 1e-6);
}

TEST(Device, RateSurvivesJitterAndBatches) {
  Desk desk;
  const auto log = device(Kind::emlog, "nmea0183", desk);
  for (int i = 0; i < 32; ++i) log->receive(vhw + vhw, at_s(0.4 * i + (i % 2 ? 0.05 : 0)));
  EXPECT_NEAR(log->health(at_s(13)).rate_hz.value(), 5, 0.15);
}

TEST(Device, SensorsOfSeveralMessagesHaveTheRateOfEachNotTheSum) {
  Desk desk;
  const auto actuators = device(Kind::actuator, "nmea2000", desk, true);
  for (int i = 0; i < 50; ++i) {
    for (const unsigned instance : {0U, 1U, 2U}) {
      actuators->receive(can_frame(0x09F10D11, true, {instance, 0xF8, 0xFF, 0x7F, 1, 0, 255, 255}),
                         at_s(0.1 * i));
    }
  }
  EXPECT_NEAR(actuators->health(at_s(5)).rate_hz.value(), 10, 1e-6);
}

TEST(Device, ErrorFramesAreCountedAndSaidInWords) {
  Desk desk;
  const auto depth = device(Kind::depth, "nmea2000", desk, true);
  auto bus_off = can_frame(0x40, false, {0, 0, 0, 0, 0, 0, 0, 0});
  bus_off.error = true;
  depth->receive(bus_off, at_s(1));
  depth->note_dropped(7);
  const Health health = depth->health(at_s(1));
  EXPECT_EQ(health.error_frames, 1U);
  EXPECT_EQ(health.can_dropped, 7U);
  EXPECT_EQ(health.last_error.view().substr(0, 7), "bus-off");
}

TEST(Device, TheRateThatTheLinkKnowsDecidesTheTimeOfValidity) {
  Desk desk;
  const auto depth = device(Kind::depth, "cia404-pressure", desk, true);
  const auto age_at = [&](unsigned bit_rate) {
    depth->set_bitrate(bit_rate);
    depth->receive(can_frame(0x181, false, {0xA5, 0x5A, 0x01, 0x00, 0x00}), at_s(1));
    const auto& origin = measurement::origin_of(desk.heard.back());
    return measurement::seconds(origin.received_at - origin.valid_at);
  };
  const double at_250 = age_at(250'000);
  // A standard frame of 5 bytes has 44 + 40 bits and its stuff bits (ISO 11898-1).
  EXPECT_GE(at_250, 84 / 250e3);
  EXPECT_NEAR(age_at(1'000'000), at_250 / 4, 1e-9);
}

TEST(Device, TheLastErrorHasItsAgeAndItsNumber) {
  Desk desk;
  const auto depth = device(Kind::depth, "nmea2000", desk, true);
  EXPECT_EQ(depth->health(at_s(1)).errors, 0U);
  EXPECT_FALSE(depth->health(at_s(1)).last_error_age);
  auto bus_off = can_frame(0x40, false, {0, 0, 0, 0, 0, 0, 0, 0});
  bus_off.error = true;
  for (const double second : {1.0, 2.0, 4.5}) depth->receive(bus_off, at_s(second));
  depth->clock_stepped(std::chrono::hours{1}, at_s(3610));
  const Health health = depth->health(at_s(3610));
  EXPECT_EQ(health.errors, 3U);
  EXPECT_EQ(health.last_error_age, std::chrono::milliseconds{5500});
}

TEST(Device, RefusedValuesAreCountedAndSaid) {
  Desk desk;
  const auto depth = device(Kind::depth, "cia404-pressure", desk, true);
  for (int i = 1; i <= 3; ++i)
    depth->receive(can_frame(0x181, false, {0x00, 0x00, 0x00, 0x80, 0x00}), at_s(i));
  const Health health = depth->health(at_s(3));
  EXPECT_EQ(health.refused, 3U);
  EXPECT_EQ(health.messages, 0U);
  EXPECT_EQ(health.last_error.view().substr(0, 21), "a pressure below zero");
}

TEST(Device, AGoodValueThatNoMeasurementHoldsIsCountedAndIsNoError) {
  Desk desk;
  const auto dvl = device(Kind::dvl, "water-linked-json", desk, true);
  const auto position = octets("{\"type\":\"position_local\",\"x\":1,\"y\":2,\"z\":3}\r\n");
  dvl->receive(position, at_s(1));
  EXPECT_EQ(dvl->health(at_s(1)).left_out.view(), "no measurement holds the DVL's dead reckoning");
  EXPECT_TRUE(dvl->health(at_s(1)).last_error.empty());
  EXPECT_EQ(dvl->health(at_s(1)).errors, 0U);
  dvl->receive(octets("{\"type\":\"velocity\",\"velocity_valid\":false,\"status\":1}\r\n"),
               at_s(2));
  dvl->receive(position, at_s(3));
  const Health health = dvl->health(at_s(3));
  EXPECT_EQ(health.last_error.view(), "the DVL is hot and will shut down soon");
  EXPECT_EQ(health.refused, 2U);
  EXPECT_EQ(health.impossible, 0U);
}

TEST(Device, BusDeviceStartsItsNodeThroughTheTransmitter) {
  Desk desk;
  const auto imu = device(Kind::imu, "cia404-imu", desk, true, 5);
  EXPECT_EQ(desk.sent, std::vector{can_frame(0x000, false, {0x01, 0x05})});
}

TEST(Device, HearsNothingBeforeItsLinkIsOpenOrAfterItStopped) {
  Desk desk;
  const auto log = device(Kind::emlog, "nmea0183", desk);
  log->stop(at_s(1));
  log->receive(vhw, at_s(2));
  EXPECT_TRUE(desk.heard.empty());
}

TEST(Device, UnknownProtocolIsRefused) {
  DeviceOptions o;
  o.driver = options(Kind::dvl, "nmea0183");
  const auto made = Device::make(o);
  ASSERT_FALSE(made);
  EXPECT_TRUE(made.error().message.starts_with(
      "no driver for kind \"dvl\" with protocol \"nmea0183\" over bytes; allowed: pd0 (bytes) "
      "pd4 (bytes) pd5 (bytes) pd6 (bytes) water-linked (bytes) water-linked-json (bytes) "
      "nortek (bytes) nortek-ad2cp (bytes) wayfinder (bytes)"))
      << made.error().message;
}

/// For any input in any pieces, every byte is counted and nothing breaks.
void counters_add_up(Kind kind, const std::string& protocol) {
  Desk desk;
  const auto d = device(kind, protocol, desk);
  const auto pieces = *rc::gen::container<std::vector<Octets>>(rc::gen::oneOf(
      rc::gen::just(vhw), rc::gen::just(Octets{0xB5, 0x62, 0x01, 0x07, 92, 0}),
      rc::gen::just(Octets{0x7F, 0x7F, 0xF0, 0x00, 0x00, 0x03}), rc::gen::arbitrary<Octets>()));
  std::uint64_t fed = 0;
  Stamp now = at_s(1);
  for (const Octets& piece : pieces) {
    d->receive(piece, now);
    fed += piece.size();
    now += std::chrono::milliseconds{10};
  }
  const Health health = d->health(now);
  RC_ASSERT(health.stream.bytes_in == fed);
  RC_ASSERT(health.stream.bytes_in ==
            health.stream.bytes_good + health.stream.bytes_skipped + health.held_bytes);
}

RC_GTEST_PROP(Device, CountersAddUpForALog, ()) { counters_add_up(Kind::emlog, "nmea0183"); }
RC_GTEST_PROP(Device, CountersAddUpForAReceiver, ()) { counters_add_up(Kind::gnss, "ubx"); }
RC_GTEST_PROP(Device, CountersAddUpForADvl, ()) { counters_add_up(Kind::dvl, "pd0"); }
RC_GTEST_PROP(Device, CountersAddUpForAWaterLinkedDvl, ()) {
  counters_add_up(Kind::dvl, "water-linked");
}
RC_GTEST_PROP(Device, CountersAddUpForANortekDvl, ()) { counters_add_up(Kind::dvl, "nortek"); }
RC_GTEST_PROP(Device, CountersAddUpForANortekDvlWithBinaryRecords, ()) {
  counters_add_up(Kind::dvl, "nortek-ad2cp");
}
RC_GTEST_PROP(Device, CountersAddUpForAWayfinder, ()) { counters_add_up(Kind::dvl, "wayfinder"); }

}  // namespace device_test
}  // namespace drydock::device::test
