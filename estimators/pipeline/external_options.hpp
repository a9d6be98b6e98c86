#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "estimators/pipeline/maker.hpp"
#include "estimators/pipeline/peer.hpp"

namespace drydock::pipeline {

/// An estimator in another program.
struct ExternalOptions {
  std::chrono::nanoseconds step =
      std::chrono::milliseconds{50};  ///< measurements of this time go together
  /// Reaches the other program. Empty: nobody is asked, for a rig that is only checked.
  std::function<std::unique_ptr<Peer>()> connect;
};

std::string fault_of(const ExternalOptions& options);
std::unique_ptr<Estimator> make_estimator(Seat seat, const ExternalOptions& options,
                                          const PipelineOptions& pipeline);

}  // namespace drydock::pipeline
