#pragma once

#include "drivers/recordings/record/layouts.hpp"
#include "hil/score/message_state.hpp"
#include "hil/score/passed_over.hpp"

namespace drydock::score {

/// The estimates of one topic of an MCAP file.
class EstimateTopic {
 public:
  EstimateTopic(const MessageType& type, const frame::Position& origin)
      : type_(type), origin_(origin) {}

  void read(const record::Layout& layout, mcap::Bytes cdr);
  /// What every message leaves as an empty message has it, is not given.
  Estimates result();

 private:
  void note(const std::string& why);
  void take(MessageState message);

  const MessageType& type_;
  const frame::Position& origin_;
  std::uint64_t messages_ = 0;
  bool default_attitudes_ = true, default_velocities_ = true;
  Estimates estimates_;
  PassedOver passed_over_{"message"};
};

/// What the estimates do not say may be in others of the same estimator and the same time.
void add_to(Track& track, const Track& other);

}  // namespace drydock::score
