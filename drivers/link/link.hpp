#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/system/result.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "drivers/link/uri.hpp"
#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/can_frame.hpp"

/// How bytes and CAN frames travel. A link never throws for what the other side does:
/// every operation ends in a result whose error says what happened.
namespace drydock::link {

namespace asio = boost::asio;
using measurement::Provenance;
using measurement::Stamp;

template <class T>
using Task = asio::awaitable<boost::system::result<T>>;

/// Which end of a virtual line is opened: `device` makes the pty, bus or socket that `driver` joins.
enum class Side : std::uint8_t { driver, device };

struct ReceivedBytes {
  std::size_t size = 0;  ///< at least 1
  Stamp at{};            ///< when the read returned
};

/// A serial line, a socket, a file: bytes in order. Closing ends pending reads with an error.
class ByteLink {
 public:
  virtual ~ByteLink() = default;
  virtual Task<ReceivedBytes> read(std::span<std::uint8_t> into) = 0;
  virtual Task<void> write(std::span<const std::uint8_t> bytes) = 0;
  virtual void close() = 0;
  virtual Provenance provenance() const = 0;
};

struct ReceivedFrame {
  wire::CanFrame frame;
  Stamp at{};               ///< of the kernel where it gives one
  bool own = false;         ///< echo of a frame that this socket sent
};

/// A CAN bus.
class FrameLink {
 public:
  virtual ~FrameLink() = default;
  virtual Task<ReceivedFrame> read() = 0;
  virtual Task<void> write(const wire::CanFrame& frame) = 0;
  virtual void close() = 0;
  virtual Provenance provenance() const = 0;
  virtual std::uint64_t dropped() const { return 0; }  ///< frames lost in the receive queue
};

/// Why a link could not be opened. `message` is a sentence for a person: what failed, what to do.
struct OpenError {
  boost::system::error_code code;
  std::string message;
};

/// Opens the link that the URI names (Uri::carries tells which kind it is).
boost::system::result<std::unique_ptr<ByteLink>, OpenError> open_bytes(
    asio::any_io_executor executor, const Uri& uri, Side side);
boost::system::result<std::unique_ptr<FrameLink>, OpenError> open_frames(
    asio::any_io_executor executor, const Uri& uri, Side side);

/// Bench time now: UTC of the host.
Stamp now();

}  // namespace drydock::link
