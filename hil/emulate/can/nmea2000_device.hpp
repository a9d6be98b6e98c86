#pragma once

#include <span>
#include <string_view>

#include "drivers/wire/nmea2000/group_function.hpp"
#include "hil/emulate/can/nmea2000_name.hpp"

namespace drydock::emulate {

constexpr std::uint32_t heartbeat_pgn = 126993;

/// What a device of an NMEA 2000 bus tells about itself.
struct Nmea2000Product {
  std::string_view model;
  std::uint8_t function, device_class, preferred_address;
  std::span<const std::uint32_t> sends, takes;  ///< PGNs beside those of every device
};

/// A device on an NMEA 2000 bus. It answers requests (PGN 59904) for its product information
/// (126996), its configuration (126998) and its lists of PGNs (126464); one to its address for a
/// PGN that it does not have gets a negative acknowledgement (59392). What it sends by itself comes
/// in its time. It sends a heartbeat (126993), whose interval a group function (126208) sets, and
/// acknowledges every other group function as refused. Layouts: canboat's database of PGNs.
class Nmea2000Device : public J1939Device {
 public:
  std::optional<Stamp> deadline() const final;
  void tick(Stamp now, Wire& out) final;

 protected:
  /// `product` must outlive the device.
  Nmea2000Device(const DeviceSetup& setup, const Nmea2000Product& product)
      : J1939Device(setup, marine_name(setup.config, product.function, product.device_class),
                    product.preferred_address),
        product_(product),
        serial_number_(identity_of(setup.config)),
        next_heartbeat_(setup.boot + heartbeat_interval_) {}

  /// Receives any frame but a request.
  virtual void hear_message(const wire::CanFrame&, Stamp /*now*/, Wire&) {}

 private:
  void hear(const wire::CanFrame& frame, Stamp now, std::uint8_t address, Wire& out) final;
  void answer(const wire::j1939::Request& request, std::uint8_t address, Wire& out);
  bool knows(std::uint32_t pgn) const;
  void hear_group_function(const wire::j1939::Identifier& id, wire::Bytes payload, Stamp now,
                           std::uint8_t address, Wire& out);
  wire::nmea2000::GroupAcknowledgement obey_request(const wire::nmea2000::GroupFunction& group,
                                                    const wire::j1939::Identifier& id, Stamp now,
                                                    Wire& out);
  std::uint8_t set_heartbeat(std::uint32_t interval_ms, Stamp now);
  void send_heartbeat(std::uint8_t address, Wire& out);
  void tell_product(std::uint8_t address, Wire& out);
  void tell_configuration(std::uint8_t address, Wire& out);
  void tell_lists(const wire::j1939::Identifier& id, Wire& out);

  const Nmea2000Product& product_;
  std::uint32_t serial_number_;
  std::uint8_t told_ = 0;  ///< fast packets about itself
  wire::FastPacketAssembler groups_;
  std::chrono::milliseconds heartbeat_interval_{60000};
  Stamp next_heartbeat_;
  std::uint64_t heartbeats_ = 0;  ///< sent
};

}  // namespace drydock::emulate
