#include "hil/program/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "drivers/text/printable.hpp"
#include "hil/program/completion_words.hpp"
#include "hil/program/dash_output.hpp"

namespace drydock::program {

namespace {

namespace fs = std::filesystem;

/// An option that names what a command writes, and how a file begins that the command wrote; `mark`
/// empty: a flag --overwrite guards it, or it is a folder.
struct Output {
  std::string_view option, content, mark;
};
constexpr auto outputs = std::to_array<Output>({
    {"json", "JSON", "{["},
    {"update-refs", "JSON", "{["},
    {"junit", "XML", "<"},
    {"plot", "SVG", "<"},
    {"allan", "SVG", "<"},
    {"csv", "CSV", "t"},
    {"record", "", ""},
    {"output", "", ""},
    {"out", "", ""},
    {"write", "", ""},
    {"report", "", ""},
});

/// The names of files that an output folder may hold beside its page.
constexpr auto in_folder = std::to_array<const char*>({"rig.toml", "mission.toml", "track.csv"});

const Output* output_of(const CLI::Option& option) {
  const auto found = std::ranges::find_if(
      outputs, [&](const Output& o) { return option.check_lname(std::string(o.option)); });
  return found == outputs.end() || is_flag(option) ? nullptr : &*found;
}

bool regular(const fs::path& path) {
  std::error_code missing;
  return fs::is_regular_file(path, missing);
}

bool same_file(const fs::path& one, const fs::path& other) {
  std::error_code missing;
  return regular(one) && fs::equivalent(one, other, missing);
}

/// The files that the value of an output stands for.
std::vector<fs::path> files_of(const std::string& value) {
  std::error_code missing;
  if (!fs::is_directory(value, missing)) return {value};
  std::vector<fs::path> files;
  files.reserve(in_folder.size());
  for (const auto* name : in_folder) files.push_back(fs::path(value) / name);
  return files;
}

std::string name_of(const CLI::Option& option) {
  return option.get_lnames().empty() ? option.get_name(true) : long_name(option);
}

[[noreturn]] void refuse(const CLI::Option& output, const std::string& why) {
  throw CLI::ValidationError(long_name(output), why);
}

/// A table of TOML begins as an array of JSON does, but goes on with the letters of its name.
bool begins_table(std::string_view head) {
  const auto name = head.find_first_not_of("[ ");
  return head.starts_with('[') && name != head.npos &&
         std::isalpha(static_cast<unsigned char>(head[name])) != 0;
}

/// True if nothing is lost with the file: it is new or empty, no plain file, or of that content.
bool replaceable(const std::string& path, const Output& output, bool sensor_file) {
  if (!regular(path)) return true;
  std::ifstream in(path, std::ios::binary);
  std::string head(sensor_file ? 4096 : 64, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  if (sensor_file) return head.empty() || head.find("drydock characterize") != std::string::npos;
  const auto first = head.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return true;
  return output.mark.find(head[first]) != std::string_view::npos &&
         !begins_table(std::string_view(head).substr(first));
}

using Options = std::vector<const CLI::Option*>;

void spare_inputs(const CLI::Option& output, const std::string& value, const Options& all) {
  for (const auto* other : all) {
    if (other == &output || is_flag(*other)) continue;
    const bool written_too = output_of(*other) != nullptr;
    for (const auto& theirs : other->results())
      for (const auto& file : files_of(value)) {
        const bool one_name =
            written_too && !fs::exists(file) &&
            fs::absolute(file).lexically_normal() == fs::absolute(theirs).lexically_normal();
        if (one_name || same_file(file, theirs))
          refuse(output, fmt::format("{} is what {} {}, and would be lost; name another file",
                                     text::printable(file.string()), name_of(*other),
                                     written_too ? "writes" : "reads"));
      }
  }
}

}  // namespace

void take_dashes(CLI::App& app) {
  for (auto* command : app.get_subcommands({}))
    for (auto* option : command->get_options())
      if (const auto* output = output_of(*option); output != nullptr && !output->mark.empty())
        take_dash(*option);
}

void spare_files(const CLI::App& app) {
  for (const auto* command : app.get_subcommands()) {
    const auto all = command->get_options([](const CLI::Option* o) { return o->count() > 0; });
    for (const auto* option : all) {
      const Output* output = output_of(*option);
      if (output == nullptr) continue;
      const bool sensor_file = command->get_name() == "characterize" && output->option == "out";
      for (const auto& value : option->results()) {
        spare_inputs(*option, value, all);
        if ((sensor_file || !output->mark.empty()) && !replaceable(value, *output, sensor_file))
          refuse(*option,
                 fmt::format("{} is no {} file of such a command, and would be lost; name "
                             "another file, or delete it first",
                             text::printable(value), sensor_file ? "sensor" : output->content));
      }
    }
  }
}

}  // namespace drydock::program
