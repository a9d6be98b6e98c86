#include <stdexcept>

#include "drivers/link/can/can_auto.hpp"
#include "drivers/link/can/frame_file.hpp"
#include "drivers/link/can/frame_hub.hpp"
#include "drivers/link/can/gateway.hpp"
#include "drivers/link/can/listening.hpp"
#include "drivers/link/can/slcan.hpp"
#include "drivers/link/can/socketcan.hpp"
#include "drivers/link/file.hpp"
#include "drivers/link/link.hpp"
#include "drivers/link/memory.hpp"
#include "drivers/link/net/tcp.hpp"
#include "drivers/link/net/udp.hpp"
#include "drivers/link/serial/pty.hpp"
#include "drivers/link/serial/serial.hpp"

namespace drydock::link {
namespace {

OpenError wrong_kind(const Uri& uri, const char* wanted) {
  return {asio::error::invalid_argument, "\"" + uri.text + "\" carries no " + wanted};
}

}  // namespace

boost::system::result<std::unique_ptr<ByteLink>, OpenError> open_bytes(
    const asio::any_io_executor& executor, const Uri& uri, Side side) {
  const bool is_driver = side == Side::driver;
  switch (uri.scheme) {
    case Scheme::serial: return open_serial(executor, uri);
    case Scheme::pty:
      return is_driver ? open_pty_driver(executor, uri) : open_pty_device(executor, uri);
    case Scheme::tcp:
      return is_driver ? open_tcp_client(executor, uri) : open_tcp_server(executor, uri);
    case Scheme::udp: return open_udp(executor, uri, side);
    case Scheme::file: return open_file(executor, uri, side);
    case Scheme::memory: return open_memory(executor, uri, side);
    default: return wrong_kind(uri, "bytes but CAN frames");
  }
}

namespace {

OpenedFrames open_bus(const asio::any_io_executor& executor, const Uri& uri, Side side) {
  switch (uri.scheme) {
    case Scheme::socketcan: return open_socketcan(executor, uri);
    case Scheme::slcan: return open_slcan(executor, uri, side);
    case Scheme::gateway: return open_gateway(executor, uri, side);
    case Scheme::memory_can: return open_memory_can(executor, uri);
    case Scheme::can_auto: return open_can_auto(executor, uri, side);
    case Scheme::file: return open_frame_file(executor, uri, side);
    default: return wrong_kind(uri, "CAN frames but bytes");
  }
}

}  // namespace

boost::system::result<std::unique_ptr<FrameLink>, OpenError> open_frames(
    const asio::any_io_executor& executor, const Uri& uri, Side side) {
  auto opened = open_bus(executor, uri, side);
  if (opened && side == Side::driver && uri.only_listens())
    return make_listening(std::move(*opened));
  return opened;
}

void throw_exception_from_error(const OpenError& error, const boost::source_location&) {
  throw std::runtime_error(error.message);
}

}  // namespace drydock::link
