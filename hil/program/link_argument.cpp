#include "hil/program/link_argument.hpp"

#include <fmt/format.h>

#include "drivers/link/uri.hpp"
#include "drivers/probe/typed_link.hpp"
#include "drivers/text/printable.hpp"
#include "hil/program/load_rig.hpp"
#include "rig_config/nearest_file.hpp"

namespace drydock::program {
namespace {

[[noreturn]] void refuse_link(const std::string& command, const std::string& why) {
  fmt::print(stderr, "{}: {}\n", command, text::printable(why));
  throw BadRig{};
}

/// A line whose rate is searched needs none here.
std::string with_baud(std::string uri) {
  if (uri.starts_with("serial:") && uri.find("baud=") == std::string::npos)
    uri += uri.find('?') == std::string::npos ? "?baud=auto" : "&baud=auto";
  return uri;
}

}  // namespace

void must_name_link(const std::string& command, const std::string& word) {
  const auto typed = probe::typed_link(word);
  if (const auto why = probe::path_trouble(typed); !why.empty())
    refuse_link(command, why + rig_config::nearest_file(word));
  if (const auto uri = link::parse_uri(with_baud(typed)); !uri)
    refuse_link(command, uri.error().message);
}

}  // namespace drydock::program
