#include "drivers/wire/bytes.hpp"

#include "drivers/recordings/export/exporter.hpp"
#include "drivers/recordings/export/output_file.hpp"
#include "drivers/wire/text_bytes.hpp"

namespace drydock::exporting {

namespace {

using Block = std::vector<std::uint8_t>;

template <class Number>
void put_le(Block& block, Number value) {
  block.resize(block.size() + sizeof value);
  wire::store_le<Number>(block, block.size() - sizeof value, value);
}

template <class Number>
void put_be(Block& block, Number value) {
  block.resize(block.size() + sizeof value);
  wire::store_be<Number>(block, block.size() - sizeof value, value);
}

void put(Block& block, wire::Bytes bytes) { block.insert(block.end(), bytes.begin(), bytes.end()); }

void pad(Block& block) { block.resize((block.size() + 3) / 4 * 4); }

void put_option(Block& block, std::uint16_t code, wire::Bytes value) {
  put_le(block, code);
  put_le(block, static_cast<std::uint16_t>(value.size()));
  put(block, value);
  pad(block);
}

/// LINKTYPE_CAN_SOCKETCAN: identifier with flags (big endian), length, CAN FD flags, two zeros,
/// data.
void put_frame(Block& packet, const wire::CanFrame& frame) {
  constexpr std::uint32_t extended = 0x80000000, remote = 0x40000000, error = 0x20000000;
  constexpr std::uint8_t bit_rate_switch = 0x01, fd = 0x04;
  put_be<std::uint32_t>(packet, frame.id | (frame.extended ? extended : 0u) |
                                    (frame.remote ? remote : 0u) | (frame.error ? error : 0u));
  packet.push_back(frame.size);
  packet.push_back(static_cast<std::uint8_t>((frame.fd ? fd : 0) |
                                             (frame.bit_rate_switch ? bit_rate_switch : 0)));
  put_be<std::uint16_t>(packet, 0);
  if (!frame.remote) put(packet, frame.payload());
}

/// LINKTYPE_RTAC_SERIAL: seconds, microseconds (big endian), event, state of the control lines,
/// footer, data.
void put_serial(Block& packet, const RawBytes& raw) {
  constexpr std::uint8_t sent = 1, received = 2;
  const auto ns = static_cast<std::uint64_t>(raw.at.time_since_epoch().count());
  put_be(packet, static_cast<std::uint32_t>(ns / 1'000'000'000));
  put_be(packet, static_cast<std::uint32_t>(ns % 1'000'000'000 / 1000));
  packet.push_back(raw.direction == record::Direction::sent ? sent : received);
  packet.push_back(0);  // not recorded
  put_be<std::uint16_t>(packet, 0);
  put(packet, raw.data);
}

/// Wireshark's format (IETF draft-ietf-opsawg-pcapng). Each link is one interface; buses and serial
/// lines are in one file; times are in nanoseconds.
class Pcapng final : public Exporter {
 public:
  Pcapng(const std::vector<RecordedLink>& links, const Target& to) : file_(to.path, to.overwrite) {
    write(section_block, [](Block& body) {
      put_le<std::uint32_t>(body, 0x1A2B3C4D);
      put_le<std::uint32_t>(body, 1);  // version 1.0
      put_le<std::int64_t>(body, -1);  // length unknown
      put_option(body, 4, wire::bytes_of("drydock"));
      put_option(body, 0, {});
    });
    for (const auto& link : links) write_interface(link);
  }

  void on_bytes(const RawBytes& raw, std::size_t link) override {
    packet_.clear();
    put_serial(packet_, raw);
    write_packet(link, raw);
  }
  void on_frame(const RawFrame& raw, std::size_t link) override {
    packet_.clear();
    put_frame(packet_, raw.frame);
    write_packet(link, raw);
  }
  void finish() override { file_.close(); }
  std::string error() const override { return file_.error(); }

 private:
  static constexpr std::uint32_t section_block = 0x0A0D0D0A, interface_block = 1, packet_block = 6;

  template <class Body>
  void write(std::uint32_t type, Body body) {
    block_.clear();
    put_le(block_, type);
    put_le<std::uint32_t>(block_, 0);
    body(block_);
    pad(block_);
    const auto size = static_cast<std::uint32_t>(block_.size() + sizeof(std::uint32_t));
    wire::store_le<std::uint32_t>(block_, 4, size);
    put_le(block_, size);
    file_.write(block_);
  }

  void write_interface(const RecordedLink& link) {
    constexpr std::uint16_t can_socketcan = 227, rtac_serial = 250;
    constexpr std::uint16_t name = 2, description = 3, time_resolution = 9;
    constexpr std::uint8_t nanoseconds[] = {9};
    write(interface_block, [&](Block& body) {
      put_le(body, link.frames ? can_socketcan : rtac_serial);
      put_le<std::uint16_t>(body, 0);
      put_le<std::uint32_t>(body, 0);  // no packet is shortened
      put_option(body, name, wire::bytes_of(link.name));
      put_option(body, description, wire::bytes_of(link.uri));
      put_option(body, time_resolution, nanoseconds);
      put_option(body, 0, {});
    });
  }

  template <class Raw>
  void write_packet(std::size_t link, const Raw& raw) {
    constexpr std::uint16_t flags = 2;
    constexpr std::uint32_t inbound = 1, outbound = 2;
    write(packet_block, [&](Block& body) {
      const auto ns = static_cast<std::uint64_t>(raw.at.time_since_epoch().count());
      put_le(body, static_cast<std::uint32_t>(link));
      put_le(body, static_cast<std::uint32_t>(ns >> 32));
      put_le(body, static_cast<std::uint32_t>(ns));
      put_le(body, static_cast<std::uint32_t>(packet_.size()));
      put_le(body, static_cast<std::uint32_t>(packet_.size()));
      put(body, packet_);
      pad(body);
      put_le(body, flags);
      put_le<std::uint16_t>(body, sizeof inbound);
      put_le(body, raw.direction == record::Direction::sent ? outbound : inbound);
      put_option(body, 0, {});
    });
    ++written_;
  }

  OutputFile file_;
  Block block_, packet_;
};

}  // namespace

std::unique_ptr<Exporter> make_pcapng(const std::vector<RecordedLink>& links, const Target& to) {
  return std::make_unique<Pcapng>(links, to);
}

}  // namespace drydock::exporting
