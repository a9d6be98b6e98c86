#include "hil/campaign/runs/ledger.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <tuple>

namespace drydock::campaign {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> journals_in(const fs::path& folder, const std::string& label) {
  std::vector<fs::path> found;
  std::error_code none;  // a folder that is not there has no journals
  for (const auto& entry : fs::directory_iterator(folder, none))
    if (const auto& path = entry.path();
        path.extension() == ".journal" && path.filename().string().starts_with(label))
      found.push_back(path);
  std::ranges::sort(found);
  return found;
}

bool is_better(const Record& a, const Record& b) {
  const auto rank = [](const Record& r) {
    return std::tuple(!r.failure.empty(), r.figures, r.exit_code, r.failure);
  };
  return rank(a) < rank(b);
}

void enter(Record record, Ledger& ledger) {
  const auto index = record.index;
  const auto [known, fresh] = ledger.records.try_emplace(index, record);
  if (fresh) return;
  ++ledger.repeated;
  const bool both_sound = known->second.failure.empty() && record.failure.empty();
  if (both_sound && known->second.figures != record.figures) ledger.differing.push_back(index);
  if (is_better(record, known->second)) known->second = std::move(record);
}

}  // namespace

Ledger read_ledger(const fs::path& folder, std::size_t runs, std::size_t figures,
                   const std::string& label) {
  Ledger ledger;
  for (const auto& path : journals_in(folder, label)) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
      auto record = read_record(line, figures);
      if (record && record->index < runs)
        enter(std::move(*record), ledger);
      else
        ++ledger.damaged_lines;
    }
  }
  return ledger;
}

std::vector<std::size_t> missing_runs(const Ledger& ledger, std::size_t runs) {
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < runs; ++i) {
    const auto found = ledger.records.find(i);
    if (found == ledger.records.end() || !found->second.failure.empty()) missing.push_back(i);
  }
  return missing;
}

}  // namespace drydock::campaign
