#include "drivers/capture/formats/ixxat.hpp"

#include <algorithm>
#include <array>

#include "drivers/capture/table_row.hpp"
#include "drivers/capture/words.hpp"

namespace drydock::capture {

namespace {

using std::chrono::nanoseconds;

constexpr std::array<std::string_view, 6> words_of_the_head{
    "ASCII Trace IXXAT", "Date:", "Start time:", "Stop time:", "Overruns:", "Baudrate:"};

/// `00:30:06.866`, `9:5:2.25`; `12.345.678.900`: seconds, ms, us, ns.
std::optional<nanoseconds> parse_told(std::string_view text) {
  const std::size_t first = text.find(':'), second = text.find(':', first + 1);
  if (first == text.npos) {
    constexpr std::size_t decimals_behind = 12;  // .345.678.900
    if (std::ranges::count(text, '.') != 3 || text.size() <= decimals_behind) return std::nullopt;
    std::string figures(text);
    figures.erase(figures.size() - 4, 1).erase(figures.size() - 7, 1);
    return parse_time(figures, 9);
  }
  if (second == text.npos) return std::nullopt;
  const auto hours = parse_number(text.substr(0, first), 10);
  const auto minutes = parse_number(text.substr(first + 1, second - first - 1), 10);
  const auto seconds = parse_time(text.substr(second + 1), 9);
  if (!hours || !minutes || !seconds || *hours > 23 || *minutes > 59 ||
      *seconds >= std::chrono::minutes{1})
    return std::nullopt;
  return std::chrono::hours{*hours} + std::chrono::minutes{*minutes} + *seconds;
}

/// The last number in `CAN 2`; 1: there is none.
std::uint32_t bus_in(std::string_view text) {
  const std::size_t digits = text.find_last_not_of("0123456789") + 1;
  return std::max(parse_number(text.substr(digits), 10).value_or(1), 1u);
}

/// `Remote request DLC = 4` in the place of data.
std::optional<std::uint32_t> requested(std::string_view text) {
  const std::size_t equals = text.find('=');
  return equals == text.npos ? std::nullopt
                             : parse_number(Words(text.substr(equals + 1)).peek(), 10);
}

bool read_bytes(std::string_view text, int base, wire::CanFrame& frame) {
  Words count(text), words(text);
  std::size_t size = 0;
  while (!count.next().empty()) ++size;
  frame.fd = size > 8;
  return (!frame.fd || is_fd_size(static_cast<std::uint32_t>(size))) &&
         read_data(words, size, base, frame);
}

}  // namespace

std::optional<Ixxat::Columns> Ixxat::columns_in(std::string_view head) {
  Columns columns;
  columns.separator = separator_of(head);
  if (columns.separator == '\0') return std::nullopt;
  const TableRow names = row_of(head, columns.separator);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto named = names[i];
    const int base = named.ends_with("(dec)") ? 10 : 16;
    if (named == "Bus") columns.bus = i;
    if (named == "Format") columns.format = i;
    if (named == "Flags" || named.starts_with("State")) columns.state = i;
    if (named == "DLC" || named == "Length") columns.length = i;
    if (named == "Time" || named.starts_with("Time (")) columns.time = i;
    if (named.starts_with("Time (rel")) columns.relative = true;
    if (named.starts_with("Identifier (") || named.starts_with("ID (")) {
      columns.id = i;
      columns.id_base = base;
    }
    if (named.starts_with("Data (")) {
      columns.data = i;
      columns.data_base = base;
    }
  }
  const bool known = columns.time && columns.id && columns.data && (columns.format || columns.bus);
  return known ? std::optional(columns) : std::nullopt;
}

bool Ixxat::recognises(std::string_view line) {
  return line.starts_with(words_of_the_head[0]) || columns_in(line);
}

Reading Ixxat::read_line(std::string_view line) {
  if (const auto columns = columns_in(line)) {
    columns_ = columns;
    return Reading::nothing();
  }
  if (std::ranges::any_of(words_of_the_head,
                          [&](std::string_view word) { return line.starts_with(word); }))
    return Reading::nothing();
  return Reading::of(columns_ ? frame_of(line) : std::nullopt);
}

nanoseconds Ixxat::since_midnight(nanoseconds told) {
  if (!columns_->relative) return clock_.since_first_midnight(told);
  sum_ = std::min(sum_ + told, latest_time);
  return sum_;
}

std::optional<Record> Ixxat::frame_of(std::string_view line) {
  const TableRow row = row_of(line, columns_->separator);
  const auto field = [&](std::optional<std::size_t> place) {
    return place && *place < row.size() ? row[*place] : std::string_view();
  };
  const auto told = parse_told(field(columns_->time));
  const auto identifier = field(columns_->id), format = field(columns_->format),
             data = field(columns_->data);
  const auto id = parse_number(identifier, columns_->id_base);
  if (!told || !id || *columns_->data >= row.size() ||
      (columns_->format && format != "Std" && format != "Ext"))
    return std::nullopt;
  Record record;
  auto& frame = record.frame;
  frame.id = *id;
  frame.extended = columns_->format ? format == "Ext" : identifier.size() > 4 || *id > 0x7FF;
  if (*id > (frame.extended ? 0x1FFFFFFFu : 0x7FFu)) return std::nullopt;
  const auto length = parse_number(field(columns_->length), 10);
  frame.remote = data.starts_with("Remote") || field(columns_->state).find("Rtr") != line.npos;
  if (frame.remote) {
    const auto size = length ? length : requested(data);
    if (!size || *size > 8) return std::nullopt;
    frame.size = static_cast<std::uint8_t>(*size);
  } else if (!read_bytes(data, columns_->data_base, frame)) {
    return std::nullopt;
  }
  const auto coded = length ? size_of_length_code(*length) : std::nullopt;
  if (length && frame.size != *length && frame.size != coded) return std::nullopt;
  record.time = since_midnight(*told);
  interface_ = "can" + std::to_string(bus_in(field(columns_->bus)) - 1);
  record.interface = interface_;
  return record;
}

}  // namespace drydock::capture
