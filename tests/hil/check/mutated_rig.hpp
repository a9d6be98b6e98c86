#pragma once

#include <rapidcheck.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "rig_config/fault_vocabulary.hpp"
#include "tests/hil/check/rig_folder.hpp"

/// Rig and mission files that are shipped ones with a few changes.
namespace drydock::check {

/// The lines of a TOML file, with those changes that a person makes: a key's value, a new key, a
/// line less.
class Draft {
 public:
  explicit Draft(const std::string& text) {
    std::string line;
    for (const char c : text) {
      if (c == '\n')
        lines_.push_back(std::exchange(line, {}));
      else
        line += c;
    }
  }

  std::string text() const {
    std::string all;
    for (const auto& line : lines_) all += line + "\n";
    return all;
  }

  /// Numbers of the lines `key = ...`. Without a key: of all lines with a value.
  std::vector<std::size_t> lines_of(const std::string& key = {}) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < lines_.size(); ++i)
      if (lines_[i].find(" = ") != std::string::npos && lines_[i].front() != '#' &&
          (key.empty() || lines_[i].starts_with(key + " = ")))
        found.push_back(i);
    return found;
  }

  std::string key_of(std::size_t line) const {
    return lines_[line].substr(0, lines_[line].find(" = "));
  }
  std::string value_of(std::size_t line) const {
    const auto begin = lines_[line].find(" = ") + 3;
    const auto end = lines_[line].find(" #", begin);
    return lines_[line].substr(begin, end == std::string::npos ? end : end - begin);
  }
  void set(std::size_t line, const std::string& value) {
    lines_[line] = key_of(line) + " = " + value;
  }
  void erase(std::size_t line) { lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(line)); }
  void append(const std::string& block) { lines_.push_back(block); }

  /// The value of a key in the table in which the line stands; empty if it has none.
  std::string beside(std::size_t line, const std::string& key) const {
    std::size_t i = line;
    while (i > 0 && !lines_[i - 1].starts_with('[')) --i;
    for (; i < lines_.size() && !lines_[i].starts_with('['); ++i)
      if (lines_[i].starts_with(key + " = ")) return value_of(i);
    return {};
  }

  /// Gives the table in which the line stands this key.
  void set_beside(std::size_t line, const std::string& key, const std::string& value) {
    std::size_t begin = line, end = line;
    while (begin > 0 && !lines_[begin - 1].starts_with('[')) --begin;
    while (end < lines_.size() && !lines_[end].starts_with('[')) ++end;
    for (std::size_t i = begin; i < end; ++i)
      if (lines_[i].starts_with(key + " = ")) return set(i, value);
    lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(begin), key + " = " + value);
  }

 private:
  std::vector<std::string> lines_;
};

inline std::string some_number() {
  return *rc::gen::oneOf(
      rc::gen::element<std::string>("0", "-1", "1", "2", "5", "30", "32", "63", "64", "89", "90",
                                    "100", "127", "128", "230", "232", "233", "253", "254", "255",
                                    "1000", "1001", "0.5", "0.001", "1e-9", "1e-300", "1e9",
                                    "-1e9"),
      rc::gen::map(rc::gen::inRange(-2000, 20000),
                   [](int tenths) { return std::to_string(tenths / 10.0); }),
      rc::gen::map(rc::gen::inRange(0, 300), [](int n) { return std::to_string(n); }));
}

inline std::string quoted(const std::string& text) { return "\"" + text + "\""; }

template <class T>
T one_of(const std::vector<T>& all) {
  return all[*rc::gen::inRange<std::size_t>(0, all.size())];
}

/// Mostly a number that a key may well have.
inline std::string likely_number() {
  return *rc::gen::inRange(0, 4) == 0 ? some_number() : std::to_string(*rc::gen::inRange(1, 101));
}

using Texts = std::vector<std::string>;

inline std::string some_link(bool frames) {
  const std::string n = some_number();
  if (*rc::gen::inRange(0, 8) == 0) frames = !frames;
  return quoted(one_of(
      frames ? Texts{"memory-can:bus", "memory-can:bus?bitrate=" + n, "can:auto?name=bus",
                     "socketcan:vcan7", "socketcan:can7", "slcan:memory:below?emulated=1",
                     "slcan:/dev/ttyACM7", "file:missing.log", "file:demo.toml",
                     "file:demo.toml?format=candump-log"}
             : Texts{"pty:line", "pty:line?baud=" + n, "memory:line", "serial:/dev/tty7?baud=9600",
                     "serial:/dev/tty7?baud=9600&emulated=1", "tcp:127.0.0.1:4711?emulated=1",
                     "tcp:127.0.0.1:4711", "udp:127.0.0.1:4711?listen=1", "file:missing.log",
                     "file:demo.toml?speed=1&baud=9600", "file:demo.toml?format=candump-log"}));
}

