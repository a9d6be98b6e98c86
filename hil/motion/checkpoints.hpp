#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace drydock::motion {

/// States of something that is integrated in equal steps, found again at any index in any order.
/// The first of each block of steps is kept for good, whole blocks only as long as they are among
/// the last ones asked for: days of a motion cost little memory, and a block integrated again is
/// the same to the last bit.
template <class State>
class Checkpoints {
 public:
  explicit Checkpoints(const State& first) : firsts_{first} {}

  /// `step(state, index)`: the state one step after that of `index`.
  template <class Step>
  const State& at(std::size_t index, Step&& step) {
    while (firsts_.size() <= index / block) {
      const std::size_t last = firsts_.size() - 1;
      firsts_.push_back(step(whole(last, step).back(), (last + 1) * block - 1));
    }
    return whole(index / block, step)[index % block];
  }

 private:
  static constexpr std::size_t block = 1024;

  struct Whole {
    std::size_t number = 0, asked = 0;  ///< `asked` 0: empty
    std::vector<State> states;
  };

  template <class Step>
  const std::vector<State>& whole(std::size_t number, Step& step) {
    Whole* oldest = &recent_[0];
    for (Whole& kept : recent_) {
      if (kept.asked > 0 && kept.number == number) {
        kept.asked = ++asked_;
        return kept.states;
      }
      if (kept.asked < oldest->asked) oldest = &kept;
    }
    *oldest = {number, ++asked_, std::move(oldest->states)};
    oldest->states.assign(1, firsts_[number]);
    while (oldest->states.size() < block)
      oldest->states.push_back(
          step(oldest->states.back(), number * block + oldest->states.size() - 1));
    return oldest->states;
  }

  std::vector<State> firsts_;
  std::array<Whole, 4> recent_;
  std::size_t asked_ = 0;
};

}  // namespace drydock::motion
