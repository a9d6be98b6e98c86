#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace drydock::bus::test {

/// Runs this test program in another process with other arguments. The destructor kills it.
class ChildProcess {
 public:
  explicit ChildProcess(std::vector<std::string> arguments);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Next line of its standard output; empty at the end.
  std::string read_line() const;
  void signal(int number) const;

 private:
  pid_t pid_ = 0;
  int output_ = -1;
};

/// The subscribing process stops at a sample with this number and prints how many it received.
inline constexpr double end_of_numbers = 1e9;

/// The work of the other process. True if `arguments` ask for it.
bool run_as_child(const std::vector<std::string>& arguments);

}  // namespace drydock::bus::test
