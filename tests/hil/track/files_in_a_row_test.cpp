// Captures of one sensor that follow each other give the track of the capture that was not cut.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "hil/track/track.hpp"
#include "tests/drivers/decode/corpora.hpp"

namespace drydock::track::files_in_a_row_test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// README.md of the dive: 1934 ensembles of 432 bytes, one in 2.03 s.
constexpr std::size_t ensemble = 432;

class FilesInARow : public decode::corpora::Corpora {
 protected:
  void SetUp() override {
    Corpora::SetUp();
    if (IsSkipped()) return;
    fs::create_directories(folder_);
    std::ifstream in(root_ / "dvl/pd0/raw/remus_20141219_a.adc", std::ios::binary);
    dive_.assign(std::istreambuf_iterator<char>(in), {});
    std::ofstream(file("rig.toml")) << "[rig]\nname = \"auv\"\n[[device]]\nname = \"dvl\"\n"
                                       "kind = \"dvl\"\nprotocol = \"pd0\"\nlink = \"pty:dvl\"\n";
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  /// Bytes of the dive as a file.
  std::string part(const std::string& name, std::size_t from, std::size_t to) const {
    fs::create_directories(fs::path(file(name)).parent_path());
    std::ofstream(file(name), std::ios::binary) << dive_.substr(from, to - from);
    return file(name);
  }
  Gathered through_rig(std::vector<replay::RigCaptures::File> files) const {
    TrackOptions options;
    options.rig = file("rig.toml");
    options.captures = std::move(files);
    return gather(options);
  }
  Gathered alone(const std::vector<std::string>& files) const {
    TrackOptions options;
    options.source.protocol = "pd0";
    options.source.capture = files.front();
    for (const auto& name : files) options.captures.push_back({name});
    return gather(options);
  }
  static void expect_same(const Gathered& one, const Gathered& other) {
    EXPECT_EQ(one.start, other.start);
    ASSERT_EQ(one.dive.readings.size(), other.dive.readings.size());
    for (std::size_t i = 0; i < one.dive.readings.size(); ++i) {
      EXPECT_EQ(one.dive.readings[i].time_s, other.dive.readings[i].time_s) << i;
      EXPECT_EQ(one.dive.readings[i].value, other.dive.readings[i].value) << i;
    }
  }

  fs::path folder_ = fs::temp_directory_path() / fmt::format("files-in-a-row-{}", ::getpid());
  std::string dive_;
};

constexpr std::size_t end = 300 * ensemble;  ///< of what the tests read

TEST_F(FilesInARow, CutBetweenOrInsideOfFramesGiveTheReadingsOfTheWhole) {
  const auto whole = through_rig({{part("whole.adc", 0, end), "dvl"}});
  ASSERT_GT(whole.dive.readings.size(), 290u);
  for (const std::size_t cut : {100 * ensemble, 100 * ensemble + 211, 100 * ensemble + 1}) {
    const auto a = part("a.adc", 0, cut), b = part("b.adc", cut, end);
    expect_same(through_rig({{a, "dvl"}, {b, "dvl"}}), whole);
  }
}

TEST_F(FilesInARow, AreReadInTheOrderOfTheirTimesAndNotOfTheCommandLine) {
  const auto whole = through_rig({{part("whole.adc", 0, end), "dvl"}});
  const auto a = part("a.adc", 0, 100 * ensemble), b = part("b.adc", 100 * ensemble, end);
  const auto turned = through_rig({{b, "dvl"}, {a, "dvl"}});
  expect_same(turned, whole);
  EXPECT_THAT(turned.notes, Contains(HasSubstr("a.adc, ")));
  EXPECT_THAT(turned.notes, Contains(HasSubstr("read as one, in the order of their times")));
  EXPECT_THAT(turned.notes, Not(Contains(HasSubstr("nothing for"))));
}

TEST_F(FilesInARow, NeedNoRigFileWhereTheProtocolIsSaid) {
  const auto whole = alone({part("whole.adc", 0, end)});
  const auto a = part("a.adc", 0, 777), b = part("b.adc", 777, 150 * ensemble),
             c = part("c.adc", 150 * ensemble, end);
  const auto joined = alone({a, c, b});
  expect_same(joined, whole);
  EXPECT_EQ(joined.source, a + ", " + c + ", " + b);
}

/// Ten ensembles are missing. nav.csv: 1419009674.49 s and 1419009696.42 s around them.
TEST_F(FilesInARow, TellTheGapBetweenThem) {
  const auto a = part("a.adc", 0, 100 * ensemble), b = part("b.adc", 110 * ensemble, end);
  const auto gathered = through_rig({{a, "dvl"}, {b, "dvl"}});
  EXPECT_THAT(gathered.notes, Contains(AllOf(HasSubstr("nothing for 21.9 s"), HasSubstr("b.adc"))));
}

TEST_F(FilesInARow, CountWhatBothHaveOnce) {
  const auto whole = through_rig({{part("whole.adc", 0, end), "dvl"}});
  const auto a = part("a.adc", 0, 100 * ensemble), b = part("b.adc", 90 * ensemble, end);
  const auto gathered = through_rig({{a, "dvl"}, {b, "dvl"}});
  expect_same(gathered, whole);
  EXPECT_THAT(gathered.notes, Contains(HasSubstr("its 10 messages of that time are left out")));
}

TEST_F(FilesInARow, InOneFolderAreOneStreamAndWhatIsBesideIsSaid) {
  const auto whole = through_rig({{part("whole.adc", 0, end), "dvl"}});
  const auto a = part("day/a.adc", 0, 100 * ensemble + 30),
             b = part("day/b.adc", 100 * ensemble + 30, end);
  std::ofstream(file("day/notes.txt")) << "calm sea\n";
  const auto gathered = through_rig(
      {{a, "", file("day")}, {b, "", file("day")}, {file("day/notes.txt"), "", file("day")}});
  expect_same(gathered, whole);
  EXPECT_THAT(gathered.notes,
              Contains(HasSubstr("notes.txt (9 bytes): no device of this rig reads it")));
}

}  // namespace
}  // namespace drydock::track::files_in_a_row_test
