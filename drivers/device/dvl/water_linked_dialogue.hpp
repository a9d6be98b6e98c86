#pragma once

#include <optional>
#include <string_view>

#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/device/fixed_text.hpp"
#include "drivers/wire/dvl/water_linked.hpp"

namespace drydock::device {

/// Sets up a Water Linked DVL when its link opens. It asks for the protocol's version (wcv), sets
/// the parameters that the rig names (wcs), reads them all back and compares (wcc), and selects the
/// output (wcp). It sends one command at a time. It sends a command again if there is no answer in
/// 1 s, if it arrived damaged (wr!) or if it was not understood (wr?), three times in all. It
/// reports a refusal (wrn), a value that does not hold and a silent DVL. It tries a silent DVL
/// again after 30 s.
class WaterLinkedDialogue {
 public:
  explicit WaterLinkedDialogue(const std::optional<WaterLinkedSettings>& wanted)
      : wanted_(wanted) {}

  void start(Stamp now, Output& out);  ///< without settings it does nothing
  /// A recording has no answers to new questions. That is not the fault of the DVL.
  void expect_no_answers(bool replayed) { replayed_ = replayed; }
  void stop();
  void receive(const wire::WaterLinked::Message& message, Stamp now, Output& out);
  void tick(Stamp now, Output& out);
  std::optional<Stamp> deadline() const { return due_; }
  bool finished() const { return step_ == Step::idle || gave_up_; }

  /// True if it asked without an answer and waits to ask again.
  bool unanswered() const { return gave_up_; }

  /// True if velocities are as the rig file says: nothing is to be set, the values read back agree,
  /// or the DVL never answers (which was reported).
  bool settings_hold() const { return settings_hold_; }

  /// That the DVL uses, as read from it. Empty until it was read.
  std::optional<double> sound_speed_mps() const { return sound_speed_mps_; }

 private:
  enum class Step : std::uint8_t { version, set, check, output, idle };

  void on(const wire::water_linked::Version& version, Stamp now, Output& out);
  void on(const wire::water_linked::Configuration& read, Stamp now, Output& out);
  void on(const wire::water_linked::Answer& answer, Stamp now, Output& out);
  template <class Other>
  void on(const Other&, Stamp, Output&) {}

  void next(Stamp now, Output& out);
  void ask(Stamp now, Output& out);
  std::size_t write_command(std::span<std::uint8_t> to) const;
  void ask_again_or(std::string_view trouble, Stamp now, Output& out);
  Reason in_words(std::string_view trouble) const;
  void tell(std::string_view trouble, Output& out) const { out.report(in_words(trouble).view()); }

  std::optional<WaterLinkedSettings> wanted_;

  Step step_ = Step::idle;
  bool settings_hold_ = true;
  bool replayed_ = false;
  bool gave_up_ = false;  ///< the step was not answered; a late answer still counts
  Reason refusal_;        ///< of wcs; empty: none
  std::optional<double> sound_speed_mps_;
  int tries_ = 0;             ///< attempts of the current command
  std::optional<Stamp> due_;  ///< time limit of its answer, or time of the next start
  FixedText<64> command_;     ///< without checksum, for reports
};

}  // namespace drydock::device
