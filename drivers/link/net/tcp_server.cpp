#include <boost/asio/buffer.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <chrono>

#include "drivers/io/signal.hpp"
#include "drivers/link/net/endpoint.hpp"
#include "drivers/link/net/tcp.hpp"

namespace drydock::link {
namespace {

using asio::ip::tcp;

constexpr auto accept_pause = std::chrono::milliseconds{100};

/// The coroutine that accepts clients shares this state.
struct Server {
  Server(const asio::any_io_executor& executor, tcp::acceptor listening)
      : acceptor(std::move(listening)),
        client(executor),
        changed(std::make_shared<io::Signal>(executor)) {}

  void drop_client() {
    boost::system::error_code already_gone;
    client.close(already_gone);
    changed->notify();
  }

  tcp::acceptor acceptor;
  tcp::socket client;  ///< open while a client is connected
  std::shared_ptr<io::Signal> changed;
};

asio::awaitable<void> accept_one_at_a_time(std::shared_ptr<Server> server) {
  while (server->acceptor.is_open()) {
    if (server->client.is_open()) {
      co_await server->changed->wait();
      continue;
    }
    auto [error, client] = co_await server->acceptor.async_accept(as_outcome);
    if (error == asio::error::operation_aborted || !server->acceptor.is_open()) co_return;
    if (error) {  // the client left too early, or no descriptor is free now
      asio::steady_timer pause(server->acceptor.get_executor(), accept_pause);
      co_await pause.async_wait(as_outcome);
      continue;
    }
    server->client = std::move(client);
    server->client.set_option(tcp::no_delay(true), error);
    server->changed->notify();
  }
}

class TcpServer final : public ByteLink {
 public:
  explicit TcpServer(std::shared_ptr<Server> server) : server_(std::move(server)) {}
  ~TcpServer() override { close(); }

  Task<ReceivedBytes> read(std::span<std::uint8_t> into) override;
  Task<void> write(std::span<const std::uint8_t> bytes) override;

  void close() override {
    boost::system::error_code already_gone;
    server_->acceptor.close(already_gone);
    server_->drop_client();
  }

  Provenance provenance() const override { return Provenance::emulated; }

 private:
  std::shared_ptr<Server> server_;
};

Task<ReceivedBytes> TcpServer::read(std::span<std::uint8_t> into) {
  const auto server = server_;
  while (server->acceptor.is_open()) {
    if (!server->client.is_open()) {
      co_await server->changed->wait();
      continue;
    }
    const auto [error, size] =
        co_await server->client.async_read_some(asio::buffer(into.data(), into.size()), as_outcome);
    if (!error) co_return ReceivedBytes{size, now()};
    if (error != asio::error::operation_aborted) server->drop_client();
  }
  co_return ErrorCode(asio::error::operation_aborted);
}

Task<void> TcpServer::write(std::span<const std::uint8_t> bytes) {
  const auto server = server_;
  if (!server->acceptor.is_open()) co_return ErrorCode(asio::error::operation_aborted);
  if (!server->client.is_open()) co_return boost::system::result<void>{};
  const auto [error, size] = co_await asio::async_write(
      server->client, asio::buffer(bytes.data(), bytes.size()), as_outcome);
  if (!server->acceptor.is_open()) co_return ErrorCode(asio::error::operation_aborted);
  if (error && error != asio::error::operation_aborted) server->drop_client();
  co_return boost::system::result<void>{};
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
  auto server = std::make_shared<Server>(executor, std::move(acceptor));
  asio::co_spawn(executor, accept_one_at_a_time(server), asio::detached);
  return std::make_unique<TcpServer>(std::move(server));
}

}  // namespace drydock::link
