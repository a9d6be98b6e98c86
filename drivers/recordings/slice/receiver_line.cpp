#include "drivers/recordings/slice/receiver_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "drivers/recordings/slice/move_message.hpp"
#include "drivers/wire/ubx/ubx_frame.hpp"

namespace drydock::slice {

wire::Bytes ReceiverLine::move(wire::Bytes bytes) {
  out_.clear();
  framer_.feed(bytes, wire::UbxNmea::scan,
               [this](wire::Bytes frame, std::size_t) { on_frame(frame); });
  const auto skipped = framer_.counters().bytes_skipped;
  if (skipped > skipped_) dropped_["bytes outside of messages"] += skipped - skipped_;
  skipped_ = skipped;
  return out_;
}

void ReceiverLine::on_frame(wire::Bytes frame) {
  if (frame[0] == '$') return on_sentence(frame);
  if (frame[0] == wire::ubx::sync_1) return on_ubx(frame);
  drop("RTCM");
}

void ReceiverLine::on_sentence(wire::Bytes frame) {
  constexpr std::size_t growth = 80;
  std::array<std::uint8_t, wire::Nmea0183::max_frame + growth> moved;
  std::size_t size = 0;
  switch (move_sentence(frame, place_, moved, size)) {
    case Fate::as_it_is: out_.insert(out_.end(), frame.begin(), frame.end()); return;
    case Fate::moved:
      out_.insert(out_.end(), moved.begin(), moved.begin() + static_cast<std::ptrdiff_t>(size));
      ++moved_;
      return;
    case Fate::dropped: break;
  }
  const auto name = wire::SentenceReader(frame).formatter();
  drop(name.empty() ? std::string("NMEA proprietary") : fmt::format("NMEA {}", name));
}

void ReceiverLine::on_ubx(wire::Bytes frame) {
  const auto at = static_cast<std::ptrdiff_t>(out_.size());
  out_.insert(out_.end(), frame.begin(), frame.end());
  const auto fate = move_ubx(std::span(out_).subspan(static_cast<std::size_t>(at)), place_);
  if (fate == Fate::moved) ++moved_;
  if (fate != Fate::dropped) return;
  out_.erase(out_.begin() + at, out_.end());
  drop(fmt::format("UBX {:02X} {:02X}", frame[2], frame[3]));
}

}  // namespace drydock::slice
