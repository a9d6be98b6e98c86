#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hil/bench/follower.hpp"
#include "hil/compare/contender.hpp"

namespace drydock::compare {

/// Gives every measurement of a run, and every finding, to all contenders.
class Contest final : public bench::Follower {
 public:
  /// `rig_text` is the content of `rig_file`. `choices`: estimators as rig_config::with_estimator
  /// takes them. `left_out`: devices of the rig that have no measurements and no place. Throws
  /// std::invalid_argument with one line that begins with the choice.
  Contest(const std::string& rig_text, const std::string& rig_file,
          const std::vector<std::string>& choices, const Contender::Setting& setting,
          const std::vector<std::string>& left_out = {});

  void on_measurement(const measurement::Measurement& measurement) override;
  void on_finding(const diagnosis::Finding& finding) override;

  /// Lets the estimators finish, and fills in what they made.
  void write(Comparison& comparison);

 private:
  std::vector<std::unique_ptr<Contender>> contenders_;
  std::uint64_t measurements_ = 0;
};

}  // namespace drydock::compare
