#include "hil/emulate/dvl/rdi_dialogue.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <chrono>

namespace drydock::emulate {
namespace {

using measurement::Stamp;

constexpr std::string_view line_end = "\r\n", prompt = ">";
constexpr std::string_view greeting =
    "\r\n[BREAK Wakeup A]\r\n"
    "WorkHorse Broadband DVL Version 16.30\r\n"
    "Emulated by Drydock\r\n"
    "All Rights Reserved.\r\n>";
constexpr std::string_view out_of_bounds = " ERR 001:  PARAMETER OUT OF BOUNDS\r\n>",
                           no_numeral = " ERR 002:  NUMERAL EXPECTED\r\n>",
                           unknown = " ERR 010:  UNRECOGNIZED COMMAND\r\n>";
constexpr std::size_t longest_line = 80, break_length = 3;
constexpr std::chrono::minutes patience{5};
constexpr std::chrono::milliseconds pause_before_break{100};

// Bottom track, control, environment, performance, recorder, sensors, timing, water profile.
constexpr std::string_view commands =
    "BA BB BC BD BE BF BH BI BJ BK BL BM BN BO BP BR BS BV BW BX BZ "
    "CA CB CC CE CF CH CJ CK CL CM CN CO CP CQ CR CS CT CU CW CX CY CZ "
    "EA EB EC ED EE EF EH EI EJ EM EP ER ES ET EU EV EX EY EZ "
    "LC LD LL LW MN OL PA PB PC PD PE PF PL PM PN PS PT RA RB RE RF RI RN RR RS RY "
    "SA SB SC SD SI SM SO SR SS ST SW SY TB TC TE TF TG TP TS TT TX "
    "WA WB WC WD WE WF WI WJ WK WL WM WN WO WP WQ WR WS WT WU WV WW WX WY WZ";
// These act by themselves and have no value.
constexpr std::string_view acting = "CK CS CZ CY CE BS LC LD LL OL PA PC PF PS PT RB RF RR";

constexpr std::array<unsigned, 9> rates{300, 1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200};

bool stands_in(std::string_view list, std::string_view command) {
  for (std::size_t at = 0; at + 2 <= list.size(); at += 3)
    if (list.substr(at, 2) == command) return true;
  return false;
}

std::optional<unsigned> whole_number(std::string_view text) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

bool is_numeric(std::string_view text) {
  return std::ranges::all_of(text, [](char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("+-.,:/ $").find(c) != std::string_view::npos;
  });
}

std::string said(std::string_view text) {
  return std::string(line_end).append(text).append(line_end).append(prompt);
}

}  // namespace

void RdiDialogue::forget() { values_ = {{"PD", std::to_string(format_)}}; }

std::string RdiDialogue::receive(std::span<const std::uint8_t> bytes, Stamp now, bool refuses) {
  const bool paused = now - std::exchange(heard_at_, now) >= pause_before_break;
  if (paused && bytes.size() == 1 && bytes[0] == 0) return wake();
  std::string answer;
  for (const std::uint8_t byte : bytes) answer += hear(static_cast<char>(byte), refuses);
  return answer;
}

std::string RdiDialogue::hear(char c, bool refuses) {
  tail_ += c;
  if (tail_.size() > break_length) tail_.erase(0, 1);
  const bool is_break = c == '\0' && state_ != State::pings;
  if (is_break || tail_ == "===" || tail_ == "+++") return wake();
  if (state_ != State::listens) return {};
  const char before = std::exchange(before_, c);
  if (c == '\n' && before == '\r') return {};
  if (c == '\r' || c == '\n') return obey_line(refuses);
  if (line_.size() < longest_line) line_ += c;
  return {c};
}

std::string RdiDialogue::wake() {
  state_ = State::listens;
  tail_.clear();
  line_.clear();
  return std::string(greeting);
}

std::string RdiDialogue::obey_line(bool refuses) {
  std::string line = std::exchange(line_, {});
  std::erase(line, ' ');
  std::erase(line, '=');
  if (line.empty()) return std::string(line_end).append(prompt);
  std::ranges::transform(line, line.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  const std::size_t name = line[0] == '#' ? 3 : 2;
  if (line.size() < name) return std::string(unknown);
  const auto command = std::string_view(line).substr(0, name);
  if (!stands_in(commands, command.substr(name - 2))) return std::string(unknown);
  return obey(command, std::string_view(line).substr(name), refuses);
}

std::string RdiDialogue::obey(std::string_view command, std::string_view argument, bool refuses) {
  if (argument == "?") {
    const auto value = values_.find(command);
    return said(std::string(command) + " = " + (value == values_.end() ? "0" : value->second));
  }
  if (!is_numeric(argument)) return std::string(no_numeral);
  if (refuses) return std::string(out_of_bounds);
  (told_ += told_.empty() ? "" : ", ").append(command).append(argument);
  if (command == "CS") {
    state_ = State::pings;
    return std::string(line_end);
  }
  if (command == "CZ") {
    state_ = State::sleeps;
    return std::string(line_end).append("Powering Down").append(line_end);
  }
  if (command == "CK") {
    saved_ = values_;
    return said("[Parameters saved as USER defaults]");
  }
  if (command == "CR") {
    const bool factory = argument == "1";
    if (!factory && argument != "0") return std::string(out_of_bounds);
    forget();
    if (!factory && !saved_.empty()) values_ = saved_;
    return said(factory ? "[Parameters set to FACTORY defaults]"
                        : "[Parameters set to USER defaults]");
  }
  if (command == "CB") return set_rate(argument);
  if (stands_in(acting, command)) return std::string(line_end).append(prompt);
  return set(std::string(command), argument);
}

/// A value without a sign: the first digit is the rate, then parity and stop bits.
std::string RdiDialogue::set_rate(std::string_view argument) {
  const auto rate = argument.size() == 3 ? whole_number(argument.substr(0, 1)) : std::nullopt;
  if (!rate || *rate >= rates.size() || argument.substr(1) != "11")
    return std::string(out_of_bounds);
  baud_ = rates[*rate];
  return set("CB", argument);
}

std::string RdiDialogue::set(const std::string& command, std::string_view argument) {
  if (argument.empty()) return std::string(no_numeral);
  if (command == "PD" && whole_number(argument) != format_) return std::string(out_of_bounds);
  if (command == "BX" && !whole_number(argument)) return std::string(out_of_bounds);
  values_[command] = argument;
  return std::string(line_end).append(prompt);
}

bool RdiDialogue::pings(Stamp now) {
  if (state_ == State::listens && now - heard_at_ >= patience) state_ = State::pings;
  return state_ == State::pings;
}

std::optional<double> RdiDialogue::deepest_m() const {
  const auto found = values_.find("BX");
  if (found == values_.end()) return {};
  constexpr double decimetre = 0.1;
  return whole_number(found->second).value_or(0) * decimetre;
}

}  // namespace drydock::emulate
