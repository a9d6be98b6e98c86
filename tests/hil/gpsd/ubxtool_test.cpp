#include <gmock/gmock.h>
#include <unistd.h>

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "drivers/link/clock.hpp"
#include "hil/emulate/real_time/real_time.hpp"
#include "tests/hil/emulate/bench.hpp"

/// gpsd's ubxtool as the client of an emulated u-blox on a paced pty.
namespace drydock::peer {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Its Python module is a package of its own (python3-gps).
bool ubxtool_runs() { return std::system("ubxtool -V >/dev/null 2>&1") == 0; }

class Ubxtool : public testing::Test {
 protected:
  void SetUp() override {
    if (!ubxtool_runs())
      GTEST_SKIP() << "ubxtool does not run (packages gpsd-clients, python3-gps)";
    auto config = emulate::device(rig_config::DeviceKind::gnss, "ubx", 5);
    config.name = "gnss";
    config.link = "pty:" + pty_ + "?baud=38400";
    emulator_.set_on_told(
        [this](std::string_view, std::string_view what) { told_.emplace_back(what); });
    ASSERT_TRUE(emulator_.start({config}));
    thread_ = std::thread([this] { io_.run(); });
  }
  void TearDown() override {
    boost::asio::post(io_, [this] { emulator_.stop(); });
    if (thread_.joinable()) thread_.join();
  }

  /// The output of ubxtool at this speed of the port.
  std::string ubxtool(const std::string& arguments, int baud) const {
    const std::string command = "timeout 30 ubxtool -f " + pty_ + " -s " + std::to_string(baud) +
                                " -P 18 -w 2 -v 2 " + arguments + " 2>&1";
    std::string output;
    FILE* pipe = popen(command.c_str(), "r");
    std::array<char, 4096> part;
    while (pipe && std::fgets(part.data(), part.size(), pipe)) output += part.data();
    if (pipe) pclose(pipe);
    return output;
  }
  /// ubxtool empties its input as it starts, and on a busy machine the answer is lost with it. So
  /// it asks up to three times.
  std::string answer(const std::string& arguments, int baud, const std::string& expected) const {
    std::string output = ubxtool(arguments, baud);
    for (int again = 0; again < 2 && output.find(expected) == output.npos; ++again)
      output = ubxtool(arguments, baud);
    return output;
  }

  const std::string pty_ = "/tmp/drydock-ubxtool-" + std::to_string(::getpid());
  struct Still final : motion::Trajectory {
    motion::Truth at(measurement::Stamp time) const override {
      motion::Truth truth = emulate::at_the_surface();
      truth.at = time;
      return truth;
    }
    measurement::Stamp start() const override { return begin; }
    measurement::Stamp end() const override { return begin; }
    measurement::Stamp begin = link::steady_now();
  } trajectory_;
  boost::asio::io_context io_{1};
  emulate::SoundDevices devices_{trajectory_, 1};
  emulate::RealTimeEmulator emulator_{io_, devices_};
  std::thread thread_;
  std::vector<std::string> told_;
};

TEST_F(Ubxtool, ReadsTheVersionSetsTheRateAndFollowsTheBaudRate) {
  EXPECT_THAT(answer("-p MON-VER", 38400, "FWVER=SPG 3.01"), HasSubstr("FWVER=SPG 3.01"));
  EXPECT_THAT(answer("-p CFG-PRT", 38400, "38400"), HasSubstr("38400"));
  EXPECT_THAT(answer("-p CFG-RATE,500", 38400, "UBX-ACK-ACK"), HasSubstr("UBX-ACK-ACK"));
  EXPECT_THAT(answer("-p CFG-RATE", 38400, "500"), HasSubstr("500"));
  ubxtool("-S 115200", 38400);
  EXPECT_THAT(ubxtool("-p MON-VER", 38400), Not(HasSubstr("FWVER")));
  EXPECT_THAT(answer("-p MON-VER", 115200, "FWVER=SPG 3.01"), HasSubstr("FWVER=SPG 3.01"));
}

}  // namespace
}  // namespace drydock::peer
