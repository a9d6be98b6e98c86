#include "hil/campaign/report/result_store.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <memory>
#include <stdexcept>

namespace drydock::campaign {
namespace {

namespace fs = std::filesystem;

struct CloseStore {
  void operator()(sqlite3* store) const { sqlite3_close(store); }
};
struct EndStatement {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};

/// A new SQLite file in one transaction.
class Store {
 public:
  explicit Store(const fs::path& path) : path_(path) {
    sqlite3* raw = nullptr;
    const int code = sqlite3_open(path.c_str(), &raw);
    handle_.reset(raw);
    check(code);
    run("PRAGMA journal_mode = MEMORY");
    run("BEGIN");
  }
  void run(const std::string& sql) {
    check(sqlite3_exec(handle_.get(), sql.c_str(), nullptr, nullptr, nullptr));
  }
  auto prepared(const std::string& sql) {
    sqlite3_stmt* raw = nullptr;
    check(sqlite3_prepare_v2(handle_.get(), sql.c_str(), -1, &raw, nullptr));
    return std::unique_ptr<sqlite3_stmt, EndStatement>(raw);
  }
  void step(sqlite3_stmt* statement) {
    const int code = sqlite3_step(statement);
    if (code != SQLITE_DONE) check(code);
    check(sqlite3_reset(statement));
  }

 private:
  void check(int code) {
    if (code != SQLITE_OK)
      throw std::runtime_error(
          fmt::format("cannot write {}: {}", path_.string(), sqlite3_errmsg(handle_.get())));
  }
  fs::path path_;
  std::unique_ptr<sqlite3, CloseStore> handle_;
};

/// Binds one value after the other.
class Row {
 public:
  explicit Row(sqlite3_stmt* statement) : statement_(statement) {}
  void put(std::int64_t value) { sqlite3_bind_int64(statement_, ++at_, value); }
  void put(double value) { sqlite3_bind_double(statement_, ++at_, value); }
  void put(const std::string& value) {
    sqlite3_bind_text(statement_, ++at_, value.data(), static_cast<int>(value.size()),
                      SQLITE_TRANSIENT);
  }
  void put(const Value& value) {
    std::visit([this](const auto& v) { put(v); }, value);
  }
  void put(const std::optional<double>& value) {
    if (value)
      put(*value);
    else
      sqlite3_bind_null(statement_, ++at_);
  }

 private:
  sqlite3_stmt* statement_;
  int at_ = 0;
};

std::vector<std::string> columns_of(const CampaignConfig& campaign) {
  std::vector<std::string> columns{"\"index\" INTEGER PRIMARY KEY", "repetition INTEGER",
                                   "seed INTEGER"};
  for (const auto& parameter : campaign.parameters)  // without a type: numbers or texts
    columns.push_back(fmt::format("\"{}\"", parameter.name));
  for (const auto& figure : campaign.figures)
    columns.push_back(fmt::format("\"{}\" REAL", figure.name));
  columns.insert(columns.end(), {"exit_code INTEGER", "failure TEXT"});
  return columns;
}

void write_facts(Store& store, const CampaignConfig& campaign) {
  store.run("CREATE TABLE campaign (\"key\" TEXT PRIMARY KEY, \"value\" TEXT)");
  const auto statement = store.prepared("INSERT INTO campaign VALUES (?, ?)");
  const auto put = [&](const std::string& key, const std::string& value) {
    Row row(statement.get());
    row.put(key);
    row.put(value);
    store.step(statement.get());
  };
  put("name", campaign.name);
  put("file", campaign.text);
}

void write_run(Store& store, sqlite3_stmt* statement, const Plan& plan, const Record& record) {
  Row row(statement);
  row.put(static_cast<std::int64_t>(record.index));
  row.put(static_cast<std::int64_t>(plan.repetition_of(record.index)));
  row.put(static_cast<std::int64_t>(plan.seed_of(record.index)));
  for (const auto& value : plan.values_of(record.index)) row.put(value);
  for (const auto& figure : record.figures) row.put(figure);
  row.put(static_cast<std::int64_t>(record.exit_code));
  row.put(record.failure);
  store.step(statement);
}

void write_runs(Store& store, const Results& results) {
  const auto columns = columns_of(results.campaign);
  store.run(fmt::format("CREATE TABLE runs ({})", fmt::join(columns, ", ")));
  std::string marks = "?";
  for (std::size_t i = 1; i < columns.size(); ++i) marks += ", ?";
  const auto statement = store.prepared(fmt::format("INSERT INTO runs VALUES ({})", marks));
  const Plan plan(results.campaign);
  for (const auto& record : results.records) write_run(store, statement.get(), plan, record);
}

}  // namespace

void write_store(const fs::path& path, const Results& results) {
  const fs::path unfinished = path.string() + ".part";
  fs::remove(unfinished);
  {
    Store store(unfinished);
    write_facts(store, results.campaign);
    write_runs(store, results);
    store.run("COMMIT");
  }
  fs::rename(unfinished, path);
}

}  // namespace drydock::campaign
