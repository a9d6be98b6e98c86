#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drivers/text/json_text.hpp"
#include "estimators/pipeline/peer.hpp"

namespace drydock::external {

/// Writes steps as lines of JSON. After the first steps it allocates nothing.
class StepLines {
 public:
  /// `devices`: their names, by index. Must outlive the object.
  explicit StepLines(const std::vector<std::string>& devices) : devices_(devices) {}

  /// Without the end of the line; good until the next call.
  std::string_view line_of(const pipeline::Step& step);

 private:
  const std::vector<std::string>& devices_;
  text::JsonText text_{std::size_t{64} * 1024};
};

}  // namespace drydock::external
