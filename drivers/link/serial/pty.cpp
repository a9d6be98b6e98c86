#include "drivers/link/serial/pty.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstdlib>

#include "drivers/link/descriptor.hpp"
#include "drivers/link/serial/line_settings.hpp"
#include "drivers/link/serial/owned_symlink.hpp"
#include "drivers/link/serial/pty_listeners.hpp"

namespace drydock::link {
namespace {

using namespace std::chrono_literals;

/// A listener may leave the line full (about 64 KiB) for this long before its bytes are lost.
constexpr auto listener_patience = 200ms;
constexpr auto listener_step = 2ms;

class PtyDevice final : public ByteLink {
 public:
  PtyDevice(const asio::any_io_executor& executor, Descriptor master, Descriptor slave,
            PtyListeners listeners, OwnedSymlink symlink)
      : master_(executor, master.release()),
        slave_(std::move(slave)),
        listeners_(std::move(listeners)),
        symlink_(std::move(symlink)),
        room_(executor) {}

  Task<ReceivedBytes> read(std::span<std::uint8_t> into) override {
    const auto [error, size] =
        co_await master_.async_read_some(asio::buffer(into.data(), into.size()), as_outcome);
    if (error) co_return error;
    co_return ReceivedBytes{size, now()};
  }

  Task<void> write(std::span<const std::uint8_t> bytes) override;

  void close() override {
    boost::system::error_code already_gone;
    symlink_.remove();
    room_.cancel();
    master_.close(already_gone);
  }

  Provenance provenance() const override { return Provenance::emulated; }
  std::uint64_t dropped() const override { return dropped_; }
  std::optional<unsigned> far_baud() const override {
    const auto baud = line_baud(slave_.get());
    return baud ? std::optional(*baud) : std::nullopt;
  }

 private:
  /// Discards unread bytes: they are old for the next program that opens the line.
  void discard_unread() {
    ::ioctl(master_.native_handle(), TCFLSH, TCOFLUSH);
    ::ioctl(slave_.get(), TCFLSH, TCIFLUSH);
  }

  asio::posix::stream_descriptor master_;
  Descriptor slave_;
  PtyListeners listeners_;
  OwnedSymlink symlink_;
  asio::steady_timer room_;
  bool overrun_ = false;  ///< the listener does not read: discard bytes at once
  std::uint64_t dropped_ = 0;
};

Task<void> PtyDevice::write(std::span<const std::uint8_t> bytes) {
  if (listeners_.opened_since() || !listeners_.present()) discard_unread();
  auto give_up = asio::steady_timer::clock_type::now() + listener_patience;
  while (!bytes.empty()) {
    if (!master_.is_open()) co_return ErrorCode(asio::error::operation_aborted);
    const ssize_t size = ::write(master_.native_handle(), bytes.data(), bytes.size());
    if (size >= 0) {
      overrun_ = false;
      give_up = asio::steady_timer::clock_type::now() + listener_patience;
      bytes = bytes.subspan(static_cast<std::size_t>(size));
      continue;
    }
    if (errno == EINTR) continue;
    if (errno != EAGAIN) co_return system_error(errno);
    overrun_ = overrun_ || asio::steady_timer::clock_type::now() >= give_up;
    if (overrun_) dropped_ += bytes.size();
    if (overrun_ || !listeners_.present()) break;
    room_.expires_after(listener_step);
    const auto [error] = co_await room_.async_wait(as_outcome);
    if (error) co_return error;
  }
  co_return boost::system::result<void>{};
}

struct Pair {
  Descriptor master, slave;
  std::string device;
};

boost::system::result<Pair> make_pair_of_ends(std::optional<unsigned> baud) {
  Pair pair;
  pair.master = Descriptor(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!pair.master) return system_error(errno);
  std::array<char, 64> name{};
  if (::grantpt(pair.master.get()) != 0 || ::unlockpt(pair.master.get()) != 0 ||
      ::ptsname_r(pair.master.get(), name.data(), name.size()) != 0)
    return system_error(errno);
  pair.device = name.data();
  pair.slave = Descriptor(::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC));
  if (!pair.slave) return system_error(errno);
  if (const auto error = make_raw(pair.slave.get(), baud)) return error;
  return pair;
}

}  // namespace

std::string pty_path(std::string_view name) {
  if (name.starts_with('/')) return std::string(name);
  const char* runtime = std::getenv("XDG_RUNTIME_DIR");
  const std::string base = runtime != nullptr && *runtime != '\0' ? runtime : "/tmp";
  return base + "/drydock-" + std::to_string(::getuid()) + "/" + std::string(name);
}

OpenedBytes open_pty_device(const asio::any_io_executor& executor, const Uri& uri) {
  auto pair = make_pair_of_ends(uri.baud());
  if (!pair) return open_error(pair.error().value(), "cannot make a pty");
  auto listeners = PtyListeners::watch(pair->device);
  if (!listeners)
    return open_error(listeners.error().value(),
                      "cannot watch " + pair->device +
                          " by inotify (see the sysctl fs.inotify.max_user_instances)");
  auto symlink = OwnedSymlink::place(pty_path(uri.target), pair->device);
  if (!symlink) return symlink.error();
  return std::make_unique<PtyDevice>(executor, std::move(pair->master), std::move(pair->slave),
                                     std::move(*listeners), std::move(*symlink));
}

}  // namespace drydock::link
