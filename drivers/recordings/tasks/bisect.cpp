#include "drivers/recordings/slice/bisect.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>

#include "drivers/recordings/tasks/recordings.hpp"
#include "drivers/terminal/exit_codes.hpp"

namespace drydock::recordings {

namespace {

namespace fs = std::filesystem;

constexpr int not_executable = 126, not_found = 127;  ///< exit codes of the shell

/// Quotes a word for a POSIX shell.
std::string quoted_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string with_slice(std::string command, const std::string& slice) {
  const std::string word = quoted_word(slice);
  for (std::size_t at = 0; (at = command.find("{}", at)) != std::string::npos; at += word.size())
    command.replace(at, 2, word);
  return command;
}

/// The times at which a link carried something, each once, in order.
std::vector<measurement::Stamp> times_in(record::Recording& recording) {
  std::vector<measurement::Stamp> times;
  if (recording.begin()) times.push_back(*recording.begin());
  while (const auto event = recording.next())
    if (const auto* raw = std::get_if<record::RawEvent>(&*event)) times.push_back(raw->at());
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// Tests slices with the command. The last slice that failed stays under the name of the output.
class Trial {
 public:
  Trial(const BisectOptions& options, std::string output, const record::Watch& watch)
      : options_(options), output_(std::move(output)), watch_(watch) {}

  std::optional<bool> operator()(const record::Selection& part) {
    if (!watch_(done_)) return {};
    slice::SliceOptions slice;
    slice.part = part;
    slice.overwrite = true;
    const std::string candidate = output_ + ".trial.mcap";
    const auto made =
        slice::slice(options_.recording, candidate, slice, [](double) { return true; });
    if (!made) return broken(made.error().line);
    const int status = std::system(with_slice(options_.command, candidate).c_str());
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) return broken("ended by Ctrl-C");
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 1;
    if (code == not_executable || code == not_found)
      return broken(fmt::format("the command cannot be run (exit code {})", code));
    done_ = 1 - (1 - done_) * 0.9;
    std::error_code ignored;
    if (code == 0) {
      fs::remove(candidate, ignored);
      return false;
    }
    fs::rename(candidate, output_, ignored);
    return true;
  }
  const std::string& trouble() const { return trouble_; }

 private:
  std::optional<bool> broken(std::string why) {
    trouble_ = std::move(why);
    std::error_code ignored;
    fs::remove(output_ + ".trial.mcap", ignored);
    return {};
  }

  const BisectOptions& options_;
  std::string output_;
  const record::Watch& watch_;
  double done_ = 0;
  std::string trouble_;
};

int refuse_bisect(std::FILE* err, std::string_view why, int code = terminal::exit_failed) {
  fmt::print(err, "bisect: {}\n", why);
  return code;
}

}  // namespace

int bisect(const BisectOptions& options, const record::Watch& watch, std::FILE* err) {
  auto recording = record::Recording::open(options.recording);
  if (!recording) return refuse_bisect(err, recording.error().line);
  if (options.command.find("{}") == std::string::npos)
    return refuse_bisect(err, "--run: the command has no {} for the slice", terminal::exit_usage);
  const std::string output = options.output.empty()
                                 ? fs::path(options.recording).stem().string() + "-smallest.mcap"
                                 : options.output;
  if (!options.overwrite && fs::exists(output))
    return refuse_bisect(err, output + ": File exists; --overwrite replaces it");
  const auto times = times_in(*recording);
  if (times.empty()) return refuse_bisect(err, options.recording + ": nothing in it");
  std::vector<std::string> links;
  for (const auto& link : recording->links()) links.push_back(link.name);
  Trial trial(options, output, watch);
  const auto found = slice::bisect(times, links, std::ref(trial));
  if (!trial.trouble().empty()) fmt::print(err, "bisect: {}\n", trial.trouble());
  if (!found.fails_at_all)
    return found.broken_off ? 1 : refuse_bisect(err, "the command succeeds on the whole recording");
  fmt::print(err, "{}: still fails with {} of {} times at which something came, after {} runs{}\n",
             output, found.events, times.size(), found.runs,
             found.broken_off ? "; not the smallest: broken off" : "");
  return found.broken_off ? 1 : 0;
}

}  // namespace drydock::recordings
