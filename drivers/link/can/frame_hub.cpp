#include "drivers/link/can/frame_hub.hpp"

#include <algorithm>
#include <boost/asio/error.hpp>
#include <map>

namespace drydock::link {
namespace {

constexpr std::size_t inbox_capacity = 1024;  // over half a second of a full bus at 250 kbit/s

class HubLink final : public FrameLink {
 public:
  HubLink(std::shared_ptr<FrameHub::Member> member, std::shared_ptr<void> keep_alive)
      : member_(std::move(member)), keep_alive_(std::move(keep_alive)) {}
  ~HubLink() override { close(); }

  Task<ReceivedFrame> read() override {
    const auto member = member_;
    for (;;) {
      if (auto outcome = member->take()) co_return *outcome;
      co_await member->changed()->wait();
    }
  }

  Task<void> write(const wire::CanFrame& frame) override {
    if (member_->has_left()) co_return ErrorCode(asio::error::operation_aborted);
    member_->send(frame, now());
    co_return boost::system::result<void>{};
  }

  void close() override {
    member_->leave();
    keep_alive_.reset();
  }

  Provenance provenance() const override { return Provenance::emulated; }
  std::uint64_t dropped() const override { return member_->dropped(); }

 private:
  std::shared_ptr<FrameHub::Member> member_;
  std::shared_ptr<void> keep_alive_;
};

}  // namespace

FrameHub::Member::Member(std::shared_ptr<FrameHub> hub, const asio::any_io_executor& executor)
    : hub_(std::move(hub)),
      changed_(std::make_shared<io::Signal>(executor)),
      inbox_(inbox_capacity) {}

std::optional<boost::system::result<ReceivedFrame>> FrameHub::Member::take() {
  const std::lock_guard lock(hub_->mutex_);
  if (left_) return ErrorCode(asio::error::operation_aborted);
  if (inbox_.empty()) return std::nullopt;
  const ReceivedFrame frame = inbox_.front();
  inbox_.pop_front();
  return frame;
}

void FrameHub::Member::send(const wire::CanFrame& frame, Stamp at) {
  const std::lock_guard lock(hub_->mutex_);
  if (left_) return;
  for (const auto& weak : hub_->members_) {
    const auto member = weak.lock();
    if (!member || member.get() == this || member->left_) continue;
    if (member->inbox_.full()) {
      ++member->dropped_;
      continue;
    }
    member->inbox_.push_back({frame, at, false});
    if (member->inbox_.size() == 1) member->changed_->notify();
  }
}

void FrameHub::Member::leave() {
  const std::lock_guard lock(hub_->mutex_);
  left_ = true;
  inbox_.clear();
  changed_->notify();
}

bool FrameHub::Member::has_left() const {
  const std::lock_guard lock(hub_->mutex_);
  return left_;
}

std::uint64_t FrameHub::Member::dropped() const {
  const std::lock_guard lock(hub_->mutex_);
  return dropped_;
}

std::shared_ptr<FrameHub::Member> FrameHub::join(const asio::any_io_executor& executor) {
  std::shared_ptr<Member> member(new Member(shared_from_this(), executor));
  const std::lock_guard lock(mutex_);
  std::erase_if(members_, [](const auto& weak) { return weak.expired(); });
  members_.push_back(member);
  return member;
}

std::unique_ptr<FrameLink> make_hub_link(std::shared_ptr<FrameHub::Member> member,
                                         std::shared_ptr<void> keep_alive) {
  return std::make_unique<HubLink>(std::move(member), std::move(keep_alive));
}

OpenedFrames open_memory_can(const asio::any_io_executor& executor, const Uri& uri) {
  static std::mutex mutex;
  static std::map<std::string, std::weak_ptr<FrameHub>> by_name;
  const std::lock_guard lock(mutex);
  std::shared_ptr<FrameHub> hub = by_name[uri.target].lock();
  if (!hub) by_name[uri.target] = hub = std::make_shared<FrameHub>();
  return make_hub_link(hub->join(executor), nullptr);
}

}  // namespace drydock::link
