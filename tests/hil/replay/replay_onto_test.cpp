// A recording is written to a pty, and a driver reads its other end in real time.
#include <gtest/gtest.h>
#include <unistd.h>

#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <filesystem>

#include "drivers/recordings/record/player.hpp"
#include "drivers/shell/real_time.hpp"
#include "drivers/shell/rig_devices.hpp"
#include "hil/bench/run.hpp"
#include "hil/replay/onto.hpp"
#include "rig_config/load.hpp"

namespace replay_onto_test {

using namespace drydock;
using namespace drydock::replay;

/// Collects the velocities of a DVL's driver and notes when its link is open.
class Velocities final : public device::Listener {
 public:
  std::vector<Eigen::Vector3d> all;
  std::function<void()> on_open, on_next;

  void on_measurement(const measurement::Measurement& m) override {
    if (const auto* velocity = std::get_if<measurement::BottomVelocity>(&m);
        velocity != nullptr && velocity->velocity)
      all.push_back(*velocity->velocity);
    if (on_next) on_next();
  }
  void on_state(const device::Device&, const device::Transition& change) override {
    if (change.to != device::State::opening && on_open) std::exchange(on_open, nullptr)();
  }
};

class ReplayOnto : public testing::Test {
 protected:
  void SetUp() override {
    path_ = std::filesystem::temp_directory_path() /
            ("replay-onto-" + std::to_string(::getpid()) + ".mcap");
    bench::RunOptions options;
    options.duration_s = 5;
    options.lockstep = true;
    options.record = {path_, true};
    testing::internal::CaptureStdout();
    bench::run_lockstep(rig_, options);
    testing::internal::GetCapturedStdout();
  }
  void TearDown() override { std::filesystem::remove(path_); }

  rig_config::Rig rig_ =
      rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value();
  std::string path_;
};

TEST_F(ReplayOnto, APtyGivesAnotherDriverTheSameMessages) {
  Velocities expected;
  record::Selection dvl;
  dvl.only = {"dvl"};
  ASSERT_TRUE(record::play(path_, dvl, expected));
  ASSERT_GT(expected.all.size(), 20u);

  boost::asio::io_context io;
  auto recording = record::Recording::open(path_).value();
  const std::string pty = "pty:replay-onto-" + std::to_string(::getpid());
  Onto onto(io, recording.links(), {"dvl=" + pty});
  auto rig = rig_;
  rig.devices[0].link = pty;
  rig.devices.resize(1);
  auto devices = shell::make_devices(rig);
  ASSERT_TRUE(devices);
  Velocities got;
  shell::RealTime driver(io, std::move(*devices), got);
  boost::asio::steady_timer too_long(io, std::chrono::seconds{4});
  const auto stop = [&] {
    too_long.cancel();
    driver.stop();
    io.stop();
  };
  too_long.async_wait([&](const boost::system::error_code& ec) {
    if (!ec) stop();
  });
  got.on_open = [&] {
    while (const auto event = recording.next())
      if (const auto* raw = std::get_if<record::RawEvent>(&*event)) onto.send(*raw);
  };
  got.on_next = [&] {
    if (got.all.size() >= expected.all.size()) boost::asio::post(io, stop);
  };
  driver.start();
  io.run();
  io.restart();
  io.poll();
  EXPECT_EQ(onto.lost(), 0u);
  ASSERT_EQ(got.all.size(), expected.all.size());
  for (std::size_t i = 0; i < got.all.size(); ++i) EXPECT_EQ(got.all[i], expected.all[i]) << i;
}

TEST_F(ReplayOnto, ANameOrLinkThatCannotBeIsRefusedInALine) {
  boost::asio::io_context io;
  const auto recording = record::Recording::open(path_).value();
  for (const std::string wrong : {"sonar=pty:x", "dvl", "dvl=memory-can:x", "dvl=file:x", "dvl=?"})
    EXPECT_THROW(Onto(io, recording.links(), {wrong}), std::runtime_error) << wrong;
}

}  // namespace replay_onto_test
