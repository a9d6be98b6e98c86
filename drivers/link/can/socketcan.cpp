#include "drivers/link/can/socketcan.hpp"

#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <linux/errqueue.h>
#include <linux/net_tstamp.h>
#include <sys/socket.h>

#include <array>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstring>
#include <utility>

#include "drivers/link/can/can_interface.hpp"
#include "drivers/link/can/controller_clock.hpp"
#include "drivers/link/can/interface_commands.hpp"
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

constexpr std::size_t control_size = CMSG_SPACE(sizeof(timespec)) +
                                     CMSG_SPACE(sizeof(scm_timestamping)) +
                                     CMSG_SPACE(sizeof(std::uint32_t));

std::chrono::nanoseconds time_of(const timespec& at) {
  return std::chrono::seconds{at.tv_sec} + std::chrono::nanoseconds{at.tv_nsec};
}

class SocketCan final : public FrameLink {
 public:
  SocketCan(const asio::any_io_executor& executor, Descriptor socket, Provenance provenance,
            std::optional<unsigned> bit_rate, const std::string& note)
      : socket_(executor, socket.release()),
        room_(executor),
        provenance_(provenance),
        bit_rate_(bit_rate),
        kernel_note_("stamps of the kernel" + note),
        controller_note_("stamps of the controller" + note) {
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
  std::optional<unsigned> bit_rate() const override { return bit_rate_; }
  std::string_view note() const override {
    return controller_stamps_ ? controller_note_ : kernel_note_;
  }

 private:
  /// EAGAIN means that nothing waits.
  boost::system::result<ReceivedFrame> receive();
  void note_drops(std::uint32_t total);
  /// Takes a control message; `by_controller` gets the controller's own stamp.
  void take_control(const cmsghdr& control, ReceivedFrame& received,
                    std::optional<std::chrono::nanoseconds>& by_controller);

  Descriptors socket_;
  asio::steady_timer room_;
  Provenance provenance_;
  std::optional<unsigned> bit_rate_;
  std::string kernel_note_, controller_note_;
  bool controller_stamps_ = false;  ///< the last frame had one
  ControllerClock controller_clock_;
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
  alignas(cmsghdr) std::array<char, control_size> control;
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  const ssize_t size = ::recvmsg(socket_.native_handle(), &message, MSG_DONTWAIT);
  if (size < 0) return system_error(errno);
  kernel.size = static_cast<std::size_t>(size);

  ReceivedFrame received{from_kernel(kernel), now(), (message.msg_flags & MSG_CONFIRM) != 0};
  std::optional<std::chrono::nanoseconds> by_controller;
  for (cmsghdr* c = CMSG_FIRSTHDR(&message); c != nullptr; c = CMSG_NXTHDR(&message, c))
    take_control(*c, received, by_controller);
  controller_stamps_ = by_controller.has_value();
  if (by_controller) received.at = controller_clock_.on_host(*by_controller, received.at);
  return received;
}

void SocketCan::take_control(const cmsghdr& control, ReceivedFrame& received,
                             std::optional<std::chrono::nanoseconds>& by_controller) {
  if (control.cmsg_level != SOL_SOCKET) return;
  if (control.cmsg_type == SO_TIMESTAMPNS) {
    timespec at;
    std::memcpy(&at, CMSG_DATA(&control), sizeof at);
    received.at = Stamp{time_of(at)};
  }
  if (control.cmsg_type == SO_TIMESTAMPING) {
    scm_timestamping stamps;
    constexpr std::size_t raw_hardware = 2;
    std::memcpy(&stamps, CMSG_DATA(&control), sizeof stamps);
    const auto at = time_of(stamps.ts[raw_hardware]);
    if (at.count() != 0) by_controller = at;
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

/// Asks for the controller's stamps. A kernel or a controller without them gives none.
void ask_for_controller_stamps(int socket) {
  constexpr int flags = SOF_TIMESTAMPING_RX_HARDWARE | SOF_TIMESTAMPING_RAW_HARDWARE;
  ::setsockopt(socket, SOL_SOCKET, SO_TIMESTAMPING, &flags, sizeof flags);
}

/// Kernel memory that a queued frame takes: 768 bytes on x86-64, CAN FD the same (Linux 6.1).
constexpr unsigned queued_frame_size = 1024;
/// The shortest frame: standard, no data, with intermission and without stuff bits (ISO 11898-1).
constexpr unsigned shortest_frame_bits = 47;

unsigned buffer_for(unsigned bit_rate) {
  return bit_rate / shortest_frame_bits * queued_frame_size;
}

/// Makes the queue hold one second of a full bus, as far as this process may. Returns its size in
/// bytes. The kernel doubles what it is told (socket(7)).
unsigned size_queue(int socket, unsigned bit_rate) {
  const int half = static_cast<int>(buffer_for(bit_rate) / 2);
  if (::setsockopt(socket, SOL_SOCKET, SO_RCVBUFFORCE, &half, sizeof half) != 0)
    ::setsockopt(socket, SOL_SOCKET, SO_RCVBUF, &half, sizeof half);
  unsigned given = 0;
  socklen_t size = sizeof given;
  ::getsockopt(socket, SOL_SOCKET, SO_RCVBUF, &given, &size);
  return given;
}

/// Says how to get a queue that holds a second. Empty if it does.
std::string queue_note(unsigned given, unsigned bit_rate) {
  const unsigned wanted = buffer_for(bit_rate);
  if (given >= wanted / 2 * 2) return {};
  return "; the queue holds " + std::to_string(given * 1000ULL / wanted) +
         " ms of a full bus: sudo sysctl -w net.core.rmem_max=" + std::to_string(wanted / 2);
}

OpenError no_socket(int error) {
  if (error == EAFNOSUPPORT || error == EPROTONOSUPPORT)
    return {system_error(error),
            "this kernel has no SocketCAN (modules can, can-raw); can:auto and slcan: do without"};
  return open_error(error, "cannot open a CAN socket");
}

std::string how_to_bring_up(const std::string& name, const Uri& uri, bool is_vcan) {
  return name + " is down: " +
         (is_vcan ? command_to_set_up_virtual(name) : command_to_set_up(name, *uri.bitrate()));
}

OpenError no_fd(const std::string& name, const Uri& uri, const CanInterface& found) {
  constexpr unsigned usual_data_rate = 2'000'000;
  const std::string how = found.is_vcan
                              ? "sudo ip link set " + name + " down; sudo ip link set " + name +
                                    " mtu " + std::to_string(CANFD_MTU) + " up"
                              : command_to_set_up_fd(name, *uri.bitrate(),
                                                     uri.data_bitrate().value_or(usual_data_rate));
  return {system_error(EINVAL), name + " carries no CAN FD (its mtu is " +
                                    std::to_string(found.mtu) + "): " + how +
                                    ", or leave out fd=1"};
}

/// What `listen=1` means on this interface.
std::string listening_note(const std::string& name, const CanInterface& found) {
  if (!found.listen_only) return "nothing is sent";
  if (*found.listen_only) return "nothing is sent: " + name + " is listen-only";
  return "nothing is sent, but " + name + " acknowledges: " + command_to_listen_only(name);
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
  if (uri.flag("fd") && found->mtu < CANFD_MTU) return no_fd(name, uri, *found);
  if (!set_options(socket.get(), uri)) return open_error(errno, "cannot set up " + name);
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = found->index;
  if (::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
    return open_error(errno, "cannot use " + name);
  ask_for_controller_stamps(socket.get());
  const unsigned bit_rate = found->bitrate.value_or(*uri.bitrate());
  std::string note = queue_note(size_queue(socket.get(), bit_rate), bit_rate);
  if (found->is_vcan) note.clear();
  if (uri.only_listens()) note += "; " + listening_note(name, *found);
  return std::make_unique<SocketCan>(executor, std::move(socket),
                                     uri.emulated() ? Provenance::emulated : Provenance::real,
                                     found->bitrate, note);
}

}  // namespace drydock::link
