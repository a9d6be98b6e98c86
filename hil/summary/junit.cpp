#include "hil/summary/junit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/text/printable.hpp"

namespace drydock::summary {
namespace {

/// Text inside an attribute. A character that XML 1.0 does not allow, or that is no UTF-8, becomes
/// a question mark.
std::string attribute(std::string_view text) {
  std::string out;
  for (const char c : text::printable(text)) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  }
  return out;
}

std::string suite(const std::string& rig, std::size_t tests, std::size_t failures,
                  std::size_t errors, double time_s, const std::string& inside) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites tests=\"{0}\" failures=\"{1}\" errors=\"{2}\" time=\"{3:.3f}\">\n"
      "  <testsuite name=\"{4}\" tests=\"{0}\" failures=\"{1}\" errors=\"{2}\" skipped=\"0\" "
      "time=\"{3:.3f}\">\n"
      "{5}  </testsuite>\n</testsuites>\n",
      tests, failures, errors, time_s, attribute(rig), inside);
}

std::string testcase(const std::string& rig, const Verdict& v, const std::string& rig_file) {
  std::string out =
      fmt::format("    <testcase classname=\"{}.{}\" name=\"{}: {}\" time=\"0\"", attribute(rig),
                  attribute(v.subject), attribute(v.what), attribute(v.expected));
  if (v.line > 0) out += fmt::format(" file=\"{}\" line=\"{}\"", attribute(rig_file), v.line);
  if (v.passed)
    return out + fmt::format(">\n      <system-out>{}</system-out>\n    </testcase>\n",
                             attribute(v.measured));
  return out + fmt::format(
                   ">\n      <failure type=\"expectation\" message=\"{}, expected {}\"/>\n"
                   "    </testcase>\n",
                   attribute(v.measured), attribute(v.expected));
}

}  // namespace

std::string to_junit(const Summary& s, const std::string& rig_file) {
  std::string inside = fmt::format(
      "    <properties>\n      <property name=\"mode\" value=\"{}\"/>\n"
      "      <property name=\"seed\" value=\"{}\"/>\n"
      "      <property name=\"duration_s\" value=\"{:.3f}\"/>\n    </properties>\n",
      attribute(s.mode), s.seed, s.duration_s);
  for (const Verdict& verdict : s.verdicts) inside += testcase(s.rig, verdict, rig_file);
  const auto failures = std::ranges::count(s.verdicts, false, &Verdict::passed);
  return suite(s.rig, s.verdicts.size(), static_cast<std::size_t>(failures), 0, s.wall_s, inside);
}

std::string junit_of_failure(const std::string& rig, const std::string& rig_file,
                             const std::string& why) {
  return suite(rig, 1, 0, 1, 0,
               fmt::format("    <testcase classname=\"{}\" name=\"the run begins\" time=\"0\" "
                           "file=\"{}\">\n      <error type=\"run\" message=\"{}\"/>\n"
                           "    </testcase>\n",
                           attribute(rig), attribute(rig_file), attribute(why)));
}

}  // namespace drydock::summary
