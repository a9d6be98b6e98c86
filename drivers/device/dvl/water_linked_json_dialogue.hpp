#pragma once

#include <optional>
#include <string_view>

#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/device/fixed_text.hpp"
#include "drivers/wire/dvl/water_linked_json.hpp"

namespace drydock::device {

/// Sets up a Water Linked DVL over TCP when its link opens: set_config with what the rig names,
/// then get_config, whose values it compares. It sends one command at a time, because the DVL takes
/// all that comes in one read as one document. It sends a command again if there is no answer in 1
/// s, three times in all. It reports a refusal, a value that does not hold and a silent DVL. It
/// tries a silent DVL again after 30 s.
class WaterLinkedJsonDialogue {
 public:
  explicit WaterLinkedJsonDialogue(const std::optional<WaterLinkedSettings>& wanted)
      : wanted_(wanted) {}

  void start(Stamp now, Output& out);  ///< without settings it does nothing
  /// A recording has no answers to new questions. That is not the fault of the DVL.
  void expect_no_answers(bool replayed) { replayed_ = replayed; }
  void receive(const wire::water_linked_json::Response& answer, Stamp now, Output& out);
  void tick(Stamp now, Output& out);
  std::optional<Stamp> deadline() const { return due_; }
  /// True if it asked without an answer and waits to ask again.
  bool unanswered() const { return gave_up_; }

  /// True if velocities are as the rig file says: nothing is to be set, the values read back agree,
  /// or the DVL never answers (which was reported).
  bool settings_hold() const { return settings_hold_; }

  /// That the DVL uses, as read from it. Empty until it was read.
  std::optional<double> sound_speed_mps() const { return sound_speed_mps_; }

 private:
  enum class Step : std::uint8_t { set, check, idle };

  void go_to(Step step, Stamp now, Output& out);
  void ask(Stamp now, Output& out);
  std::string_view command() const;
  void compare(const wire::water_linked_json::Response& answer, Output& out);
  Reason in_words(std::string_view trouble, std::string_view why = {}) const;

  std::optional<WaterLinkedSettings> wanted_;
  Step step_ = Step::idle;
  bool settings_hold_ = true;
  bool replayed_ = false;
  bool gave_up_ = false;  ///< the step was not answered; a late answer still counts
  Reason refusal_;        ///< of set_config; empty: none
  std::optional<double> sound_speed_mps_;
  int tries_ = 0;             ///< attempts of the current command
  std::optional<Stamp> due_;  ///< time limit of its answer, or time of the next start
};

}  // namespace drydock::device
