#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drivers/wire/dbc/catalogue.hpp"
#include "drivers/wire/dbc/plan.hpp"
#include "drivers/wire/dbc/protection.hpp"

/// What a description takes from its DBC file.
namespace drydock::wire::described {

/// A signal that counts the frames of its message.
struct CounterSignal {
  std::size_t signal = 0;
  unsigned modulus = 16;
};

/// Raw values of selectors: one of the frames in which a multiplexed message travels.
using Selection = std::vector<std::pair<std::size_t, std::int64_t>>;

/// A message of the DBC file. The signals of its fields are their `at`.
struct FrameLayout {
  explicit FrameLayout(dbc::Message of) : message(std::move(of)), plan(message) {}

  dbc::Message message;
  dbc::Plan plan;
  std::optional<dbc::Protection> checksum;
  std::optional<CounterSignal> counter;
  std::vector<Selection> turns;  ///< an emulated device sends one frame for each
  std::size_t waited_turns = 0;  ///< those that a sample waits for
  std::uint32_t shared = 0;      ///< bits of fields that come with several selections
  std::uint32_t optional = 0;    ///< bits of fields for which no sample waits
  bool joins = false;            ///< a field measures, or says whether that holds
  std::string sample;            ///< messages of one name make one measurement

  bool is_j1939() const { return message.format == dbc::FrameFormat::j1939; }
};

/// The messages stand in the order of Plan::messages.
struct FramePlan {
  explicit FramePlan(const dbc::Database& used) : catalogue(used) {
    for (const dbc::Message& message : used.messages) frames.emplace_back(message);
  }

  dbc::Catalogue catalogue;
  std::vector<FrameLayout> frames;
  std::chrono::nanoseconds longest_sample = std::chrono::milliseconds{5};
};

}  // namespace drydock::wire::described
