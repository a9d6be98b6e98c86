#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace drydock::motion {

/// The states of an integration in equal steps, available at any index in any order. The blocks of
/// steps that were used last are kept whole. Of all other blocks, only the first state of every
/// `apart_`-th one is kept. So a motion of any length needs the same small memory. A block that is
/// integrated again is equal to the last bit.
template <class State>
class Checkpoints {
 public:
  static constexpr std::size_t block = 1024, most_firsts = 512;

  explicit Checkpoints(const State& first) : firsts_{first} {}

  /// `step(state, index)` returns the state one step after that of `index`.
  template <class Step>
  const State& at(std::size_t index, Step&& step) {
    return whole(index / block, step)[index % block];
  }

  std::size_t firsts() const { return firsts_.size(); }

 private:
  struct Whole {
    std::size_t number = 0, asked = 0;  ///< `asked` 0: unused
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
    const State first = first_of(number, step);
    *oldest = {number, ++asked_, std::move(oldest->states)};
    oldest->states.assign(1, first);
    while (oldest->states.size() < block)
      oldest->states.push_back(
          step(oldest->states.back(), number * block + oldest->states.size() - 1));
    return oldest->states;
  }

  /// Starts from the previous block if that is whole, else from the last first state that is kept.
  template <class Step>
  State first_of(std::size_t number, Step& step) {
    for (const Whole& kept : recent_) {
      if (kept.asked == 0 || kept.number + 1 != number) continue;
      State state = step(kept.states.back(), number * block - 1);
      keep(number, state);
      return state;
    }
    std::size_t at = std::min(number / apart_, firsts_.size() - 1) * apart_;
    State state = firsts_[at / apart_];
    while (at < number) {
      for (std::size_t i = 0; i < block; ++i) state = step(state, at * block + i);
      keep(++at, state);
    }
    return state;
  }

  void keep(std::size_t number, const State& first) {
    if (number != firsts_.size() * apart_) return;
    firsts_.push_back(first);
    if (firsts_.size() < most_firsts) return;
    for (std::size_t i = 1; 2 * i < firsts_.size(); ++i) firsts_[i] = firsts_[2 * i];
    firsts_.resize((firsts_.size() + 1) / 2);
    apart_ *= 2;
  }

  std::vector<State> firsts_;  ///< one per `apart_` blocks
  std::size_t apart_ = 1;
  std::array<Whole, 4> recent_;
  std::size_t asked_ = 0;
};

}  // namespace drydock::motion
