#include <numeric>

#include "tests/drivers/described/golden_descriptions.hpp"

namespace drydock::described::test {
namespace {

using wire::Bytes;
using wire::testing::as_text;

/// A CRC of 16 bits that begins with FFFFh and takes the lowest bit first.
unsigned reflected_crc(Bytes bytes, unsigned polynomial) {
  unsigned crc = 0xFFFF;
  for (const unsigned byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ polynomial : crc >> 1;
  }
  return crc;
}

unsigned sum_of(Bytes bytes) { return std::accumulate(bytes.begin(), bytes.end(), 0u); }

unsigned big_endian(Bytes bytes) {
  return std::accumulate(bytes.begin(), bytes.end(), 0u,
                         [](unsigned all, unsigned byte) { return all << 8 | byte; });
}

}  // namespace

bool xor_is_right(Bytes sentence) {
  const auto text = as_text(sentence);
  const auto star = text.rfind('*');
  if (star == text.npos || (text[0] != '$' && text[0] != '!') || star + 3 > text.size())
    return false;
  const int sum = std::accumulate(text.begin() + 1, text.begin() + static_cast<long>(star), 0,
                                  [](int x, char c) { return x ^ c; });
  return std::stoi(std::string(text.substr(star + 1, 2)), nullptr, 16) == sum;
}

bool modbus_is_right(Bytes frame) {
  return reflected_crc(frame.first(frame.size() - 2), 0xA001) == big_endian(frame.last(2));
}

bool smbus_is_right(Bytes sentence) {
  const auto text = as_text(sentence);
  const auto star = text.rfind('*');
  if (star == text.npos || text[0] != 'w') return false;
  unsigned crc = 0;
  for (const char c : text.substr(0, star)) {
    for (int bit = 7; bit >= 0; --bit) {
      const unsigned carry = crc >> 7 ^ (static_cast<unsigned char>(c) >> bit & 1u);
      crc = (crc << 1 & 0xFF) ^ (carry ? 7 : 0);
    }
  }
  return std::stoul(std::string(text.substr(star + 1, 2)), nullptr, 16) == crc;
}

bool x25_is_right(Bytes frame) {
  const unsigned crc = reflected_crc(frame.first(frame.size() - 2), 0x8408) ^ 0xFFFF;
  return frame.back() == crc >> 8 && frame[frame.size() - 2] == (crc & 0xFF);
}

bool fletcher_is_right(Bytes frame) {
  unsigned a = 0, b = 0;
  for (const unsigned byte : frame.first(frame.size() - 2)) b += a += byte;
  return frame[frame.size() - 2] == a % 256 && frame.back() == b % 256;
}

bool xbus_is_right(Bytes frame) { return frame[0] == 0xFA && sum_of(frame.subspan(1)) % 256 == 0; }

bool stdbin_is_right(Bytes frame) {
  return as_text(frame).starts_with("IX") &&
         sum_of(frame.first(frame.size() - 4)) == big_endian(frame.last(4));
}

bool is_of_digiquartz(Bytes line) { return as_text(line).starts_with("*0001"); }

}  // namespace drydock::described::test
