#include "tests/drivers/wire/sound_frames.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>

#include "tests/drivers/wire/byte_streams.hpp"

namespace drydock::wire::testing {

/// XOR of all between '$' or '!' and '*'.
bool sound_sentence(Bytes frame) {
  const std::string_view text = as_text(frame);
  const std::size_t star = text.rfind('*');
  const bool begins = !text.empty() && (text[0] == '$' || text[0] == '!');
  if (!begins || star == text.npos || star + 3 > text.size()) return false;
  const int sum = std::accumulate(text.begin() + 1, text.begin() + static_cast<long>(star), 0,
                                  [](int x, char c) { return x ^ c; });
  return std::stoi(std::string{text.substr(star + 1, 2)}, nullptr, 16) == sum;
}

/// Fletcher-8 of all between the sync and the sum.
bool sound_ubx(Bytes frame) {
  unsigned a = 0, b = 0;
  for (const auto byte : frame.subspan(2, frame.size() - 4)) b = (b + (a = (a + byte) % 256)) % 256;
  return frame[0] == 0xB5 && frame[1] == 0x62 && frame[frame.size() - 2] == a && frame.back() == b;
}

/// A command may omit the checksum: then there is no star before the line's end.
bool sound_water_linked(Bytes frame) {
  const std::string_view text = as_text(frame);
  const std::size_t star = text.find('*');
  if (star == text.npos) return text.starts_with("wc");
  unsigned crc = 0;
  for (const char c : text.substr(0, star)) {
    for (int bit = 7; bit >= 0; --bit) {
      const unsigned carry = crc >> 7 ^ (static_cast<unsigned char>(c) >> bit & 1u);
      crc = (crc << 1 & 0xFF) ^ (carry ? 7 : 0);
    }
  }
  return std::stoul(std::string{text.substr(star + 1, 2)}, nullptr, 16) == crc;
}

/// There is no checksum. A line has a head, fields without a second colon and a line end. A known
/// line also has the right number of fields.
bool sound_pd6(Bytes frame) {
  const std::string_view text = as_text(frame);
  if (text.size() < 5 || text[0] != ':' || text.rfind(':') != 0 || text[3] != ',') return false;
  if (!text.ends_with('\n')) return false;
  const auto fields = std::ranges::count(text, ',');
  const std::string_view name = text.substr(1, 2);
  if (name == "SA") return fields == 3;
  if (name == "TS") return fields == 6;
  if (name[0] != 'B' && name[0] != 'W') return true;
  if (name[1] == 'I' || name[1] == 'D') return fields == 5;
  return (name[1] != 'S' && name[1] != 'E') || fields == 4;
}

/// Sums of 16-bit words from B58C; an odd last byte is a high byte.
bool sound_ad2cp(Bytes frame) {
  const auto sum = [](Bytes bytes) {
    unsigned total = 0xB58C;
    for (std::size_t i = 0; i < bytes.size(); ++i)
      total += i % 2 == 1 || i + 1 == bytes.size() ? bytes[i] * 256u : bytes[i];
    return total % 65536;
  };
  const auto word = [&](std::size_t at) { return frame[at] + 256u * frame[at + 1]; };
  const std::size_t header = frame[1];
  return frame[0] == 0xA5 && (header == 10 || header == 12) &&
         word(header - 2) == sum(frame.first(header - 2)) &&
         word(header - 4) == sum(frame.subspan(header)) && frame.size() == header + word(4);
}

/// There is no checksum. Outside of texts the brackets match, and the last one ends the object.
bool sound_water_linked_json(Bytes frame) {
  std::string_view text = as_text(frame);
  while (text.ends_with('\n') || text.ends_with('\r')) text.remove_suffix(1);
  std::string open;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '\\') ++i;
    if (c == '"') quoted = !quoted;
    if (quoted || (c != '{' && c != '[' && c != '}' && c != ']')) continue;
    if (i > 0 && open.empty()) return false;
    if (c == '{' || c == '[') {
      open += c;
    } else if (open.back() != (c == '}' ? '{' : '[')) {
      return false;
    } else {
      open.pop_back();
    }
  }
  return text.starts_with('{') && text.ends_with('}') && open.empty() && !quoted;
}

/// A sentence or a UBX frame on one line.
bool sound_ubx_nmea(Bytes frame) {
  return frame[0] == '$' || frame[0] == '!' ? sound_sentence(frame) : sound_ubx(frame);
}

namespace {

/// The last two bytes are the sum of all others, little-endian.
bool sums_up(Bytes frame) {
  const std::size_t n = frame.size() - 2;
  return frame[n] + 256u * frame[n + 1] ==
         std::accumulate(frame.begin(), frame.end() - 2, 0u) % 65536;
}

}  // namespace

bool sound_pd0(Bytes frame) { return sums_up(frame) && frame[0] == 0x7F && frame[1] == 0x7F; }

bool sound_pd4_or_pd5(Bytes frame) {
  return sums_up(frame) && frame[0] == 0x7D && frame[2] + 256u * frame[3] == frame.size() - 2;
}

bool sound_wayfinder(Bytes frame) {
  return sums_up(frame) && frame[0] == 0xAA && frame[3] + 256u * frame[4] == frame.size();
}

/// MAVLink's own form of the sum, and its table of seeds for the kinds of the golden frames.
bool sound_mavlink(Bytes frame) {
  static const std::map<unsigned, unsigned> seeds{
      {0, 50},   {2, 137}, {24, 24},  {27, 144}, {29, 115}, {30, 39},  {32, 185},
      {33, 104}, {74, 20}, {111, 34}, {132, 85}, {253, 83}, {331, 91}, {11011, 106}};
  const bool second = frame[0] == 0xFD;
  const std::size_t header = second ? 10 : 6, end = header + frame[1];
  const unsigned id = second ? frame[7] + 256u * frame[8] + 65536u * frame[9] : frame[5];
  const std::size_t signature = second && frame[2] == 1 ? 13 : 0;
  const auto seed = seeds.find(id);
  if (seed == seeds.end() || frame.size() != end + 2 + signature) return false;
  unsigned sum = 0xFFFF;
  const auto add = [&](unsigned byte) {
    unsigned t = byte ^ (sum & 0xFF);
    t = (t ^ t << 4) & 0xFF;
    sum = (sum >> 8 ^ t << 8 ^ t << 3 ^ t >> 4) & 0xFFFF;
  };
  for (const std::uint8_t byte : frame.subspan(1, end - 1)) add(byte);
  add(seed->second);
  return sum == frame[end] + 256u * frame[end + 1];
}

}  // namespace drydock::wire::testing
