#pragma once

#include <string>

#include "drivers/device/timed_framer.hpp"
#include "drivers/wire/ubx/ubx_nmea.hpp"
#include "drivers/wire/ubx/ubx_settings.hpp"
#include "hil/emulate/ublox/ublox_kept.hpp"
#include "hil/emulate/ublox/ublox_owner.hpp"
#include "hil/emulate/ublox/ublox_ports.hpp"
#include "hil/emulate/ublox/ublox_settings.hpp"
#include "hil/emulate/ublox/ublox_transaction.hpp"

namespace drydock::emulate::ublox {

/// What a receiver answers to a frame that sets or asks something. `none`: no acknowledgement.
enum class Verdict : std::uint8_t { ack, nak, none };

/// The port UART1 of an emulated u-blox receiver: it answers polls, takes settings and
/// acknowledges. After a change of the baud rate the acknowledgement goes out at the old rate and
/// at the new one, since a host may listen at either. It tells the wire what it was told.
class UbloxDialogue {
 public:
  /// Both must outlive the dialogue.
  UbloxDialogue(UbloxSettings& settings, Owner& owner) : settings_(settings), owner_(owner) {}

  /// A receiver that `refuses` answers each setting with ACK-NAK.
  void receive(wire::Bytes bytes, Stamp now, bool refuses, Wire& out);

  /// Frames with a bad checksum, and bytes of no frame.
  const wire::StreamCounters& counters() const { return framer_.counters(); }

  /// The receiver has sent so much by itself.
  void count_sent(std::size_t bytes) { traffic_.bytes_out += static_cast<std::uint32_t>(bytes); }

 private:
  using Packet = wire::ubx::Packet;
  using Handler = Verdict (UbloxDialogue::*)(wire::Bytes payload);
  struct Row {
    std::uint16_t id;
    std::string_view name;
    Handler handle;
    bool only_f9 = false;
  };
  static const Row* row_of(std::uint16_t id);

  void on_frame(wire::Bytes frame);
  void on_sentence(std::string_view sentence);
  void on_packet(const Packet& packet);
  Verdict handle(const Packet& packet);
  void acknowledge(std::uint16_t id, Verdict verdict);
  void follow_baud(std::uint16_t id, Verdict verdict, std::uint64_t before);
  void tell_of(const Packet& packet, Verdict verdict);

  // The messages CFG-* of an M8, ublox_config_messages.cpp
  Verdict on_prt(wire::Bytes payload);
  Verdict on_msg(wire::Bytes payload);
  Verdict on_rate(wire::Bytes payload);
  Verdict on_nav5(wire::Bytes payload);
  Verdict on_gnss(wire::Bytes payload);
  Verdict on_sbas(wire::Bytes payload);
  Verdict on_cfg(wire::Bytes payload);
  Verdict on_rst(wire::Bytes payload);
  void answer_prt(std::uint8_t port);
  Verdict set_ports(wire::Bytes payload);
  bool allows_port(wire::Bytes payload) const;
  void set_port(wire::Bytes payload);

  // The configuration database of an F9, ublox_values.cpp
  Verdict on_valget(wire::Bytes payload);
  Verdict on_valset(wire::Bytes payload);
  Verdict on_valdel(wire::Bytes payload);
  Verdict change(wire::Bytes payload, Transaction::Kind kind);
  Verdict apply(const Transaction::Changes& changes, std::uint8_t layers);
  Verdict refuse(std::string why);

  Verdict on_ver(wire::Bytes payload);    // ublox_status.cpp
  Verdict on_io(wire::Bytes payload);     // ublox_ports.cpp
  Verdict on_comms(wire::Bytes payload);  // ublox_ports.cpp
  Verdict on_kept(const Packet& packet);

  // Sentences $PUBX, ublox_sentences.cpp
  void on_pubx_rate(std::string_view fields);
  void on_pubx_port(std::string_view fields);

  /// Takes the value into RAM. False: it is not allowed.
  bool put(std::size_t item, std::uint64_t value);
  void reply(std::uint16_t id, wire::Bytes payload);
  void send(wire::Bytes frame);

  UbloxSettings& settings_;
  Transaction transaction_;
  KeptMessages kept_;
  PortTraffic traffic_;
  Owner& owner_;
  device::TimedFramer<wire::UbxNmea::max_frame> framer_;
  Wire* out_ = nullptr;  ///< valid during receive()
  bool refuses_ = false;
  bool changed_ = false;  ///< the present frame has changed a value
  std::string note_;      ///< what the present frame says, in words
  std::array<std::uint8_t, 1024> bytes_{};
};

}  // namespace drydock::emulate::ublox
