#pragma once

#include <boost/asio/io_context.hpp>
#include <functional>
#include <string>
#include <vector>

#include "drivers/io/until_stopped.hpp"
#include "drivers/link/link.hpp"
#include "drivers/terminal/early_end.hpp"
#include "drivers/wire/codec.hpp"

namespace drydock::probe {

/// Listens on one link after another. Ctrl-C ends everything. All times are of link::steady_now(),
/// because they only give durations and rates.
class Ear {
 public:
  /// Called with the received data, and every 100 ms without data. True: enough was heard.
  using OnBytes = std::function<bool(wire::Bytes, link::Stamp)>;
  using OnFrame = std::function<bool(const wire::CanFrame*, link::Stamp)>;

  /// Listens until the callback has enough, until `until`, Ctrl-C or the end of the link. Then
  /// closes the link.
  void listen(link::ByteLink& line, link::Stamp until, const OnBytes& on_bytes);
  void listen(link::FrameLink& bus, link::Stamp until, const OnFrame& on_frame);

  /// Writes to the wire while it listens. It ignores a failed write; the link reports the failure.
  void say(link::ByteLink& line, std::vector<std::uint8_t> bytes);
  void say(link::FrameLink& bus, const wire::CanFrame& frame);

  boost::asio::any_io_executor executor() { return io_.get_executor(); }
  bool interrupted() const { return until_.interrupted(); }
  std::string trouble() const { return failure_ ? failure_.message() : std::string(); }
  /// Why the last link ended; no error: it was closed.
  const boost::system::error_code& failure() const { return failure_; }

 private:
  template <class Link, class OnRead, class OnIdle>
  void run(Link& link, link::Stamp until, const OnRead& on_read, const OnIdle& on_idle);
  template <class Link, class Content>
  void write(Link& link, Content content);

  boost::asio::io_context io_{1};
  io::UntilStopped until_{io_, 0, terminal::note_early_end};  ///< it would end by itself
  int talking_ = 0;                                           ///< writes in progress
  boost::system::error_code failure_;
};

}  // namespace drydock::probe
