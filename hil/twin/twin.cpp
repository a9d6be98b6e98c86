#include "hil/twin/twin.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "drivers/terminal/exit_codes.hpp"
#include "hil/report/write_file.hpp"

namespace drydock::twin {

int twin(const TwinOptions& options, std::FILE* out, std::FILE* err) {
  namespace fs = std::filesystem;
  try {
    if (fs::exists(options.folder) && !fs::is_directory(options.folder))
      throw std::runtime_error(options.folder + " is a file, not a folder");
    if (!options.overwrite && fs::exists(options.folder) && !fs::is_empty(options.folder))
      throw std::runtime_error(options.folder + " is not empty; --overwrite writes into it");
    const auto outcome = make_twin(options);
    fmt::print(out, "{}", options.json ? to_json(outcome) : to_text(outcome));
    if (!options.report.empty())
      report::write_file(fs::path(options.report) / "index.html", to_html(outcome));
    return terminal::exit_success;
  } catch (const track::BadOptions& error) {
    fmt::print(err, "twin: {}\n", error.what());
    return terminal::exit_usage;
  } catch (const std::exception& error) {
    fmt::print(err, "twin: {}\n", error.what());
    return terminal::exit_failed;
  }
}

}  // namespace drydock::twin
