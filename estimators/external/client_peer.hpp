#pragma once

#include <chrono>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/process/child.hpp"
#include "estimators/external/client_options.hpp"
#include "estimators/external/complaints.hpp"
#include "estimators/external/step_line.hpp"
#include "estimators/pipeline/peer.hpp"

namespace drydock::external {

struct Answer;

/// An estimator in a child process. In lockstep it waits for the answer to each step, so that the
/// run does not depend on the speed of the other program; in real time it never waits.
class ClientPeer final : public pipeline::Peer {
 public:
  explicit ClientPeer(ClientOptions options);
  ~ClientPeer() override;

  void exchange(const pipeline::Step& step, std::vector<pipeline::OutsideEstimate>& into) override;
  void poll(std::vector<pipeline::OutsideEstimate>& into) override;
  void finish(std::vector<pipeline::OutsideEstimate>& into) override;
  void refuse(const pipeline::OutsideEstimate& estimate, measurement::Stamp now) override;
  const pipeline::PeerAccount& account() const override { return account_; }

 private:
  using Nanoseconds = std::chrono::nanoseconds;
  using Estimates = std::vector<pipeline::OutsideEstimate>;
  /// A step without an answer.
  struct Open {
    std::uint64_t number = 0;
    Nanoseconds sent{};
  };

  bool lost() const { return !account_.failure.empty(); }
  Nanoseconds patience() const;
  void take_waiting(Estimates& into, Nanoseconds wait);
  bool take_one(Estimates& into, Nanoseconds wait);
  void hear(std::string_view line, Estimates& into);
  void hear_hello(std::string_view line);
  void hear_answer(Answer& answer, Estimates& into);
  void note_flaw(const Answer& answer);
  void close_step(Nanoseconds now);
  void check_alive();
  void give_up(std::string why);

  ClientOptions options_;
  std::vector<std::string> names_;
  StepLines lines_;
  std::unique_ptr<process::Child> child_;
  Complaints complaints_;
  pipeline::PeerAccount account_;
  std::deque<Open> open_;  ///< the oldest first
  bool greeted_ = false;
};

}  // namespace drydock::external
