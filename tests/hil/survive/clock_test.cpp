#include "tests/hil/survive/bench.hpp"

/// The host's clock is set while devices stream.
namespace drydock::fault::testing {
namespace clock_test {

using device::LifeCycle;
using measurement::Stamp;

const Stamp noon = measurement::stamp_from_ns(1'700'000'000'000'000'000);

TEST(ClockWatch, TellsAStepOnceAndNoSlewing) {
  link::ClockWatch watch;
  EXPECT_EQ(watch.step(noon, 10s), 0s);
  EXPECT_EQ(watch.step(noon + 1s, 11s), 0s);
  EXPECT_EQ(watch.step(noon + 2s + 500us, 12s), 0s);
  EXPECT_EQ(watch.step(noon - 3597s, 13s), -3600s - 500us);
  EXPECT_EQ(watch.step(noon - 3596s, 14s), 0s);
  for (int i = 1; i <= 100; ++i)  // changes of 50 ms are no step, even all together
    EXPECT_EQ(watch.step(noon - 3596s + i * 1050ms, 14s + i * 1s), 0s);
}

TEST(SteadyNow, RunsWithTheHostsClock) {
  const auto apart = link::steady_now() - link::now();
  EXPECT_LT(std::chrono::abs(apart), 50ms);
  const Stamp earlier = link::steady_now();
  EXPECT_LE(earlier, link::steady_now());
}

TEST(LifeCycleAcrossAStep, SilenceAndBackOffLastAsLongAsTheyWouldHave) {
  for (const auto step : {-3600s, 3600s}) {
    LifeCycle life;
    life.start(noon);
    life.opened(noon);
    life.message(noon);
    life.clock_stepped(step);
    EXPECT_EQ(life.deadline(), noon + step + 2s);
    EXPECT_FALSE(life.tick(noon + step + 1s));
    EXPECT_EQ(life.tick(noon + step + 2s)->to, State::stale);
    life.link_lost(noon + step + 3s, "gone");
    life.clock_stepped(-step);
    EXPECT_EQ(life.deadline(), noon + 3s + 250ms);
  }
}

/// A speed log sends the same message at chosen times.
TEST(DeviceAcrossAStep, StampsFollowTheNewTimeAndTheRateIsMeteredAnew) {
  struct Heard final : device::Listener {
    void on_measurement(const measurement::Measurement& m) override {
      stamps.push_back(measurement::origin_of(m).received_at);
    }
    void on_state(const device::Device&, const device::Transition& change) override {
      states.push_back(change.to);
    }
    std::vector<Stamp> stamps;
    std::vector<State> states;
  } heard;
  struct Nowhere final : device::Transmitter {
    void send(wire::Bytes) override {}
    void send(const wire::CanFrame&) override {}
  } nowhere;
  rig_config::Rig rig;
  rig.devices = {speed_log("memory:step?baud=38400")};
  const auto device = std::move(shell::make_devices(rig)->front());
  device->connect(heard, nowhere);
  device->start(noon);
  device->opened(noon, measurement::Provenance::emulated);
  const auto sentence = link::testing::bytes("$HCVHW,,,,,0.2,N,0,K*5B\r\n");
  for (int i = 0; i < 10; ++i) device->receive(sentence, noon + i * 1s);

  const auto step = -3600s;
  device->clock_stepped(step, noon + 9500ms + step);
  for (int i = 10; i < 20; ++i) device->receive(sentence, noon + i * 1s + step);
  EXPECT_EQ(heard.stamps.back(), noon + 19s + step);
  EXPECT_EQ(heard.states.back(), State::streaming);
  const auto health = device->health(noon + 19s + step);
  EXPECT_NEAR(health.rate_hz.value_or(0), 1, 0.01);
  EXPECT_EQ(health.age, 0s);
  device->tick(noon + 22s + step);
  EXPECT_EQ(heard.states.back(), State::stale);
}

}  // namespace clock_test
}  // namespace drydock::fault::testing
