#include "drivers/decode/decode_by_pgns.hpp"

#include <fmt/ranges.h>

#include <map>

#include "drivers/decode/pgn_table_file.hpp"
#include "drivers/decode/records.hpp"
#include "drivers/wire/passed_over.hpp"
#include "drivers/wire/pgn_table/decode.hpp"
#include "drivers/wire/pgn_table/receiver.hpp"

namespace drydock::decode {
namespace {

namespace pgn_table = wire::pgn_table;

/// Prints messages as lines, or counts them.
class PgnMessages {
 public:
  PgnMessages(const pgn_table::Table& table, bool count, std::FILE* out)
      : catalogue_(table), missing_(table.missing_lookups), count_(count), lines_(out) {}

  void receive(const capture::Record& record) {
    ++frames_;
    auto bus = buses_.find(record.interface);
    if (bus == buses_.end())
      bus = buses_.emplace(std::string(record.interface), pgn_table::Receiver(catalogue_)).first;
    if (const auto whole =
            bus->second.receive(record.frame, record.time.value_or(std::chrono::nanoseconds{})))
      take(*whole, record);
    else if (bus->second.passed_over())
      ++passed_over_[wire::frame_name(record.frame, wire::Network::j1939)];
  }

  bool flush() { return lines_.flush(); }

  void finish() {
    for (const auto& [type, count] : counts_)
      lines_.line([&, type = std::string_view(type), count = count](text::JsonWriter& json) {
        json.field("type", type);
        json.field("count", count);
      });
  }

  std::uint64_t total() const { return messages_; }

  void print_totals(std::FILE* err, const capture::FrameCapture& capture) const {
    std::uint64_t incomplete = 0;
    for (const auto& [name, bus] : buses_) incomplete += bus.incomplete();
    if (capture.format() != nullptr) fmt::print(err, "{}: ", capture.format()->name);
    fmt::print(err, "{} frames, {} messages, {} of them cut short, {} incomplete\n", frames_,
               messages_, cut_short_, incomplete);
    if (!missing_.empty())
      fmt::print(err, "numbers without a label, as the table does not have their lookups: {}\n",
                 fmt::join(missing_, ", "));
    if (!passed_over_.empty()) fmt::print(err, "passed over:\n");
    for (const auto& [name, count] : passed_over_) fmt::print(err, "{:>8}  {}\n", count, name);
  }

 private:
  void take(const pgn_table::Receiver::Whole& whole, const capture::Record& record) {
    const auto* definition = catalogue_.find(whole.id.pgn, whole.data);
    if (definition == nullptr) {
      ++passed_over_[fmt::format("PGN {} of a form that the table does not have", whole.id.pgn)];
      return;
    }
    ++messages_;
    const auto message = pgn_table::decode(catalogue_, *definition, whole.data);
    cut_short_ += message.cut_short;
    if (count_) {
      ++counts_[definition->id];
      return;
    }
    lines_.line([&](text::JsonWriter& json) {
      json.field("type", definition->id);
      put_record(json, record);
      json.field("pgn", whole.id.pgn);
      json.field("source", whole.id.source);
      json.field("destination", whole.id.destination);
      json.field("fields", message.record);
    });
  }

  pgn_table::Catalogue catalogue_;
  std::vector<std::string> missing_;  ///< lookups
  bool count_;
  text::JsonLines lines_;
  std::map<std::string, pgn_table::Receiver, std::less<>> buses_;  ///< by interface
  std::map<std::string, std::uint64_t, std::less<>> counts_, passed_over_;
  std::uint64_t frames_ = 0, messages_ = 0, cut_short_ = 0;
};

}  // namespace

int decode_by_pgns(const DecodeOptions& options, std::FILE* out, std::FILE* err) {
  capture::FileBlocks file(options.pgns);
  const std::string text = contents(file, longest_pgn_table);
  if (file.error() != 0) return refuse(err, cannot_read(options.pgns, file.error()));
  const auto table = read_pgn_table(text);
  if (!table) return refuse(err, fmt::format("{}: {}", options.pgns, table.error().text));
  PgnMessages messages(*table, options.count, out);
  return decode_frames(messages, options, err);
}

}  // namespace drydock::decode
