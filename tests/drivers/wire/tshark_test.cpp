#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/canopen/cia404_imu.hpp"
#include "drivers/wire/j1939/aceinna.hpp"
#include "drivers/wire/j1939/j1939_transport_sender.hpp"
#include "drivers/wire/nmea2000/nmea2000.hpp"
#include "tests/drivers/wire/can_fixture.hpp"

/// Another program decodes the output of our encoders: Wireshark's J1939 and CANopen dissectors,
/// through tshark.
namespace drydock::wire {
namespace tshark_test {

using namespace std::chrono_literals;

/// A capture file of the pcap format, link type SocketCAN: identifier and flags big-endian, length,
/// three spare bytes, data.
std::string pcap(const std::vector<CanFrame>& frames) {
  constexpr std::uint32_t magic = 0xA1B2C3D4, linktype_can_socketcan = 227, extended = 0x80000000;
  std::string file;
  const auto put = [&](auto value, bool big_endian = false) {
    std::array<std::uint8_t, sizeof value> bytes{};
    if (big_endian) {
      store_be<decltype(value)>(bytes, 0, value);
    } else {
      store_le<decltype(value)>(bytes, 0, value);
    }
    file.append(bytes.begin(), bytes.end());
  };
  put(magic);
  put(std::uint16_t{2});
  put(std::uint16_t{4});
  for (const std::uint32_t field : {0u, 0u, 65535u, linktype_can_socketcan}) put(field);
  for (std::uint32_t i = 0; i < frames.size(); ++i) {
    const CanFrame& f = frames[i];
    const std::uint32_t size = 8u + f.size;
    for (const std::uint32_t field : {i, 0u, size, size}) put(field);
    put(f.id | (f.extended ? extended : 0), true);
    put(std::uint32_t{f.size});  // little-endian: the length, then three zeros
    file.append(f.data.begin(), f.data.begin() + f.size);
  }
  return file;
}

class Tshark : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v tshark >/dev/null") != 0) {
      GTEST_SKIP() << "tshark is not installed (package tshark)";
    }
  }

  /// One row for each frame: the named fields as the dissector prints them. A missing field is
  /// empty.
  static std::vector<std::vector<std::string>> fields(const std::vector<CanFrame>& frames,
                                                      const std::string& dissector,
                                                      const std::vector<std::string>& names) {
    const auto path = std::filesystem::temp_directory_path() /
                      ("drydock_tshark_" + std::to_string(::getpid()) + ".pcap");
    std::ofstream{path, std::ios::binary} << pcap(frames);
    std::string command = "tshark -n -r " + path.string() + " -d can.subdissector," + dissector +
                          " -T fields -E separator=,";
    for (const auto& name : names) command += " -e " + name;
    std::FILE* pipe = ::popen((command + " 2>/dev/null").c_str(), "r");
    std::vector<std::vector<std::string>> rows(1, {""});
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
      if (c == '\n') {
        rows.push_back({""});
      } else if (c == ',') {
        rows.back().push_back("");
      } else {
        rows.back().back() += static_cast<char>(c);
      }
    }
    ::pclose(pipe);
    std::filesystem::remove(path);
    rows.pop_back();
    return rows;
  }
};

std::string hex_of(const CanFrame& frame) {
  std::string text;
  std::array<char, 3> two{};
  for (const std::uint8_t byte : frame.payload()) {
    std::snprintf(two.data(), two.size(), "%02x", byte);
    text += two.data();
  }
  return text;
}