inline const std::vector<std::pair<std::string, Texts>>& kinds() {
  static const std::vector<std::pair<std::string, Texts>> all{
      {"dvl",
       {"pd0", "pd4", "pd5", "pd6", "water-linked", "water-linked-json", "nortek", "nortek-ad2cp",
        "wayfinder"}},
      {"emlog", {"nmea0183"}},
      {"gnss", {"ubx", "nmea0183", "ubx+nmea0183"}},
      {"imu", {"aceinna", "cia404-imu", "epson-g550", "epson-g552", "xsens"}},
      {"depth", {"nmea2000", "cia404-pressure"}},
      {"actuator", {"nmea2000", "cia402"}}};
  return all;
}

using Key = std::pair<std::string, std::string>;

/// A key that a device with this protocol may have, with a value.
inline Key some_device_key(const std::string& kind, const std::string& protocol) {
  const std::string n = likely_number(), m = likely_number();
  std::vector<Key> keys{
      {"rate_hz", n},
      {"stale_after_s", n},
      {"latency_ms", n},
      {"address", n},
      {"emulate", "{ boot_s = " + n + ", latency_ms = " + m + " }"},
      {"emulate", "{ dropout_probability = 0." + n + ", dropout_mean_samples = " + m + " }"},
      {"emulate", "{ errors = \"../sensors/leveling-paper.toml\" }"}};
  const auto often = [&](const std::string& key, const std::string& value) {
    keys.insert(keys.end(), 3, Key{key, value});
  };
  if (protocol == "\"aceinna\"") {
    often("aceinna", "{ packet_rate_hz = " + n + " }");
    often("aceinna", "{ rate_filter_hz = " + n + ", acceleration_filter_hz = 50 }");
    often("aceinna", "{ orientation = " + quoted(one_of(Texts{"+X+Y+Z", "+X+Y-Z"})) + " }");
  }
  if (protocol == "\"xsens\"") {
    often("xsens", "{ identifiers = { rate_of_turn = " + n + ", acceleration = " + m + " } }");
    often("xsens", "{ extended = true, identifiers = { status_word = " + n + " } }");
  }
  if (protocol == "\"cia404-pressure\"")
    often("pressure", "{ format = \"real32\", unit = \"psi\", decimals = " + n + " }");
  if (protocol == "\"water-linked\"") often("water_linked", "{ sound_speed_mps = 15" + n + " }");
  if (protocol == "\"water-linked-json\"") often("water_linked", "{ range_mode = \"=" + n + "\" }");
  if (protocol == "\"wayfinder\"" || protocol == "\"nortek-ad2cp\"")
    often("velocity_of", "\"bed\"");
  if (protocol == "\"pd4\"") often("beam_angle_deg", n);
  if (protocol == "\"cia404-imu\"") often("sync", "true"), often("heartbeat_timeout_s", n);
  if (kind == "\"imu\"") keys.emplace_back("output", "\"mean\"");
  if (kind == "\"dvl\"")
    often("emulate", "{ head = { longest_range_m = " + n + ", shortest_range_m = " + m + " } }");
  if (kind == "\"gnss\"")
    often("emulate",
          "{ sky = { ephemeris = " + quoted(one_of(Texts{"demo.toml", "none"})) + " } }");
  return one_of(keys);
}

inline bool speaks_frames(const std::string& protocol) {
  return (protocol.find("404") != std::string::npos || protocol.find("epson") == 1 ||
          protocol == "\"aceinna\"" || protocol == "\"xsens\"" || protocol == "\"nmea2000\"");
}

/// Another protocol, another link or another key of a device.
inline void change_device(Draft& draft) {
  const auto line = one_of(draft.lines_of("protocol"));
  const std::string kind = draft.beside(line, "kind"), protocol = draft.value_of(line);
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      for (const auto& [name, protocols] : kinds())
        if (quoted(name) == kind) draft.set(line, quoted(one_of(protocols)));
      return;
    case 1: return draft.set_beside(line, "link", some_link(speaks_frames(protocol)));
    default: {
      const auto [key, value] = some_device_key(kind, protocol);
      draft.set_beside(line, key, value);
    }
  }
}

