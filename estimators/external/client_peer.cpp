#include "estimators/external/client_peer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "estimators/external/answer.hpp"
#include "estimators/external/patience.hpp"

namespace drydock::external {
namespace {

/// A program that does not read for so long that this waits for it is given up.
constexpr std::size_t most_unsent = 16'000'000;

std::vector<std::string> names_of(const Hello& hello) {
  std::vector<std::string> names;
  for (const auto& device : hello.devices) names.push_back(device.name);
  return names;
}

}  // namespace

ClientPeer::ClientPeer(ClientOptions options)
    : options_(std::move(options)),
      names_(names_of(options_.hello)),
      lines_(names_),
      child_(std::make_unique<process::Child>(options_.command, options_.folder)),
      complaints_(options_.hello.estimator, options_.say) {
  child_->send(line_of(options_.hello));
}

ClientPeer::~ClientPeer() = default;

ClientPeer::Nanoseconds ClientPeer::patience() const {
  const Nanoseconds to_answer = patience_factor * options_.answer_within;
  return greeted_ ? to_answer : std::max<Nanoseconds>(to_answer, to_greet);
}

void ClientPeer::exchange(const pipeline::Step& step, Estimates& into) {
  complaints_.began(step.now);
  complaints_.now(step.now);
  if (lost()) return;
  open_.push_back({step.number, process::elapsed()});
  ++account_.steps;
  child_->send(lines_.line_of(step));
  take_waiting(into, options_.hello.lockstep ? patience() : Nanoseconds{0});
}

/// In lockstep nothing is left to come between two steps.
void ClientPeer::poll(Estimates& into) {
  if (!lost() && !options_.hello.lockstep) take_waiting(into, Nanoseconds{0});
}

void ClientPeer::finish(Estimates& into) {
  if (!lost()) take_waiting(into, patience());
}

/// Takes what has come. While a step is open it waits for more, at most `wait` in all.
void ClientPeer::take_waiting(Estimates& into, Nanoseconds wait) {
  const auto until = process::elapsed() + wait;
  while (!lost() && !open_.empty() && take_one(into, until - process::elapsed())) {
  }
  while (!lost() && take_one(into, Nanoseconds{0})) {
  }
  if (!lost()) check_alive();
}

bool ClientPeer::take_one(Estimates& into, Nanoseconds wait) {
  const auto line = child_->line(std::max(wait, Nanoseconds{0}));
  if (line) hear(*line, into);
  return line.has_value();
}

void ClientPeer::hear(std::string_view line, Estimates& into) {
  if (!std::exchange(greeted_, true)) return hear_hello(line);
  Answer answer = read_answer(line, options_.hello.gives);
  hear_answer(answer, into);
}

/// The program's start is no part of the time for an answer.
void ClientPeer::hear_hello(std::string_view line) {
  for (Open& step : open_) step.sent = process::elapsed();
  if (auto fault = fault_of_hello(line); !fault.empty()) give_up(std::move(fault));
}

/// A flawed line that does not say its step is taken for the answer to the oldest one: a program
/// that writes NaN goes on to the next step, and so does the run.
void ClientPeer::hear_answer(Answer& answer, Estimates& into) {
  const bool is_next = !open_.empty() && (answer.step == open_.front().number ||
                                          (answer.step == 0 && answer.flaw != Answer::Flaw::none));
  if (answer.flaw != Answer::Flaw::none) note_flaw(answer);
  if (is_next) {
    close_step(process::elapsed());
    into.insert(into.end(), answer.estimates.begin(), answer.estimates.end());
  } else if (answer.step != 0 && answer.step <= account_.steps) {
    complaints_.add(account_.twice,
                    fmt::format("answered step {} twice or not in its turn", answer.step));
  } else if (answer.flaw == Answer::Flaw::none) {
    complaints_.add(account_.malformed,
                    fmt::format("answered step {}, which it was not sent", answer.step));
  }
}

void ClientPeer::note_flaw(const Answer& answer) {
  auto& count = answer.flaw == Answer::Flaw::not_finite ? account_.not_finite : account_.malformed;
  complaints_.add(count, fmt::format("answered with {}", answer.what));
}

void ClientPeer::close_step(Nanoseconds now) {
  const auto took = now - open_.front().sent;
  open_.pop_front();
  ++account_.answers;
  account_.longest_s = std::max(account_.longest_s, seconds(took));
  account_.mean_s += (seconds(took) - account_.mean_s) / static_cast<double>(account_.answers);
  if (took > options_.answer_within)
    complaints_.add(account_.late, fmt::format("answered after {:.3f} s, allowed: {} s",
                                               seconds(took), seconds(options_.answer_within)));
}

void ClientPeer::check_alive() {
  if (child_->closed()) return give_up(child_->ended());
  const auto now = process::elapsed();
  const bool silent = !open_.empty() && now - open_.front().sent >= patience();
  if (silent) return give_up(fmt::format("did not answer within {} s", seconds(patience())));
  if (child_->unsent() > most_unsent)
    give_up(fmt::format("did not read {} bytes", child_->unsent()));
}

void ClientPeer::give_up(std::string why) {
  complaints_.say(why);
  account_.failure = fmt::format("{} at {:.3f} s", why, complaints_.seconds());
  child_->kill();
  open_.clear();
}

void ClientPeer::refuse(const pipeline::OutsideEstimate& estimate, measurement::Stamp now) {
  complaints_.add(account_.out_of_time,
                  out_of_time(measurement::seconds(pipeline::valid_at(estimate) - now)));
}

}  // namespace drydock::external
