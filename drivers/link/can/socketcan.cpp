#include "drivers/link/can/socketcan.hpp"

#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <sys/socket.h>

#include <array>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstring>
#include <utility>

#include "drivers/link/can/can_interface.hpp"
#include "drivers/link/can/kernel_frame.hpp"
#include "drivers/link/descriptor.hpp"

namespace drydock::link {
namespace {

using namespace std::chrono_literals;
using Descriptors = asio::posix::stream_descriptor;

/// Limit for a full transmit queue. It stays full if nobody on the bus acknowledges or if the
/// controller is bus-off. poll() does not report a full queue (ENOBUFS), so the link tries again at
/// each step.
constexpr auto patience = 250ms;
constexpr auto patience_step = 1ms;

class SocketCan final : public FrameLink {
 public:
  SocketCan(const asio::any_io_executor& executor, Descriptor socket, Provenance provenance,
            std::string note)
      : socket_(executor, socket.release()),
        room_(executor),
        provenance_(provenance),
        note_(std::move(note)) {
    socket_.native_non_blocking(true);
  }

  Task<ReceivedFrame> read() override;
  Task<void> write(const wire::CanFrame& frame) override;

  void close() override {
    boost::system::error_code already_gone;
    room_.cancel();
    socket_.close(already_gone);
  }

  Provenance provenance() const override { return provenance_; }
  std::uint64_t dropped() const override { return dropped_; }
  std::string_view note() const override { return note_; }

 private:
  /// EAGAIN means that nothing waits.
  boost::system::result<ReceivedFrame> receive();
  void note_drops(std::uint32_t total);
  void take_control(const cmsghdr& control, ReceivedFrame& received);

  Descriptors socket_;
  asio::steady_timer room_;
  Provenance provenance_;
  std::string note_;
  std::uint32_t last_total_ = 0;  ///< the kernel's count wraps at 32 bits
  std::uint64_t dropped_ = 0;
};

Task<ReceivedFrame> SocketCan::read() {
  for (;;) {
    if (!socket_.is_open()) co_return ErrorCode(asio::error::operation_aborted);
    const auto received = receive();
    if (received || received.error() != asio::error::try_again) co_return received;
    const auto [error] = co_await socket_.async_wait(Descriptors::wait_read, as_outcome);
    if (error) co_return error;
  }
}

boost::system::result<ReceivedFrame> SocketCan::receive() {
  KernelFrame kernel;
  iovec part{&kernel.frame, sizeof kernel.frame};
  alignas(cmsghdr)
      std::array<char, CMSG_SPACE(sizeof(timespec)) + CMSG_SPACE(sizeof(std::uint32_t))>
          control;
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  const ssize_t size = ::recvmsg(socket_.native_handle(), &message, MSG_DONTWAIT);
  if (size < 0) return system_error(errno);
  kernel.size = static_cast<std::size_t>(size);

  ReceivedFrame received{from_kernel(kernel), now(), (message.msg_flags & MSG_CONFIRM) != 0};
  for (cmsghdr* c = CMSG_FIRSTHDR(&message); c != nullptr; c = CMSG_NXTHDR(&message, c))
    take_control(*c, received);
  return received;
}

void SocketCan::take_control(const cmsghdr& control, ReceivedFrame& received) {
  if (control.cmsg_level != SOL_SOCKET) return;
  if (control.cmsg_type == SO_TIMESTAMPNS) {
    timespec at;
    std::memcpy(&at, CMSG_DATA(&control), sizeof at);
    received.at = Stamp{std::chrono::seconds{at.tv_sec} + std::chrono::nanoseconds{at.tv_nsec}};
  }
  if (control.cmsg_type == SO_RXQ_OVFL) {
    std::uint32_t total = 0;
    std::memcpy(&total, CMSG_DATA(&control), sizeof total);
    note_drops(total);
  }
}

void SocketCan::note_drops(std::uint32_t total) {
  dropped_ += total - last_total_;
  last_total_ = total;
}

Task<void> SocketCan::write(const wire::CanFrame& frame) {
  const KernelFrame kernel = to_kernel(frame);
  const auto give_up = std::chrono::steady_clock::now() + patience;
  for (;;) {
    if (!socket_.is_open()) co_return ErrorCode(asio::error::operation_aborted);
    if (::write(socket_.native_handle(), &kernel.frame, kernel.size) >= 0) break;
    const ErrorCode error = system_error(errno);
    const bool is_full = error.value() == ENOBUFS || error.value() == EAGAIN;
    if (error.value() == EINTR) continue;
    if (!is_full || std::chrono::steady_clock::now() >= give_up) co_return error;
    room_.expires_after(patience_step);
    const auto [interrupted] = co_await room_.async_wait(as_outcome);
    if (interrupted) co_return interrupted;
  }
  co_return boost::system::result<void>{};
}

/// Sets stamps, drop counts, error frames, and the URI's options. False on failure; errno says why.
bool set_options(int socket, const Uri& uri) {
  const auto set = [&](int level, int name, int value) {
    return ::setsockopt(socket, level, name, &value, sizeof value) == 0;
  };
  return set(SOL_SOCKET, SO_TIMESTAMPNS, 1) && set(SOL_SOCKET, SO_RXQ_OVFL, 1) &&
         set(SOL_CAN_RAW, CAN_RAW_ERR_FILTER, CAN_ERR_MASK) &&
         set(SOL_CAN_RAW, CAN_RAW_FD_FRAMES, uri.flag("fd")) &&
         set(SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, uri.flag("echo"));
}

OpenError no_socket(int error) {
  if (error == EAFNOSUPPORT || error == EPROTONOSUPPORT)
    return {system_error(error),
            "this kernel has no SocketCAN (modules can, can-raw); can:auto and slcan: do without"};
  return open_error(error, "cannot open a CAN socket");
}

std::string how_to_bring_up(const std::string& name, const Uri& uri, bool is_vcan) {
  const std::string type =
      is_vcan ? "" : " type can bitrate " + std::to_string(*uri.bitrate()) + " restart-ms 100";
  return name + " is down: ip link set " + name + type + " up";
}

/// What `listen=1` means on this interface.
std::string listening_note(const std::string& name, const CanInterface& found) {
  if (!found.listen_only) return "nothing is sent";
  if (*found.listen_only) return "nothing is sent: " + name + " is listen-only";
  return "nothing is sent, but " + name + " acknowledges: ip link set " + name +
         " type can listen-only on";
}

}  // namespace

OpenedFrames open_socketcan(const asio::any_io_executor& executor, const Uri& uri) {
  Descriptor socket(::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC, CAN_RAW));
  if (!socket) return no_socket(errno);
  const std::string& name = uri.target;
  const auto found = find_can_interface(name);
  if (!found) return open_error(found.error().value(), "there is no CAN interface " + name);
  if (!found->up)
    return OpenError{system_error(ENETDOWN), how_to_bring_up(name, uri, found->is_vcan)};
  if (uri.flag("fd") && found->mtu < CANFD_MTU)
    return OpenError{system_error(EINVAL), name + " carries no CAN FD (its mtu is " +
                                               std::to_string(found->mtu) +
                                               "): set it up with fd on, or leave out fd=1"};
  if (!set_options(socket.get(), uri)) return open_error(errno, "cannot set up " + name);
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = found->index;
  if (::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
    return open_error(errno, "cannot use " + name);
  return std::make_unique<SocketCan>(executor, std::move(socket),
                                     uri.emulated() ? Provenance::emulated : Provenance::real,
                                     uri.only_listens() ? listening_note(name, *found) : "");
}

}  // namespace drydock::link
