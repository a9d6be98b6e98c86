#pragma once

#include <span>
#include <string_view>

#include "drivers/wire/nmea2000/group_function.hpp"
#include "hil/emulate/can/nmea2000_intervals.hpp"
#include "hil/emulate/can/nmea2000_name.hpp"
#include "hil/emulate/can/nmea2000_pairs.hpp"
#include "hil/emulate/can/nmea2000_settings.hpp"

namespace drydock::emulate {

constexpr std::uint32_t heartbeat_pgn = 126993, lists_pgn = 126464, product_pgn = 126996,
                        configuration_pgn = 126998;

/// What a device of an NMEA 2000 bus tells about itself.
struct Nmea2000Product {
  std::string_view model;
  std::uint8_t function, device_class, preferred_address;
  std::span<const std::uint32_t> sends, takes;  ///< PGNs beside those of every device
};

/// A device on an NMEA 2000 bus. It answers requests (PGN 59904) for its product information
/// (126996), its configuration (126998) and its lists of PGNs (126464); one to its address for a
/// PGN that it does not have gets a negative acknowledgement (59392). What it sends by itself comes
/// in its time. It sends a heartbeat (126993). By a group function (126208) another node asks for a
/// PGN that has certain values, sets intervals and priorities, describes the installation, and
/// gives the device its instances; everything else is acknowledged as refused. What a device was
/// told so it says to the bench. Layouts: canboat's database of PGNs.
class Nmea2000Device : public J1939Device {
 public:
  std::optional<Stamp> deadline() const final;
  void tick(Stamp now, Wire& out) final;

 protected:
  /// `product` must outlive the device.
  Nmea2000Device(const DeviceSetup& setup, const Nmea2000Product& product)
      : J1939Device(setup,
                    settings_in(*setup.memory)
                        .in(marine_name(setup.config, product.function, product.device_class)),
                    product.preferred_address),
        product_(product),
        plain_name_(marine_name(setup.config, product.function, product.device_class)),
        serial_number_(identity_of(setup.config)),
        memory_(setup.memory),
        settings_(settings_in(*setup.memory)),
        intervals_(product.sends, measurement::from_seconds(1 / setup.config.rate_hz)),
        next_heartbeat_(setup.boot + heartbeat_interval_) {}

  /// Sends a sample of the truth at `at` from the device's address.
  virtual void measure(Stamp at, std::uint8_t address, Wire& out) = 0;

  /// Receives any frame but a request.
  virtual void hear_message(const wire::CanFrame&, Stamp /*now*/, Wire&) {}

 private:
  using Group = wire::nmea2000::GroupFunction;
  using Answer = wire::nmea2000::GroupAcknowledgement;

  void report(Stamp at, std::uint8_t address, Wire& out) final {
    IntervalWire chosen(out, intervals_, at);
    measure(at, address, chosen);
  }
  void hear(const wire::CanFrame& frame, Stamp now, std::uint8_t address, Wire& out) final;
  void answer(const wire::j1939::Request& request, std::uint8_t address, Wire& out);
  bool knows(std::uint32_t pgn) const;
  void hear_group_function(const wire::j1939::Identifier& id, wire::Bytes payload, Stamp now,
                           std::uint8_t address, Wire& out);
  void obey_request(const Group& group, const wire::j1939::Identifier& id, Stamp now, Wire& out,
                    Answer& answer);
  void obey_command(const Group& group, Wire& out, Answer& answer);
  void acknowledge(const Answer& answer, std::uint8_t asker, std::uint8_t address, Wire& out);
  std::vector<Nmea2000Field> fields_of(std::uint32_t pgn) const;
  Nmea2000Pairs pairs_of(const Group& group, Wire& out) const;
  std::uint8_t set_interval(const Group& group, Stamp now, Wire& out);
  std::uint8_t set_heartbeat(const Group& group, Stamp now);
  std::uint8_t set_priority(const Group& group, Wire& out);
  void set_descriptions(Nmea2000Pairs& pairs, Wire& out);
  void set_instances(Nmea2000Pairs& pairs, Wire& out);
  void send_heartbeat(std::uint8_t address, Wire& out);
  std::vector<std::uint8_t> product_message() const;
  std::vector<std::uint8_t> configuration_message() const;
  void tell_product(std::uint8_t address, Wire& out);
  void tell_configuration(std::uint8_t address, Wire& out);
  /// `which`: 0 the PGNs that it sends, 1 those that it takes; empty: both.
  void tell_lists(const wire::j1939::Identifier& id, std::optional<std::uint8_t> which, Wire& out);

  const Nmea2000Product& product_;
  std::uint64_t plain_name_;  ///< its NAME without instances
  std::uint32_t serial_number_;
  std::shared_ptr<Memory> memory_;
  Nmea2000Settings settings_;
  bool renamed_ = false;  ///< its NAME has changed, and it has not claimed its address yet
  Nmea2000Intervals intervals_;
  std::uint8_t told_ = 0;  ///< fast packets about itself
  wire::FastPacketAssembler groups_;
  std::chrono::milliseconds heartbeat_interval_{60000};
  Stamp next_heartbeat_;
  std::uint64_t heartbeats_ = 0;  ///< sent
};

}  // namespace drydock::emulate
