#include "estimators/external/program_dialogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "estimators/external/hello.hpp"
#include "estimators/external/patience.hpp"

namespace drydock::external {
namespace {

/// A program that does not read for so long that this waits for it is given up.
constexpr std::size_t most_unsent = 16'000'000;

}  // namespace

ProgramDialogue::ProgramDialogue(ProgramOptions options, std::string_view greeting, Read read,
                                 Take take)
    : options_(std::move(options)),
      read_(std::move(read)),
      take_(std::move(take)),
      child_(std::make_unique<process::Child>(options_.command, options_.folder)),
      complaints_(options_.name, options_.say) {
  child_->send(greeting);
}

ProgramDialogue::~ProgramDialogue() = default;

ProgramDialogue::Nanoseconds ProgramDialogue::patience() const {
  const Nanoseconds to_answer = patience_factor * options_.answer_within;
  return greeted_ ? to_answer : std::max<Nanoseconds>(to_answer, to_greet);
}

bool ProgramDialogue::begin_step(Stamp now) {
  complaints_.began(now);
  complaints_.now(now);
  return !lost();
}

void ProgramDialogue::send(std::uint64_t step, std::string_view line) {
  open_.push_back({step, process::elapsed()});
  ++account_.steps;
  child_->send(line);
  take_waiting(options_.lockstep ? patience() : Nanoseconds{0});
}

/// In lockstep nothing is left to come between two steps.
void ProgramDialogue::poll() {
  if (!lost() && !options_.lockstep) take_waiting(Nanoseconds{0});
}

void ProgramDialogue::finish() {
  if (!lost()) take_waiting(patience());
}

/// Takes what has come. While a step is open it waits for more, at most `wait` in all.
void ProgramDialogue::take_waiting(Nanoseconds wait) {
  const auto until = process::elapsed() + wait;
  while (!lost() && !open_.empty() && take_one(until - process::elapsed())) {
  }
  while (!lost() && take_one(Nanoseconds{0})) {
  }
  if (!lost()) check_alive();
}

bool ProgramDialogue::take_one(Nanoseconds wait) {
  const auto line = child_->line(std::max(wait, Nanoseconds{0}));
  if (line) hear(*line);
  return line.has_value();
}

void ProgramDialogue::hear(std::string_view line) {
  if (!std::exchange(greeted_, true)) return hear_hello(line);
  hear_answer(read_(line));
}

/// The program's start is no part of the time for an answer.
void ProgramDialogue::hear_hello(std::string_view line) {
  for (Open& step : open_) step.sent = process::elapsed();
  if (auto fault = fault_of_hello(line); !fault.empty()) give_up(std::move(fault));
}

/// A flawed line that does not say its step is taken for the answer to the oldest one: a program
/// that writes NaN goes on to the next step, and so does the run.
void ProgramDialogue::hear_answer(const Heard& heard) {
  const bool is_next = !open_.empty() && (heard.step == open_.front().number ||
                                          (heard.step == 0 && heard.flaw != Flaw::none));
  if (heard.flaw != Flaw::none) note_flaw(heard);
  if (is_next) {
    close_step(process::elapsed());
    take_();
  } else if (heard.step != 0 && heard.step <= account_.steps) {
    complaints_.add(account_.twice,
                    fmt::format("answered step {} twice or not in its turn", heard.step));
  } else if (heard.flaw == Flaw::none) {
    complaints_.add(account_.malformed,
                    fmt::format("answered step {}, which it was not sent", heard.step));
  }
}

void ProgramDialogue::note_flaw(const Heard& heard) {
  auto& count = heard.flaw == Flaw::not_finite ? account_.not_finite : account_.malformed;
  complaints_.add(count, fmt::format("answered with {}", heard.what));
}

void ProgramDialogue::close_step(Nanoseconds now) {
  const auto took = now - open_.front().sent;
  open_.pop_front();
  ++account_.answers;
  account_.longest_s = std::max(account_.longest_s, seconds(took));
  account_.mean_s += (seconds(took) - account_.mean_s) / static_cast<double>(account_.answers);
  if (took > options_.answer_within)
    complaints_.add(account_.late, fmt::format("answered after {:.3f} s, allowed: {} s",
                                               seconds(took), seconds(options_.answer_within)));
}

void ProgramDialogue::check_alive() {
  if (child_->closed()) return give_up(child_->ended());
  const auto now = process::elapsed();
  const bool silent = !open_.empty() && now - open_.front().sent >= patience();
  if (silent) return give_up(fmt::format("did not answer within {} s", seconds(patience())));
  if (child_->unsent() > most_unsent)
    give_up(fmt::format("did not read {} bytes", child_->unsent()));
}

void ProgramDialogue::give_up(std::string why) {
  complaints_.say(why);
  account_.failure = fmt::format("{} at {:.3f} s", why, complaints_.seconds());
  child_->kill();
  open_.clear();
}

}  // namespace drydock::external
