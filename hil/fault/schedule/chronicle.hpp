#pragma once

#include <functional>
#include <vector>

#include "hil/fault/injector.hpp"

namespace drydock::fault {

/// A fault as it was: from when to when.
struct Episode {
  std::string device, words;
  Stamp since{};
  std::optional<Stamp> until;  ///< empty: in force still
};

/// Which faults set in and cleared, when, as time goes on: for a terminal, a page, a report.
class Chronicle {
 public:
  static constexpr std::size_t most_kept = 1000;  ///< episodes; the first ones, then a count

  /// Hears each fault that sets in (until is empty) and each that clears.
  using OnChange = std::function<void(const Episode&)>;

  /// The injector outlives it.
  Chronicle(const Injector& injector, Stamp start);

  void set_on_change(OnChange hook) { on_change_ = std::move(hook); }

  /// Takes in all changes up to `now`. To be called before and after a fault is set or cleared by
  /// hand, which is a change at once.
  void follow(Stamp now);

  std::optional<Stamp> deadline() const { return injector_.next_change(followed_); }

  const std::vector<Episode>& episodes() const { return episodes_; }
  std::uint64_t not_kept() const { return not_kept_; }

 private:
  void compare(Stamp at);
  void keep(const Episode& episode);

  const Injector& injector_;
  OnChange on_change_ = [](const Episode&) {};
  Stamp followed_;
  std::vector<FaultNow> in_force_;
  std::vector<Episode> episodes_;
  std::uint64_t not_kept_ = 0;
};

}  // namespace drydock::fault
