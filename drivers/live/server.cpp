#include "drivers/live/server.hpp"

#include <algorithm>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/http.hpp>
#include <chrono>
#include <list>
#include <optional>
#include <utility>

#include "drivers/io/as_outcome.hpp"
#include "drivers/live/foxglove/access.hpp"
#include "drivers/live/page_answer.hpp"
#include "drivers/live/viewer.hpp"

namespace drydock::live {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;
using io::as_outcome;

constexpr std::chrono::milliseconds accept_pause{100};
constexpr std::size_t most_clients = 64;

}  // namespace

/// State that the coroutines of all clients share.
struct Server::House : std::enable_shared_from_this<House> {
  House(asio::any_io_executor on, ServerOptions with, std::vector<PageFile> files)
      : executor(std::move(on)),
        options(std::move(with)),
        page(std::move(files)),
        door(executor),
        history(options.history) {}

  boost::system::error_code open();
  asio::awaitable<void> let_in();
  asio::awaitable<void> serve(tcp::socket socket);
  asio::awaitable<std::optional<HttpRequest>> request_on(beast::tcp_stream& stream,
                                                         beast::flat_buffer& buffer);
  bool make_room();
  asio::awaitable<void> show(beast::tcp_stream stream, HttpRequest request);
  std::optional<std::string> refusal_of(const HttpRequest& request);
  void call(const ServiceCall& call, const std::shared_ptr<Viewer>& viewer) const;
  void remove(const std::shared_ptr<Viewer>& viewer);

  asio::any_io_executor executor;
  ServerOptions options;
  std::vector<PageFile> page;
  tcp::acceptor door;
  std::vector<Channel> channels;
  std::vector<Keep> keep;  ///< of each channel
  History history;
  std::vector<Service> services;
  std::vector<std::shared_ptr<Viewer>> viewers;
  std::size_t clients = 0;
  std::list<beast::tcp_stream*> unserved;  ///< amid a request or its answer, the oldest first
  ServerCounters past;                     ///< counts of viewers that have left
};

boost::system::error_code Server::House::open() {
  boost::system::error_code error;
  const bool local = is_loopback(options.address);
  if (!local && options.token.empty())
    return boost::system::errc::make_error_code(boost::system::errc::permission_denied);
  const auto address =
      asio::ip::make_address(options.address == "localhost" ? "127.0.0.1" : options.address, error);
  if (error) return error;
  const tcp::endpoint endpoint(address, options.port);
  door.open(endpoint.protocol(), error);
  if (!error) door.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) door.bind(endpoint, error);
  if (!error) door.listen(tcp::acceptor::max_listen_connections, error);
  return error;
}

asio::awaitable<void> Server::House::let_in() {
  const auto self = shared_from_this();
  while (door.is_open()) {
    auto [error, socket] = co_await door.async_accept(as_outcome);
    if (error == asio::error::operation_aborted || !door.is_open()) co_return;
    if (error || !make_room()) {  // closes the client at once if all others are viewers that read
      asio::steady_timer pause(executor, accept_pause);
      co_await pause.async_wait(as_outcome);
      continue;
    }
    asio::co_spawn(executor, serve(std::move(socket)), asio::detached);
  }
}

asio::awaitable<void> Server::House::serve(tcp::socket socket) {
  const auto self = shared_from_this();
  struct Count {
    std::size_t& clients;
    explicit Count(std::size_t& of) : clients(of) { ++clients; }
    ~Count() { --clients; }
  } const count(clients);
  boost::system::error_code ignored;
  socket.set_option(tcp::no_delay(true), ignored);
  beast::tcp_stream stream(std::move(socket));
  beast::flat_buffer buffer;
  for (bool more = true; more;) {
    auto request = co_await request_on(stream, buffer);
    if (!request) co_return;
    const auto refused = refusal_of(*request);
    if (!refused && beast::websocket::is_upgrade(*request)) {
      co_await show(std::move(stream), std::move(*request));
      co_return;
    }
    HttpResponse response =
        refused ? answer(*request, http::status::forbidden, "text/plain", *refused + "\n")
                : answer_to(*request, page, history);
    more = response.keep_alive();
    const auto place = unserved.insert(unserved.end(), &stream);
    const auto [write_error, written] = co_await http::async_write(stream, response, as_outcome);
    unserved.erase(place);
    if (write_error) co_return;
  }
}

/// The time is for the whole request: a byte now and then does not prolong it.
asio::awaitable<std::optional<HttpRequest>> Server::House::request_on(beast::tcp_stream& stream,
                                                                      beast::flat_buffer& buffer) {
  HttpRequest request;
  stream.expires_after(options.patience);
  const auto place = unserved.insert(unserved.end(), &stream);
  const auto [error, size] = co_await http::async_read(stream, buffer, request, as_outcome);
  unserved.erase(place);
  if (error) co_return std::nullopt;
  co_return request;
}

