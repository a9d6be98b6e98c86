#pragma once

#include <cstdint>
#include <list>
#include <mutex>
#include <vector>

namespace drydock::motion {

/// The steps of an integration, none computed before it is asked for. Any step can be asked for, in
/// any order and from any thread, with the same bits each time. The first step of every block is
/// kept, and all steps of the few blocks that were used last.
template <class Step>
class StepsOnDemand {
 public:
  explicit StepsOnDemand(const Step& first) : starts_{first} {}

  /// `after(step, index)` returns the step after that of `index`.
  template <class After>
  Step at(std::int64_t step, const After& after) {
    const std::lock_guard lock(mutex_);
    const std::int64_t index = step / block_steps;
    while (static_cast<std::int64_t>(starts_.size()) <= index) {
      const auto last = static_cast<std::int64_t>(starts_.size()) - 1;
      extend(block(last), block_steps, after);
    }
    const auto within = static_cast<std::size_t>(step % block_steps);
    Block& there = block(index);
    extend(there, within + 1, after);
    return there.steps[within];
  }

 private:
  static constexpr std::int64_t block_steps = 1024;
  static constexpr std::size_t kept_blocks = 4;

  struct Block {
    std::int64_t index = 0;
    std::vector<Step> steps;
  };

  /// Returns the block, which may be in memory already, with at least its first step.
  Block& block(std::int64_t index) {
    for (auto found = blocks_.begin(); found != blocks_.end(); ++found)
      if (found->index == index) {
        blocks_.splice(blocks_.begin(), blocks_, found);
        return blocks_.front();
      }
    if (blocks_.size() < kept_blocks) {
      blocks_.emplace_front().steps.reserve(block_steps);
    } else {
      blocks_.splice(blocks_.begin(), blocks_, std::prev(blocks_.end()));
    }
    blocks_.front().index = index;
    blocks_.front().steps.assign(1, starts_[static_cast<std::size_t>(index)]);
    return blocks_.front();
  }

  template <class After>
  void extend(Block& block, std::size_t steps, const After& after) {
    const std::int64_t begins = block.index * block_steps;
    while (block.steps.size() < steps)
      block.steps.push_back(
          after(block.steps.back(), begins + static_cast<std::int64_t>(block.steps.size()) - 1));
    const auto next = static_cast<std::size_t>(block.index + 1);
    if (steps == block_steps && starts_.size() == next)
      starts_.push_back(after(block.steps.back(), begins + block_steps - 1));
  }

  std::mutex mutex_;
  std::vector<Step> starts_;  ///< first steps of the blocks that were asked for so far
  std::list<Block> blocks_;   ///< the most recently used first
};

}  // namespace drydock::motion
