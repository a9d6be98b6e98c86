#include "drivers/decode/decode_by_dbc.hpp"

#include <map>
#include <vector>

#include "drivers/decode/records.hpp"
#include "drivers/decode/signal_keys.hpp"
#include "drivers/wire/dbc/catalogue.hpp"
#include "drivers/wire/dbc/plan.hpp"
#include "drivers/wire/dbc/reader.hpp"
#include "drivers/wire/dbc/whole_value.hpp"
#include "drivers/wire/j1939/j1939_protocol.hpp"

namespace drydock::decode {

namespace {

namespace dbc = wire::dbc;

constexpr std::size_t most_unknown_shown = 12;

/// A message with its plan and the values of its last frame.
struct Entry {
  explicit Entry(const dbc::Message& described)
      : message(&described), plan(described), keys(keys_of(described)), values(plan.size()) {}

  const dbc::Message* message;
  dbc::Plan plan;
  std::vector<SignalKeys> keys;
  std::vector<dbc::Value> values;
  std::uint64_t count = 0;
  std::uint64_t cut_short = 0;
};

/// Prints messages as lines, or counts them.
class Messages {
 public:
  Messages(const dbc::Database& database, bool count, std::FILE* out)
      : catalogue_(database), count_(count), lines_(out) {
    for (const dbc::Message& m : database.messages) entries_.emplace_back(m);
  }

  void receive(const capture::Record& record) {
    ++frames_;
    const wire::CanFrame& frame = record.frame;
    if (frame.error || frame.remote) {
      ++(frame.error ? errors_ : requests_);
    } else if (const auto place = catalogue_.find(frame)) {
      take(entries_[*place], wire::j1939::parse_identifier(frame.id), frame.payload(), record);
    } else if (!is_packet(frame)) {
      ++unknown_[{frame.extended, frame.id}];
    } else if (const auto whole = packets(record)) {
      const auto id = wire::j1939::make_identifier(whole->id);
      const auto message = catalogue_.find(id, true);
      if (!message) ++unknown_[{true, id}];
      if (message) take(entries_[*message], whole->id, whole->data, record);
    }
  }

  bool flush() { return lines_.flush(); }

  void finish() {
    if (!count_) return;
    for (const Entry& e : entries_)
      if (e.count > 0)
        lines_.line([&](text::JsonWriter& json) {
          json.field("type", e.message->long_name);
          json.field("count", e.count);
        });
  }

  std::uint64_t total() const {
    std::uint64_t sum = 0;
    for (const Entry& e : entries_) sum += e.count;
    return sum;
  }

  void print_totals(std::FILE* err, const capture::FrameCapture& capture) const {
    std::uint64_t cut = 0, unknown = 0;
    for (const Entry& e : entries_) cut += e.cut_short;
    for (const auto& [id, count] : unknown_) unknown += count;
    if (capture.format() != nullptr) fmt::print(err, "{}: ", capture.format()->name);
    fmt::print(err, "{} frames, {} messages, {} of them cut short, {} frames without a message\n",
               frames_, total(), cut, unknown);
    if (unknown > 0) print_unknown(err);
    if (errors_ + requests_ > 0)
      fmt::print(err, "{} error frames, {} remote frames: they carry no signals\n", errors_,
                 requests_);
    std::uint64_t incomplete = 0;
    for (const auto& [name, bus] : transports_)
      incomplete += bus.counters().dropped + bus.counters().headless + bus.unfinished();
    if (incomplete > 0)
      fmt::print(err, "{} messages of several frames are not whole\n", incomplete);
  }

 private:
  using Identifier = std::pair<bool, std::uint32_t>;  ///< 29 bits, identifier

  static bool is_packet(const wire::CanFrame& frame) {
    const auto id = wire::j1939::identify(frame);
    return id && wire::is_transport(id->pgn);
  }

