#pragma once

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

/// As much of a DBC file as its messages and little-endian signals need.
namespace drydock::wire::test {

struct DbcSignal {
  std::uint32_t id = 0;  ///< of its message, without the flag for 29 bits
  std::string message, name;
  unsigned start = 0, length = 0;
  bool little_endian = true;
  double scale = 1, offset = 0;

  std::uint64_t raw(std::uint64_t payload) const {
    return payload >> start & ((std::uint64_t{1} << length) - 1);
  }
};

/// Every SG_ line of a file, in its order; empty where there is no file.
inline std::vector<DbcSignal> dbc_signals(const std::string& path) {
  std::ifstream file(path);
  std::vector<DbcSignal> signals;
  std::uint32_t id = 0;
  std::string message;
  for (std::string line; std::getline(file, line);) {
    char name[128] = {};
    unsigned long long number = 0;
    if (std::sscanf(line.c_str(), "BO_ %llu %127[^:]:", &number, name) == 2) {
      id = static_cast<std::uint32_t>(number & 0x1FFFFFFF);
      message = name;
      continue;
    }
    DbcSignal s;
    char order = '1', sign = '+';
    if (std::sscanf(line.c_str(), " SG_ %127[^ :] : %u|%u@%c%c (%lf,%lf)", name, &s.start,
                    &s.length, &order, &sign, &s.scale, &s.offset) != 7) {
      continue;
    }
    s.id = id;
    s.message = message;
    s.name = name;
    s.little_endian = order == '1';
    signals.push_back(s);
  }
  return signals;
}

}  // namespace drydock::wire::test
