#pragma once

#include <boost/asio/awaitable.hpp>
#include <memory>
#include <string>

#include "drivers/io/signal.hpp"
#include "drivers/link/clock.hpp"
#include "drivers/link/link.hpp"
#include "hil/emulate/can_pacer.hpp"
#include "hil/emulate/line_pacer.hpp"
#include "hil/emulate/line_sharers.hpp"
#include "hil/emulate/real_time/real_time.hpp"

namespace drydock::emulate {

/// Serves one link in real time. One coroutine sends what is due, another listens to the drivers.
/// Both keep the runner alive until they end.
class Runner : public std::enable_shared_from_this<Runner> {
 public:
  Runner(boost::asio::io_context& io, RealTimeEmulator::OnWritten on_written);
  virtual ~Runner() = default;

  void start();
  void stop();
  void wake() { clock_->notify(); }  ///< call it when the deadline may be earlier
  virtual RealTimeEmulator::Counters counters() const { return counters_; }
  virtual void set_on_told(const RealTimeEmulator::OnTold&) {}

 protected:
  using Coroutine = boost::asio::awaitable<void>;

  virtual Coroutine listen() = 0;             ///< runs until the link is closed
  virtual Coroutine send_due(Stamp now) = 0;  ///< lets devices act and writes what is due
  virtual std::optional<Stamp> deadline() const = 0;
  virtual void close() = 0;

  void note_time(Stamp should, Stamp is);
  void note_written(const boost::system::result<void>& result, const std::string& device,
                    bool whole_message, const Passage& passage);

  /// Devices act at the time that they asked for, so late wake-ups do not shift their messages.
  /// After a stall they catch up at once, and the pacer drops what the line could not have carried.
  void let_act(EmulatedDevice& device, Stamp now, Wire& wire, Stamp& wire_time);

  const boost::asio::any_io_executor executor_;
  bool stopped_ = false;

 private:
  Coroutine keep_pace();

  std::shared_ptr<io::Signal> clock_;  ///< wakes at the deadline
  RealTimeEmulator::OnWritten on_written_;
  RealTimeEmulator::Counters counters_;
};

/// The byte devices at the end of a paced line. Its port may go and come back.
class LineRunner final : public Runner, private Wire {
 public:
  LineRunner(boost::asio::io_context& io, link::Uri uri, RealTimeEmulator::OnWritten on_written,
             std::unique_ptr<link::ByteLink> line);

  void add(std::string name, std::unique_ptr<EmulatedDevice> device) {
    devices_.add(std::move(name), std::move(device));
  }

  RealTimeEmulator::Counters counters() const override;
  void set_on_told(const RealTimeEmulator::OnTold& hook) override { on_told_ = hook; }

 private:
  Coroutine listen() override;
  Coroutine send_due(Stamp now) override;
  std::optional<Stamp> deadline() const override;
  void close() override;

  Coroutine hear();  ///< runs until the port goes
  void receive(wire::Bytes bytes, Stamp at);
  Coroutine plug_in();  ///< runs when the port may come back
  void lose_line();

  void send(wire::Bytes bytes) override { send_to(every_client, bytes); }
  void send(const wire::CanFrame&) override {}  // a serial line carries no frames
  void send_to(Client client, wire::Bytes bytes) override {
    pacer_.queue(bytes, wire_time_, devices_.sampled_at(), client, devices_.sender());
  }
  Client speaker() const override { return speaker_; }
  unsigned line_baud() const override { return uri_.line_rate().value_or(0).baud; }
  void set_baud(unsigned baud) override;
  void tell(std::string_view what) override { on_told_(devices_.name_of(devices_.sender()), what); }
  /// The rate that the other end has set, if it differs from the device's own.
  std::optional<unsigned> other_rate(unsigned own) const;
  void unplug() override;
  void plug() override;

  link::Uri uri_;
  LineSharers devices_;
  LinePacer pacer_;
  std::shared_ptr<link::ByteLink> line_;  ///< null: the port is gone
  Client speaker_ = every_client;         ///< of what was read last
  bool plugged_ = true;
  bool knows_its_rate_ = false;  ///< the device has said its baud rate
  RealTimeEmulator::OnTold on_told_ = [](std::string_view, std::string_view) {};
  std::uint64_t not_taken_ = 0;       ///< bytes, on the lines before this one
  std::shared_ptr<io::Signal> port_;  ///< notified when plugged_ has changed
  Stamp wire_time_{};
};

/// The nodes of one CAN bus. Its interface may be set down and up again.
class BusRunner final : public Runner {
 public:
  BusRunner(boost::asio::io_context& io, link::Uri uri, RealTimeEmulator::OnWritten on_written,
            std::unique_ptr<link::FrameLink> bus);
  ~BusRunner() override;

  void add(std::string name, std::unique_ptr<EmulatedDevice> device);
  RealTimeEmulator::Counters counters() const override;
  void set_on_told(const RealTimeEmulator::OnTold& hook) override { on_told_ = hook; }

 private:
  struct Node;

  Coroutine listen() override;
  Coroutine send_due(Stamp now) override;
  std::optional<Stamp> deadline() const override;
  void close() override;

  Coroutine hear();  ///< runs until the interface goes
  void receive(const wire::CanFrame& frame, Stamp at);
  Coroutine open_again();  ///< tries it once
  void deliver(const wire::CanFrame& frame, Stamp at, int sender);

  link::Uri uri_;
  CanPacer pacer_;
  int cut_off_by_ = 0;  ///< number of nodes whose faults make the drivers' controller bus-off
  std::shared_ptr<link::FrameLink> bus_;  ///< null: the interface is down or gone
  std::shared_ptr<io::Signal> closed_;
  std::vector<std::unique_ptr<Node>> nodes_;
  RealTimeEmulator::OnTold on_told_ = [](std::string_view, std::string_view) {};
};

}  // namespace drydock::emulate
