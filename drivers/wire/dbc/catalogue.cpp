#include "drivers/wire/dbc/catalogue.hpp"

#include <algorithm>

#include "drivers/wire/j1939/j1939.hpp"

namespace drydock::wire::dbc {

namespace {

std::uint64_t identifier_key(std::uint32_t id, bool extended) {
  return std::uint64_t{extended} << 32 | id;
}

std::uint64_t group_key(std::uint32_t pgn, std::uint8_t source) {
  return std::uint64_t{pgn} << 8 | source;
}

}  // namespace

Catalogue::Catalogue(const Database& database) {
  for (std::size_t i = 0; i < database.messages.size(); ++i) {
    const Message& m = database.messages[i];
    identifiers_.push_back({identifier_key(m.id, m.extended), i});
    if (m.format != FrameFormat::j1939) continue;
    const auto id = j1939::parse_identifier(m.id);
    groups_.push_back({group_key(id.pgn, id.source), i});
  }
  std::ranges::stable_sort(identifiers_, {}, &Entry::key);
  std::ranges::stable_sort(groups_, {}, &Entry::key);
}

std::optional<std::size_t> Catalogue::find(const std::vector<Entry>& entries, std::uint64_t key) {
  const auto found = std::ranges::lower_bound(entries, key, {}, &Entry::key);
  if (found == entries.end() || found->key != key) return std::nullopt;
  return found->message;
}

std::optional<std::size_t> Catalogue::find(const CanFrame& frame) const {
  if (frame.remote || frame.error) return std::nullopt;
  return find(frame.id, frame.extended);
}

std::optional<std::size_t> Catalogue::find(std::uint32_t id, bool extended) const {
  if (const auto exact = find(identifiers_, identifier_key(id, extended))) return exact;
  if (!extended) return std::nullopt;
  const auto parsed = j1939::parse_identifier(id);
  if (const auto own = find(groups_, group_key(parsed.pgn, parsed.source))) return own;
  return find(groups_, group_key(parsed.pgn, any_source));
}

}  // namespace drydock::wire::dbc
