#include "drivers/probe/probe.hpp"

#include <fmt/format.h>

#include <boost/asio/error.hpp>

#include "drivers/doctor/holders.hpp"
#include "drivers/link/clock.hpp"
#include "drivers/probe/probe_bus.hpp"
#include "drivers/probe/probe_recording.hpp"
#include "drivers/probe/typed_link.hpp"
#include "drivers/terminal/exit_codes.hpp"

namespace drydock::probe {
namespace {

using link::Carries;
using link::Stamp;

/// Parses the URI. If the rate is missing it puts one in: the probe searches for the rate.
boost::system::result<link::Uri, link::UriError> parse_without_baud(const std::string& text) {
  const bool missing = text.starts_with("serial:") && text.find("baud=") == std::string::npos;
  if (!missing) return link::parse_uri(text);
  return link::parse_uri(with_key(text, "baud", "9600"));
}

std::string why_no_link(const std::string& text, const link::UriError& error) {
  const auto trouble = path_trouble(text);
  return trouble.empty() ? error.message : trouble;
}

/// Other programs that have the port open, in words: each byte goes to only one of them.
std::string others_at(const link::Uri& uri) {
  const bool pty = uri.scheme == link::Scheme::pty || uri.scheme == link::Scheme::can_auto;
  if (!pty && uri.scheme != link::Scheme::serial) return {};
  return doctor::in_words(doctor::holders_of("/", pty ? link::pty_path(uri.target) : uri.target));
}

bool search(const ProbeOptions& options, const link::Uri& uri, std::FILE* err,
            ProbeReport& report) {
  if (uri.recorded()) return read_recording(uri, options, report);
  Ear ear;
  Progress progress(err);
  const Stamp start = link::steady_now();
  const LineSearch wanted{report.link, start + measurement::from_seconds(options.duration_s),
                          options.ask, options.descriptions};
  const bool opened = uri.carries() == Carries::bytes ? search_line(wanted, ear, progress, report)
                                                      : search_bus(wanted, ear, progress, report);
  report.listened_s = measurement::seconds(link::steady_now() - start);
  report.interrupted = ear.interrupted();
  if (opened) report.shared_with = others_at(uri);
  if (uri.scheme == link::Scheme::pty && opened)
    report.notes.push_back("a pty has no baud rate: any will do");
  return opened;
}

/// Adds the most frequent cause of silence or noise.
void note_nothing(const link::Uri& uri, ProbeReport& report) {
  if (uri.recorded() || uri.carries() != Carries::bytes ||
      report.confidence() != survey::Confidence::nothing)
    return;
  std::uint64_t bytes = 0;
  for (const auto& attempt : report.attempts) bytes += attempt.bytes;
  if (report.attempts.empty()) return;
  if (bytes == 0)
    report.notes.emplace_back(
        "silence: no power, receive and transmit exchanged, or a sensor that waits to be asked "
        "(--ask)");
  else if (uri.scheme == link::Scheme::serial)
    report.notes.emplace_back(
        "bytes, but no protocol that we know: a rate not tried, RS-422 with A and B exchanged, or "
        "another protocol");
  else
    report.notes.emplace_back("bytes, but no protocol that we know");
}

}  // namespace

ProbeReport find_sensors(const std::string& link, double duration_s) {
  ProbeReport report;
  report.link = typed_link(link);
  ProbeOptions options;
  options.link = link;
  options.duration_s = duration_s;
  const auto uri = parse_without_baud(report.link);
  if (!uri) {
    report.notes.push_back(why_no_link(report.link, uri.error()));
  } else if (search(options, *uri, stderr, report)) {
    note_nothing(*uri, report);
  }
  return report;
}

int probe(const ProbeOptions& options, std::FILE* out, std::FILE* err) {
  ProbeReport report;
  report.link = typed_link(options.link);
  const auto uri = parse_without_baud(report.link);
  if (!uri) {
    fmt::print(err, "probe: {}\n", why_no_link(report.link, uri.error()));
    return terminal::exit_usage;
  }
  if (!search(options, *uri, err, report)) {
    report.opened = false;
    fmt::print(err, "probe: {}\n", problems_of(report).front());
    if (options.json) print_json(report, out);
    return terminal::exit_failed;
  }
  note_nothing(*uri, report);
  if (options.json) {
    print_json(report, out);
  } else {
    print_text(report, out);
  }
  return terminal::exit_of(problems_of(report).empty());
}

}  // namespace drydock::probe
