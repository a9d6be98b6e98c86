// An emulated sensor in a test of one's own: the parser under test would stand where Pd0 does.
#include <gtest/gtest.h>
#include <drydock/drivers/wire/dvl/pd0.hpp>
#include <drydock/hil/emulate/make_emulated_device.hpp>

using namespace drydock;

/// Straight on at 1.5 m/s, level, 20 m deep. The ocean is still and 100 m deep if one gives none.
struct Cruise : motion::Trajectory {
  motion::Truth at(measurement::Stamp time) const override {
    motion::Truth truth;
    truth.at = time;
    truth.velocity_body = truth.velocity_ned = {1.5, 0, 0};
    truth.height_m = -20;
    return truth;
  }
  measurement::Stamp start() const override { return {}; }
  measurement::Stamp end() const override { return measurement::stamp_from_ns(10'000'000'000); }
};

struct Parser : emulate::Wire {
  std::vector<wire::Pd0Ensemble> ensembles;
  wire::Framer<wire::Pd0::max_frame> framer;
  void send(wire::Bytes bytes) override {
    framer.feed(bytes, wire::Pd0::scan, [this](wire::Bytes frame, std::size_t) {
      if (const auto message = wire::Pd0::decode(frame)) ensembles.push_back(std::get<0>(*message));
    });
  }
  void send(const wire::CanFrame&) override {}
};

TEST(EmulatedDvl, SaysTheVelocityOfTheTruthFiveTimesASecond) {
  rig_config::DeviceConfig config;
  config.name = "dvl";
  config.kind = measurement::Kind::dvl;
  config.protocol = "pd0";
  config.rate_hz = 5;
  const Cruise cruise;
  const auto dvl = emulate::make_emulated_device(config, cruise, 1).value();
  Parser parser;
  while (dvl->deadline() && *dvl->deadline() <= measurement::stamp_from_ns(2'000'000'000))
    dvl->tick(*dvl->deadline(), parser);
  ASSERT_GE(parser.ensembles.size(), 9u);
  ASSERT_LE(parser.ensembles.size(), 11u);
  const auto& last = parser.ensembles.back();
  ASSERT_TRUE(last.bottom_track);
  const auto velocity =
      wire::velocity_frd(last.bottom_track->velocity_mps, last.fixed, last.variable);
  EXPECT_NEAR(velocity.value()[0], 1.5, 0.001);
  for (const auto& range : last.bottom_track->range_m) EXPECT_NEAR(range.value(), 80, 0.01);
}
