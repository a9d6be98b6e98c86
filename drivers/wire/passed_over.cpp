#include "drivers/wire/passed_over.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/j1939/j1939.hpp"
#include "drivers/wire/j1939/pgn_name.hpp"
#include "drivers/wire/nmea0183/nmea0183_sentence.hpp"
#include "drivers/wire/nmea2000/pgn_name.hpp"
#include "drivers/wire/ubx/rtcm3.hpp"
#include "drivers/wire/ubx/ubx_frame.hpp"
#include "drivers/wire/ubx/ubx_names.hpp"

namespace drydock::wire {
namespace {

/// Data types that the guides of Teledyne's ADCPs, of VmDas and of WinRiver name. Other programs
/// write their own under the same numbers.
struct Pd0Block {
  std::uint16_t id;
  std::string_view name;
};
constexpr std::array pd0_blocks{Pd0Block{0x0100, "velocity profile"},
                                Pd0Block{0x0200, "correlation profile"},
                                Pd0Block{0x0300, "echo intensity profile"},
                                Pd0Block{0x0400, "percent good profile"},
                                Pd0Block{0x0500, "status profile"},
                                Pd0Block{0x2000, "navigation, neither of VmDas nor of a REMUS"},
                                Pd0Block{0x2022, "sentence, as of WinRiver"},
                                Pd0Block{0x2100, "DBT sentence, as of WinRiver"},
                                Pd0Block{0x2101, "GGA sentence, as of WinRiver"},
                                Pd0Block{0x2102, "VTG sentence, as of WinRiver"},
                                Pd0Block{0x2103, "GSA sentence, as of WinRiver"},
                                Pd0Block{0x2104, "HDT sentence, as of WinRiver"}};

std::string ubx_name(Bytes frame) { return "UBX " + ubx::message_name(frame[2], frame[3]); }

/// The type is the first 12 bits of the payload.
std::string rtcm_name(Bytes frame) {
  return fmt::format("RTCM {}", load_be<std::uint16_t>(frame, rtcm3::header_size) >> 4);
}

constexpr bool is_printed(std::uint8_t byte) { return byte > 0x20 && byte < 0x7F; }

/// Up to a comma, a checksum or a byte that is not printed.
std::string first_word(Bytes frame) {
  constexpr std::size_t longest = 16;
  std::string word;
  for (const std::uint8_t byte : frame.first(std::min(frame.size(), longest))) {
    if (!is_printed(byte) || byte == ',' || byte == '*') break;
    word.push_back(static_cast<char>(byte));
  }
  return word;
}

std::string identifier_name(const CanFrame& frame) {
  return frame.extended ? fmt::format("identifier {:08X}", frame.id)
                        : fmt::format("identifier {:03X}", frame.id);
}

/// CiA 301, 7.3.5 (predefined connection set); CiA 305 for LSS. Empty: free for the user.
std::string canopen_text(const CanFrame& frame) {
  struct Object {
    std::uint32_t base;
    std::string_view name;
  };
  constexpr std::array of_a_node{
      Object{0x080, "emergency"},  Object{0x180, "TPDO1"},       Object{0x200, "RPDO1"},
      Object{0x280, "TPDO2"},      Object{0x300, "RPDO2"},       Object{0x380, "TPDO3"},
      Object{0x400, "RPDO3"},      Object{0x480, "TPDO4"},       Object{0x500, "RPDO4"},
      Object{0x580, "SDO answer"}, Object{0x600, "SDO request"}, Object{0x700, "heartbeat"}};
  constexpr std::array of_all{Object{0x000, "NMT"}, Object{0x080, "SYNC"}, Object{0x100, "TIME"},
                              Object{0x7E4, "LSS"}, Object{0x7E5, "LSS"}};
  if (frame.extended) return {};
  if (const auto found = std::ranges::find(of_all, frame.id, &Object::base); found != of_all.end())
    return fmt::format(" {}", found->name);
  constexpr std::uint32_t node_mask = 0x7F;
  const std::uint32_t node = frame.id & node_mask;
  const auto found = std::ranges::find(of_a_node, frame.id & ~node_mask, &Object::base);
  return node == 0 || found == of_a_node.end() ? ""
                                               : fmt::format(" {} of node {}", found->name, node);
}

std::string pgn_text(std::uint32_t pgn) {
  std::string_view name = nmea2000::pgn_name(pgn);
  if (name.empty()) name = j1939::pgn_name(pgn);
  return fmt::format("PGN {}{}{}", pgn, name.empty() ? "" : " ", name);
}

}  // namespace

std::string frame_name(Bytes frame) {
  if (frame.size() >= ubx::overhead && frame[0] == ubx::sync_1) return ubx_name(frame);
  if (frame.size() > rtcm3::header_size + 1 && frame[0] == rtcm3::preamble) return rtcm_name(frame);
  const std::string word = first_word(without_tag(frame));
  return word.size() > 1 ? word : fmt::format("frame of {} bytes", frame.size());
}

std::string frame_name(const CanFrame& frame, Network network) {
  if (frame.error) return "error frame";
  if (frame.remote) return "request for " + identifier_name(frame);
  const auto id = j1939::identify(frame);
  if (id && network == Network::j1939) return pgn_text(id->pgn);
  return identifier_name(frame) + (network == Network::canopen ? canopen_text(frame) : "");
}

std::string block_name(std::uint16_t id) {
  const auto known = std::ranges::find(pd0_blocks, id, &Pd0Block::id);
  return known != pd0_blocks.end() ? fmt::format("block {:04X} {}", id, known->name)
                                   : fmt::format("block {:04X}", id);
}

}  // namespace drydock::wire
