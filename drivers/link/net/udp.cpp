#include "drivers/link/net/udp.hpp"

#include <net/if.h>

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/udp.hpp>
#include <cstring>
#include <vector>

#include "drivers/link/net/endpoint.hpp"
#include "drivers/link/net/first_use.hpp"
#include "drivers/link/net/sender_filter.hpp"
#include "drivers/link/net/udp_socket.hpp"

namespace drydock::link {
namespace {

using asio::ip::udp;

constexpr std::size_t longest_datagram = 65'535;

class UdpLink final : public ByteLink {
 public:
  /// `socket` is bound and waits for the other end to say where it is, or sends to this peer.
  UdpLink(udp::socket socket, const std::optional<udp::endpoint>& peer, SenderFilter senders,
          Side side, Provenance provenance)
      : socket_(std::move(socket)),
        host_(socket_.get_executor(), {}),
        aims_(peer.has_value()),
        found_(socket_.get_executor(), nothing_to_find),
        peer_(peer),
        senders_(std::move(senders)),
        side_(side),
        provenance_(provenance),
        datagram_(longest_datagram) {}
  /// The end that sends to a host of this name. It finds it at its first read or write.
  UdpLink(const asio::any_io_executor& executor, const HostAndPort& to, unsigned interface,
          SenderFilter senders, Side side, Provenance provenance)
      : socket_(executor),
        host_(executor, to.host),
        port_(to.port),
        interface_(interface),
        aims_(true),
        found_(executor, [this] { return find(); }),
        senders_(std::move(senders)),
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
  std::string_view note() override { return senders_.note(); }

 private:
  bool counts(const udp::endpoint& sender, std::size_t size);
  static asio::awaitable<ErrorCode> nothing_to_find() { co_return ErrorCode{}; }
  asio::awaitable<ErrorCode> find();

  /// The network reports that nobody listens there: news for a driver, but not for a device.
  bool is_absence(const boost::system::error_code& error) const {
    return side_ == Side::device && error == asio::error::connection_refused;
  }

  udp::socket socket_;
  Host host_;
  std::uint16_t port_ = 0;
  unsigned interface_ = 0;  ///< the kernel's index; 0: any
  bool aims_ = false;       ///< it sends to its address, whoever writes to it
  FirstUse found_;
  std::optional<udp::endpoint> peer_;  ///< empty until the other end is known
  SenderFilter senders_;               ///< of the driver's side
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
    error = aim_at(socket_, endpoint, interface_);
    if (error) continue;
    peer_ = endpoint;
    break;
  }
  co_return error;
}

/// A driver may send hello with an empty datagram. To a driver, an empty one says nothing.
bool UdpLink::counts(const udp::endpoint& sender, std::size_t size) {
  return side_ == Side::device || (size > 0 && senders_.takes(sender.address()));
}

Task<ReceivedBytes> UdpLink::read(std::span<std::uint8_t> into) {
  if (const auto ready = co_await found_.done(); !ready) co_return ready.error();
  while (begin_ == end_) {
    udp::endpoint sender;
    const auto [error, size] =
        co_await socket_.async_receive_from(asio::buffer(datagram_), sender, as_outcome);
    if (error && is_absence(error)) continue;
    if (error) co_return error;
    if (!counts(sender, size)) continue;
    if (!aims_) peer_ = sender;
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

OpenError cannot(const std::string& what, const Uri& uri, const ErrorCode& error) {
  std::string advice;
  if (error == system_error(ENODEV) || error == system_error(ENETUNREACH))
    advice = " (no route leads there; name the network of a group, as in interface=eth0)";
  return {error, "cannot " + what + " " + uri.target + ": " + error.message() + advice};
}

/// The kernel's index of the interface that the URI names; 0 if it names none.
boost::system::result<unsigned, OpenError> interface_of(const Uri& uri) {
  const std::string name(uri.text_of("interface"));
  if (name.empty()) return 0U;
  const auto address = address_in_numbers(host_and_port(uri.target).host);
  if (address && !address->is_multicast())
    return OpenError{
        asio::error::invalid_argument,
        "cannot use " + uri.target + " with interface=" + name +
            ": only a multicast group (224.0.0.0 to 239.255.255.255, ff00::/8) has one"};
  if (const unsigned index = ::if_nametoindex(name.c_str()); index != 0) return index;
  return OpenError{system_error(ENODEV), "cannot use " + uri.target + ": there is no interface " +
                                             name + " (ip link shows those that are there)"};
}

/// A group or a network's broadcast address has many senders by design, so there only `from` picks
/// one.
boost::system::result<SenderFilter, OpenError> senders_of(const Uri& uri,
                                                          SenderFilter::Unless unless) {
  const std::string name(uri.text_of("from"));
  if (name.empty()) return SenderFilter({}, unless);
  if (const auto address = address_in_numbers(name)) return SenderFilter(address, unless);
  return OpenError{asio::error::invalid_argument,
                   "cannot use " + uri.target + " with from=" + name +
                       ": it is no IP address in numbers, as 192.168.2.95 or fe80::1"};
}

}  // namespace

OpenedBytes open_udp(const asio::any_io_executor& executor, const Uri& uri, Side side) {
  const bool emulated = uri.emulated() || side == Side::device;
  const auto provenance = emulated ? Provenance::emulated : Provenance::real;
  const bool binds = (side == Side::driver) == uri.flag("listen");
  const auto interface = interface_of(uri);
  if (!interface) return interface.error();
  const auto to = host_and_port(uri.target);
  const auto number = address_in_numbers(to.host);
  using Unless = SenderFilter::Unless;
  const bool many = number && has_many_listeners(executor, {*number, to.port});
  const auto senders = senders_of(uri, many ? Unless::all : Unless::first_heard);
  if (!senders) return senders.error();
  if (!binds && !number)
    return std::make_unique<UdpLink>(executor, to, *interface, *senders, side, provenance);
  udp::socket socket(executor);
  if (!binds) {
    const udp::endpoint peer(*number, to.port);
    if (const auto error = aim_at(socket, peer, *interface)) return cannot("send to", uri, error);
    return std::make_unique<UdpLink>(std::move(socket), peer, *senders, side, provenance);
  }
  const auto endpoint = own_endpoint<udp>(uri);
  if (!endpoint) return endpoint.error();
  if (const auto error = listen_on(socket, *endpoint, *interface))
    return cannot("listen on", uri, error);
  return std::make_unique<UdpLink>(std::move(socket), std::nullopt, *senders, side, provenance);
}

}  // namespace drydock::link
