#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "estimators/external/answer.hpp"
#include "estimators/external/client_options.hpp"
#include "estimators/external/program_dialogue.hpp"
#include "estimators/external/step_line.hpp"
#include "estimators/pipeline/peer.hpp"

namespace drydock::external {

/// An estimator in a child process.
class ClientPeer final : public pipeline::Peer {
 public:
  explicit ClientPeer(const ClientOptions& options);

  void exchange(const pipeline::Step& step, std::vector<pipeline::OutsideEstimate>& into) override;
  void poll(std::vector<pipeline::OutsideEstimate>& into) override;
  void finish(std::vector<pipeline::OutsideEstimate>& into) override;
  void refuse(const pipeline::OutsideEstimate& estimate, measurement::Stamp now) override;
  const pipeline::PeerAccount& account() const override { return dialogue_.account(); }

 private:
  using Estimates = std::vector<pipeline::OutsideEstimate>;

  Heard read(std::string_view line);

  Gives gives_;
  std::vector<std::string> names_;
  StepLines lines_;
  Answer answer_;              ///< what was read last
  Estimates* into_ = nullptr;  ///< during a call
  ProgramDialogue dialogue_;
};

}  // namespace drydock::external
