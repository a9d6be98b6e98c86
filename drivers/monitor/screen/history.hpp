#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

namespace drydock::monitor {

/// One value over time. The numbers are its components, as in ShownValue.
struct Sampled {
  double at_s = 0;
  std::vector<double> numbers;
};

/// The values of the last five minutes, taken whenever the screen is drawn.
class History {
 public:
  static constexpr double kept_s = 300;

  /// `value`: its name. Equal names of one device are told apart by the caller.
  void add(const std::string& device, const std::string& value, Sampled sample);
  const std::deque<Sampled>& of(const std::string& device, const std::string& value) const;

 private:
  std::map<std::pair<std::string, std::string>, std::deque<Sampled>> values_;
};

}  // namespace drydock::monitor
