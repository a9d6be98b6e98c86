#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/survey/driver_trial.hpp"

/// Which protocol is on a line? Every byte protocol of the registry listens at once; what counts is
/// frames whose checksum is right, and how much of the line they explain. Pure: no port, no clock.
namespace drydock::survey {

/// How sure an answer is. `certain` ends the search.
enum class Confidence : std::uint8_t { nothing, trace, likely, certain };
std::string_view to_string(Confidence confidence);

/// How often a kind of message came.
struct MessageCount {
  std::string_view type;
  std::uint64_t count = 0;
  std::optional<double> rate_hz;  ///< empty for a single one, or without times
};

/// What one protocol made of the line.
struct ByteFinding {
  std::string_view protocol;
  Confidence confidence = Confidence::nothing;
  std::uint64_t proofs = 0;  ///< frames that chance hardly makes: checksum right, or known fields
  std::uint64_t frames = 0, bad_checksums = 0;
  std::uint64_t bytes = 0;       ///< since the first proof; all where there is none
  std::uint64_t bytes_good = 0;  ///< of them within frames
  std::uint64_t messages_total = 0;
  std::vector<MessageCount> messages;  ///< in the order in which they were first heard
  std::vector<SensorHeard> sensors;    ///< drivers that got measurements out of it

  double explained() const {
    return bytes == 0 ? 0 : static_cast<double>(bytes_good) / static_cast<double>(bytes);
  }
};

/// `12 good frames, 0 bad; 98 % of 1204 bytes explained`.
std::string reasons(const ByteFinding& finding);

/// One protocol on the line.
class ByteCandidate {
 public:
  virtual ~ByteCandidate() = default;
  virtual void feed(wire::Bytes bytes, Stamp at) = 0;
  virtual void finish() = 0;
  virtual ByteFinding finding() const = 0;
};

class ByteSurvey {
 public:
  ByteSurvey();

  /// `at`: arrival of the last byte. The stamps may all be the same where no times are known.
  void feed(wire::Bytes bytes, Stamp at);
  void finish();  ///< no more bytes will come

  std::uint64_t bytes() const { return bytes_; }
  /// All that found anything, the best first: most bytes explained, then most messages understood.
  std::vector<ByteFinding> findings() const;
  /// The first of them; confidence `nothing` when there is none.
  ByteFinding best() const;
  /// Nothing more is to be learned: certain, and the rate of its sensors is known.
  bool settled() const;

 private:
  std::vector<std::unique_ptr<ByteCandidate>> candidates_;
  std::uint64_t bytes_ = 0;
};

/// Data bits of a 7-bit line with parity, read as 8-bit without: byte by byte what a port set to
/// 7 bits would give; bytes of wrong parity are dropped, as that port would drop them.
std::vector<std::uint8_t> seven_bits(wire::Bytes eight, bool odd);

}  // namespace drydock::survey
