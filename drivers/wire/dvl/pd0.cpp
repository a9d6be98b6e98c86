#include "drivers/wire/dvl/pd0.hpp"

#include <algorithm>
#include <cstring>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/checksum.hpp"
#include "drivers/wire/dvl/pd0_blocks.hpp"

namespace drydock::wire {
namespace {

constexpr std::uint8_t sync = 0x7F;
constexpr std::size_t header_size = 6, checksum_size = 2;

/// Number of bytes before the next 7F 7F. A 7F at the very end counts as a possible start.
std::size_t distance_to_sync(Bytes bytes) {
  const std::uint8_t* at = bytes.data();
  const std::uint8_t* const end = at + bytes.size();
  while (at != end) {
    at =
        static_cast<const std::uint8_t*>(std::memchr(at, sync, static_cast<std::size_t>(end - at)));
    if (!at) return bytes.size();
    if (at + 1 == end || at[1] == sync) break;
    ++at;
  }
  return static_cast<std::size_t>(at - bytes.data());
}

/// The offsets of the data types. Each is checked against the frame when its block is requested.
class OffsetTable {
 public:
  explicit OffsetTable(Bytes frame)
      : data_(frame.first(frame.size() - checksum_size)),
        count_(std::min<std::size_t>(data_[5], (data_.size() - header_size) / 2)) {}

  std::size_t size() const { return count_; }

  /// A block ends where the next block in the frame begins. That block may have any place in the
  /// table.
  Bytes block(std::size_t index) const {
    const std::size_t begin = offset(index);
    if (begin + 2 > data_.size()) return {};
    std::size_t end = data_.size();
    for (std::size_t i = 0; i < count_; ++i) {
      if (const std::size_t other = offset(i); other > begin) end = std::min(end, other);
    }
    return data_.subspan(begin, end - begin);
  }

  /// Id of a data type. 0xFFFF if its offset points outside.
  std::uint16_t id(std::size_t index) const {
    const std::size_t begin = offset(index);
    return begin + 2 <= data_.size() ? load_le<std::uint16_t>(data_, begin) : 0xFFFF;
  }

 private:
  std::size_t offset(std::size_t index) const {
    return load_le<std::uint16_t>(data_, header_size + 2 * index);
  }

  Bytes data_;
  std::size_t count_;
};

/// The data types of `decode` of which an ensemble has one.
constexpr bool is_read(std::uint16_t id) {
  return id == pd0::fixed_leader || id == pd0::variable_leader || id == pd0::bottom_track ||
         id == pd0::high_resolution || id == pd0::bottom_range || id == pd0::navigation;
}

template <class Block>
void read_optional(Bytes block, std::optional<Block>& m) {
  if (Block read; read_block(block, read)) m = read;
}

}  // namespace

Scan Pd0::scan(Bytes bytes) {
  if (const std::size_t noise = distance_to_sync(bytes)) return Scan::skip(noise);
  if (bytes.size() < header_size) return Scan::need_more();
  const std::size_t checked = load_le<std::uint16_t>(bytes, 2);
  const std::size_t smallest = header_size + 2u * bytes[5];
  if (bytes[5] == 0 || checked < smallest || checked + checksum_size > max_frame) {
    return Scan::skip(1);
  }
  if (bytes.size() < checked + checksum_size) return Scan::need_more(checked + checksum_size);
  return byte_sum(bytes.first(checked)) == load_le<std::uint16_t>(bytes, checked)
             ? Scan::frame(checked + checksum_size)
             : Scan::bad_checksum();
}

std::optional<Pd0::Message> Pd0::decode(Bytes frame) {
  if (frame.size() < header_size + checksum_size) return std::nullopt;
  const OffsetTable table{frame};
  bool has_fixed = false, has_variable = false;
  Pd0Ensemble m;
  for (std::size_t i = 0; i < table.size(); ++i) {
    switch (table.id(i)) {
      case pd0::fixed_leader: has_fixed |= read_block(table.block(i), m.fixed); break;
      case pd0::variable_leader: has_variable |= read_block(table.block(i), m.variable); break;
      case pd0::bottom_track: read_optional(table.block(i), m.bottom_track); break;
      case pd0::high_resolution: read_optional(table.block(i), m.high_resolution); break;
      case pd0::bottom_range: read_optional(table.block(i), m.bottom_range); break;
      case pd0::navigation: read_optional(table.block(i), m.navigation); break;
      case pd0::computer_navigation: read_block(table.block(i), m.computer); break;
      default: read_block(table.block(i), m.winriver); break;
    }
  }
  // Without both leaders the frame of the velocities and their time are not known.
  if (!has_fixed || !has_variable) return std::nullopt;
  if ((m.fixed.sensors_available & pd0::has_depth_sensor) == 0) m.variable.pressure_pa.reset();
  return m;
}

void Pd0::unread_blocks(Bytes frame, const std::function<void(std::uint16_t)>& tell) {
  if (frame.size() < header_size + checksum_size) return;
  const OffsetTable table{frame};
  WinRiverSentences sentences;
  Pd0ComputerNavigation computer;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const std::uint16_t id = table.id(i);
    const bool read =
        is_read(id) || (id == pd0::computer_navigation ? read_block(table.block(i), computer)
                                                       : read_block(table.block(i), sentences));
    if (!read) tell(id);
  }
}

}  // namespace drydock::wire
