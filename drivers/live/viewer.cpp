#include "drivers/live/viewer.hpp"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <optional>

#include "drivers/io/as_outcome.hpp"

namespace drydock::live {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using io::as_outcome;

constexpr std::size_t longest_request = 64 * 1024;

/// The first of the server's subprotocols that the client offers. Empty if there is none.
std::string_view chosen_subprotocol(std::string_view offered) {
  for (const auto ours : subprotocols)
    if (offered.find(ours) != std::string_view::npos) return ours;
  return {};
}

}  // namespace

Viewer::Viewer(beast::tcp_stream stream, std::chrono::milliseconds silence)
    : socket_(std::move(stream)),
      queued_(std::make_shared<io::Signal>(socket_.get_executor())),
      silence_(silence) {
  auto limits = websocket::stream_base::timeout::suggested(beast::role_type::server);
  limits.idle_timeout = silence;
  socket_.set_option(limits);
  socket_.control_callback([this](websocket::frame_type, beast::string_view) {
    heard_at_ = std::chrono::steady_clock::now();
  });
}

asio::awaitable<void> Viewer::run(beast::http::request<beast::http::string_body> request,
                                  std::vector<std::string> greeting, Desk desk) {
  beast::get_lowest_layer(socket_).expires_never();  // the WebSocket has its own time-outs
  socket_.read_message_max(longest_request);
  const std::string chosen(chosen_subprotocol(request[beast::http::field::sec_websocket_protocol]));
  socket_.set_option(
      websocket::stream_base::decorator([chosen](websocket::response_type& response) {
        if (!chosen.empty()) response.set(beast::http::field::sec_websocket_protocol, chosen);
      }));
  const auto [error] = co_await socket_.async_accept(request, as_outcome);
  if (error) co_return;
  open_ = true;
  for (const auto& text : greeting) tell(text);
  asio::co_spawn(
      socket_.get_executor(),
      [self = shared_from_this()]() -> asio::awaitable<void> { co_await self->write_all(); },
      asio::detached);
  co_await read_all(std::move(desk));
  open_ = false;
  queued_->notify();
}

asio::awaitable<void> Viewer::read_all(Desk desk) {
  beast::flat_buffer buffer;
  for (;;) {
    const auto [error, size] = co_await socket_.async_read(buffer, as_outcome);
    if (error) co_return;
    heard_at_ = std::chrono::steady_clock::now();
    const std::string message = beast::buffers_to_string(buffer.data());
    if (socket_.got_text())
      obey(parse_request(message), desk);
    else
      obey(parse_call(message), desk);
    buffer.consume(size);
  }
}

void Viewer::obey(const Request& request, const Desk& desk) {
  if (const auto* subscribe = std::get_if<Subscribe>(&request)) {
    std::optional<std::uint32_t> missing;
    for (const auto& [id, channel] : subscribe->subscriptions) {
      if (desk.has(channel))
        subscriptions_[channel] = id;
      else
        missing = channel;
    }
    if (missing) tell(status(2, "there is no channel " + std::to_string(*missing)));
  } else if (const auto* unsubscribe = std::get_if<Unsubscribe>(&request)) {
    for (const auto id : unsubscribe->ids)
      std::erase_if(subscriptions_, [id](const auto& entry) { return entry.second == id; });
  } else {
    tell(status(2, std::get<Refused>(request).why));
  }
}

void Viewer::obey(const std::variant<ServiceCall, Refused>& call, const Desk& desk) {
  if (const auto* refused = std::get_if<Refused>(&call))
    tell(status(2, refused->why));
  else
    desk.call(std::get<ServiceCall>(call), shared_from_this());
}

void Viewer::queue(Kind kind, const std::string& message) {
  if (!open_) return;
  if (queue_.size() >= most_queued + most_texts || queued_bytes_ > 2 * most_queued_bytes) {
    close();  // the client sends requests but reads no answers
    return;
  }
  queue_.push_back(
      {kind, {}, std::make_shared<std::vector<std::uint8_t>>(message.begin(), message.end())});
  queued_bytes_ += message.size();
  queued_->notify();
}

void Viewer::publish(std::uint32_t channel, std::uint64_t time_ns, const Body& body) {
  const auto subscription = subscriptions_.find(channel);
  if (!open_ || subscription == subscriptions_.end()) return;
  make_room(body->size());
  queue_.push_back({Kind::data, data_head(subscription->second, time_ns), body});
  queued_bytes_ += body->size();
  queued_->notify();
}

void Viewer::make_room(std::size_t size) {
  for (auto item = queue_.begin();
       item != queue_.end() &&
       (queue_.size() >= most_queued || queued_bytes_ + size > most_queued_bytes);) {
    if (item->kind != Kind::data) {
      ++item;
      continue;
    }
    queued_bytes_ -= item->body->size();
    item = queue_.erase(item);
    ++dropped_;
  }
}

asio::awaitable<void> Viewer::write_all() {
  while (open_) {
    if (queue_.empty()) {
      if (dropped_ > told_dropped_) {
        tell(status(1, std::to_string(dropped_ - told_dropped_) +
                           " messages were dropped: this viewer does not keep up"));
        told_dropped_ = dropped_;
        continue;
      }
      co_await queued_->wait();
      continue;
    }
    const Item item = std::move(queue_.front());
    queue_.pop_front();
    queued_bytes_ -= item.body->size();
    socket_.text(item.kind == Kind::text);
    const std::array<asio::const_buffer, 2> parts{
        asio::buffer(item.head.data(), item.kind == Kind::data ? item.head.size() : 0),
        asio::buffer(*item.body)};
    const auto [error, size] = co_await socket_.async_write(parts, as_outcome);
    if (error) break;
    if (item.kind == Kind::data) ++sent_;
  }
  close();
}

/// A ping goes out after half of the silence, so nothing after three quarters means no pong.
bool Viewer::takes_nothing() const {
  if (!open_) return false;  // it comes, or has gone
  return !heard_at_ || dropped_ > told_dropped_ ||
         std::chrono::steady_clock::now() - *heard_at_ > silence_ * 3 / 4;
}

void Viewer::close() {
  open_ = false;
  queued_->notify();
  beast::get_lowest_layer(socket_).close();
}

}  // namespace drydock::live
