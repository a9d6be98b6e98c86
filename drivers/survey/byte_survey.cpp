#include "drivers/survey/byte_survey.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "drivers/device/timed_framer.hpp"
#include "drivers/survey/arrivals.hpp"
#include "drivers/wire/described/described_codec.hpp"
#include "drivers/wire/passed_over.hpp"
#include "drivers/wire/registry.hpp"

namespace drydock::survey {
namespace {

/// True if noise hardly ever gives such a frame. PD6 has no checksum: there only a line with all
/// known fields is proof, and of JSON only an object with known keys. An answer of slcan may be a
/// single CR, and a command of Water Linked may lack its checksum; neither is proof.
template <class P>
bool proves([[maybe_unused]] const P& codec, [[maybe_unused]] wire::Bytes frame,
            const std::optional<typename P::Message>& message) {
  if constexpr (std::is_same_v<P, wire::described::DescribedCodec>)
    return codec.description->plan.checksum.size() != 0 || message.has_value();
  if constexpr (std::is_same_v<P, wire::Pd6> || std::is_same_v<P, wire::WaterLinkedJson>)
    return message.has_value();
  if constexpr (std::is_same_v<P, wire::Slcan>)
    return message && std::holds_alternative<wire::slcan::Frame>(*message);
  if constexpr (std::is_same_v<P, wire::WaterLinked>)
    return std::ranges::find(frame, std::uint8_t{'*'}) != frame.end();
  return true;
}

constexpr std::uint64_t enough_proofs = 5;
constexpr std::size_t most_names = 32;
constexpr double nearly_all = 0.9, half = 0.5;

Confidence judge(const ByteFinding& f) {
  if (f.proofs == 0) return Confidence::nothing;
  if (f.proofs >= enough_proofs && f.explained() >= nearly_all && f.proofs >= 10 * f.bad_checksums)
    return Confidence::certain;
  return f.proofs >= 2 && f.explained() >= half ? Confidence::likely : Confidence::trace;
}

/// `P`: a codec of the registry, or DescribedCodec.
template <class P>
class CandidateOf final : public ByteCandidate {
 public:
  CandidateOf(P codec, std::vector<std::unique_ptr<DriverTrial>> trials)
      : codec_(std::move(codec)),
        framer_(std::make_unique<device::TimedFramer<P::max_frame>>()),
        trials_(std::move(trials)) {}

  void feed(wire::Bytes bytes, Stamp at) override {
    last_ = at;
    framer_->feed(bytes, at, scan(), on_frame());
    for (auto& trial : trials_) trial->receive(bytes, at);
  }

  /// The last line of a recording may have no end.
  void finish() override {
    constexpr std::uint8_t line_end[] = {'\n'};
    if (framer_->held() > 0) {
      lent_ = 1;
      const auto frames = framer_->counters().frames;
      framer_->feed(line_end, last_, scan(), on_frame());
      lent_good_ = framer_->counters().frames > frames ? 1 : 0;
    }
    framer_->finish(scan(), on_frame());
    for (auto& trial : trials_) trial->finish(last_);
  }

  ByteFinding finding() const override {
    const auto& c = framer_->counters();
    ByteFinding f;
    f.protocol = codec_.name;
    f.proofs = proofs_;
    f.frames = c.frames;
    f.bad_checksums = c.bad_checksums;
    f.bytes = c.bytes_in - framer_->held() - skipped_before_ - lent_;
    f.bytes_good = c.bytes_good - lent_good_;
    for (const auto& [type, arrivals] : heard_) {
      f.messages.push_back({type, arrivals.count, arrivals.rate_hz()});
      f.messages_total += arrivals.count;
    }
    f.unread = unread_;
    f.read = read_;
    for (const auto& trial : trials_)
      if (trial->measurements() > 0) f.sensors.push_back(trial->heard());
    f.confidence = judge(f);
    return f;
  }

 private:
  auto scan() const {
    return [this](wire::Bytes bytes) { return codec_.scan(bytes); };
  }
  auto on_frame() {
    return [this](wire::Bytes frame, const device::Arrival& arrival) {
      const auto message = codec_.decode(frame);
      if (proves(codec_, frame, message) && proofs_++ == 0)
        skipped_before_ = framer_->counters().bytes_skipped;  // bytes before the first good frame
      if (message) std::visit([&](const auto& m) { note(m.type, arrival.read_at); }, *message);
      count_name(message ? read_ : unread_, frame);
    };
  }

  static void count_name(std::vector<NameCount>& names, wire::Bytes frame) {
    const auto name = wire::frame_name_of<P>(frame);
    auto known = std::ranges::find(names, name, &NameCount::name);
    if (known == names.end()) {
      if (names.size() == most_names) return;
      known = names.insert(known, {name, 0});
    }
    ++known->count;
  }

  void note(std::string_view type, Stamp at) {
    auto heard = std::ranges::find(heard_, type, [](const auto& entry) { return entry.first; });
    if (heard == heard_.end()) heard = heard_.insert(heard, {type, {}});
    heard->second.add(at);
  }

