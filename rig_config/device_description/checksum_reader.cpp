#include "rig_config/device_description/checksum_reader.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "drivers/wire/described/crc_line.hpp"
#include "rig_config/rules/explain.hpp"

namespace drydock::rig_config {

namespace described = wire::described;

namespace {

std::string no_checksum(const std::string& word) {
  const auto all = described::checksum_names();
  std::vector<std::string> known(all.begin(), all.end());
  for (const auto& crc : described::crc_aliases) known.emplace_back(crc.alias);
  const std::vector<std::string> plain(described::plain_checksums.begin(),
                                       described::plain_checksums.end());
  return fmt::format(
      "\"{}\" is no checksum{}, allowed: {}, or a CRC of 8, 16, 24 or 32 bits by its name in the "
      "CRC catalogue, such as crc-16/modbus, or by its parameters, such as width=16 poly=1021 "
      "init=FFFF refin=false refout=false xorout=0",
      word, did_you_mean(word, known), listed(plain));
}

}  // namespace

void read_checksum(const Node& word, const std::string& path, described::Checksum& into,
                   const std::string& file, Problems& problems) {
  std::string fault;
  if (word.text.find('=') != word.text.npos) {
    described::Crc crc;
    fault = described::read_crc(word.text, crc);
    if (fault.empty()) into = described::Checksum(crc);
  } else if (!described::Checksum::find(word.text, into)) {
    fault = no_checksum(word.text);
  }
  if (!fault.empty())
    problems.push_back({file, word.at.line, word.at.column, path, std::move(fault)});
}

}  // namespace drydock::rig_config
