#include "tests/drivers/recordings/sample_dive/sample_dive.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <sstream>

#include "drivers/recordings/record/recorder.hpp"
#include "drivers/wire/bytes.hpp"
#include "drivers/wire/can/candump.hpp"

namespace drydock::record::test {

namespace {

constexpr Stamp start = measurement::stamp_from_ns(1'700'000'000'000'000'000);
constexpr double degree = std::numbers::pi / 180;

constexpr const char* rig = R"(# off Zurich
[rig]
name = "bench"
mission = "../missions/not-here.toml"
start = 2026-11-21T08:00:00Z

[[device]]
name = "gps"
kind = "gnss"
protocol = "ubx+nmea0183"
link = "serial:/dev/ttyGPS?baud=38400"

[[device]]
name = "dvl"
kind = "dvl"
protocol = "pd0"
link = "serial:/dev/ttyDVL?baud=115200"

[[device]]
name = "depth"
kind = "depth"
protocol = "nmea2000"
link = "socketcan:can0"
)";

RecorderOptions options() {
  RecorderOptions options;
  options.links = {{"serial:/dev/ttyGPS?baud=38400", "gps", false, {"gps"}},
                   {"serial:/dev/ttyDVL?baud=115200", "dvl", false, {"dvl"}},
                   {"socketcan:can0", "can0", true, {"depth"}}};
  options.devices = {
      {"gps", bus::Kind::gnss}, {"dvl", bus::Kind::dvl}, {"depth", bus::Kind::depth}};
  options.attachments = {
      {0, 0, "rig.toml", "application/toml", rig},
      {0, 0, "mission.toml", "application/toml",
       "[mission]\nlatitude_deg = 47.2852332  # the lake\nlongitude_deg = 8.565265\n"},
      {0, 0, "chart.png", "image/png", "8.565265"}};
  options.versions = {{"drydock", "0.1.0"}};
  options.when_behind = WhenBehind::wait;
  return options;
}

std::string fixture(const std::string& name) {
  return read_all(DRYDOCK_SOURCE_DIR "/fixtures/" + name);
}

/// Adds the bytes in reads of `size`, equally spaced over twenty seconds.
std::size_t record_bytes(std::vector<std::pair<Stamp, std::string>>& reads,
                         const std::string& bytes, std::size_t size) {
  const std::size_t count = (bytes.size() + size - 1) / size;
  for (std::size_t i = 0; i < count; ++i)
    reads.emplace_back(start + std::chrono::seconds{20} / count * i, bytes.substr(i * size, size));
  return count;
}

/// As many frames as fit into the dive, one each 900 ms; the last two are positions.
std::vector<wire::CanFrame> frames() {
  constexpr std::size_t of_the_log = 21;
  std::vector<wire::CanFrame> all;
  std::istringstream lines(fixture("nmea2000/frames.log"));
  for (std::string line; all.size() < of_the_log && std::getline(lines, line);)
    if (const auto parsed = wire::candump::parse_line(line)) all.push_back(parsed->frame);
  wire::CanFrame position;  // 129025, rapid update: latitude, longitude in 1e-7 degree
  position.extended = true;
  position.id = 0x09F80123;
  position.size = 8;
  wire::store_le<std::int32_t>(position.data, 0, 472852332);
  wire::store_le<std::int32_t>(position.data, 4, 85652650);
  all.push_back(position);
  position.id = 0x0DF80523;  // a part of 129029: the same position, eight bytes each
  wire::store_le<std::int32_t>(position.data, 4, 472852332);
  all.push_back(position);
  return all;
}

}  // namespace

TestFolder::TestFolder() {
  auto name = (std::filesystem::temp_directory_path() / "drydock-dive-XXXXXX").string();
  folder_ = mkdtemp(name.data());
}

TestFolder::~TestFolder() { std::filesystem::remove_all(folder_); }

SampleCounts write_sample_dive(const std::string& path) {
  Recorder recorder(mcap::file_sink(path).value(), options());
  std::vector<std::pair<Stamp, std::string>> gnss, dvl;
  SampleCounts counts;
  counts.gnss_reads =
      record_bytes(gnss, fixture("ubx/golden.ubx") + fixture("nmea0183/golden.nmea"), 100);
  counts.dvl_reads = record_bytes(dvl, fixture("pd0/golden.pd0"), 64);
  const auto bus = frames();
  counts.frames = bus.size();
  const auto put = [&](const char* link, const auto& read) {
    const auto* data = reinterpret_cast<const std::uint8_t*>(read.second.data());
    recorder.on_bytes(link, shell::Direction::received, {data, read.second.size()}, read.first);
  };
  std::size_t g = 0, d = 0, f = 0;
  for (Stamp at = start; at < start + std::chrono::seconds{20};
       at += std::chrono::milliseconds{10}) {
    while (g < gnss.size() && gnss[g].first <= at) put("serial:/dev/ttyGPS?baud=38400", gnss[g++]);
    while (d < dvl.size() && dvl[d].first <= at) put("serial:/dev/ttyDVL?baud=115200", dvl[d++]);
    if (f < bus.size() && at >= start + std::chrono::milliseconds{900} * f)
      recorder.on_frame("socketcan:can0", shell::Direction::received, bus[f++], at);
    if ((at - start) % std::chrono::seconds{1} != std::chrono::seconds{0}) continue;
    measurement::GnssFix fix;
    fix.origin.valid_at = fix.origin.received_at = at;
    fix.position = {sample_latitude_deg * degree, sample_longitude_deg * degree};
    fix.ellipsoidal_height_m = 456.789;
    recorder.topics().publish(fix);
    measurement::BottomVelocity velocity;
    velocity.origin.device = 1;
    velocity.origin.valid_at = velocity.origin.received_at = at;
    velocity.velocity = Eigen::Vector3d{1.5, 0.25, -0.125};
    recorder.topics().publish(velocity);
  }
  const std::array<std::uint8_t, 3> command{'C', 'S', '\r'};
  recorder.on_bytes("serial:/dev/ttyDVL?baud=115200", shell::Direction::sent, command,
                    start + std::chrono::seconds{20});
  EXPECT_FALSE(recorder.finish());
  return counts;
}

std::string read_all(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return std::move(text).str();
}

std::string output_of(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  std::array<char, 4096> chunk{};
  while (const auto n = std::fread(chunk.data(), 1, chunk.size(), pipe))
    text.append(chunk.data(), n);
  EXPECT_EQ(pclose(pipe), 0) << command;
  return text;
}

}  // namespace drydock::record::test
