#include "drivers/link/net/udp.hpp"

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <cstring>
#include <vector>

#include "drivers/link/net/endpoint.hpp"

namespace drydock::link {
namespace {

using asio::ip::udp;

constexpr std::size_t longest_datagram = 65'535;

class UdpLink final : public ByteLink {
 public:
  /// `peer` is the address of the other end. It is empty until the other end has sent something.
  UdpLink(udp::socket socket, std::optional<udp::endpoint> peer, Side side, Provenance provenance)
      : socket_(std::move(socket)),
        peer_(std::move(peer)),
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
    boost::system::error_code already_gone;
    socket_.close(already_gone);
  }

  Provenance provenance() const override { return provenance_; }

 private:
  /// The network reports that nobody listens there: news for a driver, but not for a device.
  bool is_absence(const boost::system::error_code& error) const {
    return side_ == Side::device && error == asio::error::connection_refused;
  }

  udp::socket socket_;
  std::optional<udp::endpoint> peer_;
  Side side_;
  Provenance provenance_;
  std::vector<std::uint8_t> datagram_;
  std::size_t begin_ = 0, end_ = 0;  ///< received bytes that read() has not yet returned
  Stamp received_at_{};
};

Task<ReceivedBytes> UdpLink::read(std::span<std::uint8_t> into) {
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
  if (!socket_.is_open()) co_return ErrorCode(asio::error::operation_aborted);
  if (peer_) {
    const auto [error, size] = co_await socket_.async_send_to(
        asio::buffer(bytes.data(), bytes.size()), *peer_, as_outcome);
    if (error && !is_absence(error)) co_return error;
  }
  co_return boost::system::result<void>{};
}

/// Connects the socket, so that the kernel reports when nobody is there.
boost::system::error_code aim(udp::socket& socket, const udp::endpoint& endpoint) {
  boost::system::error_code error;
  socket.connect(endpoint, error);
  if (!error) socket.send(asio::const_buffer{}, 0, error);
  return error;
}

}  // namespace

OpenedBytes open_udp(const asio::any_io_executor& executor, const Uri& uri, Side side) {
  const auto endpoint = udp_endpoint(uri);
  if (!endpoint) return endpoint.error();
  const bool binds = (side == Side::driver) == uri.flag("listen");
  udp::socket socket(executor);
  boost::system::error_code error;
  socket.open(endpoint->protocol(), error);
  if (!error && binds) socket.bind(*endpoint, error);
  if (!error && !binds) error = aim(socket, *endpoint);
  if (error)
    return OpenError{error, std::string(binds ? "cannot listen on " : "cannot send to ") +
                                uri.target + ": " + error.message()};
  const bool emulated = uri.emulated() || side == Side::device;
  std::optional<udp::endpoint> peer;
  if (!binds) peer = *endpoint;
  return std::make_unique<UdpLink>(std::move(socket), peer, side,
                                   emulated ? Provenance::emulated : Provenance::real);
}

}  // namespace drydock::link
