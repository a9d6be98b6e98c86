// The missing runs in pieces, one for each task.
#include <gmock/gmock.h>

#include <fstream>

#include "hil/campaign/runs/scratch_folder.hpp"
#include "hil/campaign/slurm/line_counter.hpp"
#include "hil/campaign/slurm/shard_list.hpp"

namespace campaign_shards_test {
namespace {

using namespace drydock::campaign;
using testing::ElementsAre;
using Indexes = std::vector<std::size_t>;

TEST(CampaignShards, WriteNeighboursAsARange) {
  EXPECT_EQ(to_ranges(Indexes{0, 1, 2, 3, 7, 9, 10}), "0-3,7,9-10");
  EXPECT_THAT(read_ranges("0-3,7,9-10"), ElementsAre(0, 1, 2, 3, 7, 9, 10));
  for (const char* bad : {"x", "1-", "1,,2", "-3", "1 2"})
    EXPECT_THROW(read_ranges(bad), std::runtime_error) << bad;
}

TEST(CampaignShards, HaveEveryMissingRunOnce) {
  const ScratchFolder folder;
  Indexes missing;
  for (std::size_t i = 0; i < 1000; i += 1 + i % 3) missing.push_back(i);
  const auto list = folder.path() / "1.shards";
  const auto shards = write_shards(list, missing, 7);
  EXPECT_EQ(shards, (missing.size() + 6) / 7);
  Indexes all;
  for (std::size_t k = 0; k < shards; ++k)
    for (const auto index : read_shard(list, k)) all.push_back(index);
  EXPECT_EQ(all, missing);
  EXPECT_THROW(read_shard(list, shards), std::runtime_error);
}

TEST(CampaignShards, LinesOfJournalsAreCountedAsTheyGrow) {
  const ScratchFolder folder;
  LineCounter lines(folder.path());
  EXPECT_EQ(lines.count(), 0u);
  std::ofstream one(folder.path() / "1.journal"), two(folder.path() / "2.journal");
  one << "a\nb\nhal" << std::flush;
  two << "c\n" << std::flush;
  EXPECT_EQ(lines.count(), 3u);
  one << "f\n" << std::flush;
  EXPECT_EQ(lines.count(), 4u);
  EXPECT_EQ(lines.count(), 4u);
}

}  // namespace
}  // namespace campaign_shards_test
