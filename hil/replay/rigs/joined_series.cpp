#include "hil/replay/rigs/joined_series.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>

#include "hil/replay/rigs/rig_readers.hpp"

namespace drydock::replay {
namespace {

using File = RigCaptures::File;

class Joiner {
 public:
  Joiner(const rig_config::Rig& rig, const RigCaptures& captures)
      : rig_(rig), captures_(captures), made_{{{}, captures.how}, {}, {}} {}

  JoinedSeries made() {
    for (const auto& file : captures_.files) {
      if (!file.device.empty())
        series_[{file.device, {}, {}}].push_back(file);
      else if (!file.folder.empty())
        add_of_folder(file);
      else
        made_.captures.files.push_back(file);
    }
    for (const auto& [key, files] : series_) add_series(key, files);
    return std::move(made_);
  }

 private:
  struct Key {
    std::string device, folder;
    std::vector<std::size_t> readers;
    auto operator<=>(const Key&) const =
        default;  // NOLINT(modernize-use-nullptr): clang 14 takes it for a 0
  };

  const std::vector<RigReader>& readers() {
    if (!readers_) readers_ = readers_of(rig_, captures_.how);
    return *readers_;
  }

  /// What lies in the folder besides must not stop the reading.
  void add_of_folder(const File& file) {
    Key key{{}, file.folder, {}};
    try {
      const auto parts = parts_of(file.path, captures_.how.format);
      for (std::size_t i = 0; i < readers().size(); ++i)
        if (std::ranges::any_of(parts,
                                [&](const auto& part) { return understands(readers()[i], part); }))
          key.readers.push_back(i);
    } catch (const std::runtime_error& error) {
      made_.notes.emplace_back(error.what());
      return;
    }
    if (key.readers.empty())
      made_.captures.files.push_back(file);
    else
      series_[key].push_back(file);
  }

  void add_series(const Key& key, const std::vector<File>& files) {
    const auto reader = std::ranges::find(readers(), key.device, &RigReader::name);
    const bool is_known = key.device.empty() || reader != readers().end();
    if (files.size() == 1 || !is_known) {
      std::ranges::copy(files, std::back_inserter(made_.captures.files));
      return;
    }
    std::vector<std::string> paths;
    paths.reserve(files.size());
    for (const auto& file : files) paths.push_back(file.path);
    auto joined =
        join(paths, key.device.empty() ? readers()[key.readers.front()].how : reader->how);
    made_.captures.files.push_back(
        {joined.file->path(), key.device, {}, joined.format, joined.shown});
    made_.files.push_back(std::move(joined.file));
    std::ranges::move(joined.notes, std::back_inserter(made_.notes));
  }

  const rig_config::Rig& rig_;
  const RigCaptures& captures_;
  JoinedSeries made_;
  std::map<Key, std::vector<File>> series_;
  std::optional<std::vector<RigReader>> readers_;
};

}  // namespace

JoinedSeries join_series(const rig_config::Rig& rig, const RigCaptures& captures) {
  return Joiner(rig, captures).made();
}

}  // namespace drydock::replay