/// A client that has asked for nothing yet, or does not take its answer, gives way to one that may;
/// so does a viewer that takes nothing.
bool Server::House::make_room() {
  if (clients < most_clients) return true;
  if (unserved.empty()) {
    const auto idle = std::ranges::find_if(viewers, &Viewer::takes_nothing);
    if (idle == viewers.end()) return false;
    (*idle)->close();
    return true;
  }
  auto* const oldest = unserved.front();
  unserved.splice(unserved.end(), unserved, unserved.begin());
  oldest->close();
  return true;
}

std::optional<std::string> Server::House::refusal_of(const HttpRequest& request) {
  const std::string target = text_of(request.target()), host = text_of(request[http::field::host]),
                    origin = text_of(request[http::field::origin]);
  if (!options.token.empty() && is_part_of(page, request)) return {};
  auto refused = refusal({target, host, origin}, options.token);
  if (refused) ++past.refused;
  return refused;
}

asio::awaitable<void> Server::House::show(beast::tcp_stream stream, HttpRequest request) {
  const auto viewer = std::make_shared<Viewer>(std::move(stream), options.silence);
  viewers.push_back(viewer);
  const bool obeys = !services.empty();
  std::vector<std::string> greeting{server_info(options.name, std::to_string(options.port), obeys),
                                    advertise(channels)};
  if (obeys) greeting.push_back(advertise_services(services));
  Desk desk{
      [this](std::uint32_t channel) { return channel >= 1 && channel <= channels.size(); },
      [this](const ServiceCall& asked, const std::shared_ptr<Viewer>& by) { call(asked, by); }};
  co_await viewer->run(std::move(request), std::move(greeting), std::move(desk));
  remove(viewer);
}

void Server::House::call(const ServiceCall& call, const std::shared_ptr<Viewer>& viewer) const {
  const auto refuse = [&](const std::string& why) { viewer->tell(service_failure(call, why)); };
  if (services.empty()) return refuse("this server only shows: it has no services");
  if (call.service < 1 || call.service > services.size())
    return refuse("there is no service " + std::to_string(call.service));
  if (call.encoding != "json") return refuse("the encoding of a request is json");
  services[call.service - 1].serve(
      call.request, [key = ServiceCall{call.service, call.call, {}, {}},
                     asking = std::weak_ptr(viewer)](const ServiceAnswer& answer) {
        const auto there = asking.lock();
        if (!there) return;
        if (const auto* refused = std::get_if<Refused>(&answer))
          there->tell(service_failure(key, refused->why));
        else
          there->answer(service_response(key, std::get<std::string>(answer)));
      });
}

void Server::House::remove(const std::shared_ptr<Viewer>& viewer) {
  past.sent += viewer->sent();
  past.dropped += viewer->dropped();
  std::erase(viewers, viewer);
}

Server::Server(asio::any_io_executor executor, ServerOptions options, std::vector<PageFile> page)
    : house_(std::make_shared<House>(std::move(executor), std::move(options), std::move(page))) {}

Server::~Server() { stop(); }

boost::system::error_code Server::listen() {
  if (const auto error = house_->open()) return error;
  asio::co_spawn(house_->executor, house_->let_in(), asio::detached);
  return {};
}

std::uint16_t Server::port() const {
  boost::system::error_code error;
  return house_->door.local_endpoint(error).port();
}

std::uint32_t Server::add_channel(Channel channel, Keep keep) {
  channel.id = static_cast<std::uint32_t>(house_->channels.size() + 1);
  house_->channels.push_back(std::move(channel));
  house_->keep.push_back(keep);
  const auto text = advertise(std::span(house_->channels).last(1));
  for (const auto& viewer : house_->viewers) viewer->tell(text);
  return house_->channels.back().id;
}

void Server::add_service(Service service) { house_->services.push_back(std::move(service)); }

bool Server::wanted(std::uint32_t channel) const {
  return house_->history.keeps() || std::ranges::any_of(house_->viewers, [&](const auto& viewer) {
           return viewer->wants(channel);
         });
}

void Server::publish(std::uint32_t channel, measurement::Stamp at,
                     std::span<const std::uint8_t> data) {
  if (!wanted(channel)) return;
  const auto body = std::make_shared<std::vector<std::uint8_t>>(data.begin(), data.end());
  house_->history.add(channel, house_->keep.at(channel - 1), at, body);
  const auto time = static_cast<std::uint64_t>(at.time_since_epoch().count());
  for (const auto& viewer : house_->viewers) viewer->publish(channel, time, body);
}

ServerCounters Server::counters() const {
  ServerCounters counters = house_->past;
  counters.viewers = house_->viewers.size();
  for (const auto& viewer : house_->viewers) {
    counters.sent += viewer->sent();
    counters.dropped += viewer->dropped();
  }
  return counters;
}

void Server::stop() {
  boost::system::error_code ignored;
  house_->door.close(ignored);
  for (const auto& viewer : house_->viewers) viewer->close();
}

}  // namespace drydock::live
