// What journals say together: nothing lost, nothing counted twice.
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "hil/campaign/campaign_status.hpp"
#include "hil/campaign/runs/journal.hpp"
#include "hil/campaign/runs/ledger.hpp"
#include "hil/campaign/runs/scratch_folder.hpp"

namespace campaign_journal_test {
namespace {

using namespace drydock::campaign;
using testing::ElementsAre;
using testing::HasSubstr;

Record sound(std::size_t index, double figure) {
  return {.index = index, .figures = {figure, std::nullopt}, .exit_code = 0};
}

Record failed(std::size_t index) {
  return {.index = index,
          .figures = {std::nullopt, std::nullopt},
          .exit_code = 9,
          .failure = "ended by signal 9"};
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

TEST(CampaignJournal, GivesEveryRecordBackToTheLastBit) {
  const ScratchFolder folder;
  Journal journal(folder.path(), "x");
  journal.add(sound(3, 0.1 + 0.2));
  journal.add(failed(1));
  const auto ledger = read_ledger(folder.path(), 5, 2);
  EXPECT_EQ(ledger.records.at(3).figures.at(0), 0.1 + 0.2);
  EXPECT_EQ(ledger.records.at(3).figures.at(1), std::nullopt);
  EXPECT_EQ(ledger.records.at(1).failure, "ended by signal 9");
  EXPECT_THAT(missing_runs(ledger, 5), ElementsAre(0, 1, 2, 4));
}

TEST(CampaignJournal, ATornAndAChangedLineCountAsMissing) {
  const ScratchFolder folder;
  const std::string whole = to_line(sound(0, 1)), torn = to_line(sound(1, 2)).substr(0, 30);
  std::string changed = to_line(sound(2, 3.0));
  changed.replace(changed.find("3.0"), 1, "4");
  write(folder.path() / "a.journal", whole + "\n" + changed + "\n" + torn);
  const auto ledger = read_ledger(folder.path(), 3, 2);
  EXPECT_EQ(ledger.damaged_lines, 2u);
  EXPECT_THAT(missing_runs(ledger, 3), ElementsAre(1, 2));
}

TEST(CampaignJournal, ARunDoneTwiceCountsOnceWhateverTheOrderOfTheFiles) {
  for (const bool swapped : {false, true}) {
    const ScratchFolder folder;
    const std::string a = to_line(failed(0)) + "\n" + to_line(sound(1, 5)) + "\n",
                      b = to_line(sound(1, 5)) + "\n" + to_line(sound(0, 7)) + "\n";
    write(folder.path() / "1.journal", swapped ? b : a);
    write(folder.path() / "2.journal", swapped ? a : b);
    const auto ledger = read_ledger(folder.path(), 2, 2);
    EXPECT_EQ(ledger.records.size(), 2u);
    EXPECT_EQ(ledger.repeated, 2u);
    EXPECT_TRUE(ledger.differing.empty());
    EXPECT_EQ(ledger.records.at(0).figures.at(0), 7);
  }
}

TEST(CampaignJournal, ARunThatGivesOtherFiguresTheSecondTimeIsNamed) {
  const ScratchFolder folder;
  write(folder.path() / "1.journal", to_line(sound(4, 1)) + "\n" + to_line(sound(4, 2)) + "\n");
  const auto ledger = read_ledger(folder.path(), 5, 2);
  EXPECT_THAT(ledger.differing, ElementsAre(4));
  EXPECT_EQ(ledger.records.at(4).figures.at(0), 1);
}

// A task that is queued again reads the journals of its own shard alone; that of shard 11 is not of
// shard 1.
TEST(CampaignJournal, ALabelChoosesTheJournalsOfOneShard) {
  const ScratchFolder folder;
  Journal(folder.path(), "shard-1-1").add(sound(0, 1));
  Journal(folder.path(), "shard-1-11").add(sound(1, 2));
  const auto ledger = read_ledger(folder.path(), 3, 2, "shard-1-1-");
  EXPECT_THAT(missing_runs(ledger, 3), ElementsAre(1, 2));
}

/// Lets a file grow to so many bytes only, as a full disk does, while it lives.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, SIG_IGN);
  }
  ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
};

TEST(CampaignJournal, OnAFullDiskWhatItHasStaysAndTheNextLineIsWhole) {
  const ScratchFolder folder;
  Journal journal(folder.path(), "x");
  journal.add(sound(0, 1));
  const auto length = std::filesystem::file_size(journal.path());
  {
    const FullDisk disk(length + 20);  // the disk takes a part of the line
    try {
      journal.add(sound(1, 2));
      ADD_FAILURE() << "the line was taken";
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr("run 1 cannot be written"));
    }
  }
  EXPECT_EQ(std::filesystem::file_size(journal.path()), length);
  journal.add(sound(2, 3));
  const auto ledger = read_ledger(folder.path(), 3, 2);
  EXPECT_EQ(ledger.damaged_lines, 0u);
  EXPECT_THAT(missing_runs(ledger, 3), ElementsAre(1));
}

TEST(CampaignStatus, KnowsTheRateAndTheTimeLeft) {
  Ledger ledger;
  for (std::size_t i = 0; i < 5; ++i) {
    ledger.records[i] = sound(i, 0);
    ledger.records[i].ended_ms = 1000 + 500 * static_cast<std::int64_t>(i);  // two a second
  }
  EXPECT_EQ(progress_text(ledger, 25, 7000),
            "5 of 25 runs, 0 failed, 2 runs/s, 10 s left, the last one ended 4 s ago");
  EXPECT_EQ(progress_text(ledger, 5, 7000), "5 of 5 runs, 0 failed");
  EXPECT_EQ(progress_text({}, 5, 7000), "0 of 5 runs, 0 failed");
}

TEST(CampaignStatus, AFailedRunIsDone) {
  Ledger ledger;
  for (std::size_t i = 0; i < 5; ++i) {
    ledger.records[i] = sound(i, 0);
    ledger.records[i].ended_ms = 1000 + 500 * static_cast<std::int64_t>(i);
  }
  ledger.records[3].failure = "exit code 1";
  EXPECT_EQ(progress_text(ledger, 7, 3000),
            "5 of 7 runs, 1 failed, 2 runs/s, 1 s left, the last one ended 0 s ago");
  EXPECT_EQ(progress_text(ledger, 5, 3000), "5 of 5 runs, 1 failed; --resume runs these again");
}

}  // namespace
}  // namespace campaign_journal_test
