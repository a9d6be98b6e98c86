// Files of packets that tcpdump began anew in the middle of a stream (-C, -W) are one stream.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "hil/track/track.hpp"
#include "tests/drivers/decode/corpora.hpp"

namespace drydock::track::packet_files_in_a_row_test {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;

void add(std::string& out, std::uint64_t value, int bytes, bool big_endian = false) {
  for (int i = 0; i < bytes; ++i)
    out.push_back(static_cast<char>(value >> 8 * (big_endian ? bytes - 1 - i : i)));
}

/// The head of a file of raw IP packets: magic, version 2.4, zone, accuracy, longest, link type.
std::string pcap_head() {
  std::string out;
  add(out, 0xA1B2C3D4, 4);
  add(out, 2, 2);
  add(out, 4, 2);
  add(out, 0, 8);
  add(out, 65535, 4);
  add(out, 101, 4);
  return out;
}

/// A piece of a TCP stream (RFC 791, RFC 9293) as a packet of the file.
std::string packet(const std::string& payload, std::uint32_t sequence, std::uint64_t us) {
  std::string tcp;
  add(tcp, 16171, 2, true);
  add(tcp, 5000, 2, true);
  add(tcp, sequence, 4, true);
  add(tcp, 0, 4, true);
  add(tcp, 0x5018, 2, true);
  add(tcp, 1000, 2, true);
  add(tcp, 0, 4, true);
  tcp += payload;
  std::string ip;
  add(ip, 0x4500, 2, true);
  add(ip, 20 + tcp.size(), 2, true);
  add(ip, 1, 4, false);
  add(ip, 0x4006, 2, true);
  add(ip, 0, 2, true);
  add(ip, 0x0A000002, 4, true);
  add(ip, 0x0A000001, 4, true);
  ip[4] = ip[5] = ip[6] = ip[7] = 0;
  ip += tcp;
  std::string out;
  add(out, us / 1'000'000, 4);
  add(out, us % 1'000'000, 4);
  add(out, ip.size(), 4);
  add(out, ip.size(), 4);
  return out + ip;
}

class PacketFilesInARow : public decode::corpora::Corpora {
 protected:
  /// README.md of the dive: ensembles of 432 bytes, one in 2.03 s. A packet has 300 bytes.
  static constexpr std::size_t ensembles = 90, packet_bytes = 300;

  void SetUp() override {
    Corpora::SetUp();
    if (IsSkipped()) return;
    fs::create_directories(folder_);
    std::ifstream in(root_ / "dvl/pd0/raw/remus_20141219_a.adc", std::ios::binary);
    std::string dive(ensembles * 432, '\0');
    in.read(dive.data(), static_cast<std::streamsize>(dive.size()));
    for (std::size_t at = 0; at < dive.size(); at += packet_bytes)
      packets_.push_back(packet(dive.substr(at, packet_bytes), static_cast<std::uint32_t>(at),
                                1'419'009'472'000'000 + at * 4'700));
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Packets as a file, without its last bytes.
  std::string file(const std::string& name, std::size_t from, std::size_t to,
                   std::size_t without = 0) const {
    std::string all = pcap_head();
    for (std::size_t i = from; i < to; ++i) all += packets_[i];
    const auto path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary) << all.substr(0, all.size() - without);
    return path;
  }
  static Gathered gathered(const std::vector<std::string>& files) {
    TrackOptions options;
    options.source.protocol = "pd0";
    options.source.capture = files.front();
    if (files.size() > 1)
      for (const auto& name : files) options.captures.push_back({name});
    return gather(options);
  }

  fs::path folder_ = fs::temp_directory_path() / fmt::format("packet-files-{}", ::getpid());
  std::vector<std::string> packets_;
};

TEST_F(PacketFilesInARow, LoseNoFrameThatBothHaveAPartOf) {
  const auto whole = gathered({file("whole.pcap", 0, packets_.size())});
  ASSERT_GT(whole.dive.readings.size(), 80u);
  const auto cut = gathered({file("a.pcap", 0, 40), file("b.pcap", 40, packets_.size())});
  EXPECT_EQ(cut.dive.readings.size(), whole.dive.readings.size());
}

TEST_F(PacketFilesInARow, GoOnBehindAPacketThatIsCutShort) {
  const auto whole = gathered({file("whole.pcap", 0, packets_.size())});
  const auto cut = gathered({file("a.pcap", 0, 40, 10), file("b.pcap", 40, packets_.size())});
  // The 300 bytes of the packet are of two ensembles at most.
  EXPECT_GE(cut.dive.readings.size() + 2 * whole.dive.readings.size() / ensembles,
            whole.dive.readings.size());
  EXPECT_THAT(
      cut.notes,
      Contains(HasSubstr(fmt::format("a.pcap: its last packet is cut short, {} bytes are left out",
                                     packets_[39].size() - 10))));
}

}  // namespace
}  // namespace drydock::track::packet_files_in_a_row_test
