#pragma once

#include <boost/circular_buffer.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "drivers/io/signal.hpp"
#include "drivers/link/opening.hpp"

namespace drydock::link {

/// A CAN bus inside this process: each member hears all others, but not itself. A member that does
/// not read loses the newest frames and counts them. Members may be on different threads.
class FrameHub : public std::enable_shared_from_this<FrameHub> {
 public:
  class Member {
   public:
    /// The oldest waiting frame, or the end of the bus or of this member as an error. Empty if
    /// nothing waits.
    std::optional<boost::system::result<ReceivedFrame>> take();
    void send(const wire::CanFrame& frame, Stamp at);
    void leave();
    bool has_left() const;
    std::uint64_t dropped() const;
    const std::shared_ptr<io::Signal>& changed() const { return changed_; }

   private:
    friend class FrameHub;
    Member(std::shared_ptr<FrameHub> hub, const asio::any_io_executor& executor);

    std::shared_ptr<FrameHub> hub_;
    std::shared_ptr<io::Signal> changed_;
    boost::circular_buffer<ReceivedFrame> inbox_;
    std::uint64_t dropped_ = 0;
    bool left_ = false;
  };

  std::shared_ptr<Member> join(const asio::any_io_executor& executor);

 private:
  mutable std::mutex mutex_;  ///< protects the list and the state of every member
  std::vector<std::weak_ptr<Member>> members_;
};

/// A member of a hub as a link. The link holds `keep_alive` (ports of the bus) until it is closed.
std::unique_ptr<FrameLink> make_hub_link(std::shared_ptr<FrameHub::Member> member,
                                         std::shared_ptr<void> keep_alive);

/// `memory-can:NAME`: everybody who opens this name in the process is on one bus.
OpenedFrames open_memory_can(const asio::any_io_executor& executor, const Uri& uri);

}  // namespace drydock::link
