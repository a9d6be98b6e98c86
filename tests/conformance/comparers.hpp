#pragma once

#include "tests/conformance/corpus.hpp"

/// One discovery and one comparer for each kind of corpus.
namespace drydock::conformance {

std::vector<Case> discover_pd0(const fs::path& folder);  ///< raw/*, expected/STEM.jsonl of MHKiT
void compare_pd0(const Case& one, Score& score);

std::vector<Case> discover_water_linked(const fs::path& folder);  ///< *.txt with crc_ok, crc_bad
void compare_water_linked(const Case& one, Score& score);

std::vector<Case> discover_pd6(const fs::path& folder);  ///< *.txt that begin with a colon
void compare_pd6(const Case& one, Score& score);

std::vector<Case> discover_nortek(const fs::path& folder);  ///< *.txt
void compare_nortek(const Case& one, Score& score);

/// raw/*, expected/STEM.jsonl; nothing in the latter: no record is sound
std::vector<Case> discover_nortek_ad2cp(const fs::path& folder);
void compare_nortek_ad2cp(const Case& one, Score& score);

std::vector<Case> discover_speed_log(const fs::path& folder);  ///< *.tsv
void compare_speed_log(const Case& one, Score& score);

/// daemon/LOG.log with gpsd's reports in LOG.log.chk
std::vector<Case> discover_gpsd_satellites(const fs::path& folder);
void compare_gpsd_satellites(const Case& one, Score& score);
std::vector<Case> discover_gpsd_positions(const fs::path& folder);
void compare_gpsd_positions(const Case& one, Score& score);

std::vector<Case> discover_gnss_logs(const fs::path& folder);  ///< *.log, daemon/*.log; scanned
void compare_gnss_messages(const Case& one, Score& score);

std::vector<Case> discover_canboat_samples(const fs::path& folder);  ///< samples/, expected/F.json
void compare_canboat(const Case& one, Score& score);
std::vector<Case> discover_canboat_tests(const fs::path& folder);  ///< STEM.in, STEM*.out

std::vector<Case> discover_gpsd_nmea2000(const fs::path& folder);  ///< LOG.log, LOG.log.chk
void compare_gpsd_nmea2000(const Case& one, Score& score);

std::vector<Case> discover_aceinna(const fs::path& folder);  ///< STEM*.log, STEM.expected.jsonl
void compare_aceinna(const Case& one, Score& score);

std::vector<Case> discover_xsens(const fs::path& folder);  ///< *.tsv: id, payload, meaning
void compare_xsens(const Case& one, Score& score);

std::vector<Case> discover_can_pressure(const fs::path& folder);  ///< *.tsv: id, payload, meaning
void compare_can_pressure(const Case& one, Score& score);

std::vector<Case> discover_dbc(const fs::path& folder);  ///< files/STEM.dbc, expected/STEM.jsonl
void compare_dbc(const Case& one, Score& score);

std::vector<Case> discover_can_log(const fs::path& folder);  ///< *.asc, *.pcap
void compare_can_log(const Case& one, Score& score);

}  // namespace drydock::conformance
