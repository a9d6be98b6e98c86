#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "drivers/wire/line_rate.hpp"

/// An asynchronous serial line as levels, and what a receiver with settings of its own makes of
/// them: a 16550A behind Linux's 8250_port.c, as tests/ports/uart.py has it, at any two rates.
namespace drydock::probe::uart_model {

/// A level that stays from `begin_s` to `end_s`.
struct Level {
  bool mark = true;
  double begin_s = 0, end_s = 0;
};

inline bool parity_bit(unsigned data, wire::Parity parity) {
  return (__builtin_popcount(data) % 2 == 1) != (parity == wire::Parity::odd);
}

/// Levels of one character from `begin_s` on: start, data from the lowest bit, parity, stop.
inline std::vector<Level> sent(std::uint8_t byte, wire::LineRate rate, double begin_s) {
  const unsigned data = byte & ((1U << rate.frame.data_bits) - 1);
  std::vector<bool> bits{false};
  for (unsigned i = 0; i < rate.frame.data_bits; ++i) bits.push_back((data >> i & 1) != 0);
  if (rate.frame.parity != wire::Parity::none) bits.push_back(parity_bit(data, rate.frame.parity));
  bits.insert(bits.end(), rate.frame.stop_bits, true);
  std::vector<Level> levels;
  for (std::size_t i = 0; i < bits.size(); ++i) {
    const auto at = [&](std::size_t bit) { return begin_s + static_cast<double>(bit) / rate.baud; };
    levels.push_back({bits[i], at(i), at(i + 1)});
  }
  return levels;
}

/// Samples each bit in its middle, of the stop bits only the first. Drydock sets INPCK and IGNPAR
/// where there is parity, and neither where there is none.
class Receiver {
 public:
  explicit Receiver(wire::LineRate rate) : rate_(rate) {}

  void hear(const Level& level) {
    if (state_ == State::broken && level.mark) state_ = State::idle;
    if (state_ == State::idle && !level.mark) begin(level.begin_s + 1.5 / rate_.baud);
    while (state_ == State::inside && next_s_ < level.end_s) sample(level.mark);
  }
  std::vector<std::uint8_t> taken() { return std::exchange(read_, {}); }

 private:
  enum class State : std::uint8_t { idle, inside, broken };

  void begin(double first_s) {
    state_ = State::inside;
    next_s_ = first_s;
    data_ = count_ = 0;
    parity_ = false;
  }
  void sample(bool mark) {
    const auto& frame = rate_.frame;
    next_s_ += 1.0 / rate_.baud;
    const unsigned at = count_++;
    if (at < frame.data_bits) {
      data_ |= static_cast<unsigned>(mark) << at;
    } else if (frame.parity != wire::Parity::none && at == frame.data_bits) {
      parity_ = mark;
    } else {
      end(mark);
    }
  }
  void end(bool stop) {
    const bool checked = rate_.frame.parity != wire::Parity::none;
    const bool wrong = !stop || (checked && parity_ != parity_bit(data_, rate_.frame.parity));
    const bool is_break = !stop && !parity_ && data_ == 0;
    if (!wrong || !checked || is_break) read_.push_back(static_cast<std::uint8_t>(data_));
    state_ = is_break ? State::broken : State::idle;
    if (!is_break && !stop) begin(next_s_);  // taken for the next start bit
  }

  wire::LineRate rate_;
  State state_ = State::idle;
  double next_s_ = 0;
  unsigned data_ = 0, count_ = 0;
  bool parity_ = false;
  std::vector<std::uint8_t> read_;
};

}  // namespace drydock::probe::uart_model
