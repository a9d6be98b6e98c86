#include "drivers/wire/protocols.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>

/// The table of protocols, and the page that shows it to people. Its first table, which has the
/// descriptions too, is held against the program in tests/drivers/described.
namespace drydock::wire::protocols_test {
namespace {

std::string page() {
  std::ifstream in(DRYDOCK_SOURCE_DIR "/docs/sensors/protocols.md");
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The cells of a line "| a | b |", without the spaces around them.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t begin = 1; begin < line.size();) {
    const std::size_t end = line.find('|', begin);
    if (end == std::string::npos) break;
    std::string cell = line.substr(begin, end - begin);
    cell.erase(0, cell.find_first_not_of(' '));
    cell.erase(cell.find_last_not_of(' ') + 1);
    cells.push_back(cell);
    begin = end + 1;
  }
  return cells;
}

/// The rows of the page's second table by protocol: column name -> cell.
std::map<std::string, std::map<std::string, std::string>> rows_of_the_page() {
  std::map<std::string, std::map<std::string, std::string>> rows;
  std::istringstream text(page());
  std::vector<std::string> head;
  for (std::string line; std::getline(text, line);) {
    const auto cells = cells_of(line);
    if (head.empty() && line.starts_with("| made by hand |")) head = cells;
    if (!head.empty() && line.empty()) break;
    if (head.empty() || cells.size() != head.size() || !cells[0].starts_with('`')) continue;
    for (std::size_t i = 0; i < cells.size(); ++i) rows[cells[0]][head[i]] = cells[i];
  }
  return rows;
}

std::string checksum_in_words(const Protocol& protocol) {
  if (protocol.travels == Travels::as_frames) return "of CAN";
  return protocol.checksum.empty() ? "none" : std::string(protocol.checksum);
}

std::string in_words(DeviceClock clock) {
  return std::map<DeviceClock, std::string>{
      {DeviceClock::no, "no"}, {DeviceClock::yes, "yes"}, {DeviceClock::of_receiver, "receiver"}}
      .at(clock);
}

std::string in_words(Settings settings) {
  return std::map<Settings, std::string>{{Settings::none, "no"},
                                         {Settings::obeyed, "yes, cannot refuse"},
                                         {Settings::refusable, "yes"}}
      .at(settings);
}

std::string in_words(Place place) {
  return std::map<Place, std::string>{{Place::no, "no"},
                                      {Place::yes, "yes"},
                                      {Place::of_receiver, "receiver"},
                                      {Place::of_bus, "bus"},
                                      {Place::under_any_identifier, "unknown"}}
      .at(place);
}

TEST(Protocols, ThePageShowsEveryRowAndNoOther) {
  const auto rows = rows_of_the_page();
  EXPECT_EQ(rows.size(), protocols().size());
  for (const Protocol& protocol : protocols()) {
    const std::string name = "`" + std::string(protocol.name) + "`";
    ASSERT_TRUE(rows.contains(name)) << name;
    const auto& row = rows.at(name);
    EXPECT_EQ(row.at("travels as"), protocol.travels == Travels::as_bytes ? "bytes" : "frames")
        << name;
    EXPECT_EQ(row.at("checksum"), checksum_in_words(protocol)) << name;
    EXPECT_EQ(row.at("device clock"), in_words(protocol.clock)) << name;
    EXPECT_EQ(row.at("can be set up"), in_words(protocol.settings)) << name;
    EXPECT_EQ(row.at("knows its place"), in_words(protocol.place)) << name;
  }
}

TEST(Protocols, ANameIsThereOnceAndIsFound) {
  std::set<std::string_view> names;
  for (const Protocol& protocol : protocols()) {
    EXPECT_TRUE(names.insert(protocol.name).second) << protocol.name;
    EXPECT_EQ(find_protocol(protocol.name), &protocol);
  }
  EXPECT_EQ(find_protocol(""), nullptr);
  EXPECT_EQ(find_protocol("pd"), nullptr);
}

}  // namespace
}  // namespace drydock::wire::protocols_test
