#include "drivers/link/net/udp.hpp"

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/udp.hpp>
#include <cstring>
#include <vector>

#include "drivers/link/net/endpoint.hpp"
#include "drivers/link/net/first_use.hpp"

namespace drydock::link {
namespace {

using asio::ip::udp;

constexpr std::size_t longest_datagram = 65'535;

/// Connects the socket, so that the kernel reports when nobody is there.
boost::system::error_code aim(udp::socket& socket, const udp::endpoint& endpoint) {
  boost::system::error_code error;
  if (socket.is_open()) socket.close(error);
  socket.open(endpoint.protocol(), error);
  if (!error) socket.connect(endpoint, error);
  if (!error) socket.send(asio::const_buffer{}, 0, error);
  return error;
}

class UdpLink final : public ByteLink {
 public:
  /// The end that binds: `socket` is bound, and the other end has still to say where it is.
  UdpLink(udp::socket socket, Side side, Provenance provenance)
      : socket_(std::move(socket)),
        host_(socket_.get_executor(), {}),
        found_(socket_.get_executor(), nothing_to_find),
        side_(side),
        provenance_(provenance),
        datagram_(longest_datagram) {}
  /// The end that sends to this address. It finds the host at its first read or write.
  UdpLink(const asio::any_io_executor& executor, const HostAndPort& to, Side side,
          Provenance provenance)
      : socket_(executor),
        host_(executor, to.host),
        port_(to.port),
        found_(executor, [this] { return find(); }),
        side_(side),
        provenance_(provenance),
        datagram_(longest_datagram) {}

  Task<ReceivedBytes> read(std::span<std::uint8_t> into) override;
  Task<void> write(std::span<const std::uint8_t> bytes) override;

  void say_last(std::span<const std::uint8_t> bytes) override {
    boost::system::error_code nobody;
    if (peer_ && socket_.is_open())
      socket_.send_to(asio::buffer(bytes.data(), bytes.size()), *peer_, 0, nobody);
  }

  void close() override {
    found_.close();
    host_.stop();
    boost::system::error_code already_gone;
    socket_.close(already_gone);
  }

  Provenance provenance() const override { return provenance_; }

 private:
  static asio::awaitable<ErrorCode> nothing_to_find() { co_return ErrorCode{}; }
  asio::awaitable<ErrorCode> find();

  /// The network reports that nobody listens there: news for a driver, but not for a device.
  bool is_absence(const boost::system::error_code& error) const {
    return side_ == Side::device && error == asio::error::connection_refused;
  }

  udp::socket socket_;
  Host host_;
  std::uint16_t port_ = 0;
  FirstUse found_;
  std::optional<udp::endpoint> peer_;  ///< empty until the other end is known
  Side side_;
  Provenance provenance_;
  std::vector<std::uint8_t> datagram_;
  std::size_t begin_ = 0, end_ = 0;  ///< received bytes that read() has not yet returned
  Stamp received_at_{};
};

/// Takes the first address of the host that can be sent to.
asio::awaitable<ErrorCode> UdpLink::find() {
  const auto addresses = co_await host_.addresses();
  if (!addresses) co_return addresses.error();
  ErrorCode error;
  for (const auto& address : *addresses) {
    const udp::endpoint endpoint(address, port_);
    error = aim(socket_, endpoint);
    if (error) continue;
    peer_ = endpoint;
    break;
  }
  co_return error;
}

Task<ReceivedBytes> UdpLink::read(std::span<std::uint8_t> into) {
  if (const auto ready = co_await found_.done(); !ready) co_return ready.error();
  while (begin_ == end_) {
    udp::endpoint sender;
    const auto [error, size] =
        co_await socket_.async_receive_from(asio::buffer(datagram_), sender, as_outcome);
    if (error && is_absence(error)) continue;
    if (error) co_return error;
    peer_ = sender;
    begin_ = 0;
    end_ = size;
    received_at_ = now();
  }
  const std::size_t size = std::min(into.size(), end_ - begin_);
  std::memcpy(into.data(), datagram_.data() + begin_, size);
  begin_ += size;
  co_return ReceivedBytes{size, received_at_};
}

Task<void> UdpLink::write(std::span<const std::uint8_t> bytes) {
  if (const auto ready = co_await found_.done(); !ready) co_return ready.error();
  if (peer_) {
    const auto [error, size] = co_await socket_.async_send_to(
        asio::buffer(bytes.data(), bytes.size()), *peer_, as_outcome);
    if (error && !is_absence(error)) co_return error;
  }
  co_return boost::system::result<void>{};
}

}  // namespace

OpenedBytes open_udp(const asio::any_io_executor& executor, const Uri& uri, Side side) {
  const bool emulated = uri.emulated() || side == Side::device;
  const auto provenance = emulated ? Provenance::emulated : Provenance::real;
  const bool binds = (side == Side::driver) == uri.flag("listen");
  if (!binds)
    return std::make_unique<UdpLink>(executor, host_and_port(uri.target), side, provenance);
  const auto endpoint = own_endpoint<udp>(uri);
  if (!endpoint) return endpoint.error();
  udp::socket socket(executor);
  boost::system::error_code error;
  socket.open(endpoint->protocol(), error);
  if (!error) socket.bind(*endpoint, error);
  if (error) return OpenError{error, "cannot listen on " + uri.target + ": " + error.message()};
  return std::make_unique<UdpLink>(std::move(socket), side, provenance);
}

}  // namespace drydock::link
