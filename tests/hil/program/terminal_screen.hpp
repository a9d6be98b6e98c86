#pragma once

#include <chrono>
#include <string>
#include <thread>

#include "tests/hil/program/program.hpp"

namespace program {

/// The program on a terminal that tmux plays: another program's reading of what it draws.
class TerminalScreen {
 public:
  TerminalScreen(const Folder& folder, const std::string& arguments, const std::string& term,
                 int width, int height)
      : tmux_("TMUX= tmux -S " + (folder / "tmux").string() + " -f /dev/null "),
        raw_(folder / "raw") {
    const std::string command = "cd " DRYDOCK_SOURCE_DIR
                                "; export LC_ALL=C.UTF-8 XDG_RUNTIME_DIR=" +
                                (folder / "").string() + "; sleep 0.2; TERM=" + term +
                                " " DRYDOCK_PROGRAM " " + arguments + "; echo exit=$?; cat";
    ask("new-session -d -x " + std::to_string(width) + " -y " + std::to_string(height) + " '" +
        command + "' \\; pipe-pane 'cat > " + raw_.string() + "'");
  }
  ~TerminalScreen() { ask("kill-server"); }
  TerminalScreen(const TerminalScreen&) = delete;
  TerminalScreen& operator=(const TerminalScreen&) = delete;

  std::string text() const { return ask("capture-pane -p"); }
  void press(const std::string& keys) const { ask("send-keys " + keys); }
  void resize(int width, int height) const {
    ask("resize-window -x " + std::to_string(width) + " -y " + std::to_string(height));
  }
  std::string bytes() const { return read_file(raw_); }  ///< all that the program wrote

  /// The screen as soon as it has the text; the last one when patience is over.
  std::string showing(const std::string& wanted) const {
    const auto end = std::chrono::steady_clock::now() + patience;
    std::string seen;
    while (std::chrono::steady_clock::now() < end) {
      seen = text();
      if (seen.find(wanted) != std::string::npos) break;
      std::this_thread::sleep_for(std::chrono::milliseconds{50});
    }
    return seen;
  }

 private:
  std::string ask(const std::string& command) const {
    std::FILE* pipe = popen((tmux_ + command + " 2>&1").c_str(), "r");
    std::string answer;
    std::array<char, 4096> chunk{};
    while (const auto n = std::fread(chunk.data(), 1, chunk.size(), pipe))
      answer.append(chunk.data(), n);
    pclose(pipe);
    return answer;
  }

  std::string tmux_;
  std::filesystem::path raw_;
};

}  // namespace program
