#include "drivers/shell/lockstep.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "drivers/shell/device_actor.hpp"

namespace drydock::shell {
namespace {

using measurement::from_seconds;
using namespace std::chrono_literals;

Stamp at_s(double s) { return Stamp{from_seconds(s)}; }

using Diary = std::vector<std::pair<std::string, Stamp>>;

/// Acts at given times and records each action.
class Diarist final : public Actor {
 public:
  Diarist(std::string name, std::vector<Stamp> times, Diary& diary)
      : name_(std::move(name)), times_(std::move(times)), diary_(diary) {}
  std::optional<Stamp> deadline() const override {
    return next_ < times_.size() ? std::optional{times_[next_]} : std::nullopt;
  }
  void act(Stamp now) override {
    ++next_;
    diary_.emplace_back(name_, now);
  }

 private:
  std::string name_;
  std::vector<Stamp> times_;
  Diary& diary_;
  std::size_t next_ = 0;
};

TEST(Lockstep, WhatWasDueInASkippedTimeActsOnceAtItsEnd) {
  Diary diary;
  Diarist diarist("a", {at_s(1), at_s(1e9), at_s(1e9 + 2)}, diary);
  Lockstep lockstep(at_s(0));
  lockstep.add(diarist);
  lockstep.run_until(at_s(2));
  lockstep.skip_to(at_s(1e9 + 1));
  lockstep.skip_to(at_s(5));
  lockstep.run_until(at_s(1e9 + 3));
  EXPECT_EQ(diary, (Diary{{"a", at_s(1)}, {"a", at_s(1e9 + 1)}, {"a", at_s(1e9 + 2)}}));
}

TEST(Lockstep, ActorsActInTheOrderOfTheirDeadlines) {
  Diary diary;
  Diarist a("a", {at_s(3), at_s(4)}, diary), b("b", {at_s(1), at_s(5)}, diary);
  Lockstep shell(at_s(0));
  shell.add(a);
  shell.add(b);
  shell.run_until(at_s(10));
  EXPECT_EQ(diary, (Diary{{"b", at_s(1)}, {"a", at_s(3)}, {"a", at_s(4)}, {"b", at_s(5)}}));
  EXPECT_EQ(shell.now(), at_s(10));
}

TEST(Lockstep, DueAtTheSameTimeTheFirstAddedActsFirst) {
  Diary diary;
  Diarist a("a", {at_s(1)}, diary), b("b", {at_s(1)}, diary), c("c", {at_s(0.5), at_s(1)}, diary);
  Lockstep shell(at_s(0));
  for (Diarist* actor : {&b, &a, &c}) shell.add(*actor);
  shell.run_until(at_s(1));  // includes the end
  EXPECT_EQ(diary, (Diary{{"c", at_s(0.5)}, {"b", at_s(1)}, {"a", at_s(1)}, {"c", at_s(1)}}));
}

TEST(Lockstep, MissedDeadlineIsActedNowNotInThePast) {
  Diary diary;
  Diarist late("late", {at_s(1)}, diary);
  Lockstep shell(at_s(5));
  shell.add(late);
  shell.run_until(at_s(6));
  EXPECT_EQ(diary, (Diary{{"late", at_s(5)}}));
}

TEST(Lockstep, WhatIsDueAfterTheEndWaitsForTheNextRun) {
  Diary diary;
  Diarist a("a", {at_s(2)}, diary);
  Lockstep shell(at_s(0));
  shell.add(a);
  shell.run_until(at_s(1));
  EXPECT_TRUE(diary.empty());
  shell.run_until(at_s(2));
  EXPECT_EQ(diary.size(), 1U);
}

TEST(Lockstep, ActorThatNeverMovesItsDeadlineIsAProgrammingError) {
  struct Stuck final : Actor {
    std::optional<Stamp> deadline() const override { return at_s(1); }
    void act(Stamp) override {}
  } stuck;
  Lockstep shell(at_s(0));
  shell.add(stuck);
  EXPECT_THROW(shell.run_until(at_s(2)), std::logic_error);
}

struct Desk final : device::Listener, device::Transmitter {
  void on_measurement(const measurement::Measurement&) override { ++heard; }
  void on_state(const device::Device&, const device::Transition& change) override {
    changes.emplace_back(change.to, change.at);
  }
  void send(wire::Bytes) override {}
  void send(const wire::CanFrame&) override {}
  int heard = 0;
  std::vector<std::pair<device::State, Stamp>> changes;
};

TEST(DeviceActor, LivesThroughSilenceInVirtualTime) {
  device::DeviceOptions options;
  options.driver.kind = device::Kind::emlog;
  options.driver.protocol = "nmea0183";
  Desk desk;
  DeviceActor log(*device::Device::make(options), desk, desk, at_s(100));
  Lockstep shell(at_s(100));
  shell.add(log);
  shell.run_until(at_s(101));
  const std::string_view vhw = "$HCVHW,,,,,0.2,N,0,K*5B\r\n";
  log.receive({reinterpret_cast<const std::uint8_t*>(vhw.data()), vhw.size()}, at_s(101));
  shell.run_until(at_s(114));

  using device::State;
  const std::vector<std::pair<State, Stamp>> expected{
      {State::opening, at_s(100)},     {State::waiting, at_s(100)},
      {State::streaming, at_s(101)},   {State::stale, at_s(103)},
      {State::backing_off, at_s(113)}, {State::opening, at_s(113.25)},
      {State::waiting, at_s(113.25)}};
  EXPECT_EQ(desk.changes, expected);
  EXPECT_EQ(desk.heard, 1);
}

}  // namespace
}  // namespace drydock::shell
