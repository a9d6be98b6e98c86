#pragma once

#include <boost/circular_buffer.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "drivers/io/signal.hpp"

namespace drydock::link {

/// A CAN bus inside this process: each member hears all others, not itself. A member that does
/// not read loses the newest frames and counts them. Members may live on different threads.
class FrameHub : public std::enable_shared_from_this<FrameHub> {
 public:
  class Member {
   public:
    /// The oldest frame waiting, the end of the bus or of this member as an error, or nothing yet.
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
  mutable std::mutex mutex_;  ///< of the list and of every member's state
  std::vector<std::weak_ptr<Member>> members_;
};

/// A member of a hub as a link. `keep_alive` is held until it is closed (ports of the bus).
std::unique_ptr<FrameLink> make_hub_link(std::shared_ptr<FrameHub::Member> member,
                                         std::shared_ptr<void> keep_alive);

/// `memory-can:NAME`: all who open the name in this process are on one bus.
OpenedFrames open_memory_can(const asio::any_io_executor& executor, const Uri& uri);

}  // namespace drydock::link
