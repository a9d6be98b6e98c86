#include "drivers/capture/formats/candump_log.hpp"

#include "drivers/wire/can/candump.hpp"

namespace drydock::capture {

namespace {

std::optional<Record> parse(std::string_view text) {
  const auto line = wire::candump::parse_line(text);
  if (!line) return std::nullopt;
  return Record{line->time, line->interface, line->frame};
}

}  // namespace

bool CandumpLog::recognises(std::string_view line) { return parse(line).has_value(); }

Reading CandumpLog::read_line(std::string_view line) {
  if (auto record = parse(line)) return {record, false};
  // A lost line end can put a good line directly behind a torn one.
  const auto last = line.rfind('(');
  if (last == line.npos) return line[0] == '#' ? Reading::nothing() : Reading::damage();
  return {parse(line.substr(last)), true};
}

}  // namespace drydock::capture
