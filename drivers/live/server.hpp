#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/system/error_code.hpp>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "drivers/live/foxglove/services.hpp"
#include "drivers/live/history.hpp"
#include "drivers/measurement/stamp.hpp"

namespace drydock::live {

/// Who may look. On a loopback address: everybody on this host, except foreign web pages. On any
/// other address: only clients with the token.
struct ServerOptions {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8765;  ///< 0: any free port
  std::string token = {};     ///< `?token=...` in every request; empty: not needed
  std::string name = "drydock";
  std::chrono::milliseconds patience{10'000};  ///< for a whole request, and for its answer
  std::chrono::milliseconds silence{20'000};   ///< of a viewer that answers no ping: then it goes
  std::chrono::seconds history{0};  ///< kept for GET /history, for viewers that come later
};

/// One file of the page.
struct PageFile {
  std::string_view path, media_type, content;
};

struct ServerCounters {
  std::uint64_t viewers = 0;  ///< present number
  std::uint64_t sent = 0;     ///< data messages to all viewers
  std::uint64_t dropped = 0;  ///< for viewers that were too slow
  std::uint64_t refused = 0;  ///< requests without permission
};

/// One port: the page through HTTP, data through the Foxglove WebSocket protocol. It runs on its
/// executor, which must be one thread. publish() never waits for a viewer.
class Server {
 public:
  Server(boost::asio::any_io_executor executor, ServerOptions options,
         std::vector<PageFile> page = {});
  ~Server();

  /// Fails if the address is invalid or the port is in use. On an address other than loopback it
  /// also fails without a token (errc::permission_denied).
  boost::system::error_code listen();
  std::uint16_t port() const;  ///< after listen()

  /// Gives the channel its id and announces it to the connected viewers.
  std::uint32_t add_channel(Channel channel, Keep keep = Keep::all);
  /// True if a viewer is subscribed or a history is kept. Otherwise there is no need to encode.
  bool wanted(std::uint32_t channel) const;
  void publish(std::uint32_t channel, measurement::Stamp at, std::span<const std::uint8_t> data);

  /// For viewers that connect later. Without any service a viewer can change nothing.
  void add_service(Service service);

  ServerCounters counters() const;
  void stop();

 private:
  struct House;
  std::shared_ptr<House> house_;
};

}  // namespace drydock::live
