#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>

#include "tests/conformance/report.hpp"

namespace {

using namespace drydock::conformance;

constexpr int exit_wrong = 1, exit_usage = 2;

/// Shows the current capture on one line of a terminal.
void show(const Corpus& corpus, const fs::path& capture) {
  if (::isatty(STDERR_FILENO))
    fmt::print(stderr, "\r\033[K{}: {}", corpus.name, capture.filename().string());
}

void hide() {
  if (::isatty(STDERR_FILENO)) fmt::print(stderr, "\r\033[K");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Decodes captures made by others and compares with the values that other programs read.\n"
      "Exit codes: 0 nothing is wrong, 1 something is, 2 wrong usage or nothing to compare."};
  app.footer("Example: conformance ../shared/corpora --verbose\nSee docs/build/conformance.md.");
  std::string folder;
  bool as_json = false, verbose = false;
  app.add_option("DIR", folder, "folder with the corpora: dvl/, eml/, gps/, n2k/, can_imu/, ...")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_flag("--json", as_json, "the scoreboard and every difference as JSON");
  app.add_flag("--verbose", verbose, "list the differences: file, message, field, ours, theirs");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : exit_usage;
  }

  const std::vector<Result> results = score_all(folder, show);
  hide();
  if (results.empty()) {
    fmt::print(stderr, "conformance: no capture of a known kind below {}\n", folder);
    return exit_usage;
  }
  as_json ? print_json(results, stdout) : print_table(results, verbose, stdout);
  return clean(results) ? 0 : exit_wrong;
}
