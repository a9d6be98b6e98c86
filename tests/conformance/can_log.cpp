#include <regex>

#include "tests/conformance/comparers.hpp"
#include "tests/conformance/reading.hpp"
#include "tests/conformance/scan.hpp"

/// CAN traces of other tools. Every data frame must be read, with the identifier and bytes in the
/// text or packet.
namespace drydock::conformance {

namespace {

struct Frame {
  std::size_t place;  ///< line or packet
  std::uint32_t id;
  std::string data;  ///< hex
};

/// Vector ASC: time, channel, identifier (x: 29 bits), Rx or Tx, d, size, bytes.
std::vector<Frame> scan_asc(const std::string& text) {
  static const std::regex data_frame(
      R"(^\s*[\d.]+\s+\d+\s+([0-9A-Fa-f]+)(x?)\s+(?:Rx|Tx)\s+d\s+(\d+)((?:\s+[0-9A-Fa-f]{2})*))");
  std::vector<Frame> frames;
  std::size_t number = 0;
  for (const std::string& line : lines_of(text)) {
    ++number;
    std::smatch found;
    if (!std::regex_search(line, found, data_frame)) continue;
    std::string data = found[4];
    std::erase_if(data, [](char c) { return c == ' ' || c == '\t'; });
    data.resize(std::min(data.size(), 2 * std::stoul(found[3])));
    frames.push_back({number, static_cast<std::uint32_t>(std::stoul(found[1], nullptr, 16)), data});
  }
  return frames;
}

/// pcap, little-endian, link type 227 (SocketCAN): identifier big-endian, size, bytes.
std::vector<Frame> scan_pcap(std::string_view bytes) {
  constexpr std::size_t file_head = 24, packet_head = 16, frame_head = 8;
  constexpr unsigned not_data = 0x60;  // remote or error, in the identifier's first byte
  std::vector<Frame> frames;
  std::size_t number = 0;
  for (std::size_t at = file_head; at + packet_head + frame_head <= bytes.size();) {
    ++number;
    const std::size_t size = pair_le(bytes, at + 8) | pair_le(bytes, at + 10) << 16;
    const std::string_view packet = bytes.substr(at + packet_head, size);
    at += packet_head + size;
    if (packet.size() < size || size < frame_head || (octet(packet, 0) & not_data) != 0) continue;
    Frame frame{number,
                (octet(packet, 0) & 0x1FU) << 24 | octet(packet, 1) << 16 | octet(packet, 2) << 8 |
                    octet(packet, 3),
                {}};
    constexpr std::string_view digits = "0123456789ABCDEF";
    for (std::size_t i = 0; i < octet(packet, 4); ++i) {
      frame.data += digits[octet(packet, frame_head + i) >> 4];
      frame.data += digits[octet(packet, frame_head + i) & 0xF];
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

bool is_data(const json& message) {
  return message["error"] == false && message["remote"] == false;
}

}  // namespace

std::vector<Case> discover_can_log(const fs::path& folder) {
  auto files = files_of(folder, ".asc");
  for (fs::path& pcap : files_of(folder, ".pcap")) files.push_back(std::move(pcap));
  return vectors(files);
}

void compare_can_log(const Case& one, Score& score) {
  const std::string name = one.capture.filename().string(), bytes = read_text(one.capture);
  const auto theirs = one.capture.extension() == ".asc" ? scan_asc(bytes) : scan_pcap(bytes);
  auto ours = decode("can", one.capture).messages;
  std::erase_if(ours, [](const json& message) { return !is_data(message); });
  for (std::size_t i = 0; i < theirs.size(); ++i) {
    if (i >= ours.size()) {
      score.missed(name, theirs[i].place, theirs[i].data);
      continue;
    }
    Comparison c(name, theirs[i].place);
    c.same("identifier", ours[i]["id"], theirs[i].id);
    c.same("data", ours[i]["data"].is_null() ? json("") : ours[i]["data"], theirs[i].data);
    score.add(c);
  }
  for (std::size_t i = theirs.size(); i < ours.size(); ++i)
    score.unexpected(name, i + 1, ours[i].dump());
}

}  // namespace drydock::conformance
