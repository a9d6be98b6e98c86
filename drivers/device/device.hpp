#pragma once

#include <boost/system/result.hpp>
#include <memory>
#include <string>
#include <variant>

#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/device/health.hpp"
#include "drivers/device/make_driver.hpp"
#include "drivers/device/news.hpp"
#include "drivers/device/rate_meter.hpp"

namespace drydock::device {

class Device;

/// Receives the measurements and states of the devices. The shell that runs the devices makes the
/// calls.
class Listener {
 public:
  virtual ~Listener() = default;
  virtual void on_measurement(const Measurement& measurement) = 0;
  /// Called for a change of state that is news. `change.from` is the last state that was reported.
  virtual void on_state(const Device& device, const Transition& change) = 0;
};

/// Takes the data that a driver sends to its sensor.
class Transmitter {
 public:
  virtual ~Transmitter() = default;
  virtual void send(wire::Bytes bytes) = 0;
  virtual void send(const wire::CanFrame& frame) = 0;
};

struct DeviceOptions {
  std::string name;
  std::string link;  ///< URI; the shell uses it
  DriverOptions driver;
  LifeCycleOptions life_cycle;
  double nominal_rate_hz = 0;
};

/// One sensor of the rig: its driver, its life cycle, its health. Sans-I/O: a shell opens the link
/// if wants_open(), passes on the data that arrive, and calls tick() at deadline().
class Device final : private Output {
 public:
  /// Fails if no driver speaks the protocol for this kind of sensor.
  static boost::system::result<std::unique_ptr<Device>, DriverError> make(DeviceOptions options);

  /// Both must outlive the device. Call it once, before start().
  void connect(Listener& listener, Transmitter& transmitter);

  /// From now on it discards all data that its driver wants to send.
  void listen_only() { listens_only_ = true; }
  bool listens_only() const { return listens_only_; }
  /// Its link has other devices too: only the silence of all opens it again. The shell calls
  /// give_up() then.
  void share_link() { life_cycle_.share_link(); }
  std::optional<Stamp> gives_up_at() const { return life_cycle_.gives_up_at(); }
  void give_up(Stamp now) { tell(life_cycle_.give_up(now)); }

  void start(Stamp now);
  void opened(Stamp now, measurement::Provenance provenance);
  void set_baud(unsigned baud);        ///< call it before opened() if the shell searches the rate
  void set_bitrate(unsigned bitrate);  ///< call it before opened() if the link knows the bus's rate
  void open_failed(Stamp now, std::string_view reason);
  void link_lost(Stamp now, std::string_view reason);
  void stop(Stamp now, std::string_view reason = "stopped");
  /// The recording that feeds it has nothing more. It closes where it would have become stale.
  void end_of_recording(Stamp now);

  void receive(wire::Bytes bytes, Stamp at);  ///< `at`: arrival of the last byte
  void receive(const wire::CanFrame& frame, Stamp at);
  void tick(Stamp now);
  /// The host's clock was changed by `step` and now shows `now`. The driver begins anew, as after
  /// opening: its knowledge of the device's clock and its time limits refer to the old time.
  void clock_stepped(std::chrono::nanoseconds step, Stamp now);
  /// By how much the host's clock was set in all.
  std::chrono::nanoseconds clock_moved() const { return clock_moved_; }
  std::optional<Stamp> deadline() const;

  State state() const { return life_cycle_.state(); }
  bool wants_open() const { return life_cycle_.wants_open(); }
  bool wants_close() const { return life_cycle_.wants_close(); }
  bool on_bus() const { return std::holds_alternative<std::unique_ptr<FrameDriver>>(driver_); }
  Travels travels() const { return on_bus() ? Travels::as_frames : Travels::as_bytes; }
  const DeviceOptions& options() const { return options_; }
  const std::string& name() const { return options_.name; }
  std::uint16_t index() const { return options_.driver.device; }

  std::uint64_t messages() const { return messages_; }
  Health health(Stamp now) const;
  Vitals vitals() const;
  void note_dropped(std::uint64_t total) { can_dropped_ = total; }  ///< FrameLink::dropped()
  void note_link(std::string_view note) { link_note_ = note; }      ///< FrameLink::note()

 private:
  using AnyDriver = std::variant<std::unique_ptr<ByteDriver>, std::unique_ptr<FrameDriver>>;

  Device(DeviceOptions options, AnyDriver driver);

  void publish(const Measurement& measurement) override;
  void send(wire::Bytes bytes) override;
  void send(const wire::CanFrame& frame) override;
  void report(std::string_view trouble) override { note_error(trouble, now_); }
  void refuse(std::string_view why, Refusal because) override;

  const RateMeter* fastest() const;  ///< null: none has a rate, or nothing streams
  void finish(Stamp now);            ///< frames that wait in the driver come out
  Driver& driver() const;
  void tell(const LifeCycle::Change& change);
  void note_error(std::string_view what, Stamp at);

  DeviceOptions options_;
  AnyDriver driver_;
  LifeCycle life_cycle_;
  News news_;
  Listener* listener_ = nullptr;
  Transmitter* transmitter_ = nullptr;
  bool listens_only_ = false;
  Stamp now_{};  ///< time of the current call
  std::chrono::nanoseconds clock_moved_{0};
  std::array<RateMeter, 4> rates_;
  std::uint64_t messages_ = 0;
  std::optional<Stamp> last_message_at_;
  Reason last_error_;
  std::optional<Stamp> last_error_at_;
  std::uint64_t errors_ = 0;
  Reason left_out_;
  Reason link_note_;
  std::uint64_t can_dropped_ = 0;
  std::uint64_t error_frames_ = 0;
  std::uint64_t refused_ = 0, impossible_ = 0, bytes_not_text_ = 0;
};

}  // namespace drydock::device
