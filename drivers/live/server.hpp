#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/system/error_code.hpp>
#include <memory>
#include <string>
#include <vector>

#include "drivers/live/foxglove/services.hpp"
#include "drivers/measurement/stamp.hpp"

namespace drydock::live {

/// Who may look. On a loopback address everyone of this host who is no foreign web page; on any
/// other only who knows the token.
struct ServerOptions {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8765;  ///< 0: any that is free
  std::string token = {};     ///< `?token=...` of every request; empty: none is needed
  std::string name = "drydock";
};

/// One file of the page.
struct PageFile {
  std::string_view path, media_type, content;
};

struct ServerCounters {
  std::uint64_t viewers = 0;  ///< now
  std::uint64_t sent = 0;     ///< data messages, over all viewers
  std::uint64_t dropped = 0;  ///< for viewers that did not keep up
  std::uint64_t refused = 0;  ///< requests without the right to be here
};

/// One port: the page by HTTP, data by the Foxglove WebSocket protocol. Runs on its executor, which
/// must be one thread; publish() never waits for a viewer.
class Server {
 public:
  Server(boost::asio::any_io_executor executor, ServerOptions options,
         std::vector<PageFile> page = {});
  ~Server();

  /// Fails when the address is none or the port is taken; on any but a loopback address also
  /// without a token (errc::permission_denied).
  boost::system::error_code listen();
  std::uint16_t port() const;  ///< after listen()

  /// Gives the channel its id and tells the viewers that are there.
  std::uint32_t add_channel(Channel channel);
  /// Someone is subscribed: without, there is no need to encode.
  bool wanted(std::uint32_t channel) const;
  void publish(std::uint32_t channel, measurement::Stamp at, std::span<const std::uint8_t> data);

  /// Of viewers that come from now on. Without any, a viewer can change nothing.
  void add_service(Service service);

  ServerCounters counters() const;
  void stop();

 private:
  struct House;
  std::shared_ptr<House> house_;
};

}  // namespace drydock::live
