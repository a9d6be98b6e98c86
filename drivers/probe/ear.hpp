#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <functional>
#include <string>
#include <vector>

#include "drivers/link/link.hpp"
#include "drivers/wire/codec.hpp"

namespace drydock::probe {

/// Listens on one link after another, until Ctrl-C ends it all.
class Ear {
 public:
  Ear();

  /// Called with what came; and, every 100 ms, with nothing. True: that is enough.
  using OnBytes = std::function<bool(wire::Bytes, link::Stamp)>;
  using OnFrame = std::function<bool(const link::ReceivedFrame*)>;

  /// Until enough was heard, `until`, Ctrl-C or the link's end; closes the link.
  void listen(link::ByteLink& line, link::Stamp until, const OnBytes& on_bytes);
  void listen(link::FrameLink& bus, link::Stamp until, const OnFrame& on_frame);

  /// Puts something on the wire while it listens; what fails is left to the link.
  void say(link::ByteLink& line, std::vector<std::uint8_t> bytes);
  void say(link::FrameLink& bus, const wire::CanFrame& frame);

  boost::asio::any_io_executor executor() { return io_.get_executor(); }
  bool interrupted() const { return interrupted_; }
  const std::string& trouble() const { return trouble_; }  ///< why the last link ended; or empty

 private:
  template <class Link, class Read, class Idle>
  void run(Link& link, link::Stamp until, Read read, const Idle& idle);

  boost::asio::io_context io_{1};
  boost::asio::signal_set signals_{io_, SIGINT, SIGTERM};
  bool interrupted_ = false;
  int talking_ = 0;  ///< writes under way
  std::string trouble_;
};

}  // namespace drydock::probe
