#include "drivers/capture/formats/yacht_devices.hpp"

#include "drivers/capture/words.hpp"
#include "drivers/wire/hex.hpp"

namespace drydock::capture {

namespace {

std::optional<Record> parse(std::string_view line) {
  Words words(line);
  Record record{parse_clock(words.next()), "can0", {}};
  const auto direction = words.next(), identifier = words.next();
  const auto id = wire::parse_hex(identifier);
  if (!record.time || (direction != "R" && direction != "T") || identifier.size() != 8 || !id ||
      *id > 0x1FFFFFFF)
    return std::nullopt;
  record.frame.id = *id;
  record.frame.extended = true;
  std::size_t bytes = 0;
  for (Words rest = words; !rest.next().empty();) ++bytes;
  if (bytes > 8 || !read_data(words, bytes, 16, record.frame)) return std::nullopt;
  return record;
}

}  // namespace

bool YachtDevices::recognises(std::string_view line) { return parse(line).has_value(); }

Reading YachtDevices::read_line(std::string_view line) {
  auto record = parse(line);
  if (record) record->time = clock_.since_first_midnight(*record->time);
  return Reading::of(record);
}

}  // namespace drydock::capture
