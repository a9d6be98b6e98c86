#include "hil/steer/real_time/autopilot_server.hpp"

#include <fmt/format.h>

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <charconv>
#include <stdexcept>
#include <utility>

#include "drivers/io/as_outcome.hpp"
#include "drivers/link/clock.hpp"

namespace drydock::steer {
namespace {

namespace asio = boost::asio;
using asio::ip::udp;

[[noreturn]] void refuse(const std::string& listen, const std::string& why) {
  throw std::runtime_error(fmt::format("cannot wait for an autopilot on {}: {}", listen, why));
}

udp::endpoint endpoint_of(const std::string& listen) {
  const std::size_t colon = listen.rfind(':');
  unsigned port = 0;
  const char* digits = listen.data() + colon + 1;
  std::from_chars(digits, listen.data() + listen.size(), port);
  boost::system::error_code error;
  const auto address = asio::ip::make_address_v4(listen.substr(0, colon), error);
  if (error || port > 0xFFFF) refuse(listen, "it is not ADDRESS:PORT, as 127.0.0.1:9002");
  return {address, static_cast<unsigned short>(port)};
}

udp::socket bound(asio::io_context& context, const std::string& listen) {
  udp::socket socket(context);
  boost::system::error_code error;
  const udp::endpoint endpoint = endpoint_of(listen);
  socket.open(endpoint.protocol(), error);
  if (!error) socket.bind(endpoint, error);
  if (error) refuse(listen, error.message());
  return socket;
}

Sender sender_of(const udp::endpoint& endpoint) {
  return Sender{endpoint.address().to_v4().to_uint()} << 16 | endpoint.port();
}

}  // namespace

AutopilotServer::AutopilotServer(asio::io_context& context, motion::SteeredTrajectory& motion,
                                 const rig_config::MissionConfig& mission, JointTroublesAt troubles)
    : socket_(bound(context, mission.steering.value().listen)),
      session_(motion, mission),
      troubles_(std::move(troubles)) {
  asio::co_spawn(context, serve(), asio::detached);
}

void AutopilotServer::stop() {
  boost::system::error_code already_closed;
  socket_.close(already_closed);
}

asio::awaitable<void> AutopilotServer::serve() {
  std::array<std::uint8_t, 256> packet;
  while (socket_.is_open()) {
    udp::endpoint sender;
    const auto [error, size] =
        co_await socket_.async_receive_from(asio::buffer(packet), sender, io::as_outcome);
    if (error == asio::error::operation_aborted || !socket_.is_open()) co_return;
    if (error) continue;  // an earlier answer was not taken: the autopilot has gone
    const Stamp now = link::steady_now();
    session_.set_troubles(troubles_(now));
    const auto answer = session_.answer(wire::Bytes{packet}.first(size), now, sender_of(sender));
    if (answer.empty()) continue;
    co_await socket_.async_send_to(asio::buffer(answer), sender, io::as_outcome);
  }
}

}  // namespace drydock::steer
