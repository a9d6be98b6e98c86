#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

#include "tests/conformance/canboat_columns.hpp"
#include "tests/conformance/comparers.hpp"
#include "tests/conformance/reading.hpp"

/// Compares NMEA 2000 with canboat's analyzer (-json -si -nv): the messages of canboat_columns.hpp,
/// in the order of each sender.
namespace drydock::conformance {

namespace {

using canboat::Column;
using canboat::Message;

constexpr Rule no_fix_rule{
    "canboat prints a position without a fix",
    "the method field says no fix; what then stands in the position is no position"};
constexpr Rule dilution_rule{
    "canboat prints a negative dilution",
    "0xFFFF in the signed field of a dilution of precision, which cannot be below zero"};

constexpr Rule cut_number_rule{"canboat reads a number that is cut short",
                               "the message ends within the residual of its last satellite; "
                               "canboat takes the bytes that there "
                               "are for the number"};

const Message* message_of(const json& row) {
  const auto found = std::ranges::find(canboat::messages, row.value("pgn", 0U), &Message::pgn);
  return found == canboat::messages.end() ? nullptr : &*found;
}

/// canboat's value: plain, or beside its name or its bytes. Null if there is none. A value with
/// only a name is not compared.
json value_of(const json& fields, const char* key) {
  if (!fields.contains(key)) return nullptr;
  const json& field = fields[key];
  return field.is_object() ? field.value("value", json()) : field;
}

json in_their_unit(const json& value, double scale, double offset = 0) {
  if (value.is_boolean()) return int(value.get<bool>());
  return value.is_number() ? json(value.get<double>() * scale + offset) : value;
}

bool by_rule(const json& ours, const json& fields, const Column& column, Comparison& c) {
  const std::string_view key = column.theirs;
  const json theirs = value_of(fields, column.theirs);
  if (!ours[column.ours].is_null() || !theirs.is_number()) return false;
  if (key == "Range residuals" && !fields.contains("Status")) {
    c.by_rule(cut_number_rule);
    return true;
  }
  const bool position = key == "Latitude" || key == "Longitude" || key == "Altitude";
  if (position && value_of(fields, "Method") == 0) {
    c.by_rule(no_fix_rule);
    return true;
  }
  if (key.ends_with("DOP") && theirs < 0) {
    c.by_rule(dilution_rule);
    return true;
  }
  return false;
}

void compare_time(const json& ours, const json& fields, Comparison& c) {
  const json days = value_of(fields, "Date"), steps = value_of(fields, "Time");
  if (days.is_string() || steps.is_string()) return;
  const bool whole = days.is_number() && steps.is_number();
  c.number("UTC", ours["utc_ns"].is_number() ? json(double(ours["utc_ns"]) * 1e-9) : json(),
           whole ? json(double(days) * 86400 + double(steps) * 1e-4) : json(), {1e-4});
}

void compare_columns(const std::string& type, std::span<const Column> columns, const json& ours,
                     const json& fields, bool si, Comparison& c) {
  for (const Column& column : columns) {
    const json theirs = value_of(fields, column.theirs);
    if (theirs.is_string() || by_rule(ours, fields, column, c)) continue;
    const bool shown = !si && column.shown.resolution > 0;
    const auto& [resolution, scale, offset] = column.shown;
    c.number(type + " " + column.theirs,
             shown ? in_their_unit(ours[column.ours], scale, offset)
                   : in_their_unit(ours[column.ours], column.scale),
             theirs, {shown ? resolution : column.resolution});
  }
}

void compare_satellites(const json& ours, const json& fields, bool si, Comparison& c) {
  const json& theirs = fields.contains("list") ? fields["list"] : json::array();
  c.same("satellites", ours.size(), theirs.size());
  for (std::size_t i = 0; i < std::min(ours.size(), theirs.size()); ++i)
    compare_columns("satellite", canboat::satellite, ours[i], theirs[i], si, c);
}

void compare_message(const json& ours, const json& row, const Message& message, bool si,
                     Comparison& c) {
  c.same("source", ours["source"], row.at("src"));
  // canboat leaves the fields out if no value of the message is available.
  static const json no_fields = json::object();
  const json& fields = row.contains("fields") ? row.at("fields") : no_fields;
  compare_columns(std::string(message.type), message.columns, ours, fields, si, c);
  if (ours.contains("utc_ns")) compare_time(ours, fields, c);
  if (message.type == "satellites_in_view") compare_satellites(ours["satellites"], fields, si, c);
}

/// The first line of canboat's output names its units; older outputs have none, and are not SI.
bool in_si(const std::vector<json>& rows) {
  return !rows.empty() && rows[0].value("units", "") == "si";
}

using Queues = std::map<std::pair<std::string, int>, std::deque<json>>;

Queues by_sender(std::vector<json> decoded) {
  Queues queues;
  for (json& message : decoded) {
    const std::pair key{message["type"].get<std::string>(), message["source"].get<int>()};
    queues[key].push_back(std::move(message));
  }
  return queues;
}

void compare_rows(const std::string& name, std::vector<json> decoded, const std::vector<json>& rows,
                  Score& score) {
  Queues queues = by_sender(std::move(decoded));
  const bool si = in_si(rows);
  std::size_t number = 0;
  for (const json& row : rows) {
    const Message* message = message_of(row);
    if (row.contains("pgn")) ++number;
    if (!message) continue;
    auto& queue = queues[{std::string(message->type), row.at("src").get<int>()}];
    if (queue.empty()) {
      score.missed(name, number, row.dump());
      continue;
    }
    Comparison c(name, number);
    compare_message(queue.front(), row, *message, si, c);
    score.add(c);
    queue.pop_front();
  }
  for (const auto& [key, queue] : queues)
    for (const json& left : queue) score.unexpected(name, 0, left.dump());
}

/// STEM.in and its golden output with values in numbers: the STEM*.out with nv in its name,
/// otherwise STEM.out if it is JSON.
fs::path golden_beside(const fs::path& input) {
  const std::string stem = (input.parent_path() / input.stem()).string();
  for (const char* end : {"-json-nv.out", "-nv.out", ".out"})
    if (fs::exists(stem + end) && read_text(stem + end).starts_with("{")) return stem + end;
  return {};
}

}  // namespace

std::vector<Case> discover_canboat_samples(const fs::path& folder) {
  auto expected = files_of(folder / "expected", ".json");
  return paired(files_of(folder / "samples"), expected, [&](const fs::path& sample) {
    return folder / "expected" / (sample.filename().string() + ".json");
  });
}

void compare_canboat(const Case& one, Score& score) {
  auto decoded = decode("nmea2000", one.capture).messages;
  if (one.expected.empty()) return score.matched(decoded.size());
  compare_rows(one.capture.filename().string(), std::move(decoded), read_json_lines(one.expected),
               score);
}

std::vector<Case> discover_canboat_tests(const fs::path& folder) {
  return paired(files_of(folder, ".in"), {}, golden_beside);
}

}  // namespace drydock::conformance