TEST_F(Tshark, ReadsPriorityPgnAndAddressesOfOurJ1939Frames) {
  const std::vector<std::uint8_t> message(20, 0x42);
  j1939::TransportSender sender;
  const auto announced = *sender.send({6, 65240, 0x80, 1}, message, 0ms);
  aceinna::SlopeSensor slope;
  slope.source = 0x80;
  slope.pitch_rad = 0.1;
  struct Case {
    CanFrame frame;
    const char *priority, *pgn, *source, *destination;
  };
  const std::vector<Case> cases{
      {encode(nmea2000::Pressure{35, 1, 0, 1, 101325.0}), "5", "130314", "35", ""},
      {encode(nmea2000::Temperature{35, 1, 0, 0, 283.15, {}}), "5", "130312", "35", ""},
      {encode(nmea2000::WaterDepth{35, 1, 30.0, 0.0, 200.0}), "3", "128267", "35", ""},
      {encode(nmea2000::Rudder{40, 0, {}, {}, 0.1}), "2", "127245", "40", ""},
      {encode(nmea2000::Engine{40, 0, 100.0, {}, {}}), "2", "127488", "40", ""},
      {encode(slope), "3", "61481", "128", ""},
      {encode(aceinna::AngularRate{0x80, {0.1, 0.2, 0.3}, {}, {}}), "3", "61482", "128", ""},
      {encode(aceinna::Acceleration{0x80, {1, 2, 3}, {}}), "2", "61485", "128", ""},
      {encode(j1939::AddressClaimed{0x90, 42}), "6", "60928", "144", "255"},
      {encode(j1939::AddressClaimed{j1939::null_address, 42}), "6", "60928", "254", "255"},
      {encode(j1939::Request{j1939::null_address, 0x90, 60928}), "6", "59904", "254", "144"},
      {announced, "7", "60416", "1", "128"},
      {j1939::encode_transport_packet(1, 0x80, message, 3), "7", "60160", "1", "128"},
  };
  std::vector<CanFrame> frames;
  for (const auto& c : cases) frames.push_back(c.frame);
  const auto rows =
      fields(frames, "j1939",
             {"j1939.priority", "j1939.pgn", "j1939.src_addr", "j1939.dst_addr", "j1939.data"});
  ASSERT_EQ(rows.size(), cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Case& c = cases[i];
    EXPECT_EQ(rows[i], (std::vector<std::string>{c.priority, c.pgn, c.source, c.destination,
                                                 hex_of(c.frame)}));
  }
}

/// A function code or node in the form that tshark prints.
std::string code(unsigned value) {
  std::array<char, 11> text{};
  std::snprintf(text.data(), text.size(), "0x%08x", value);
  return text.data();
}

TEST_F(Tshark, ReadsTheServicesOfOurCanopenFrames) {
  using namespace canopen;
  const auto set = encode(cia404_imu::ImuSet{5, {0.1, 0.2, 0.3}, {1, 2, 3}});
  const std::vector<CanFrame> frames{
      encode(Nmt{NmtCommand::start, 5}),
      encode(Nmt{NmtCommand::reset_communication, 0}),
      encode(Heartbeat{5, NodeState::boot_up}),
      encode(Heartbeat{5, NodeState::operational}),
      encode(Heartbeat{127, NodeState::pre_operational}),
      encode(Emergency{5, 0x1000, 0x81, {}}),
      set[0],
      set[1],
      set[2],
      sync_frame(),
  };
  const auto rows =
      fields(frames, "canopen",
             {"canopen.function_code", "canopen.node_id", "canopen.nmt_ctrl.cd",
              "canopen.nmt_ctrl.node_id", "canopen.nmt_guard.state", "canopen.em.err_code"});
  using Row = std::vector<std::string>;
  EXPECT_EQ(rows, (std::vector<Row>{
                      {code(0), code(0), "0x01", "0x05", "", ""},
                      {code(0), code(0), "0x82", "0x00", "", ""},
                      {code(14), code(5), "", "", "0x00", ""},
                      {code(14), code(5), "", "", "0x05", ""},
                      {code(14), code(127), "", "", "0x7f", ""},
                      {code(1), code(5), "", "", "", "0x1000"},
                      {code(3), code(5), "", "", "", ""},
                      {code(5), code(5), "", "", "", ""},
                      {code(7), code(5), "", "", "", ""},
                      {code(1), code(0), "", "", "", ""},
                  }));
}

}  // namespace tshark_test
}  // namespace drydock::wire
