#pragma once

#include <boost/system/result.hpp>
#include <memory>
#include <variant>

#include "drivers/device/driver.hpp"
#include "drivers/device/make_driver.hpp"
#include "drivers/measurement/message_time.hpp"

namespace drydock::device {

/// The times of a recording's messages. Empty if the protocol does not tell the device's time, or
/// if its clock jumps too often to be one.
struct RecordedTimes {
  measurement::MessageTimes messages;
  std::chrono::nanoseconds usual_step{0};  ///< from one to the next, the median
  std::size_t jumps = 0;  ///< of the clock, backward or by more than a day: taken as a usual step
};

/// What a driver publishes of a recording whose bytes, or frames, come one every `place`.
class PlacedOutput final : public Output {
 public:
  struct Told {
    std::uint64_t through = 0;         ///< as MessageTime
    std::chrono::nanoseconds clock{};  ///< that the device tells
    std::chrono::nanoseconds age{};    ///< from the time of validity to the end of the message
  };

  explicit PlacedOutput(std::chrono::nanoseconds place) : place_(place) {}
  void publish(const Measurement& measurement) override;
  void send(wire::Bytes) override {}
  void send(const wire::CanFrame&) override {}

  const std::vector<Told>& told() const { return told_; }  ///< of messages that tell a time
  const std::vector<std::uint64_t>& places() const { return places_; }  ///< of all messages

 private:
  std::chrono::nanoseconds place_;
  std::vector<Told> told_;
  std::vector<std::uint64_t> places_;
};

/// Runs a driver over a recording without times and reads the device's clock in what it publishes.
/// Each byte, or frame, counts as 10 ns, so received_at tells the place of a message. A message was
/// sent at the time that its device tells, plus its age. A second driver reads bytes on a line of
/// half the rate: by how much older its messages are is the part of their age that bytes took.
class ClockReader final {
 public:
  /// Fails if no driver speaks the protocol for this kind of sensor.
  static boost::system::result<ClockReader, DriverError> make(DriverOptions options,
                                                              Travels travels);

  void feed(wire::Bytes bytes);  ///< of a device on a byte link
  void feed(const wire::CanFrame& frame);
  /// The recording is at its end.
  RecordedTimes finish();
  /// Where its messages ended, those that tell no time too: bytes or frames, rising.
  const std::vector<std::uint64_t>& places() const { return output_.places(); }

 private:
  using AnyDriver = std::variant<std::unique_ptr<ByteDriver>, std::unique_ptr<FrameDriver>>;

  ClockReader(AnyDriver driver, std::unique_ptr<ByteDriver> slow);

  AnyDriver driver_;
  std::unique_ptr<ByteDriver> slow_;  ///< on a line of half the rate; null: frames
  Stamp now_{};
  PlacedOutput output_, slow_output_;
};

/// Makes of what a clock told times that never fall. A time of day and a time of week may begin
/// anew; a fall below half a usual step and 0.1 s is one of rounding and no jump. A clock that
/// tells hardly a step forward is none.
RecordedTimes times_in_order(const measurement::MessageTimes& told);

}  // namespace drydock::device
