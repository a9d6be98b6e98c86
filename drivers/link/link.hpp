#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/system/result.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "drivers/link/uri.hpp"
#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/can/can_frame.hpp"

/// Transport of bytes and CAN frames. A link never throws because of the other side: every
/// operation ends in a result, and its error says what happened.
namespace drydock::link {

namespace asio = boost::asio;
using measurement::Provenance;
using measurement::Stamp;

template <class T>
using Task = asio::awaitable<boost::system::result<T>>;

/// The end of a virtual line that is opened: `device` makes the pty, bus or socket, and `driver`
/// joins it.
enum class Side : std::uint8_t { driver, device };

struct ReceivedBytes {
  std::size_t size = 0;  ///< at least 1
  Stamp at{};            ///< when the read returned
};

/// A serial line, a socket, a file: bytes in order. close() ends pending reads with
/// operation_aborted. The `device` side outlives its drivers: it waits when one leaves, and bytes
/// that it writes while nobody listens are lost, as on a wire. The `driver` side reads an error
/// when the device is gone; it then closes and opens again. There is at most one read and one write
/// at a time, all on the thread of the executor. A pending read or write must have ended before the
/// link is destroyed.
class ByteLink {
 public:
  ByteLink() = default;
  ByteLink(const ByteLink&) = delete;
  ByteLink& operator=(const ByteLink&) = delete;
  virtual ~ByteLink() = default;
  virtual Task<ReceivedBytes> read(std::span<std::uint8_t> into) = 0;
  virtual Task<void> write(std::span<const std::uint8_t> bytes) = 0;
  /// Who said what read() gave last. 0: this link has one other end.
  virtual std::uint64_t speaker() const { return 0; }
  /// Only to the one that speaker() named. One that has left misses it.
  virtual Task<void> write_to(std::uint64_t, std::span<const std::uint8_t> bytes) {
    return write(bytes);
  }
  /// Sends what fits at once and loses the rest: the last words before close(). The links to real
  /// devices have it; others say nothing.
  virtual void say_last(std::span<const std::uint8_t>) {}
  virtual void close() = 0;
  virtual Provenance provenance() const = 0;
  /// Bit/s that the other end has set, if this link can tell. The end of a pty can.
  virtual std::optional<unsigned> far_baud() const { return {}; }
  /// Written bytes that a listener who was there did not take in time.
  virtual std::uint64_t dropped() const { return 0; }
  /// What a person should know about this line, as one line. Empty: nothing. Valid until the next
  /// call.
  virtual std::string_view note() { return {}; }
};

struct ReceivedFrame {
  wire::CanFrame frame;
  Stamp at{};        ///< from the kernel, if it gives one
  bool own = false;  ///< echo of a frame that this socket sent
};

/// A CAN bus, with the same rules as a ByteLink.
class FrameLink {
 public:
  FrameLink() = default;
  FrameLink(const FrameLink&) = delete;
  FrameLink& operator=(const FrameLink&) = delete;
  virtual ~FrameLink() = default;
  virtual Task<ReceivedFrame> read() = 0;
  virtual Task<void> write(const wire::CanFrame& frame) = 0;
  virtual void close() = 0;
  virtual Provenance provenance() const = 0;
  virtual std::uint64_t dropped() const { return 0; }  ///< frames lost in the receive queue
  /// Bit/s, if the link knows it better than its URI.
  virtual std::optional<unsigned> bit_rate() const { return {}; }
  /// What a person should know about this bus, as one line. Empty: nothing. It may change once the
  /// first read or write has opened the channel.
  virtual std::string_view note() const { return {}; }
};

/// Why a link could not be opened. `message` is a sentence for a person: the failure and the
/// remedy.
struct OpenError {
  boost::system::error_code code;
  std::string message;
};

/// result::value() calls it if there is no value; throws std::runtime_error.
[[noreturn]] void throw_exception_from_error(const OpenError& error,
                                             const boost::source_location& where);

/// Opens the link that the URI names. Uri::carries gives its kind.
boost::system::result<std::unique_ptr<ByteLink>, OpenError> open_bytes(
    const asio::any_io_executor& executor, const Uri& uri, Side side);
boost::system::result<std::unique_ptr<FrameLink>, OpenError> open_frames(
    const asio::any_io_executor& executor, const Uri& uri, Side side);

/// The bus that a can:auto URI means now, in words: "vcan0 of the kernel" or "slcan on the pty
/// /tmp/drydock-0/bus0". It is fixed once the device side is open.
std::string can_auto_level(const Uri& uri);

/// The path of the symlink of a pty with this name. An absolute path is returned unchanged.
std::string pty_path(std::string_view name);

/// The present bench time: UTC of the host.
Stamp now();

}  // namespace drydock::link
