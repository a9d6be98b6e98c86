#include "drivers/probe/setting_search.hpp"

#include <algorithm>

namespace drydock::probe {
namespace {

using survey::Confidence;

/// A port with parity passes nothing of a line with the other parity: silence there is a reason to
/// leave, once it lasts longer than the line's own.
bool stays_silent(const Attempt& attempt, link::Stamp now) {
  constexpr double margin = 1.5;
  if (attempt.hearing.eight.bytes() > 0 || !attempt.usual_silence) return false;
  const auto silent = now - attempt.since;
  return silent > patience(attempt.setting) && silent > margin * *attempt.usual_silence;
}

std::optional<std::chrono::nanoseconds> longest_silence(
    const std::vector<std::unique_ptr<Attempt>>& attempts) {
  std::optional<std::chrono::nanoseconds> longest;
  for (const auto& attempt : attempts)
    if (attempt->hearing.eight.bytes() > 0)
      longest =
          std::max(longest.value_or(std::chrono::nanoseconds{}), attempt->hearing.longest_silence);
  return longest;
}

}  // namespace

bool Attempt::hear(wire::Bytes bytes, link::Stamp at, bool seven_too) {
  if (!bytes.empty()) hearing.feed(bytes, at, seven_too && setting.parity == 'N');
  hearing.pause(at);
  if (!bytes.empty()) return false;
  return hearing.settled() ||
         (may_leave && (hearing.hopeless(at, since, patience(setting)) || stays_silent(*this, at)));
}

const survey::ByteSurvey& Attempt::survey() const {
  const auto as = heard_as();
  if (as.bits == setting.bits) return hearing.eight;
  return as.parity == 'O' ? hearing.odd : hearing.even;
}

LineSetting Attempt::heard_as() const {
  const Confidence eight = hearing.eight.best().confidence, even = hearing.even.best().confidence,
                   odd = hearing.odd.best().confidence;
  if (odd > std::max(eight, even)) return {setting.baud, 'O', 7};
  if (even > eight) return {setting.baud, 'E', 7};
  return setting;
}

std::vector<std::unique_ptr<Attempt>> search_settings(const SettingSearch& search) {
  std::vector<std::unique_ptr<Attempt>> attempts;
  bool over = false;
  std::optional<std::chrono::nanoseconds> usual_silence;
  const auto listen = [&](const LineSetting& setting) -> std::unique_ptr<Attempt> {
    auto attempt = search.make(setting);
    attempt->usual_silence = usual_silence;
    const Listened how = search.listen(*attempt);
    over = how == Listened::last || (how == Listened::refused && attempts.empty()) ||
           attempt->hearing.settled();
    return how == Listened::refused ? nullptr : std::move(attempt);
  };
  const auto listen_with_each = [&](const std::vector<LineSetting>& settings) {
    for (std::size_t i = 0; i < settings.size() && !over; ++i)
      if (auto attempt = listen(settings[i])) attempts.push_back(std::move(attempt));
  };
  listen_with_each(search.plain);
  for (auto& attempt : attempts) {
    if (over || !attempt->hearing.slight()) continue;
    if (auto again = listen(attempt->setting)) attempt = std::move(again);
  }
  usual_silence = longest_silence(attempts);
  listen_with_each(search.with_parity);
  std::ranges::stable_sort(attempts, {}, [](const auto& a) { return a->hearing.confidence(); });
  return attempts;
}

}  // namespace drydock::probe
