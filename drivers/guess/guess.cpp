#include "drivers/guess/guess.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "drivers/wire/hex.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::guess {
namespace {

struct Characters {
  std::size_t all = 0, plain = 0, control = 0;

  explicit Characters(wire::Bytes capture) : all(capture.size()) {
    for (const std::uint8_t c : capture) {
      const bool is_plain = (c >= 0x20 && c <= 0x7E) || c == '\t' || c == '\r' || c == '\n';
      plain += is_plain ? 1 : 0;
      control += !is_plain && c < 0x80 ? 1 : 0;
    }
  }
  /// A few damaged bytes make no binary protocol of it, nor do degree signs: a binary protocol has
  /// control characters too.
  bool are_text() const { return control * 100 <= all && plain * 4 >= all * 3; }
  /// Of bytes at random three in eight are characters.
  bool may_have_lines() const { return plain * 2 >= all; }
};

/// Bytes of the sentence that begins here, with its line end; 0: none with a right checksum does.
std::size_t sentence_at(wire::Bytes bytes) {
  constexpr std::size_t longest = 512;
  std::uint8_t sum = 0;
  for (std::size_t i = 1; i + 3 <= bytes.size() && i < longest; ++i) {
    if (bytes[i] == '*') {
      if (wire::parse_hex(wire::as_text(bytes.subspan(i + 1, 2))) != sum) return 0;
      std::size_t end = i + 3;
      while (end < bytes.size() && (bytes[end] == '\r' || bytes[end] == '\n')) ++end;
      return end;
    }
    if (bytes[i] < 0x20 || bytes[i] > 0x7E) return 0;
    sum ^= bytes[i];
  }
  return 0;
}

/// A receiver says both on one line.
std::vector<std::uint8_t> without_sentences(wire::Bytes capture) {
  std::vector<std::uint8_t> rest;
  rest.reserve(capture.size());
  for (std::size_t i = 0; i < capture.size();) {
    const bool may_be = capture[i] == '$' || capture[i] == '!';
    const std::size_t size = may_be ? sentence_at(capture.subspan(i)) : 0;
    if (size == 0) rest.push_back(capture[i]);
    i += std::max<std::size_t>(size, 1);
  }
  return rest;
}

/// A file has one form of messages.
constexpr std::string_view also_texts =
    "\n# The line carries sentences too. They need a description of their own: give drydock "
    "describe\n# a capture of them alone.\n";
constexpr std::string_view also_frames =
    "\n# The line carries binary frames too. They need a description of their own: give drydock "
    "describe\n# a capture of them alone.\n";

}  // namespace

std::string guess_description(wire::Bytes capture) {
  constexpr std::string_view head =
      "# A guess from a capture: nothing here is certain. Compare it with the maker's manual. As "
      "it\n"
      "# stands, drydock decode shows its columns. For a driver give the sensor its kind, and "
      "each\n"
      "# column that is measured `field` and `unit` instead of `name`; then run drydock check.\n"
      "# docs/sensors/described.md\n\n"
      "[sensor]\ntitle = \"unknown\"\n# kind = \"depth\"              # or dvl, emlog, gnss, imu, "
      "actuator, attitude\n";
  const std::vector<std::uint8_t> rest = without_sentences(capture);
  const bool has_sentences = rest.size() < capture.size();
  const bool has_lines = has_sentences || Characters(capture).may_have_lines();
  const std::string texts = has_lines ? guess_text(capture) : std::string();
  const std::string frames = Characters(rest).are_text() ? std::string() : guess_binary(rest);
  if (texts.empty() && frames.empty()) return {};
  if (frames.empty()) return std::string(head) + texts;
  if (texts.empty() || !has_sentences) return std::string(head) + frames;
  const bool mostly_frames = rest.size() * 2 > capture.size();
  return fmt::format("{}{}{}", head, mostly_frames ? frames : texts,
                     mostly_frames ? also_texts : also_frames);
}

}  // namespace drydock::guess
