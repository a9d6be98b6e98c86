#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "drivers/io/signal.hpp"
#include "drivers/live/foxglove/services.hpp"

namespace drydock::live {

class Viewer;

/// The functions that serve a viewer's requests.
struct Desk {
  std::function<bool(std::uint32_t channel)> has;
  std::function<void(const ServiceCall&, const std::shared_ptr<Viewer>&)> call;
};

/// One client of the protocol. Data that it does not read in time are dropped, the oldest first.
class Viewer : public std::enable_shared_from_this<Viewer> {
 public:
  using Body = std::shared_ptr<const std::vector<std::uint8_t>>;
  static constexpr std::size_t most_queued = 512, most_queued_bytes = 4u << 20;
  static constexpr std::size_t most_texts = 512;

  /// A client that is silent for half of `silence` gets a ping; after all of it, it has gone.
  Viewer(boost::beast::tcp_stream stream, std::chrono::milliseconds silence);

  /// Ends when the client has gone. The texts of `greeting` are sent first.
  boost::asio::awaitable<void> run(
      boost::beast::http::request<boost::beast::http::string_body> request,
      std::vector<std::string> greeting, Desk desk);

  /// Control messages are never dropped. A client with too many unread ones is disconnected.
  void tell(const std::string& text) { queue(Kind::text, text); }
  void answer(const std::string& message) { queue(Kind::answer, message); }  ///< sent as binary
  bool wants(std::uint32_t channel) const { return subscriptions_.contains(channel); }
  void publish(std::uint32_t channel, std::uint64_t time_ns, const Body& body);
  void close();

  /// True if it seems to read nothing: it has said nothing since it came, or has answered no ping
  /// for long, or the data that wait for it overflow. Where there is no room, it gives way.
  bool takes_nothing() const;

  std::uint64_t sent() const { return sent_; }
  std::uint64_t dropped() const { return dropped_; }

 private:
  enum class Kind : std::uint8_t { text, answer, data };
  struct Item {
    Kind kind = Kind::data;
    DataHead head{};  ///< for data
    Body body;
  };
  boost::asio::awaitable<void> write_all();
  boost::asio::awaitable<void> read_all(Desk desk);
  void obey(const Request& request, const Desk& desk);
  void obey(const std::variant<ServiceCall, Refused>& call, const Desk& desk);
  void queue(Kind kind, const std::string& message);
  void make_room(std::size_t size);

  boost::beast::websocket::stream<boost::beast::tcp_stream> socket_;
  std::shared_ptr<io::Signal> queued_;
  std::deque<Item> queue_;
  std::size_t queued_bytes_ = 0;
  std::map<std::uint32_t, std::uint32_t> subscriptions_;  ///< channel -> the client's number
  std::uint64_t sent_ = 0, dropped_ = 0, told_dropped_ = 0;
  bool open_ = false;
  std::chrono::milliseconds silence_;
  std::optional<std::chrono::steady_clock::time_point> heard_at_;  ///< a message, or a pong
};

}  // namespace drydock::live
