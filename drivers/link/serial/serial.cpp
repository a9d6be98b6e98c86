#include "drivers/link/serial/serial.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/ioctl.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/write.hpp>

#include "drivers/link/descriptor.hpp"
#include "drivers/link/serial/access_advice.hpp"
#include "drivers/link/serial/line_settings.hpp"

namespace drydock::link {
namespace {

class SerialLink final : public ByteLink {
 public:
  SerialLink(const asio::any_io_executor& executor, Descriptor port, Provenance provenance)
      : port_(executor, port.release()), provenance_(provenance) {}

  /// A line that has disappeared (unplugged, or its pty is closed) gives end of file or EIO.
  Task<ReceivedBytes> read(std::span<std::uint8_t> into) override {
    const auto [error, size] =
        co_await port_.async_read_some(asio::buffer(into.data(), into.size()), as_outcome);
    if (error) co_return error;
    co_return ReceivedBytes{size, now()};
  }

  Task<void> write(std::span<const std::uint8_t> bytes) override {
    const auto [error, size] =
        co_await asio::async_write(port_, asio::buffer(bytes.data(), bytes.size()), as_outcome);
    if (error) co_return error;
    co_return boost::system::result<void>{};
  }

  void say_last(std::span<const std::uint8_t> bytes) override {
    if (port_.is_open()) (void)!::write(port_.native_handle(), bytes.data(), bytes.size());
  }

  void close() override {
    boost::system::error_code already_gone;
    port_.close(already_gone);
  }

  Provenance provenance() const override { return provenance_; }

 private:
  asio::posix::stream_descriptor port_;
  Provenance provenance_;
};

std::string advice(int error, const std::string& path) {
  switch (error) {
    case ENOENT: return " (is the device plugged in, or the emulator running?)";
    case EACCES: return " (" + access_advice(path) + ")";
    case EBUSY:
    case EWOULDBLOCK: return " (another program has it open)";
    case ENOTTY: return " (not a serial port)";
    case ERANGE: return " (the port cannot do this baud rate)";
    default: return {};
  }
}

OpenError refused(int error, const std::string& path) {
  return {system_error(error),
          "cannot open " + path + ": " + system_error(error).message() + advice(error, path)};
}

OpenError refused(const LineRefusal& refusal, const std::string& path) {
  if (refusal.setting.empty()) return refused(refusal.code.value(), path);
  return {asio::error::operation_not_supported, "cannot open " + path +
                                                    ": its driver did not take " + refusal.setting +
                                                    " (take a setting or an adapter that has it)"};
}

OpenedBytes open_line(const asio::any_io_executor& executor, const std::string& path,
                      const Uri& uri, bool exclusive) {
  Descriptor port(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!port) return refused(errno, path);
  if (const auto refusal = configure_line(port.get(), line_settings(uri)))
    return refused(*refusal, path);
  if (exclusive) {
    if (::flock(port.get(), LOCK_EX | LOCK_NB) != 0) return refused(errno, path);
    if (::ioctl(port.get(), TIOCEXCL) != 0) return refused(errno, path);
    request_low_latency(port.get());
  }
  const auto provenance = uri.emulated() ? Provenance::emulated : Provenance::real;
  return std::make_unique<SerialLink>(executor, std::move(port), provenance);
}

}  // namespace

OpenedBytes open_serial(const asio::any_io_executor& executor, const Uri& uri) {
  return open_line(executor, uri.target, uri, true);
}

OpenedBytes open_pty_driver(const asio::any_io_executor& executor, const Uri& uri) {
  return open_line(executor, pty_path(uri.target), uri, false);
}

}  // namespace drydock::link
