#include "hil/example/example.hpp"

#include <fmt/format.h>

#include <cctype>
#include <fstream>
#include <iterator>

#include "drivers/terminal/exit_codes.hpp"
#include "rig_config/rules/explain.hpp"
#include "rig_config/shipped.hpp"

namespace drydock::example {
namespace {

using rig_config::kinds_of_files;

constexpr std::size_t widest = 90;

/// Behind the first full stop outside brackets after which no small letter or figure goes on: that
/// of
/// "(Lee et al. 2010)" is none.
std::size_t end_of_sentence(const std::string& text) {
  int open = 0;
  for (std::size_t i = 0; i + 2 < text.size(); ++i) {
    open += (text[i] == '(') - (text[i] == ')');
    const auto next = static_cast<unsigned char>(text[i + 2]);
    const bool goes_on = std::islower(next) != 0 || std::isdigit(next) != 0;
    if (open == 0 && text.compare(i, 2, ". ") == 0 && !goes_on) return i;
  }
  return text.find_last_not_of(". ") + 1;
}

/// What a file says first: the first sentence of the comment at its head; else its title.
std::string first_sentence(const std::filesystem::path& path) {
  constexpr std::string_view title = "title = \"";
  std::ifstream in(path);
  std::string sentence;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("# ")) sentence += line.substr(2) + ' ';
    if (!line.starts_with("#") && !sentence.empty()) break;
    if (line.starts_with(title)) return line.substr(title.size(), line.rfind('"') - title.size());
  }
  sentence.resize(end_of_sentence(sentence));
  if (sentence.size() <= widest) return sentence;
  return sentence.substr(0, sentence.rfind(' ', widest)) + " ...";
}

/// The files that a shipped one names lie beside its folder; a copy elsewhere names them by where
/// they are.
std::string with_whole_paths(std::string text, const std::filesystem::path& from) {
  const std::string up = "\"../", kinds_folder = from.parent_path().parent_path().string();
  for (auto at = text.find(up); at != std::string::npos; at = text.find(up, at + 1))
    text.replace(at + 1, up.size() - 2, kinds_folder);
  return text;
}

/// As `missions/loop`.
std::string with_kind(const std::filesystem::path& path) {
  return (path.parent_path().filename() / path.stem()).string();
}

/// All shipped files of that name, with or without their kind and ending, in the order of kinds.
std::vector<std::filesystem::path> files_of(const std::string& name) {
  std::vector<std::filesystem::path> found;
  for (const auto kind : kinds_of_files)
    for (const auto& path : rig_config::shipped_files(kind))
      if (path.stem() == name || path.filename() == name || with_kind(path) == name ||
          with_kind(path) + ".toml" == name)
        found.push_back(path);
  return found;
}

int nothing_shipped(std::FILE* err) {
  fmt::print(err, "example: the files that come with the program are not beside it\n");
  return terminal::exit_failed;
}

}  // namespace

int list(std::FILE* out, std::FILE* err) {
  if (rig_config::shipped_folder().empty()) return nothing_shipped(err);
  for (const auto kind : kinds_of_files) {
    const std::string folder(kind);
    fmt::print(out, "{}\n", folder);
    for (const auto& path : rig_config::shipped_files(kind))
      fmt::print(out, "  {:24} {}\n", path.stem().string(), first_sentence(path));
  }
  fmt::print(out, "in {}\n", (rig_config::shipped_folder() / "rig_config").string());
  return terminal::exit_success;
}

int show(const std::string& name, std::FILE* out, std::FILE* err) {
  if (rig_config::shipped_folder().empty()) return nothing_shipped(err);
  const auto found = files_of(name);
  if (!found.empty()) {
    const auto& path = found.front();
    std::ifstream in(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    fmt::print(out, "# {}\n", path.string());
    for (std::size_t i = 1; i < found.size(); ++i)
      fmt::print(out, "# drydock example {} prints the other of that name\n", with_kind(found[i]));
    fmt::print(out, "{}", with_whole_paths(text, path));
    return terminal::exit_success;
  }
  std::vector<std::string> names;
  for (const auto kind : kinds_of_files)
    for (const auto& path : rig_config::shipped_files(kind)) names.push_back(path.stem().string());
  fmt::print(err, "example: no shipped file is named '{}'{}; drydock example lists them\n", name,
             rig_config::did_you_mean(name, names));
  return terminal::exit_usage;
}

}  // namespace drydock::example
