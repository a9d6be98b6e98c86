#pragma once

#include <vector>

#include "estimators/external/complaints.hpp"
#include "estimators/external/topic_options.hpp"
#include "estimators/pipeline/peer.hpp"

namespace drydock::external {

/// An estimator that publishes on the bus, such as a ROS 2 node. It takes the measurements from the
/// bus itself, so it is sent nothing, and nothing waits for it.
class TopicPeer final : public pipeline::Peer {
 public:
  /// Throws bus::Error with one line.
  explicit TopicPeer(TopicOptions options);

  void exchange(const pipeline::Step& step, std::vector<pipeline::OutsideEstimate>& into) override;
  void poll(std::vector<pipeline::OutsideEstimate>& into) override;
  void finish(std::vector<pipeline::OutsideEstimate>& into) override { poll(into); }
  void refuse(const pipeline::OutsideEstimate& estimate, measurement::Stamp now) override;
  const pipeline::PeerAccount& account() const override { return account_; }

 private:
  void hear(const bus::OutsideReader::Heard& heard, std::vector<pipeline::OutsideEstimate>& into);

  TopicOptions options_;
  bus::Participant participant_;
  bus::OutsideReader reader_;
  Complaints complaints_;
  pipeline::PeerAccount account_;
  std::uint64_t unusable_ = 0;  ///< of the reader, so far
  std::uint64_t lacking_ = 0;   ///< messages without what the estimator gives
};

}  // namespace drydock::external
