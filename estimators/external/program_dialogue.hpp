#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/process/child.hpp"
#include "estimators/external/answer_line.hpp"
#include "estimators/external/complaints.hpp"
#include "estimators/pipeline/peer.hpp"

namespace drydock::external {

/// How another program is started and spoken to.
struct ProgramOptions {
  std::vector<std::string> command;
  std::string folder;  ///< the program's working folder
  std::string name;    ///< of what it does, for a person
  bool lockstep = false;
  /// A later answer is late. After five times as long without one the program is given up.
  std::chrono::nanoseconds answer_within = std::chrono::seconds{2};
  std::function<void(const std::string&)> say;  ///< the first fault of each sort, as a line
};

/// What a line of the other program says about itself.
struct Heard {
  std::uint64_t step = 0;  ///< 0: the line does not say it
  Flaw flaw = Flaw::none;
  std::string what;  ///< of the flaw, in words
};

/// The dialogue of docs/build/external-estimator.md with a child process: a greeting, then a line
/// for each step and a line back. In lockstep it waits for the answer to each step, so that the run
/// does not depend on the speed of the other program; in real time it never waits.
class ProgramDialogue {
 public:
  using Stamp = measurement::Stamp;
  /// Reads a line and keeps its content until the next one.
  using Read = std::function<Heard(std::string_view line)>;
  /// What was read last is the answer to the oldest step without one.
  using Take = std::function<void()>;

  ProgramDialogue(ProgramOptions options, std::string_view greeting, Read read, Take take);
  ~ProgramDialogue();

  /// Complaints are of this time from now on. False: the program is lost.
  bool begin_step(Stamp now);
  void send(std::uint64_t step, std::string_view line);
  void poll();    ///< takes what came since, without a step
  void finish();  ///< takes what is still to come at the end of a run

  bool lost() const { return !account_.failure.empty(); }
  pipeline::PeerAccount& account() { return account_; }
  const pipeline::PeerAccount& account() const { return account_; }
  Complaints& complaints() { return complaints_; }

 private:
  using Nanoseconds = std::chrono::nanoseconds;
  /// A step without an answer.
  struct Open {
    std::uint64_t number = 0;
    Nanoseconds sent{};
  };

  Nanoseconds patience() const;
  void take_waiting(Nanoseconds wait);
  bool take_one(Nanoseconds wait);
  void hear(std::string_view line);
  void hear_hello(std::string_view line);
  void hear_answer(const Heard& heard);
  void note_flaw(const Heard& heard);
  void close_step(Nanoseconds now);
  void check_alive();
  void give_up(std::string why);

  ProgramOptions options_;
  Read read_;
  Take take_;
  std::unique_ptr<process::Child> child_;
  Complaints complaints_;
  pipeline::PeerAccount account_;
  std::deque<Open> open_;  ///< the oldest first
  bool greeted_ = false;
};

}  // namespace drydock::external
