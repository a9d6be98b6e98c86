#pragma once

#include <optional>
#include <vector>

#include "drivers/device/described/described_dialogue.hpp"
#include "drivers/device/described/joined_messages.hpp"
#include "drivers/device/described/publish_measured.hpp"
#include "drivers/device/stream_driver.hpp"
#include "drivers/wire/described/codec.hpp"

namespace drydock::device {

/// The driver of every sensor that a file describes. A message with a field of a measurement
/// becomes a measurement. A damaged or undescribed content is told; it is never a value.
class DescribedDriver final
    : public StreamDriver<wire::described::longest_frame, wire::described::Scanner> {
 public:
  explicit DescribedDriver(const DriverOptions& options);

  void restart(Stamp now, Output& out) override;
  void tick(Stamp now, Output& out) override;
  std::optional<Stamp> deadline() const override;

 private:
  void on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) override;
  void publish(const Arrival& arrival, Output& out);
  void join(const Arrival& arrival, Output& out);
  /// True if the message that was read says what another one has just said.
  bool repeats(Stamp at);

  DriverOptions options_;
  const wire::described::Description& description_;
  DescribedDialogue dialogue_;
  wire::described::Record record_;
  wire::described::Readings readings_;
  JoinedMessages joined_;
  MeasuredPublisher publisher_;
  std::vector<std::optional<Stamp>> heard_at_;  ///< of each message
};

}  // namespace drydock::device
