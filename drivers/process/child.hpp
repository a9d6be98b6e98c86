#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drydock::process {

/// Another program that is spoken to in lines, on its standard input and output. Its standard error
/// is that of this program. It has a process group of its own, so that Ctrl-C ends the run and not
/// the program in the middle of a line.
class Child {
 public:
  /// Starts the program in `folder` (empty: this program's). If it cannot start, `ended` says why.
  Child(const std::vector<std::string>& command, const std::string& folder);
  /// Closes the program's input. It then has a second to end by itself before it is killed.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Queues a line, without its end, and sends what the program takes at once. Never waits.
  void send(std::string_view line);

  /// The next whole line of the program's output, without its end; empty if none came within
  /// `wait`. The text is good until the next call.
  std::optional<std::string_view> line(std::chrono::nanoseconds wait);

  /// True after the program closed its output or went on too long without an end of line.
  bool closed() const { return closed_; }
  /// How it ended, in words: "exited with code 3", "was killed by signal 11 (Segmentation fault)".
  const std::string& ended();

  /// Bytes that the program has not yet taken.
  std::size_t unsent() const { return unsent_.size() - sent_; }

  void kill();  ///< at once, for a program that does not answer

 private:
  std::optional<std::string_view> whole_line();
  bool wait_for_io(std::chrono::nanoseconds wait);
  void write_some();
  void read_some();
  bool reap(std::chrono::milliseconds wait);
  void close_all();

  pid_t pid_ = -1;
  int in_ = -1, out_ = -1;  ///< the program's standard input and output
  std::string unsent_, read_;
  std::size_t sent_ = 0, taken_ = 0, searched_ = 0;
  bool closed_ = false;
  std::string ended_;
};

/// Time of this machine since any instant, for how long an answer takes. Never virtual.
std::chrono::nanoseconds elapsed();

}  // namespace drydock::process
