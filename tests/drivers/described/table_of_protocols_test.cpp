#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "drivers/link/uri_forms.hpp"
#include "drivers/wire/described/read_back.hpp"
#include "tests/drivers/described/probed_rows.hpp"
#include "tests/drivers/described/witnesses_of.hpp"

/// The one table of all protocols, docs/sensors/protocols.md, is what the program can do.
namespace drydock::described::test {
namespace table_of_protocols_test {

using wire::Protocol;
using wire::Travels;

std::string in_code(const std::string& text) { return text.empty() ? text : "`" + text + "`"; }

std::string kinds_cell(const wire::Kinds& kinds) {
  std::string cell;
  for (const Kind kind : kinds)
    cell += (cell.empty() ? "" : " ") + in_code(std::string(to_string(kind)));
  return cell;
}

/// The schemes of links to real devices that carry it.
std::string links_cell(Travels travels) {
  std::string cell;
  for (const auto& form : link::uri_forms()) {
    const auto uri = link::parse_uri(form.example).value();
    const bool carries = uri.carries() == (travels == Travels::as_bytes ? link::Carries::bytes
                                                                        : link::Carries::frames);
    if (carries && !uri.emulated() && !uri.recorded())
      cell += (cell.empty() ? "" : " ") + std::string(form.name);
  }
  return cell;
}

/// Descriptions, and the protocol written by hand that each has beside it.
const std::map<std::string, std::string>& by_hand() {
  static const auto all = [] {
    std::map<std::string, std::string> found;
    for (const auto& one : rig_config::shipped_descriptions())
      found[one->name] = by_hand_beside({one->kind.value(), one->name, one, one->facts.travels});
    return found;
  }();
  return all;
}

std::string row_of(const Protocol& protocol) {
  const std::string name(protocol.name);
  std::string made = "by hand";
  for (const auto& [description, codec] : by_hand())
    if (codec == name) made += ", also `" + description + "`";
  std::string probed;
  if (protocol.kinds.empty() || !protocol.emulated)
    probed = is_named_on_golden_bytes(name) ? "yes" : "no";
  else
    for (const Kind kind : protocol.kinds) {
      const auto cell = probed_cell({kind, name, nullptr, protocol.travels});
      if (probed.find(cell) == probed.npos) probed += (probed.empty() ? "" : ", ") + cell;
    }
  const std::string emulated = protocol.kinds.empty() || !protocol.emulated ? "no" : "yes";
  return "| `" + name + "` | " + kinds_cell(protocol.kinds) + " | " + links_cell(protocol.travels) +
         " | " + made + " | " + emulated + " | " + probed + " | " +
         witness_cell("protocols", name) + " |";
}

std::string row_of(const DescriptionPtr& one) {
  const auto& codec = by_hand().at(one->name);
  const std::string stem = one->name.substr(0, one->name.rfind('.'));
  return "| `" + one->name + "` | " + kinds_cell(one->facts.kinds) + " | " +
         links_cell(one->facts.travels) + " | described" +
         (codec.empty() ? "" : ", beside " + in_code(codec)) + " | " +
         (why_silent(*one).empty() ? "yes" : "no") + " | " +
         probed_cell({one->kind.value(), one->name, one, one->facts.travels}) + " | " +
         witness_cell("descriptions", stem) + " |";
}

/// The rows of the page's first table by their first cell, without the last cell: the page.
std::map<std::string, std::string> rows_of_the_page() {
  std::ifstream in(DRYDOCK_SOURCE_DIR "/docs/sensors/protocols.md");
  std::map<std::string, std::string> rows;
  bool inside = false;
  for (std::string line; std::getline(in, line) && !(inside && line.empty());) {
    inside |= line.starts_with("| protocol |");
    if (!inside || !line.starts_with("| `")) continue;
    const auto end = line.rfind('|', line.size() - 2);
    rows[line.substr(2, line.find(" |") - 2)] = line.substr(0, end + 1);
  }
  return rows;
}

void expect_row(std::map<std::string, std::string>& rows, const std::string& name,
                const std::string& expected) {
  EXPECT_EQ(rows["`" + name + "`"], expected);
  rows.erase("`" + name + "`");
}

TEST(TableOfProtocols, HasEachProtocolAndEachDescriptionAsTheProgramHasThem) {
  auto rows = rows_of_the_page();
  for (const Protocol& protocol : wire::protocols())
    expect_row(rows, std::string(protocol.name), row_of(protocol));
  for (const auto& one : rig_config::shipped_descriptions())
    expect_row(rows, one->name, row_of(one));
  for (const auto& [name, row] : rows) ADD_FAILURE() << "nobody knows " << row;
}

}  // namespace table_of_protocols_test
}  // namespace drydock::described::test
