#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/drivers/described/dbc_bus.hpp"

namespace drydock::described::test {

/// A description and its DBC file in a folder of their own.
class DbcFolder : public testing::Test {
 protected:
  DbcFolder()
      : folder_(std::filesystem::path(testing::TempDir()) /
                ("drydock-dbc-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~DbcFolder() override { std::filesystem::remove_all(folder_); }

  DescriptionPtr description(const std::string& kind, const std::string& dbc,
                             const std::string& frames) const {
    std::ofstream(folder_ / "s.dbc") << "VERSION \"\"\nBU_: s\n" << dbc;
    std::ofstream(folder_ / "s.toml")
        << "[sensor]\ntitle = \"s\"\nkind = \"" << kind << "\"\n[protocol]\ndbc = \"s.dbc\"\n"
        << frames;
    auto loaded = rig_config::load_description((folder_ / "s.toml").string());
    EXPECT_TRUE(loaded) << (loaded ? "" : to_string(loaded.error().front()));
    return *loaded;
  }

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

}  // namespace drydock::described::test