  P codec_;
  std::unique_ptr<device::TimedFramer<P::max_frame>> framer_;
  std::vector<std::unique_ptr<DriverTrial>> trials_;
  std::vector<std::pair<std::string_view, Arrivals>> heard_;  ///< in order of first arrival
  std::vector<NameCount> unread_, read_;
  std::uint64_t proofs_ = 0, skipped_before_ = 0;
  std::uint64_t lent_ = 0, lent_good_ = 0;  ///< bytes that finish() added
  Stamp last_{};
};

template <class... P>
void add_all(wire::ProtocolList<P...>, std::vector<std::unique_ptr<ByteCandidate>>& candidates) {
  (candidates.push_back(std::make_unique<CandidateOf<P>>(P{}, trials_of(P::name))), ...);
}

bool better(const ByteFinding& a, const ByteFinding& b) {
  if (a.bytes_good != b.bytes_good) return a.bytes_good > b.bytes_good;
  return a.messages_total > b.messages_total;
}

bool has_all(const std::vector<NameCount>& names, const std::vector<NameCount>& wanted) {
  return !wanted.empty() && std::ranges::all_of(wanted, [&](const NameCount& one) {
    return has_name(names, one.name);
  });
}

/// Few frames among many of other protocols prove a sensor too.
bool is_proved(const ByteFinding& f) {
  return f.confidence >= Confidence::likely || f.proofs >= enough_proofs;
}

}  // namespace

std::string_view to_string(Confidence confidence) {
  constexpr std::array<std::string_view, 4> names{"nothing", "a trace", "likely", "certain"};
  return names[static_cast<std::size_t>(confidence)];
}

bool has_name(const std::vector<NameCount>& names, std::string_view name) {
  return std::ranges::find(names, name, &NameCount::name) != names.end();
}

std::string reasons(const ByteFinding& f) {
  return fmt::format("{} good frames, {} bad; {:.0f} % of {} bytes explained", f.proofs,
                     f.bad_checksums, 100 * f.explained(), f.bytes);
}

std::vector<SensorHeard> sensors_of(const std::vector<ByteFinding>& findings) {
  std::vector<SensorHeard> sensors;
  std::vector<const ByteFinding*> of;  // the finding of each sensor
  for (const auto& finding : findings) {
    if (&finding != findings.data() && !is_proved(finding)) continue;
    const auto says_the_same = [&](const SensorHeard& sensor) {
      for (std::size_t i = 0; i < sensors.size(); ++i)
        if (of[i] != &finding && sensors[i].kind == sensor.kind &&
            !has_all(of[i]->unread, finding.read))
          return true;
      return false;
    };
    for (const auto& sensor : finding.sensors) {
      if (says_the_same(sensor)) continue;
      sensors.push_back(sensor);
      of.push_back(&finding);
    }
  }
  return sensors;
}

ByteSurvey::ByteSurvey(const Descriptions& named, const Descriptions& known) {
  add(named);
  add_all(wire::BytesProtocols{}, candidates_);
  add_all(wire::FrameCarriers{}, candidates_);
  add(known);
}

void ByteSurvey::add(const Descriptions& descriptions) {
  using wire::described::DescribedCodec;
  for (const auto& one : descriptions) {
    if (one->frames) continue;  // BusSurvey looks for those
    candidates_.push_back(
        std::make_unique<CandidateOf<DescribedCodec>>(DescribedCodec(one), trials_of(one)));
  }
}

void ByteSurvey::feed(wire::Bytes bytes, Stamp at) {
  bytes_ += bytes.size();
  note_text(bytes);
  for (auto& candidate : candidates_) candidate->feed(bytes, at);
}

void ByteSurvey::note_text(wire::Bytes bytes) {
  constexpr std::size_t most = 40;
  for (const std::uint8_t byte : bytes) {
    const bool printed = byte >= 0x20 && byte <= 0x7E;
    is_text_ = is_text_ && (printed || byte == '\r' || byte == '\n' || byte == '\t');
    if (printed && text_.size() < most) text_.push_back(static_cast<char>(byte));
  }
}

void ByteSurvey::finish() {
  for (auto& candidate : candidates_) candidate->finish();
}

std::vector<ByteFinding> ByteSurvey::findings() const {
  std::vector<ByteFinding> found;
  for (const auto& candidate : candidates_) {
    auto finding = candidate->finding();
    if (finding.confidence != Confidence::nothing) found.push_back(std::move(finding));
  }
  std::ranges::stable_sort(found, better);
  return found;
}

ByteFinding ByteSurvey::best() const {
  auto found = findings();
  return found.empty() ? ByteFinding{} : std::move(found.front());
}

bool ByteSurvey::settled() const {
  const auto found = findings();
  if (found.empty() || found.front().confidence != Confidence::certain) return false;
  const auto sensors = sensors_of(found);
  return !sensors.empty() && std::ranges::all_of(sensors, [](const SensorHeard& s) {
    constexpr std::uint64_t enough_for_a_rate = 8;
    return s.measurements >= enough_for_a_rate && s.rate_hz.has_value();
  });
}

std::vector<std::uint8_t> seven_bits(wire::Bytes eight, bool odd) {
  std::vector<std::uint8_t> seven;
  for (const std::uint8_t byte : eight)
    if ((std::popcount(byte) % 2 == 1) == odd) seven.push_back(byte & 0x7F);
  return seven;
}

}  // namespace drydock::survey
