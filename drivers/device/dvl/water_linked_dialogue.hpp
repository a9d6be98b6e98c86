#pragma once

#include <optional>
#include <string_view>

#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/device/fixed_text.hpp"
#include "drivers/wire/dvl/water_linked.hpp"

namespace drydock::device {

/// Sets a Water Linked DVL up when its link opens: asks for the protocol's version (wcv), sets the
/// parameters that the rig names (wcs), reads all back and compares (wcc), chooses the output
/// (wcp). One command at a time; one without an answer in 1 s, one that arrived damaged (wr!) or
/// was not understood (wr?) is sent again, three times in all. A refusal (wrn), a value that does
/// not hold and a silent DVL are reported; a silent one is tried again after 30 s.
class WaterLinkedDialogue {
 public:
  explicit WaterLinkedDialogue(const std::optional<WaterLinkedSettings>& wanted)
      : wanted_(wanted) {}

  void start(Stamp now, Output& out);  ///< nothing to do without settings
  /// A recording that has no answers is not a DVL that gives none.
  void expect_no_answers(bool replayed) { replayed_ = replayed; }
  void stop() { step_ = Step::idle, due_.reset(); }
  void receive(const wire::WaterLinked::Message& message, Stamp now, Output& out);
  void tick(Stamp now, Output& out);
  std::optional<Stamp> deadline() const { return due_; }
  bool finished() const { return step_ == Step::idle; }

  /// It asked and heard nothing; it waits to ask again.
  bool unanswered() const { return finished() && due_; }

  /// Whether velocities are what the rig file says: nothing is to be set, what was read back
  /// agrees, or the DVL answers nothing at all, which was reported.
  bool settings_hold() const { return settings_hold_; }

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
  void tell(std::string_view trouble, Output& out) const;

  std::optional<WaterLinkedSettings> wanted_;
  bool nothing_to_set() const;

  Step step_ = Step::idle;
  bool settings_hold_ = true;
  bool replayed_ = false;
  int tries_ = 0;             ///< of the command under way
  std::optional<Stamp> due_;  ///< of its answer, or of the next start
  FixedText<64> command_;     ///< without checksum, for the reports
};

}  // namespace drydock::device
