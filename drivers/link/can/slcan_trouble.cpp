#include "drivers/link/can/slcan_trouble.hpp"

#include <algorithm>
#include <array>

#include "drivers/link/error_words.hpp"
#include "drivers/wire/can/slcan.hpp"

namespace drydock::link {
namespace {

constexpr std::array<std::string_view, 11> opening_commands{"S0", "S1", "S2", "S3", "S4", "S5",
                                                            "S6", "S7", "S8", "L",  "O"};
constexpr int rates = 9;
constexpr int unanswered = 100;

/// The value is the place of the command, from 1, and `unanswered` more if it was not answered.
class SlcanCategory final : public ErrorWords {
 public:
  const char* name() const noexcept override { return "slcan"; }
  std::string message(int value) const override {
    const std::string command(
        opening_commands.at(static_cast<std::size_t>(value % unanswered - 1)));
    if (value > unanswered)
      return "no answer to " + command + " from the slcan adapter: unplug it and plug it in again";
    return "the slcan adapter refused " + command + reason(command);
  }

 private:
  static std::string reason(const std::string& command) {
    if (const auto rate = wire::slcan::bit_rate_of(command))
      return " (" + std::to_string(*rate) + " bit/s): it lacks this rate, choose another bitrate";
    if (command == "L") return ": it cannot only listen, so it was not opened; use one that can";
    return " (open the channel): unplug it and plug it in again";
  }
};

const SlcanCategory& slcan_category() {
  static const SlcanCategory only;
  return only;
}

int place_of(std::string_view command) {
  return 1 +
         static_cast<int>(std::ranges::find(opening_commands, command) - opening_commands.begin());
}

}  // namespace

ErrorCode slcan_refused(std::string_view command) { return {place_of(command), slcan_category()}; }

ErrorCode slcan_unanswered(std::string_view command) {
  return {unanswered + place_of(command), slcan_category()};
}

bool is_refused_rate(const ErrorCode& error) {
  return error.category() == slcan_category() && error.value() <= rates;
}

}  // namespace drydock::link
