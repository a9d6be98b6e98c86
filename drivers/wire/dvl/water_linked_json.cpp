#include "drivers/wire/dvl/water_linked_json.hpp"

#include <algorithm>
#include <cstring>

#include "drivers/wire/dvl/json_reader.hpp"
#include "drivers/wire/line_end.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::wire {
namespace {

constexpr std::size_t line_end_size = 2;

std::size_t before_object(Bytes bytes) {
  const void* const brace = std::memchr(bytes.data(), '{', bytes.size());
  if (!brace) return bytes.size();
  return static_cast<std::size_t>(static_cast<const std::uint8_t*>(brace) - bytes.data());
}

/// What goes on here is an object inside a torn line.
Scan behind_object(Bytes bytes, std::size_t end) {
  constexpr std::string_view goes_on = ",]} \t";
  if (end == bytes.size()) return Scan::need_more();
  if (goes_on.find(static_cast<char>(bytes[end])) != goes_on.npos) return Scan::skip(1);
  return with_line_end(bytes, end);
}

}  // namespace

Scan WaterLinkedJson::scan(Bytes bytes) {
  if (bytes.empty()) return Scan::need_more();
  if (bytes[0] != '{') return Scan::skip(before_object(bytes));
  if (bytes.size() > 1 && bytes[1] != '"' && bytes[1] != '}') return Scan::skip(1);
  constexpr std::size_t longest = max_frame - line_end_size;
  JsonReader reader(as_text(bytes.first(std::min(bytes.size(), longest))));
  reader.skip();
  if (reader.sound()) return behind_object(bytes, reader.at());
  return reader.cut() && bytes.size() < longest ? Scan::need_more() : Scan::bad_checksum();
}

}  // namespace drydock::wire
