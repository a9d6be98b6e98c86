#pragma once

#include <string>
#include <vector>

/// Runs programs of can-utils in parallel with our links.
namespace drydock::vcan {

/// The interface that with-vcan.sh found (DRYDOCK_CAN).
std::string interface();

/// A program that runs in parallel with the test. The destructor ends it with SIGINT, as a person
/// would.
class Process {
 public:
  /// Standard output and errors go to a pipe that output_until() reads.
  explicit Process(const std::vector<std::string>& command);
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process();

  /// Its whole output so far. Reads until the output contains `text` `count` times, the program
  /// ends, or 20 s have passed (a machine in software is slow).
  std::string output_until(const std::string& text, int count = 1);
  /// Waits for its end. Returns its exit status.
  int wait();

 private:
  int pid_ = -1;
  int pipe_ = -1;
  std::string output_;
};

/// Runs a program to its end. Returns its exit status.
int run_program(const std::vector<std::string>& command);

/// Number of receivers of all frames on the interface (/proc/net/can/rcvlist_all).
int receiver_count(const std::string& name);
/// A candump that has just started receives nothing until it is one of these receivers. False after
/// 20 s.
bool wait_for_receivers(const std::string& name, int at_least);

}  // namespace drydock::vcan
