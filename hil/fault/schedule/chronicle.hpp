#pragma once

#include <functional>
#include <vector>

#include "hil/fault/injector.hpp"

namespace drydock::fault {

/// A past or present fault with its times.
struct Episode {
  std::string device, words;
  Stamp since{};
  std::optional<Stamp> until;  ///< empty: still in force
};

/// Records when faults begin and end: for a terminal, a page, a report.
class Chronicle {
 public:
  static constexpr std::size_t most_kept = 1000;  ///< episodes; later ones are only counted

  /// Called for each fault that begins (`until` is empty) and each that ends.
  using OnChange = std::function<void(const Episode&)>;

  /// The injector must outlive the chronicle.
  Chronicle(const Injector& injector, Stamp start);

  void set_on_change(OnChange hook) { on_change_ = std::move(hook); }

  /// Records all changes up to `now`. Call it before and after a fault is set or cleared by hand,
  /// because that is an immediate change.
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
