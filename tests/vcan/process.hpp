#pragma once

#include <string>
#include <vector>

/// Programs of can-utils beside our links.
namespace drydock::vcan {

/// The interface that with-vcan.sh found (DRYDOCK_CAN).
std::string interface();

/// A program that runs beside the test; ended with SIGINT, as a person would, when it goes.
class Process {
 public:
  /// Standard output and errors go to a pipe that output_until() reads.
  explicit Process(const std::vector<std::string>& command);
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process();

  /// Everything it has said so far, read until that contains `text` `count` times, the program
  /// ends, or five seconds have passed.
  std::string output_until(const std::string& text, int count = 1);
  /// Waits for its end; its exit status.
  int wait();

 private:
  int pid_ = -1;
  int pipe_ = -1;
  std::string output_;
};

/// Runs a program to its end; its exit status.
int run_program(const std::vector<std::string>& command);

/// Receivers of all frames on the interface (/proc/net/can/rcvlist_all).
int receiver_count(const std::string& name);
/// A candump that has just been started hears nothing before it is among them. False after 5 s.
bool wait_for_receivers(const std::string& name, int at_least);

}  // namespace drydock::vcan
