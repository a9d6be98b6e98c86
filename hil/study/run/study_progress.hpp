#pragma once

#include <chrono>
#include <cstdio>
#include <string_view>

#include "drivers/terminal/interrupt_flag.hpp"
#include "hil/study/campaign.hpp"

namespace drydock::study {

/// A bar with the remaining time if `out` is a terminal; else nothing. Ctrl-C stops the study.
class StudyProgress final : public study::Progress {
 public:
  explicit StudyProgress(std::FILE* out);

  void on_run(std::string_view campaign, std::size_t done, std::size_t of) override;
  bool stopped() const override { return interrupt_.set(); }

  /// Erases the bar and prints one line about the finished work. `earlier`: runs of options.runs
  /// that were there before it.
  void finish(std::string_view study, std::size_t runs, const study::Options& options,
              std::size_t earlier = 0);

 private:
  using Clock = std::chrono::steady_clock;

  std::FILE* out_;
  bool terminal_;
  terminal::InterruptFlag interrupt_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point campaign_begin_ = begin_, next_drawing_ = begin_;
};

}  // namespace drydock::study
