#include "drivers/host/finding_lines.hpp"

#include <fmt/format.h>

#include "drivers/diagnosis/finding_words.hpp"

namespace drydock::host {

void FindingLines::on_finding(const diagnosis::Finding& finding) {
  const auto account = diagnosis::account_of(finding, rig_.devices.at(finding.device).name, start_);
  if (account.until_s)
    print_(fmt::format("{:.3f} s {}", *account.until_s, diagnosis::end_line_of(account)));
  else
    print_(fmt::format("{:.3f} s found: {}", account.found_s, diagnosis::line_of(account)));
}

void FindingLines::on_stall(Stamp from, Stamp to) {
  print_(fmt::format("{:.3f} s {}", measurement::seconds(to - start_),
                     stall_line(measurement::seconds(to - from))));
}

std::string stall_line(double for_s) {
  return fmt::format(
      "nothing was heard or asked for {:.1f} s: this program or the computer stood "
      "still, or the recording has a hole; no sensor is blamed for it",
      for_s);
}

}  // namespace drydock::host
