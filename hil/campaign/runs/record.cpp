#include "hil/campaign/runs/record.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>
#include <nlohmann/json.hpp>

namespace drydock::campaign {
namespace {

using RecordJson = nlohmann::ordered_json;

constexpr std::size_t checksum_digits = 8;

std::string checksum(std::string_view text) {
  boost::crc_32_type crc;
  crc.process_bytes(text.data(), text.size());
  return fmt::format("{:08x}", crc.checksum());
}

std::vector<std::optional<double>> figures_of(const RecordJson& list) {
  std::vector<std::optional<double>> figures;
  for (const auto& one : list)
    figures.push_back(one.is_null() ? std::nullopt : std::optional(one.get<double>()));
  return figures;
}

}  // namespace

std::string to_line(const Record& record) {
  RecordJson figures = RecordJson::array();
  for (const auto& figure : record.figures)
    figures.push_back(figure ? RecordJson(*figure) : RecordJson());
  const RecordJson json{{"index", record.index},    {"figures", figures},
                        {"exit", record.exit_code}, {"failure", record.failure},
                        {"took_s", record.took_s},  {"ended_ms", record.ended_ms}};
  const auto text = json.dump(-1, ' ', true, RecordJson::error_handler_t::replace);
  return checksum(text) + " " + text;
}

std::optional<Record> read_record(std::string_view line, std::size_t figures) {
  if (line.size() <= checksum_digits) return std::nullopt;
  const auto text = line.substr(checksum_digits + 1);
  if (line.substr(0, checksum_digits) != checksum(text)) return std::nullopt;
  try {
    const RecordJson json = RecordJson::parse(text);
    Record record{.index = json.at("index").get<std::size_t>(),
                  .figures = figures_of(json.at("figures")),
                  .exit_code = json.at("exit").get<int>(),
                  .failure = json.at("failure").get<std::string>(),
                  .took_s = json.at("took_s").get<double>(),
                  .ended_ms = json.at("ended_ms").get<std::int64_t>()};
    if (record.figures.size() != figures) return std::nullopt;
    return record;
  } catch (const RecordJson::exception&) {
    return std::nullopt;
  }
}

}  // namespace drydock::campaign
