#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace drydock::decode {

/// The times of files that follow each other. A file that counts from its own start goes on behind
/// the last time before; one whose dates lie before those in front of it stays as it is. Notes say
/// which.
class FollowingTimes {
 public:
  void begin_file(const std::string& name);
  std::chrono::nanoseconds of(std::chrono::nanoseconds written);
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  std::string name_;
  bool at_begin_ = false;
  std::chrono::nanoseconds latest_{0}, moved_{0};
  std::vector<std::string> notes_;
};

}  // namespace drydock::decode
