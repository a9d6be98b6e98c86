#pragma once

#include <optional>
#include <vector>

#include "drivers/bus/clock_writer.hpp"
#include "drivers/bus/publisher.hpp"
#include "estimators/external/complaints.hpp"
#include "estimators/external/topic_options.hpp"
#include "estimators/pipeline/peer.hpp"

namespace drydock::external {

/// An estimator on the bus in lockstep, such as a ROS 2 node that uses sim time. Each step it is
/// given the measurements, and after all of its readers have them `/clock` with the end of the
/// step. The step is answered by a message with this stamp.
class StepTopicPeer final : public pipeline::Peer {
 public:
  /// Answers later than `answer_within` are late. After five times as long the program is given up;
  /// it has 10 s to come. Throws bus::Error with one line.
  StepTopicPeer(TopicOptions options, const std::vector<bus::Device>& devices,
                std::chrono::nanoseconds answer_within);

  void exchange(const pipeline::Step& step, std::vector<pipeline::OutsideEstimate>& into) override;
  void poll(std::vector<pipeline::OutsideEstimate>&) override {}
  void finish(std::vector<pipeline::OutsideEstimate>&) override {}
  void refuse(const pipeline::OutsideEstimate& estimate, measurement::Stamp now) override;
  const pipeline::PeerAccount& account() const override { return account_; }

 private:
  using Nanoseconds = std::chrono::nanoseconds;
  using Estimates = std::vector<pipeline::OutsideEstimate>;

  bool lost() const { return !account_.failure.empty(); }
  void meet();
  void send(const pipeline::Step& step);
  void wait_for_answer(Nanoseconds sent, Estimates& into);
  void take(Estimates& into);
  void hear(const bus::OutsideReader::Heard& heard, Estimates& into);
  void note_unusable();
  void note_answer(Nanoseconds took);
  void give_up(const std::string& why);

  TopicOptions options_;
  Nanoseconds answer_within_;
  bus::Participant participant_;
  bus::Publisher publisher_;
  bus::ClockWriter clock_;
  bus::OutsideReader reader_;
  Complaints complaints_;
  pipeline::PeerAccount account_;
  std::optional<measurement::Stamp> open_;      ///< the end of a step without an answer
  std::optional<measurement::Stamp> answered_;  ///< the end of the last one with an answer
  std::uint64_t unusable_ = 0;                  ///< of the reader, so far
  bool met_ = false;
};

}  // namespace drydock::external
