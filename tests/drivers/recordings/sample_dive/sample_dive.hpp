#pragma once

#include <filesystem>
#include <string>

/// A recording of twenty seconds with bytes from fixtures/: a receiver's line (UBX and NMEA 0183),
/// a DVL's (PD0) and a bus with NMEA 2000 sensors.
namespace drydock::record::test {

/// A folder for one test. The destructor removes it.
class TestFolder {
 public:
  TestFolder();
  ~TestFolder();
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;
  std::string operator/(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};

/// The receiver's first position in the golden bytes (fixtures/ubx/NOTE.md, NAV-PVT 1).
inline constexpr double sample_latitude_deg = 47.2852332, sample_longitude_deg = 8.565265;

/// Number of reads on the two lines and frames on the bus that write_sample_dive() records.
struct SampleCounts {
  std::size_t gnss_reads = 0, dvl_reads = 0, frames = 0;
};
SampleCounts write_sample_dive(const std::string& path);

std::string read_all(const std::string& path);
/// The output of a command. If the command fails, "" and a failed test.
std::string output_of(const std::string& command);

}  // namespace drydock::record::test
