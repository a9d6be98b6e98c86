#include "hil/emulate/dvl/ad2cp_dialogue.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace drydock::emulate {
namespace {

constexpr std::string_view soft_break = "K1W%!Q";
constexpr char hard_break = '\x03';
constexpr std::size_t longest_line = 512;
constexpr std::array<std::string_view, 4> refusable_commands{"SETBT", "SETTMBT", "SAVE", "START"};

bool ends_line(char c) { return c == '\r' || c == '\n'; }

}  // namespace

std::string Ad2cpDialogue::receive(std::span<const std::uint8_t> bytes, bool refuses) {
  std::string said;
  for (const std::uint8_t byte : bytes) {
    const char c = static_cast<char>(byte);
    if (ends_line(c)) {
      said += obey_line(refuses);
      continue;
    }
    if (line_.size() < longest_line) line_ += c;
    if (c == hard_break || line_.ends_with(soft_break)) {
      line_.clear();
      said += start(false);
    }
  }
  return said;
}

std::string Ad2cpDialogue::obey_line(bool refuses) {
  const std::string line = std::exchange(line_, {});
  if (line.empty()) return {};
  if (line.size() == longest_line) return failed("the line is too long");
  const std::size_t comma = std::min(line.find(','), line.size());
  const std::string_view command = std::string_view(line).substr(0, comma);
  if (refuses && std::ranges::find(refusable_commands, command) != refusable_commands.end())
    return failed("it refuses to be set");
  return obey(command, std::string_view(line).substr(std::min(comma + 1, line.size())));
}

std::string Ad2cpDialogue::obey(std::string_view command, std::string_view arguments) {
  if (command == "BBPWAKEUP") {
    awake_ = true;
    return taken();
  }
  if (measures_ && !std::exchange(awake_, false))
    return failed("it measures: BBPWAKEUP or a break first");
  if (command == "GETERROR") return "\"" + last_error_ + "\"\r\n" + taken();
  if (command == "GETBT") return tell(bottom_track_.arguments(), arguments);
  if (command == "GETTMBT") return tell(telemetry_.arguments(), arguments);
  if (command == "STOP") return start(false);
  if (measures_) return failed("it measures: STOP or a break first");
  if (command == "SETBT") return set(bottom_track_.arguments(), arguments);
  if (command == "SETTMBT") return set(telemetry_.arguments(), arguments);
  if (command == "START") return start(true);
  if (command == "SAVE") return taken();
  return failed("unknown command");
}

std::string Ad2cpDialogue::taken() { return "OK\r\n"; }

std::string Ad2cpDialogue::failed(std::string why) {
  last_error_ = std::move(why);
  return "ERROR\r\n";
}

std::string Ad2cpDialogue::set(std::span<Ad2cpArgument* const> arguments, std::string_view text) {
  std::string why_not = set_arguments(arguments, text);
  return why_not.empty() ? taken() : failed(std::move(why_not));
}

std::string Ad2cpDialogue::tell(std::span<Ad2cpArgument* const> arguments, std::string_view text) {
  const auto values = values_of(arguments, text);
  return values ? *values + "\r\n" + taken() : failed("unknown argument");
}

std::string Ad2cpDialogue::start(bool measures) {
  measures_ = measures;
  awake_ = false;
  return taken();
}

}  // namespace drydock::emulate
