#pragma once

#include <functional>
#include <memory>

#include "drivers/io/signal.hpp"
#include "drivers/link/traffic.hpp"

namespace drydock::link {

/// Writes what is put into a bounded queue to an open link, in order. What is put during a write
/// waits for the next one. Everything runs on the thread of the executor.
template <class Link, class Queue = typename Traffic<Link>::Queue>
class Pump {
 public:
  using Run = asio::awaitable<void>;
  using Item = typename Traffic<Link>::Item;
  /// Gets the content and the outcome of every write. False ends the writing: the rest is lost.
  using Written = std::function<bool(const Item&, const boost::system::error_code&)>;

  /// At most `most_queued` bytes, frames or messages wait, besides those that are being written.
  /// The link must outlive the pump.
  Pump(const asio::any_io_executor& executor, Link& link, std::size_t most_queued, Written written);

  /// False: the pump is closed or the queue is full, and the item is lost.
  bool put(const Item& item);
  /// Ends when the queue is written, or at once if another coroutine writes it.
  Run drain();
  /// Writes whatever is put; nobody else may drain.
  Run drain_until_closed();
  /// Closes the link: reading and writing end.
  void close();

  bool is_open() const { return open_; }
  bool is_writing() const { return writing_; }
  /// What waits for its turn; once the pump is closed: what never had it. In bytes, frames or
  /// messages.
  std::size_t waiting() const { return queued_.size() + left_; }

 private:
  Run write_batch();

  Link& link_;
  std::size_t most_queued_;
  Written written_;
  std::shared_ptr<io::Signal> changed_;
  Queue queued_, batch_;
  std::size_t left_ = 0;  ///< of the batch in which a write failed
  bool open_ = true, writing_ = false;
  bool idle_ = false;  ///< drain_until_closed() waits
};

extern template class Pump<ByteLink>;
extern template class Pump<ByteLink, MessageQueue>;
extern template class Pump<FrameLink>;

}  // namespace drydock::link
