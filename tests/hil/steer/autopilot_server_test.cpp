#include <gtest/gtest.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>

#include "hil/steer/real_time/autopilot_server.hpp"
#include "tests/hil/steer/json_autopilot.hpp"

namespace drydock::steer::test {
namespace {

namespace asio = boost::asio;
using asio::ip::udp;

JointTroubles sound(Stamp) { return {}; }

TEST(AutopilotServer, AnswersAnAutopilotAtTheAddressFromWhichItSpeaksAndNoSecondOneBeside) {
  const auto mission = mission_of("bluerov2.toml");
  motion::SteeredTrajectory motion(mission, bench_s(0));
  asio::io_context io{1};
  AutopilotServer server(io, motion, mission, sound);
  const udp::endpoint there{asio::ip::address_v4::loopback(), server.port()};
  udp::socket first(io, {udp::v4(), 0}), second(io, {udp::v4(), 0});
  const auto say = [&](udp::socket& socket, std::uint32_t count) {
    socket.send_to(asio::buffer(packet(18458, 400, count, Pulses(16, 1500))), there);
  };
  const auto exchange = [&](udp::socket& socket, std::uint32_t count) {
    say(socket, count);
    while (socket.available() == 0) io.run_one();
    std::array<char, 2048> line;
    return read({line.data(), socket.receive(asio::buffer(line))}).timestamp_s;
  };
  EXPECT_NEAR(exchange(first, 1), 0.0025, 1e-9);
  say(second, 1);
  first.send_to(asio::buffer("nothing"), there);
  EXPECT_NEAR(exchange(first, 2), 0.005, 1e-9);
  EXPECT_EQ(server.session().counters().refused, 1u);
  EXPECT_EQ(server.session().counters().others, 1u);
  EXPECT_EQ(second.available(), 0u);
  server.stop();
  io.run();
}

TEST(AutopilotServer, APortThatAnotherProgramHasIsALineThatNamesIt) {
  asio::io_context io{1};
  udp::socket other(io, {asio::ip::address_v4::loopback(), 0});
  auto mission = mission_of("bluerov2.toml");
  mission.steering->listen = "127.0.0.1:" + std::to_string(other.local_endpoint().port());
  motion::SteeredTrajectory motion(mission, bench_s(0));
  try {
    AutopilotServer server(io, motion, mission, sound);
    FAIL() << "it has the port of another program";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(mission.steering->listen), std::string::npos);
  }
}

}  // namespace
}  // namespace drydock::steer::test
