#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "drivers/guess/binary_guess.hpp"
#include "drivers/guess/doubts.hpp"
#include "drivers/guess/guess_counters.hpp"
#include "drivers/guess/guess_messages.hpp"
#include "drivers/guess/header_sum.hpp"
#include "drivers/wire/described/plan.hpp"

namespace drydock::guess {
namespace {

using wire::Bytes;

std::string order_of(bool big_endian) { return big_endian ? ", order = \"big\"" : ""; }

std::string counter_text(const Guessed& one, const std::vector<Guessed>& all) {
  std::string note;
  if (one.size > 1) note = fmt::format("  # {:.10g} to {:.10g}", one.low, one.high);
  if (const auto at = wider_counter_at(one, all))
    note += fmt::format("; or u32 at {}, of which two bytes never changed", *at);
  return fmt::format("  {{ at = {}, type = \"{}\", name = \"counter_{}\"{} }},{}\n", one.at,
                     one.type, one.at, order_of(one.big_endian), note);
}

std::string field_text(const Guessed& one, const std::vector<Guessed>& all) {
  if (one.looks == Guessed::Looks::counter) return counter_text(one, all);
  return fmt::format("  {{ at = {}, type = \"{}\", name = \"at_{}\"{} }},  # {:.6g} to {:.6g}\n",
                     one.at, one.type, one.at, order_of(one.big_endian), one.low, one.high);
}

/// Bytes in a row that are always the same, or mostly.
struct Constants {
  std::size_t from = 0, to = 0;
  bool always = true;

  std::string text(Bytes frame) const {
    const char* how = always ? "always" : "mostly";
    if (to - from == 1)
      return fmt::format("  # byte {}: {} {} (0x{:02X})\n", from, how, frame[from], frame[from]);
    constexpr std::size_t shown = 16;
    return fmt::format("  # bytes {} to {}: {} {}{}\n", from, to - 1, how,
                       hex_of(frame.subspan(from, std::min(shown, to - from))),
                       to - from > shown ? " ..." : "");
  }
};

/// Runs of constant bytes, which only a comment names, and fields until they are too many.
class FieldList {
 public:
  FieldList(const BinaryGuess& guess, const MessageGuesses& kinds, const MessageGuess& kind,
            const std::optional<HeaderSum>& header)
      : guess_(guess), kinds_(kinds), kind_(kind), header_(header) {}

  std::string text() {
    const std::size_t tail = guess_.sum ? guess_.sum->tail() : std::size_t{0};
    identify();
    std::vector<std::size_t> known = kinds_.id_at;  // and the length
    for (std::size_t i = 0; guess_.length && i < guess_.length->size; ++i)
      known.push_back(guess_.length->at + i);
    for (std::size_t i = 0; guess_.sum && guess_.sum->at && i < guess_.sum->checksum.size(); ++i)
      known.push_back(*guess_.sum->at + i);
    if (header_)
      for (std::size_t i = 0; i < header_->checksum.size(); ++i) known.push_back(header_->at + i);
    const std::vector<Guessed> all = fields(known, kind_.shortest - tail);
    for (const Guessed& one : all) add(one, all);
    end_constants();
    if (left_out_ > 0) text_ += fmt::format("  # and {} more that change\n", left_out_);
    if (kind_.longest > kind_.shortest)
      text_ += fmt::format("  # the longest has {} bytes more\n", kind_.longest - kind_.shortest);
    return std::move(text_);
  }

 private:
  /// Counters, those first that count the frames of all kinds, and the numbers between them.
  std::vector<Guessed> fields(std::vector<std::size_t> known, std::size_t end) const {
    std::vector<Guessed> all;
    const auto take = [&](const std::vector<Guessed>& counters) {
      for (const Guessed& one : counters)
        for (std::size_t i = 0; i < one.size; ++i) known.push_back(one.at + i);
      all.insert(all.end(), counters.begin(), counters.end());
    };
    const std::size_t shortest = std::ranges::min(kinds_.all, {}, &MessageGuess::shortest).shortest;
    const std::size_t tail = kind_.shortest - end;
    take(guess_counters(guess_.frames, guess_.sync, shortest - tail, known));
    take(guess_counters(kind_.frames, guess_.sync, end, known));
    const auto numbers = guess_numbers(kind_.frames, guess_.sync, end, known);
    all.insert(all.end(), numbers.begin(), numbers.end());
    std::ranges::sort(all, {}, &Guessed::at);
    return all;
  }

  /// Identifiers that the sync cannot have with it, as constants.
  void identify() {
    for (std::size_t i = 0; i < kinds_.id_at.size(); ++i) {
      if (kinds_.id_at[i] == guess_.sync + i) continue;
      text_ +=
          fmt::format("  {{ at = {}, type = \"u8\", is = {} }},\n", kinds_.id_at[i], kind_.id[i]);
      ++fields_;
    }
  }

  void add(const Guessed& one, const std::vector<Guessed>& all) {
    if (one.looks == Guessed::Looks::constant) return add_constant(one);
    end_constants();
    if (fields_ == wire::described::most_fields)
      ++left_out_;
    else
      text_ += field_text(one, all), ++fields_;
  }

