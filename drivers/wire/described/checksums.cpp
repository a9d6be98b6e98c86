#include "drivers/wire/described/checksums.hpp"

#include <algorithm>
#include <string>

#include "drivers/wire/checksum.hpp"

namespace drydock::wire::described {
namespace {

constexpr std::uint32_t reversed(std::uint32_t value, unsigned bits) {
  std::uint32_t result = 0;
  for (unsigned i = 0; i < bits; ++i) result |= (value >> i & 1) << (bits - 1 - i);
  return result;
}

/// A CRC that is not reflected stands in the top bits of 32. So one loop serves every width.
constexpr std::uint32_t entry_of(const Crc& crc, std::uint32_t index) {
  if (crc.reflected) {
    const std::uint32_t polynomial = reversed(crc.polynomial, crc.width);
    for (int bit = 0; bit < 8; ++bit) index = index >> 1 ^ ((index & 1) != 0 ? polynomial : 0);
    return index;
  }
  std::uint32_t value = index << 24;
  const std::uint32_t polynomial = crc.polynomial << (32 - crc.width);
  for (int bit = 0; bit < 8; ++bit) value = value << 1 ^ ((value >> 31) != 0 ? polynomial : 0);
  return value;
}

std::uint32_t word_sum(Bytes bytes, bool big_endian) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    sum += std::uint32_t{bytes[i]} << ((i % 2 == 0) == big_endian ? 8 : 0);
  return sum & 0xFFFF;
}

std::uint32_t fletcher_255(Bytes bytes) {
  std::uint32_t low = 0, high = 0;
  for (const std::uint8_t byte : bytes) {
    low = (low + byte) % 255;
    high = (high + low) % 255;
  }
  return high << 8 | low;
}

std::string in_small_letters(std::string_view name) {
  std::string small(name);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

std::uint8_t exclusive_or(Bytes bytes) {
  std::uint64_t sum = 0;
  for (; bytes.size() >= 8; bytes = bytes.subspan(8)) sum ^= load_le<std::uint64_t>(bytes, 0);
  std::uint8_t result = xor_of_bytes(sum);
  for (const std::uint8_t byte : bytes) result = static_cast<std::uint8_t>(result ^ byte);
  return result;
}

}  // namespace

Checksum::Checksum(const Crc& crc)
    : Checksum(crc.name, crc.reflected ? Way::crc_reflected : Way::crc, crc.width) {
  start_ = crc.reflected ? reversed(crc.start, crc.width) : crc.start << (32 - crc.width);
  xor_out_ = crc.xor_out;
  for (std::uint32_t i = 0; i < table_.size(); ++i) table_[i] = entry_of(crc, i);
}

bool Checksum::find(std::string_view word, Checksum& into) {
  const std::string small = in_small_letters(word);
  const auto alias = std::ranges::find(crc_aliases, small, &CrcAlias::alias);
  const std::string_view name = alias == crc_aliases.end() ? std::string_view(small) : alias->name;
  const auto take = [&](std::string_view known, Way way, unsigned width) {
    if (known == name) into = Checksum(known, way, width);
    return known == name;
  };
  if (take("none", Way::none, 0) || take("xor", Way::exclusive_or, 8) ||
      take("fletcher-16", Way::fletcher, 16) || take("fletcher-16-255", Way::fletcher_255, 16) ||
      take("sum-15", Way::sum, 15))
    return true;
  const auto plain = std::ranges::find(plain_checksums, name);
  if (plain != plain_checksums.end()) {
    const bool words = name.starts_with("word-");
    const bool big = name.starts_with("word-sum-16-big");
    const unsigned width = name.starts_with("sum-8") ? 8 : name.starts_with("sum-32") ? 32 : 16;
    return take(*plain, big ? Way::big_word_sum : words ? Way::word_sum : Way::sum, width);
  }
  const auto found = std::ranges::find(crcs, name, &Crc::name);
  if (found == crcs.end()) return false;
  into = Checksum(*found);
  return true;
}

std::vector<std::string_view> checksum_names() {
  std::vector<std::string_view> names(plain_checksums.begin(), plain_checksums.end());
  for (const Crc& crc : crcs) names.push_back(crc.name);
  return names;
}

std::uint32_t Checksum::finished(std::uint32_t sum) const {
  if (finish_ == Finish::negative) sum = -sum;
  if (finish_ == Finish::inverted) sum = ~sum;
  return sum & (0xFFFFFFFFu >> (32 - width_));
}

template <Checksum::Way way>
std::uint32_t Checksum::crc_of(Bytes bytes, Bytes extra) const {
  std::uint32_t crc = start_;
  for (const Bytes part : {bytes, extra})
    for (const std::uint8_t byte : part) crc = after<way>(crc, byte);
  return out_of(crc);
}

template <Checksum::Way way>
std::array<std::uint32_t, 3> Checksum::crcs_of(const std::array<Bytes, 3>& each) const {
  const auto [a, b, c] = each;
  const std::size_t common = std::min({a.size(), b.size(), c.size()});
  std::uint32_t of_a = start_, of_b = start_, of_c = start_;
  for (std::size_t i = 0; i < common; ++i) {
    of_a = after<way>(of_a, a[i]);
    of_b = after<way>(of_b, b[i]);
    of_c = after<way>(of_c, c[i]);
  }
  const auto finish = [&](std::uint32_t crc, Bytes bytes) {
    for (const std::uint8_t byte : bytes.subspan(common)) crc = after<way>(crc, byte);
    return out_of(crc);
  };
  return {finish(of_a, a), finish(of_b, b), finish(of_c, c)};
}

Checksum Checksum::linear() const {
  Checksum result = *this;
  result.start_ = result.xor_out_ = 0;
  return result;
}

std::uint64_t Checksum::polynomial() const {
  const std::uint32_t first = table_[way_ == Way::crc ? 1 : 128];  // the bit that leaves first
  return std::uint64_t{width_} << 33 | std::uint64_t{way_ == Way::crc} << 32 | first;
}

std::uint32_t Checksum::of(Bytes bytes, Bytes extra) const {
  switch (way_) {
    case Way::none: return 0;
    case Way::exclusive_or: return exclusive_or(bytes);
    case Way::sum: return finished(byte_total(bytes));
    case Way::word_sum: return finished(word_sum(bytes, false));
    case Way::big_word_sum: return finished(word_sum(bytes, true));
    case Way::fletcher_255: return fletcher_255(bytes);
    case Way::fletcher: return fletcher8(bytes);
    case Way::crc: return crc_of<Way::crc>(bytes, extra);
    case Way::crc_reflected: return crc_of<Way::crc_reflected>(bytes, extra);
  }
  return 0;
}

std::array<std::uint32_t, 3> Checksum::of_three(const std::array<Bytes, 3>& each) const {
  if (way_ == Way::crc) return crcs_of<Way::crc>(each);
  if (way_ == Way::crc_reflected) return crcs_of<Way::crc_reflected>(each);
  return {of(each[0]), of(each[1]), of(each[2])};
}

}  // namespace drydock::wire::described
