#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/survey/driver_trial.hpp"

/// Finds the protocol on a line. Every byte protocol of the registry decodes in parallel. The
/// criteria are the frames with a right checksum and the share of the line that they explain. Pure:
/// no port, no clock.
namespace drydock::survey {

/// Certainty of an answer. `certain` ends the search.
enum class Confidence : std::uint8_t { nothing, trace, likely, certain };
std::string_view to_string(Confidence confidence);

/// The number of messages of one kind.
struct MessageCount {
  std::string_view type;
  std::uint64_t count = 0;
  std::optional<double> rate_hz;  ///< empty for a single message, or without times
};

/// Valid frames of one name: "$SDDPT".
struct NameCount {
  std::string name;
  std::uint64_t count = 0;
};

bool has_name(const std::vector<NameCount>& names, std::string_view name);

/// The result of one protocol on the line.
struct ByteFinding {
  std::string_view protocol;
  Confidence confidence = Confidence::nothing;
  std::uint64_t proofs = 0;  ///< frames that noise hardly gives: checksum right, or fields known
  std::uint64_t frames = 0, bad_checksums = 0;
  std::uint64_t bytes = 0;       ///< since the first proof; all bytes if there is none
  std::uint64_t bytes_good = 0;  ///< those within frames
  std::uint64_t messages_total = 0;
  std::vector<MessageCount> messages;  ///< in order of first arrival
  std::vector<NameCount> unread;       ///< frames that give no message: the first 32 names
  std::vector<NameCount> read;         ///< frames that give messages: the first 32 names
  std::vector<SensorHeard> sensors;    ///< drivers that decoded measurements

  double explained() const {
    return bytes == 0 ? 0 : static_cast<double>(bytes_good) / static_cast<double>(bytes);
  }
};

/// `12 good frames, 0 bad; 98 % of 1204 bytes explained`.
std::string reasons(const ByteFinding& finding);

/// The sensors of a line, of findings in their order. Behind those of the first stand those that
/// another protocol makes of the same line: a kind that was not there yet, or one of frames that
/// the protocol before passes over.
std::vector<SensorHeard> sensors_of(const std::vector<ByteFinding>& findings);

/// Tries one protocol on the line.
class ByteCandidate {
 public:
  virtual ~ByteCandidate() = default;
  virtual void feed(wire::Bytes bytes, Stamp at) = 0;
  virtual void finish() = 0;
  virtual ByteFinding finding() const = 0;
};

class ByteSurvey {
 public:
  using Descriptions = std::vector<wire::described::DescriptionPtr>;

  /// It also tries the described protocols: those that the user named, and those that it knows
  /// itself. Where two explain as much, one that was named goes before the registry's, and one that
  /// was not goes behind.
  explicit ByteSurvey(const Descriptions& named = {}, const Descriptions& known = {});

  /// `at` is the arrival of the last byte. If times are not known, all stamps may be equal.
  void feed(wire::Bytes bytes, Stamp at);
  void finish();  ///< no more bytes will come

  std::uint64_t bytes() const { return bytes_; }
  /// The first characters of a line that was all text so far; empty: it was not.
  std::string_view text() const { return is_text_ ? std::string_view(text_) : std::string_view(); }
  /// All protocols that found anything, the best first: most bytes explained, then most messages
  /// understood.
  std::vector<ByteFinding> findings() const;
  /// The first of findings(). Its confidence is `nothing` if there is none.
  ByteFinding best() const;
  /// True if more listening adds nothing: the protocol is certain, and the rate of its sensors is
  /// known.
  bool settled() const;

 private:
  void add(const Descriptions& descriptions);
  void note_text(wire::Bytes bytes);

  std::vector<std::unique_ptr<ByteCandidate>> candidates_;
  std::uint64_t bytes_ = 0;
  std::string text_;
  bool is_text_ = true;
};

/// Converts bytes read as 8 bits without parity to the 7 data bits of a line with parity. The
/// result is the same as from a port with 7 bits: bytes with wrong parity are dropped.
std::vector<std::uint8_t> seven_bits(wire::Bytes eight, bool odd);

}  // namespace drydock::survey