  std::optional<wire::j1939::TransportMessage> packets(const capture::Record& record) {
    const auto id = wire::j1939::identify(record.frame);
    auto& bus = transports_[std::string(record.interface)];
    return bus
        .receive(*id, record.frame.payload(), record.time.value_or(std::chrono::nanoseconds{}))
        .message;
  }

  void take(Entry& e, const wire::j1939::Identifier& id, wire::Bytes payload,
            const capture::Record& record) {
    ++e.count;
    e.cut_short += payload.size() < e.message->size;
    if (count_) return;
    e.plan.decode(payload, e.values);
    lines_.line([&](text::JsonWriter& json) {
      json.field("type", e.message->long_name);
      put_record(json, record);
      if (e.message->extended && e.message->format == dbc::FrameFormat::j1939) {
        json.field("source", id.source);
        json.field("destination", id.destination);
      }
      for (std::size_t i = 0; i < e.values.size(); ++i)
        put(json, e.keys[i], e.message->signals[i], e.values[i]);
    });
  }

  /// A signal whose values have names has a second key for them.
  static void put(text::JsonWriter& json, const SignalKeys& keys, const dbc::Signal& signal,
                  const dbc::Value& value) {
    put_number(json, keys.number, signal, value);
    if (keys.label.empty()) return;
    const auto* label =
        value.present ? signal.label_of(static_cast<std::int64_t>(value.raw)) : nullptr;
    json.field(keys.label, label ? std::optional<std::string_view>(*label) : std::nullopt);
  }

  static void put_number(text::JsonWriter& json, std::string_view key, const dbc::Signal& signal,
                         const dbc::Value& value) {
    using Number = std::optional<double>;
    const auto whole = value.present ? dbc::whole_value(value, signal.layout) : std::nullopt;
    if (whole)
      std::visit([&](auto number) { json.field(key, number); }, *whole);
    else
      json.field(key, value.present ? Number(value.physical) : Number());
  }

  void print_unknown(std::FILE* err) const {
    fmt::print(err, "no message:");
    std::size_t shown = 0;
    for (const auto& [id, count] : unknown_) {
      if (shown++ == most_unknown_shown) break;
      fmt::print(err, " {:0{}X} ({})", id.second, id.first ? 8 : 3, count);
    }
    if (unknown_.size() > most_unknown_shown)
      fmt::print(err, " and {} more identifiers", unknown_.size() - most_unknown_shown);
    fmt::print(err, "\n");
  }

  dbc::Catalogue catalogue_;
  bool count_;
  text::JsonLines lines_;
  std::vector<Entry> entries_;
  std::map<std::string, wire::j1939::TransportReceiver> transports_;  ///< by interface
  std::map<Identifier, std::uint64_t> unknown_;
  std::uint64_t frames_ = 0, errors_ = 0, requests_ = 0;
};

void print(std::FILE* err, const std::string& file, const std::vector<dbc::Remark>& remarks,
           std::string_view kind) {
  for (const dbc::Remark& r : remarks)
    fmt::print(err, "{}:{}:{}: {}{}\n", file, r.at.line, r.at.column, kind, r.text);
}

}  // namespace

int decode_by_dbc(const DecodeOptions& options, std::FILE* out, std::FILE* err) {
  capture::FileBlocks file(options.dbc);
  const std::string text = contents(file, dbc::longest_text);
  if (file.error() != 0) return refuse(err, cannot_read(options.dbc, file.error()));
  const dbc::Reading reading = dbc::read(text);
  print(err, options.dbc, reading.errors, "");
  if (!options.quiet) print(err, options.dbc, reading.warnings, "warning: ");
  if (reading.remarks_left_out > 0)
    fmt::print(err, "{}: and {} more\n", options.dbc, reading.remarks_left_out);
  if (!reading.errors.empty()) return refuse(err, "the DBC file has errors");
  Messages messages(reading.database, options.count, out);
  return decode_frames(messages, options, err);
}

}  // namespace drydock::decode
