#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "estimators/external/hello.hpp"

namespace drydock::external {

/// How an estimator in another program is started and spoken to.
struct ClientOptions {
  std::vector<std::string> command;
  std::string folder;  ///< the program's working folder
  Hello hello;
  /// A later answer is late. After five times as long without one the program is given up.
  std::chrono::nanoseconds answer_within = std::chrono::seconds{2};
  std::function<void(const std::string&)> say;  ///< the first fault of each sort, as a line
};

}  // namespace drydock::external