  void add_constant(const Guessed& one) {
    const bool always = one.low == one.high;
    if (constants_.to != one.at || constants_.always != always) {
      end_constants();
      constants_ = {one.at, one.at, always};
    }
    constants_.to = one.at + 1;
  }

  void end_constants() {
    if (constants_.to > constants_.from) text_ += constants_.text(kind_.frames[0]);
    constants_ = {};
  }

  const BinaryGuess& guess_;
  const MessageGuesses& kinds_;
  const MessageGuess& kind_;
  const std::optional<HeaderSum>& header_;
  std::string text_;
  Constants constants_;
  std::size_t fields_ = 0, left_out_ = 0;
};

/// The sync with those identifiers that follow it at once.
std::string sync_text(const BinaryGuess& guess, const MessageGuesses& kinds, Bytes frame) {
  std::size_t size = guess.sync;
  for (const std::size_t at : kinds.id_at) size += at == size;
  return size > 0 ? fmt::format("sync = \"{}\"\n", hex_of(frame.first(size))) : std::string();
}

/// Of packets the delimiters tell it.
std::string length_text(const BinaryGuess& guess, const MessageGuess& kind) {
  if (guess.packets) return {};
  if (!guess.length) return fmt::format("length = {}\n", kind.frames[0].size());
  const LengthField& field = *guess.length;
  return fmt::format("length = {{ at = {}, type = \"u{}\"{}{} }}\n", field.at, 8 * field.size,
                     field.size > 1 ? order_of(field.big_endian) : "",
                     field.plus > 0 ? fmt::format(", plus = {}", field.plus) : "");
}

std::string message_text(const BinaryGuess& guess, const MessageGuesses& kinds,
                         const MessageGuess& kind, const std::optional<HeaderSum>& header) {
  std::string name = "frame";
  for (const std::uint8_t byte : kind.id) name += fmt::format("_{:02X}", byte);
  return fmt::format(
      "\n[[protocol.binary]]             # {} frames\nname = \"{}\"\n{}{}"
      "fields = [\n{}]\n",
      kind.frames.size(), name, sync_text(guess, kinds, kind.frames[0]), length_text(guess, kind),
      FieldList(guess, kinds, kind, header).text());
}

std::string_view name_of(wire::described::Stuffing stuffing) {
  constexpr std::array<std::string_view, 5> names{"none", "dle", "slip", "hdlc", "cobs"};
  return names[static_cast<std::size_t>(stuffing)];
}

/// How much of the capture the guess explains.
std::string explained_text(const BinaryGuess& guess, std::size_t capture_bytes) {
  const std::size_t rest = capture_bytes - std::min(capture_bytes, guess.bytes());
  if (rest == 0) return "# The frames below are all bytes of the capture.\n";
  return fmt::format("# Not described: {} of {} bytes of the capture ({:.2g} %) are in no frame.\n",
                     rest, capture_bytes,
                     100 * static_cast<double>(rest) / static_cast<double>(capture_bytes));
}

std::string protocol_text(const BinaryGuess& guess, const MessageGuesses& kinds,
                          std::size_t capture_bytes, const std::optional<HeaderSum>& header) {
  std::string text =
      "\n[protocol]\n" + explained_text(guess, capture_bytes) + doubt_text(guess, kinds);
  constexpr std::size_t usual = 1024;
  const auto longest = std::ranges::max(kinds.all, {}, &MessageGuess::longest).longest;
  if (longest > usual) text += fmt::format("longest = {}\n", wire::described::longest_frame);
  if (guess.packets) text += fmt::format("stuffing = \"{}\"\n", name_of(guess.stuffing));
  if (header) text += header->text();
  if (!guess.sum) {
    if (header && header->big_endian) text += "checksum_order = \"big\"\n";
    return text +
           (header ? "# of whole frames no checksum was found\n" : "# no checksum was found\n");
  }
  const Sum& sum = *guess.sum;
  text += fmt::format("checksum = \"{}\"\n", sum.checksum.name());
  if (sum.big_endian || (header && header->big_endian)) text += "checksum_order = \"big\"\n";
  if (sum.from > 0) text += fmt::format("checksum_from = {}\n", sum.from);
  if (sum.at) text += fmt::format("checksum_at = {}\n", *sum.at);
  if (sum.behind > 0)
    text += fmt::format("end = \"{}\"\n", hex_of(guess.frames[0].last(sum.behind)));
  return text;
}

}  // namespace

std::string binary_text(const BinaryGuess& guess, std::size_t capture_bytes) {
  const MessageGuesses kinds = guess_messages(guess);
  const auto header = guess_header_sum(guess);
  std::string text = protocol_text(guess, kinds, capture_bytes, header), left_out;
  for (std::size_t i = 0; i < kinds.all.size(); ++i) {
    const MessageGuess& kind = kinds.all[i];
    if (i < wire::described::most_messages)
      text += message_text(guess, kinds, kind, header);
    else
      left_out += fmt::format("# {} frames {}\n", kind.frames.size(), hex_of(kind.id));
  }
  return text + (left_out.empty() ? "" : "\n# Not described:\n" + left_out);
}

}  // namespace drydock::guess