inline void change_value(Draft& draft) {
  const auto line = one_of(draft.lines_of());
  const std::string key = draft.key_of(line), value = draft.value_of(line);
  if (key == "mission")
    return draft.set(
        line, quoted(one_of(Texts{"../missions/shelf.toml", "../missions/velocity-paper.toml",
                                  "../missions/none.toml", "../missions/sounding-rocket.toml"})));
  if (value.starts_with('"')) {
    const auto other = one_of(draft.lines_of(key));  // another device's, another estimator's
    return draft.set(line, draft.value_of(other));
  }
  if (!value.starts_with('{') && !value.starts_with('[')) draft.set(line, likely_number());
}

inline void add_fault(Draft& draft) {
  const auto words = rig_config::fault_vocabulary();
  const auto& word = words[*rc::gen::inRange<std::size_t>(0, words.size())];
  const auto names = draft.lines_of("name");
  std::string block = "[[fault]]\ndevice = " + draft.value_of(one_of(names)) +
                      "\nfault = " + quoted(std::string(word.name)) + "\nfor_s = 0.1\n";
  if (!word.amount.empty())
    block += (word.amount == "quantity" ? std::string("rate_degps") : std::string(word.amount)) +
             " = " + likely_number() + "\n";
  draft.append(block);
}

inline void change_estimator(Draft& draft) {
  const auto devices = draft.lines_of("name");
  const auto device = [&] { return draft.value_of(one_of(devices)); };
  const std::string kind =
      *rc::gen::element<std::string>("leveling", "mixing", "roll", "navigation", "velocity");
  std::string block =
      "[[estimator]]\nname = \"another\"\nkind = " + quoted(kind) + "\nimu = " + device() + "\n";
  if (kind == "navigation" || kind == "velocity")
    block +=
        "sensors = \"../sensors/velocity-filter-paper.toml\"\ninitial = { latitude_deg = 36, "
        "longitude_deg = 0, heading_deg = 0, tilt_sigma_deg = 1, heading_sigma_deg = 1 }\n";
  if (kind == "velocity")
    block += "vehicle = \"../vehicles/nps-auv-ii.toml\"\nactuators = " + device() + "\n";
  if (kind != "roll" && kind != "navigation") block += "log = " + device() + "\n";
  if (kind == "roll") block += "gnss = " + device() + "\n";
  if (kind == "navigation" || kind == "velocity") block += "depth = " + device() + "\n";
  draft.append(block);
}

inline void change(Draft& draft) {
  switch (*rc::gen::weightedElement<int>({{2, 0}, {8, 1}, {1, 2}, {1, 3}, {1, 4}})) {
    case 0: return change_value(draft);
    case 1: return change_device(draft);
    case 2: return draft.erase(one_of(draft.lines_of()));
    case 3: return add_fault(draft);
    default: return change_estimator(draft);
  }
}

inline std::string mission_of(const Draft& rig) {
  const auto lines = rig.lines_of("mission");
  if (lines.empty()) return {};
  const std::string value = rig.value_of(lines.front());
  return value.substr(value.find_last_of('/') + 1,
                      value.find_last_of('"') - value.find_last_of('/') - 1);
}

/// Writes a mutated rig, and now and then a mutated mission, into the folder. Returns the rig's
/// path.
inline std::string write_mutated(const RigFolder& folder, const std::vector<std::string>& rigs) {
  Draft rig(RigFolder::shipped("rigs/" + one_of(rigs)));
  const std::string mission = mission_of(rig);
  if (!mission.empty() && *rc::gen::inRange(0, 4) == 0) {
    Draft changed(RigFolder::shipped("missions/" + mission));
    const auto line = one_of(changed.lines_of());
    if (!changed.value_of(line).starts_with('"')) changed.set(line, some_number());
    folder.write("missions/mutated.toml", changed.text());
    rig.set(rig.lines_of("mission").front(), "\"../missions/mutated.toml\"");
  }
  const int changes = *rc::gen::inRange(1, 3);
  for (int i = 0; i < changes; ++i) change(rig);
  return folder.write("rigs/mutated.toml", rig.text());
}

}  // namespace drydock::check
