#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drivers/wire/canopen/canopen.hpp"
#include "hil/fault/schedule/schedule.hpp"
#include "hil/fault/wire/outlet.hpp"
#include "rig_config/load.hpp"

/// What drivers receive after faults, and example lines that no encoder of this program made.
namespace drydock::fault::testing {

using namespace std::chrono_literals;

/// The output with its times.
struct Heard final : Outlet {
  struct Read {
    std::string bytes;
    Stamp at;
    friend bool operator==(const Read&, const Read&) = default;
  };
  struct Frame {
    wire::CanFrame frame;
    Stamp at;
    friend bool operator==(const Frame&, const Frame&) = default;
  };
  struct Port {
    bool there;
    Stamp at;
    friend bool operator==(const Port&, const Port&) = default;
  };

  void pass(wire::Bytes bytes, Stamp at) override {
    reads.push_back({{bytes.begin(), bytes.end()}, at});
  }
  void pass(const wire::CanFrame& frame, Stamp at) override { frames.push_back({frame, at}); }
  void set_port(bool there, Stamp at) override { ports.push_back({there, at}); }

  std::string all() const {
    std::string text;
    for (const auto& read : reads) text += read.bytes;
    return text;
  }

  std::vector<Read> reads;
  std::vector<Frame> frames;
  std::vector<Port> ports;
};

inline wire::Bytes bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

// Example sentences from manuals of GPS receivers.
inline const std::string gga =
    "$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n";
inline const std::string rmc =
    "$GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W*6A\r\n";

/// A fault from the text of a fault file.
inline FaultConfig fault_of(const std::string& keys) {
  return rig_config::load_faults_text("[[fault]]\n" + keys, "faults.toml").value().front();
}

inline const Stamp start = measurement::stamp_from_ns(1'700'000'000'000'000'000);

}  // namespace drydock::fault::testing
