#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "drivers/wire/dbc/reader.hpp"

namespace drydock::wire::dbc {

/// Collects what is wrong or doubtful, up to a bound.
class Remarks {
 public:
  explicit Remarks(Reading& reading) : reading_(reading) {}

  void error(Place at, std::string text) { add(reading_.errors, {at, std::move(text)}); }
  void warn(Place at, std::string text) { add(reading_.warnings, {at, std::move(text)}); }
  void in_order_of_lines() {
    for (auto* list : {&reading_.errors, &reading_.warnings})
      std::ranges::stable_sort(*list, {}, [](const Remark& r) { return r.at.line; });
  }

 private:
  void add(std::vector<Remark>& list, Remark remark) {
    if (list.size() < most_remarks) {
      list.push_back(std::move(remark));
    } else {
      ++reading_.remarks_left_out;
    }
  }

  Reading& reading_;
};

}  // namespace drydock::wire::dbc
