#include "drivers/recordings/slice/receiver_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "drivers/recordings/slice/move_message.hpp"
#include "drivers/wire/ubx/ubx_frame.hpp"

namespace drydock::slice {

const std::vector<ReceiverLine::Moved>& ReceiverLine::move(wire::Bytes bytes,
                                                           measurement::Stamp at) {
  out_.clear();
  framer_.feed(bytes, at, wire::UbxNmea::scan, taker());
  count_skipped();
  return out_;
}

const std::vector<ReceiverLine::Moved>& ReceiverLine::finish() {
  out_.clear();
  framer_.finish(wire::UbxNmea::scan, taker());
  count_skipped();
  return out_;
}

void ReceiverLine::count_skipped() {
  const auto skipped = framer_.counters().bytes_skipped;
  if (skipped > skipped_) dropped_["bytes outside of messages"] += skipped - skipped_;
  skipped_ = skipped;
}

void ReceiverLine::keep(wire::Bytes frame, measurement::Stamp at) {
  if (out_.empty() || out_.back().at != at) out_.push_back({at, {}});
  out_.back().bytes.insert(out_.back().bytes.end(), frame.begin(), frame.end());
}

void ReceiverLine::on_frame(wire::Bytes frame, measurement::Stamp at) {
  if (frame[0] == '$') return on_sentence(frame, at);
  if (frame[0] == wire::ubx::sync_1) return on_ubx(frame, at);
  drop(frame[0] == '!' ? "NMEA encapsulated" : "RTCM");
}

void ReceiverLine::on_sentence(wire::Bytes frame, measurement::Stamp at) {
  constexpr std::size_t growth = 80;
  std::array<std::uint8_t, wire::Nmea0183::max_frame + growth> moved;
  std::size_t size = 0;
  switch (move_sentence(frame, place_, moved, size)) {
    case Fate::as_it_is: return keep(frame, at);
    case Fate::moved: ++moved_; return keep(wire::Bytes{moved}.first(size), at);
    case Fate::dropped: break;
  }
  const auto name = wire::SentenceReader(frame).formatter();
  drop(name.empty() ? std::string("NMEA proprietary") : fmt::format("NMEA {}", name));
}

void ReceiverLine::on_ubx(wire::Bytes frame, measurement::Stamp at) {
  std::vector<std::uint8_t> moved(frame.begin(), frame.end());
  const auto fate = move_ubx(moved, place_);
  if (fate == Fate::dropped) return drop(fmt::format("UBX {:02X} {:02X}", frame[2], frame[3]));
  if (fate == Fate::moved) ++moved_;
  keep(moved, at);
}

}  // namespace drydock::slice
