#include "tests/conformance/corpus.hpp"

#include <algorithm>
#include <array>

#include "tests/conformance/comparers.hpp"

namespace drydock::conformance {

std::span<const Corpus> corpora() {
  static constexpr std::array list{
      Corpus{"dvl/pd0", "dvl/pd0", discover_pd0, compare_pd0},
      Corpus{"dvl/waterlinked", "dvl/waterlinked", discover_water_linked, compare_water_linked},
      Corpus{"dvl/nortek", "dvl/nortek", discover_nortek, compare_nortek},
      Corpus{"dvl/ad2cp", "dvl/ad2cp", discover_nortek_ad2cp, compare_nortek_ad2cp},
      Corpus{"eml", "eml", discover_speed_log, compare_speed_log},
      Corpus{"gps/gpsd positions", "gps/gpsd", discover_gpsd_positions, compare_gpsd_positions},
      Corpus{"gps/gpsd satellites", "gps/gpsd", discover_gpsd_satellites, compare_gpsd_satellites},
      Corpus{"gps/gpsd messages", "gps/gpsd", discover_gnss_logs, compare_gnss_messages},
      Corpus{"gps/pyubx2 messages", "gps/pyubx2", discover_gnss_logs, compare_gnss_messages},
      Corpus{"n2k/canboat", "n2k/canboat", discover_canboat_samples, compare_canboat},
      Corpus{"n2k/canboat tests", "n2k/canboat/analyzer_tests", discover_canboat_tests,
             compare_canboat},
      Corpus{"n2k/gpsd", "n2k/gpsd", discover_gpsd_nmea2000, compare_gpsd_nmea2000},
      Corpus{"can_imu aceinna", "can_imu", discover_aceinna, compare_aceinna},
      Corpus{"can_imu xsens", "can_imu", discover_xsens, compare_xsens},
      Corpus{"dvl/waterlinked pd6", "dvl/waterlinked", discover_pd6, compare_pd6},
      Corpus{"can_depth", "can_depth", discover_can_pressure, compare_can_pressure},
      Corpus{"dbc", "dbc", discover_dbc, compare_dbc},
      Corpus{"canlog", "canlog", discover_can_log, compare_can_log},
  };
  return list;
}

std::vector<fs::path> files_of(const fs::path& folder, std::string_view extension) {
  std::vector<fs::path> found;
  if (!fs::is_directory(folder)) return found;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && (extension.empty() || entry.path().extension() == extension))
      found.push_back(entry.path());
  std::ranges::sort(found);
  return found;
}

Score score(const Corpus& corpus, const fs::path& root, const Progress& progress) {
  Score result;
  for (const Case& one : corpus.discover(root / corpus.folder)) {
    if (one.capture.empty()) {
      result.error(one.expected.filename().string() + ": expected values without their capture");
      continue;
    }
    const std::string name = one.capture.filename().string();
    if (progress) progress(corpus, one.capture);
    result.capture();
    if (one.expected.empty()) result.note(name + ": no expected values, messages only counted");
    try {
      corpus.compare(one, result);
    } catch (const std::exception& error) {
      result.error(name + ": " + error.what());
    }
  }
  return result;
}

std::vector<Result> score_all(const fs::path& root, const Progress& progress) {
  std::vector<Result> results;
  for (const Corpus& corpus : corpora()) {
    Score one = score(corpus, root, progress);
    if (one.counts().captures > 0 || !one.errors().empty())
      results.push_back({std::string(corpus.name), std::move(one)});
  }
  return results;
}

bool clean(const std::vector<Result>& results) {
  return std::ranges::all_of(results, [](const Result& r) { return r.score.clean(); });
}

std::vector<Case> vectors(const std::vector<fs::path>& files) {
  std::vector<Case> cases;
  for (const fs::path& file : files) cases.push_back({file, file});
  return cases;
}

}  // namespace drydock::conformance
