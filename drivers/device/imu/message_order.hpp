#pragma once

#include <algorithm>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::device {

/// Which of the two messages of a sample its device sends first. Of two successive pauses between
/// them the shorter lies within a sample. A late read makes a wrong vote, so the most votes count.
class MessageOrder {
 public:
  enum class Message : bool { rate, force };

  void reset() { *this = {}; }

  void hear(Message message, measurement::Stamp at) {
    if (heard_ >= 2 && message != last_ && message == before_) {
      const auto earlier = last_at_ - before_at_, later = at - last_at_;
      if (earlier != later) vote(earlier < later ? message : last_);
    }
    before_ = last_;
    before_at_ = last_at_;
    last_ = message;
    last_at_ = at;
    heard_ = std::min(heard_ + 1, 2);
  }

  /// Empty until it is clear.
  std::optional<Message> first() const { return first_; }

 private:
  static constexpr int clear = 3, most_votes = 4096;

  void vote(Message first) {
    votes_ = std::clamp(votes_ + (first == Message::rate ? 1 : -1), -most_votes, most_votes);
    if (votes_ >= clear) first_ = Message::rate;
    if (votes_ <= -clear) first_ = Message::force;
  }

  Message last_{}, before_{};
  measurement::Stamp last_at_{}, before_at_{};
  int heard_ = 0, votes_ = 0;
  std::optional<Message> first_;
};

}  // namespace drydock::device
