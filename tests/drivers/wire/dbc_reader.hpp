#pragma once

#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"

/// The part of the DBC format that our files use: messages, signals of either byte order, value
/// tables, and the types of floating-point signals.
namespace drydock::wire::test {

struct DbcSignal {
  unsigned start = 0, bits = 0;  ///< big-endian: `start` is the highest bit
  bool big_endian = false, is_signed = false, is_float = false;
  double factor = 1, offset = 0;
  std::map<std::int64_t, std::string> names;

  std::uint64_t raw(Bytes data) const {
    std::uint64_t value = 0;
    unsigned bit = start;
    for (unsigned i = 0; i < bits; ++i) {
      const std::uint64_t set = (data[bit / 8] >> bit % 8) & 1u;
      value = big_endian ? value << 1 | set : value | set << i;
      if (big_endian) {
        bit = bit % 8 == 0 ? bit + 15 : bit - 1;
      } else {
        ++bit;
      }
    }
    return value;
  }

  double physical(Bytes data) const {
    const std::uint64_t value = raw(data);
    if (is_float) {
      float number = 0;
      std::memcpy(&number, &value, sizeof number);
      return number;
    }
    const unsigned unused = 64 - bits;
    const auto extended = static_cast<std::int64_t>(value << unused) >> unused;
    return (is_signed ? static_cast<double>(extended) : static_cast<double>(value)) * factor +
           offset;
  }
};

struct DbcMessage {
  std::uint32_t id = 0;  ///< without the flag
  bool extended = false;
  std::string name;
  unsigned size = 0;
  std::map<std::string, DbcSignal> signals;
};

using Dbc = std::vector<DbcMessage>;

class DbcReader {
 public:
  static Dbc read(const std::string& path) {
    DbcReader reader;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
      if (line.ends_with('\r')) line.pop_back();
      reader.take(line);
    }
    return reader.messages_;
  }

 private:
  void take(const std::string& line) {
    static const std::regex message(R"(BO_ (\d+) (\w+): (\d+) \w+)");
    static const std::regex signal(
        R"( SG_ (\w+) : (\d+)\|(\d+)@([01])([+-]) \(([^,]+),([^)]+)\) \[.*\] ".*" \w+)");
    static const std::regex type(R"(SIG_VALTYPE_ (\d+) (\w+) : 1;)");
    static const std::regex values(R"(VAL_ (\d+) (\w+) (.*);)");
    std::smatch m;
    if (std::regex_match(line, m, message)) {
      const std::uint64_t id = std::stoull(m[1]);
      messages_.push_back({static_cast<std::uint32_t>(id & 0x1FFFFFFF),
                           (id & 0x80000000) != 0,
                           m[2],
                           static_cast<unsigned>(std::stoul(m[3])),
                           {}});
    } else if (std::regex_match(line, m, signal)) {
      DbcSignal& added = messages_.back().signals[m[1]];
      added.start = static_cast<unsigned>(std::stoul(m[2]));
      added.bits = static_cast<unsigned>(std::stoul(m[3]));
      added.big_endian = m[4] == "0";
      added.is_signed = m[5] == "-";
      added.factor = std::stod(m[6]);
      added.offset = std::stod(m[7]);
    } else if (std::regex_match(line, m, type)) {
      of(m[1]).signals.at(m[2]).is_float = true;
    } else if (std::regex_match(line, m, values)) {
      name_values(of(m[1]).signals.at(m[2]), m[3]);
    }
  }

  static void name_values(DbcSignal& signal, const std::string& list) {
    static const std::regex entry(R"re((\d+) "([^"]*)")re");
    for (std::sregex_iterator i(list.begin(), list.end(), entry), end; i != end; ++i) {
      signal.names[std::stoll((*i)[1])] = (*i)[2];
    }
  }

  DbcMessage& of(const std::string& id_text) {
    const auto id = static_cast<std::uint32_t>(std::stoull(id_text) & 0x1FFFFFFF);
    for (DbcMessage& m : messages_) {
      if (m.id == id) return m;
    }
    throw std::runtime_error("no message " + id_text);
  }

  Dbc messages_;
};

}  // namespace drydock::wire::test
