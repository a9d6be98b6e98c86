#include <algorithm>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/container/static_vector.hpp>
#include <charconv>
#include <chrono>

#include "drivers/link/net/endpoint.hpp"
#include "drivers/link/net/tcp.hpp"
#include "drivers/link/net/tcp_guest.hpp"

namespace drydock::link {
namespace {

using asio::ip::tcp;

constexpr auto accept_pause = std::chrono::milliseconds{100};
constexpr std::size_t most_guests = 16;
constexpr std::uint64_t everyone = 0;  ///< instead of the number of a guest

using Guests = boost::container::static_vector<std::shared_ptr<TcpGuest>, most_guests>;

/// The coroutine that accepts clients shares this state.
struct Server {
  Server(const asio::any_io_executor& executor, tcp::acceptor listening, std::size_t room)
      : acceptor(std::move(listening)),
        seats(room),
        changed(std::make_shared<io::Signal>(executor)) {}

  void let_in(tcp::socket client);
  void let_go(std::size_t i);
  void forget_those_who_left();
  std::uint64_t dropped_in_all() const;
  Guests chosen(std::uint64_t to) const;  ///< one by its number, or everyone

  tcp::acceptor acceptor;
  std::size_t seats;
  std::shared_ptr<io::Signal> changed;
  Guests guests;              ///< the oldest first
  std::uint64_t dropped = 0;  ///< bytes that guests of the past never heard
  std::uint64_t come = 0;     ///< guests so far
};

/// The newest client is served: an older one may be a program that hangs, or a host that is gone.
void Server::let_in(tcp::socket client) {
  forget_those_who_left();
  if (guests.size() == seats) let_go(0);
  const auto guest = std::make_shared<TcpGuest>(std::move(client), changed, ++come);
  guests.push_back(guest);
  const auto serve = [&](auto task) {
    asio::co_spawn(
        acceptor.get_executor(), [guest, task] { return (guest.get()->*task)(); }, asio::detached);
  };
  serve(&TcpGuest::listen);
  serve(&TcpGuest::deliver);
  changed->notify();
}

void Server::let_go(std::size_t i) {
  guests[i]->leave();
  dropped += guests[i]->dropped();
  guests.erase(guests.begin() + static_cast<std::ptrdiff_t>(i));
}

void Server::forget_those_who_left() {
  for (std::size_t i = guests.size(); i-- > 0;)
    if (!guests[i]->is_here()) let_go(i);
}

std::uint64_t Server::dropped_in_all() const {
  std::uint64_t all = dropped;
  for (const auto& guest : guests) all += guest->dropped();
  return all;
}

Guests Server::chosen(std::uint64_t to) const {
  Guests some;
  for (const auto& guest : guests)
    if (to == everyone || guest->number() == to) some.push_back(guest);
  return some;
}

asio::awaitable<void> accept_clients(std::shared_ptr<Server> server) {
  while (server->acceptor.is_open()) {
    auto [error, client] = co_await server->acceptor.async_accept(as_outcome);
    if (error == asio::error::operation_aborted || !server->acceptor.is_open()) co_return;
    if (error) {  // the client left too early, or no descriptor is free now
      asio::steady_timer pause(server->acceptor.get_executor(), accept_pause);
      co_await pause.async_wait(as_outcome);
      continue;
    }
    server->let_in(std::move(client));
  }
}

class TcpServer final : public ByteLink {
 public:
  explicit TcpServer(std::shared_ptr<Server> server) : server_(std::move(server)) {}
  ~TcpServer() override { close(); }

  Task<ReceivedBytes> read(std::span<std::uint8_t> into) override;
  Task<void> write(std::span<const std::uint8_t> bytes) override { return give(everyone, bytes); }
  Task<void> write_to(std::uint64_t guest, std::span<const std::uint8_t> bytes) override {
    return give(guest, bytes);
  }
  std::uint64_t speaker() const override { return speaker_; }

  void close() override {
    boost::system::error_code already_gone;
    server_->acceptor.close(already_gone);
    for (const auto& guest : server_->guests) guest->finish();
    server_->changed->notify();
  }

  Provenance provenance() const override { return Provenance::emulated; }
  std::uint64_t dropped() const override { return server_->dropped_in_all(); }

 private:
  Task<void> give(std::uint64_t to, std::span<const std::uint8_t> bytes);

  std::shared_ptr<Server> server_;
  std::uint64_t speaker_ = 0;
};

Task<ReceivedBytes> TcpServer::read(std::span<std::uint8_t> into) {
  const auto server = server_;
  while (server->acceptor.is_open()) {
    server->forget_those_who_left();
    for (const auto& guest : server->guests) {
      const auto said = guest->said();
      if (said.empty()) continue;
      const std::size_t size = std::min(said.size(), into.size());
      std::copy_n(said.begin(), size, into.begin());
      guest->take(size);
      speaker_ = guest->number();
      co_return ReceivedBytes{size, guest->said_at()};
    }
    co_await server->changed->wait();
  }
  co_return ErrorCode(asio::error::operation_aborted);
}

/// They get what there is room for at once; then it waits for those who read more slowly.
Task<void> TcpServer::give(std::uint64_t to, std::span<const std::uint8_t> bytes) {
  const auto server = server_;
  server->forget_those_who_left();
  const Guests guests = server->chosen(to);
  std::array<std::size_t, most_guests> given{};
  if (to != everyone && guests.empty()) server->dropped += bytes.size();
  for (bool wait = true; wait && server->acceptor.is_open();) {
    wait = false;
    for (std::size_t i = 0; i < guests.size(); ++i) {
      if (guests[i]->is_here()) given[i] += guests[i]->give(bytes.subspan(given[i]));
      wait = wait || (guests[i]->is_here() && given[i] < bytes.size());
    }
    if (wait) co_await server->changed->wait();
  }
  for (std::size_t i = 0; i < guests.size(); ++i)
    if (given[i] < bytes.size()) server->dropped += bytes.size() - given[i];
  if (!server->acceptor.is_open()) co_return ErrorCode(asio::error::operation_aborted);
  co_return boost::system::result<void>{};
}

std::size_t seats_of(const Uri& uri) {
  std::size_t seats = 1;
  const auto text = uri.text_of("clients");
  std::from_chars(text.data(), text.data() + text.size(), seats);
  return seats;
}

}  // namespace

OpenedBytes open_tcp_server(const asio::any_io_executor& executor, const Uri& uri) {
  const auto endpoint = own_endpoint<tcp>(uri);
  if (!endpoint) return endpoint.error();
  tcp::acceptor acceptor(executor);
  boost::system::error_code error;
  acceptor.open(endpoint->protocol(), error);
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(*endpoint, error);
  if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
  if (error) return OpenError{error, "cannot listen on " + uri.target + ": " + error.message()};
  auto server = std::make_shared<Server>(executor, std::move(acceptor), seats_of(uri));
  asio::co_spawn(executor, accept_clients(server), asio::detached);
  return std::make_unique<TcpServer>(std::move(server));
}

}  // namespace drydock::link
