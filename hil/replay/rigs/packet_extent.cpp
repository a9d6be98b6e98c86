#include "hil/replay/rigs/packet_extent.hpp"

#include <array>
#include <fstream>

namespace drydock::replay {
namespace {

// tcpdump.org/pcap/pcap-savefile, ietf.org draft-ietf-opsawg-pcapng.
constexpr std::uint64_t packet_head = 16, block_head = 12;
constexpr std::uint32_t section_block = 0x0A0D0D0A, section_order = 0x1A2B3C4D;
constexpr std::uint32_t pcap_order_us = 0xA1B2C3D4, pcap_order_ns = 0xA1B23C4D;

class Words {
 public:
  explicit Words(const std::string& file) : in_(file, std::ios::binary) {
    in_.seekg(0, std::ios::end);
    size_ = in_ ? static_cast<std::uint64_t>(in_.tellg()) : 0;
  }
  std::uint64_t size() const { return size_; }
  bool holds(std::uint64_t begin, std::uint64_t bytes) const {
    return begin <= size_ && bytes <= size_ - begin;
  }
  /// Of what holds() says that it is there.
  std::uint32_t at(std::uint64_t place, bool big_endian) {
    std::array<char, 4> bytes{};
    in_.seekg(static_cast<std::streamoff>(place));
    in_.read(bytes.data(), bytes.size());
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
      word = word << 8 | static_cast<std::uint8_t>(bytes[big_endian ? i : bytes.size() - 1 - i]);
    return word;
  }

 private:
  std::ifstream in_;
  std::uint64_t size_ = 0;
};

std::uint64_t extent_of_blocks(Words& words) {
  std::uint64_t end = 0;
  for (bool big_endian = false; words.holds(end, block_head);) {
    if (words.at(end, false) == section_block)
      big_endian = words.at(end + 8, true) == section_order;
    const std::uint64_t size = words.at(end + 4, big_endian);
    if (size < block_head || !words.holds(end, size)) break;
    end += size;
  }
  return end;
}

std::uint64_t extent_of_packets(Words& words, bool big_endian) {
  std::uint64_t end = pcap_head;
  while (words.holds(end, packet_head)) {
    const std::uint64_t size = packet_head + words.at(end + 8, big_endian);
    if (!words.holds(end, size)) break;
    end += size;
  }
  return end;
}

}  // namespace

std::uint64_t packet_extent(const std::string& file) {
  Words words(file);
  if (!words.holds(0, pcap_head)) return words.size();
  if (words.at(0, false) == section_block) return extent_of_blocks(words);
  const auto order = words.at(0, true);
  return extent_of_packets(words, order == pcap_order_us || order == pcap_order_ns);
}

}  // namespace drydock::replay
