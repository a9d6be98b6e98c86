#pragma once

#include <span>
#include <string_view>

#include "hil/emulate/can/nmea2000_name.hpp"

namespace drydock::emulate {

/// What a device of an NMEA 2000 bus tells about itself.
struct Nmea2000Product {
  std::string_view model;
  std::uint8_t function, device_class, preferred_address;
  std::span<const std::uint32_t> sends, takes;  ///< PGNs beside those of every device
};

/// A device on an NMEA 2000 bus. It answers requests (PGN 59904) for its product information
/// (126996), its configuration (126998) and its lists of PGNs (126464); one to its address for a
/// PGN that it does not have gets a negative acknowledgement (59392). What it sends by itself comes
/// in its time. Layouts: canboat's database of PGNs.
class Nmea2000Device : public J1939Device {
 protected:
  /// `product` must outlive the device.
  Nmea2000Device(const DeviceSetup& setup, const Nmea2000Product& product)
      : J1939Device(setup, marine_name(setup.config, product.function, product.device_class),
                    product.preferred_address),
        product_(product),
        serial_number_(identity_of(setup.config)) {}

  /// Receives any frame but a request.
  virtual void hear_message(const wire::CanFrame&, Stamp /*now*/, Wire&) {}

 private:
  void hear(const wire::CanFrame& frame, Stamp now, std::uint8_t address, Wire& out) final;
  void answer(const wire::j1939::Request& request, std::uint8_t address, Wire& out);
  void tell_product(std::uint8_t address, Wire& out);
  void tell_configuration(std::uint8_t address, Wire& out);
  void tell_lists(const wire::j1939::Identifier& id, Wire& out);

  const Nmea2000Product& product_;
  std::uint32_t serial_number_;
  std::uint8_t told_ = 0;  ///< fast packets about itself
};

}  // namespace drydock::emulate
