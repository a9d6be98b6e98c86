// A dropped ssh session and a service manager end a recording as Ctrl-C does.
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>
#include <string>
#include <utility>

#include "tests/hil/program/program.hpp"

namespace hangup_test {

using program::Folder;

/// The program on a terminal of its own.
class OnATerminal {
 public:
  OnATerminal(const Folder& folder, const std::string& arguments) {
    pid_ = forkpty(&terminal_, nullptr, nullptr, nullptr);
    if (pid_ != 0) return;
    ::setenv("XDG_RUNTIME_DIR", (folder / "").c_str(), 1);
    const std::string command = "cd " DRYDOCK_SOURCE_DIR "; exec " DRYDOCK_PROGRAM " " + arguments;
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    std::abort();
  }
  ~OnATerminal() {
    ::close(terminal_);
    if (!ended_) ::kill(pid_, SIGKILL);
    if (!ended_) ::waitpid(pid_, nullptr, 0);
  }
  OnATerminal(const OnATerminal&) = delete;
  OnATerminal& operator=(const OnATerminal&) = delete;

  /// Reads until the text has come. False at the end of the program.
  bool says(const std::string& text) {
    std::array<char, 4096> chunk{};
    while (output_.find(text) == std::string::npos) {
      const auto n = ::read(terminal_, chunk.data(), chunk.size());
      if (n <= 0) return false;
      output_.append(chunk.data(), static_cast<std::size_t>(n));
    }
    return true;
  }
  void hang_up() { ::close(std::exchange(terminal_, -1)); }
  void tell(int signal) const { ::kill(pid_, signal); }
  /// The status as of waitpid().
  int end() {
    int status = 0;
    ::waitpid(pid_, &status, 0);
    ended_ = true;
    return status;
  }

 private:
  int terminal_ = -1;
  pid_t pid_ = 0;
  bool ended_ = false;
  std::string output_;
};

/// A file has the closing magic of MCAP only if it was finished.
bool is_finished(const std::filesystem::path& recording) {
  return program::read_file(recording).ends_with("\x89MCAP0\r\n");
}

TEST(Hangup, OfASshSessionFinishesTheRecording) {
  const Folder folder;
  std::ofstream(folder / "rig.toml")
      << "[rig]\nname = \"log\"\n[[device]]\nname = \"log\"\nkind = \"emlog\"\n"
         "protocol = \"nmea0183\"\nlink = \"udp:127.0.0.1:24873\"\nrate_hz = 1\n";
  OnATerminal record(folder, "record " + (folder / "rig.toml").string() + " -o " +
                                 (folder / "dive.mcap").string());
  ASSERT_TRUE(record.says("waiting for the first message"));
  record.hang_up();
  const int status = record.end();
  ASSERT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 1) << "no device streamed";
  EXPECT_TRUE(is_finished(folder / "dive.mcap"));
}

TEST(Hangup, ATermSignalFinishesTheRecordingOfARunInVirtualTime) {
  const Folder folder;
  const auto recording = folder / "dive.mcap";
  OnATerminal run(folder, "run rig_config/rigs/demo.toml --for 100h --speed max --record " +
                              recording.string());
  std::error_code missing;
  while (!(std::filesystem::file_size(recording, missing) > 1'000'000) || missing) ::usleep(10'000);
  run.tell(SIGTERM);
  EXPECT_TRUE(run.says("recording "));
  EXPECT_TRUE(WIFEXITED(run.end()));
  EXPECT_TRUE(is_finished(recording));
}

/// `drydock run ... | head -1`: what the run was for is written, and the code is that of a signal.
/// On a slow machine head may leave behind the last line of the start: then the table at the end
/// meets the closed pipe.
TEST(ClosedPipe, OfARunEndsItWithItsFiles) {
  for (const char* pace : {"--for 20s", "--for 3000s --speed max"}) {
    const Folder folder;
    const std::string verdict = (folder / "run.json").string();
    const std::string recording = (folder / "run.mcap").string();
    const std::string command =
        std::string("demo.toml ") + pace + " --json " + verdict + " --record " + recording;
    const auto outcome =
        program::drydock("--version; bash -c '" DRYDOCK_PROGRAM " run rig_config/rigs/" + command +
                         " | head -1 >/dev/null; exit ${PIPESTATUS[0]}'");
    EXPECT_EQ(outcome.exit_code, 130) << pace << outcome.output;
    EXPECT_NE(program::read_file(verdict).find("\"interrupted\""), std::string::npos) << pace;
    EXPECT_TRUE(is_finished(recording)) << pace;
  }
}

/// `drydock run ... | :`: nobody reads a single line.
TEST(ClosedPipe, ThatNobodyEverReadsLeavesTheFilesOfARunToo) {
  const Folder folder;
  const std::string verdict = (folder / "run.json").string();
  const std::string page = (folder / "page").string();
  const auto outcome =
      program::drydock("--version; bash -c '" DRYDOCK_PROGRAM
                       " run rig_config/rigs/demo.toml --for 20s --speed max --json " +
                       verdict + " --report " + page + " | :; exit ${PIPESTATUS[0]}'");
  EXPECT_EQ(outcome.exit_code, 130) << outcome.output;
  EXPECT_NE(program::read_file(verdict).find("\"interrupted\""), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(page + "/index.html")) << outcome.output;
}

}  // namespace hangup_test
