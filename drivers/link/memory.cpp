#include "drivers/link/memory.hpp"

#include <algorithm>
#include <array>
#include <boost/asio/error.hpp>
#include <boost/circular_buffer.hpp>
#include <map>
#include <mutex>

#include "drivers/io/signal.hpp"

namespace drydock::link {
namespace {

constexpr std::size_t capacity = 65'536;

/// The state of one end of the line that the other end uses.
struct End {
  bool open = false;
  boost::circular_buffer<std::uint8_t> inbox{capacity};  ///< bytes for this end
  std::shared_ptr<io::Signal> changed;                   ///< wakes this end
};

struct Line {
  End& end(Side side) { return ends[static_cast<std::size_t>(side)]; }
  End& opposite(Side side) { return ends[1 - static_cast<std::size_t>(side)]; }
  void wake_opposite(Side side) {
    if (opposite(side).open) opposite(side).changed->notify();
  }

  std::mutex mutex;  ///< protects everything below
  std::array<End, 2> ends;
};

class MemoryLink final : public ByteLink {
 public:
  MemoryLink(std::shared_ptr<Line> line, Side side) : line_(std::move(line)), side_(side) {}
  ~MemoryLink() override { close(); }

  Task<ReceivedBytes> read(std::span<std::uint8_t> into) override;
  Task<void> write(std::span<const std::uint8_t> bytes) override;
  void say_last(std::span<const std::uint8_t> bytes) override;
  void close() override;
  Provenance provenance() const override { return Provenance::emulated; }

 private:
  std::shared_ptr<Line> line_;
  Side side_;
};

Task<ReceivedBytes> MemoryLink::read(std::span<std::uint8_t> into) {
  const auto line = line_;
  const Side side = side_;
  End& mine = line->end(side);
  const auto changed = mine.changed;
  for (;;) {
    {
      const std::lock_guard lock(line->mutex);
      if (!mine.open) co_return ErrorCode(asio::error::operation_aborted);
      if (!mine.inbox.empty()) {
        const std::size_t size = std::min(into.size(), mine.inbox.size());
        std::copy_n(mine.inbox.begin(), size, into.begin());
        mine.inbox.erase_begin(size);
        line->wake_opposite(side);
        co_return ReceivedBytes{size, now()};
      }
      if (side == Side::driver && !line->opposite(side).open) co_return ErrorCode(asio::error::eof);
    }
    co_await changed->wait();
  }
}

Task<void> MemoryLink::write(std::span<const std::uint8_t> bytes) {
  const auto line = line_;
  const Side side = side_;
  End& mine = line->end(side);
  End& other = line->opposite(side);
  const auto changed = mine.changed;
  for (;;) {
    {
      const std::lock_guard lock(line->mutex);
      if (!mine.open) co_return ErrorCode(asio::error::operation_aborted);
      if (!other.open && side == Side::driver) co_return ErrorCode(asio::error::broken_pipe);
      if (!other.open) break;
      const std::size_t size = std::min(bytes.size(), other.inbox.reserve());
      other.inbox.insert(other.inbox.end(), bytes.begin(),
                         bytes.begin() + static_cast<std::ptrdiff_t>(size));
      if (size > 0) line->wake_opposite(side);
      bytes = bytes.subspan(size);
      if (bytes.empty()) break;
    }
    co_await changed->wait();
  }
  co_return boost::system::result<void>{};
}

void MemoryLink::say_last(std::span<const std::uint8_t> bytes) {
  const std::lock_guard lock(line_->mutex);
  End& other = line_->opposite(side_);
  if (!line_->end(side_).open || !other.open) return;
  const std::size_t size = std::min(bytes.size(), other.inbox.reserve());
  other.inbox.insert(other.inbox.end(), bytes.begin(),
                     bytes.begin() + static_cast<std::ptrdiff_t>(size));
  line_->wake_opposite(side_);
}

void MemoryLink::close() {
  const std::lock_guard lock(line_->mutex);
  End& mine = line_->end(side_);
  if (!mine.open) return;
  mine.open = false;
  mine.inbox.clear();
  mine.changed->notify();
  line_->wake_opposite(side_);
}

/// The lines of this process by name.
class Lines {
 public:
  OpenedBytes open(const asio::any_io_executor& executor, const Uri& uri, Side side) {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<Line> line = by_name_[uri.target].lock();
    if (side == Side::driver && !is_open(line, Side::device))
      return OpenError{asio::error::connection_refused,
                       "no device has opened memory:" + uri.target + " in this process yet"};
    if (is_open(line, side))
      return OpenError{asio::error::address_in_use, "memory:" + uri.target + " is already in use"};
    if (side == Side::device) by_name_[uri.target] = line = std::make_shared<Line>();
    join(*line, executor, side);
    return std::make_unique<MemoryLink>(std::move(line), side);
  }

 private:
  static bool is_open(const std::shared_ptr<Line>& line, Side side) {
    if (!line) return false;
    const std::lock_guard lock(line->mutex);
    return line->end(side).open;
  }

  static void join(Line& line, const asio::any_io_executor& executor, Side side) {
    const std::lock_guard lock(line.mutex);
    End& end = line.end(side);
    end.open = true;
    end.inbox.clear();
    end.changed = std::make_shared<io::Signal>(executor);
  }

  std::mutex mutex_;
  std::map<std::string, std::weak_ptr<Line>> by_name_;
};

}  // namespace

OpenedBytes open_memory(const asio::any_io_executor& executor, const Uri& uri, Side side) {
  static Lines lines;
  return lines.open(executor, uri, side);
}

}  // namespace drydock::link
