#include "drivers/monitor/hints/shared_ports.hpp"

#include <chrono>

#include "drivers/doctor/holders.hpp"
#include "drivers/link/clock.hpp"
#include "drivers/link/link.hpp"

namespace drydock::monitor {
namespace {

constexpr std::chrono::seconds look_period{2};

std::string look_for(const std::string& text) {
  const auto uri = link::parse_uri(text);
  if (!uri) return {};
  const bool pty = uri->scheme == link::Scheme::pty || uri->scheme == link::Scheme::can_auto;
  if (!pty && uri->scheme != link::Scheme::serial) return {};
  return doctor::in_words(doctor::holders_of("/", pty ? link::pty_path(uri->target) : uri->target));
}

}  // namespace

std::string SharedPorts::others(const std::string& link) {
  auto& look = looks_[link];
  const auto now = link::steady_now();
  if (look.at == measurement::Stamp{} || now - look.at > look_period) look = {now, look_for(link)};
  return look.found;
}

}  // namespace drydock::monitor
