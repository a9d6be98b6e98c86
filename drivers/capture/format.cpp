#include "drivers/capture/format.hpp"

#include <algorithm>
#include <array>

#include "drivers/capture/formats/actisense_ascii.hpp"
#include "drivers/capture/formats/busmaster.hpp"
#include "drivers/capture/formats/canboat_plain.hpp"
#include "drivers/capture/formats/candump_log.hpp"
#include "drivers/capture/formats/candump_screen.hpp"
#include "drivers/capture/formats/crtd.hpp"
#include "drivers/capture/formats/ikonvert.hpp"
#include "drivers/capture/formats/ixxat.hpp"
#include "drivers/capture/formats/kvaser.hpp"
#include "drivers/capture/formats/pcan_trc.hpp"
#include "drivers/capture/formats/pcap.hpp"
#include "drivers/capture/formats/pcapng.hpp"
#include "drivers/capture/formats/python_can.hpp"
#include "drivers/capture/formats/savvycan.hpp"
#include "drivers/capture/formats/vector_asc.hpp"
#include "drivers/capture/formats/vector_blf.hpp"
#include "drivers/capture/formats/yacht_devices.hpp"

namespace drydock::capture {

namespace {

template <class R>
std::unique_ptr<Reader> make() {
  return std::make_unique<R>();
}

template <class R>
std::optional<std::size_t> magic(Bytes head, std::size_t, std::size_t before, bool) {
  return before > 0 && R::recognises(head) ? std::optional<std::size_t>(0) : std::nullopt;
}

template <class R>
std::optional<std::size_t> first_good_line(Bytes head, std::size_t from, std::size_t before,
                                           bool is_whole_file) {
  for (std::size_t at = from; at < before;) {
    const Scan scan = scan_line(head.subspan(at), is_whole_file);
    if (scan.kind == Scan::Kind::need_more) break;
    const std::string_view line = text_of(head.subspan(at, scan.size));
    if (scan.kind == Scan::Kind::frame && !line.empty() && R::recognises(line)) return at;
    at += scan.size;
  }
  return std::nullopt;
}

template <class R>
constexpr Format binary_format() {
  return {R::name, make<R>, magic<R>, true};
}
template <class R>
constexpr Format text_format() {
  return {R::name, make<R>, first_good_line<R>, false};
}

// Formats with a magic come first: a binary file may look like lines from its first byte on.
constexpr std::array all{
    binary_format<Pcap>(),       binary_format<Pcapng>(),      binary_format<VectorBlf>(),
    text_format<CandumpLog>(),   text_format<CandumpScreen>(), text_format<VectorAsc>(),
    text_format<PcanTrc>(),      text_format<CanboatPlain>(),  text_format<ActisenseAscii>(),
    text_format<YachtDevices>(), text_format<Ikonvert>(),      text_format<SavvyCan>(),
    text_format<PythonCan>(),    text_format<Busmaster>(),     text_format<Crtd>(),
    text_format<Ixxat>(),        text_format<Kvaser>()};

}  // namespace

std::span<const Format> formats() { return all; }

const Format* find_format(std::string_view name) {
  const auto found = std::ranges::find(all, name, &Format::name);
  return found == all.end() ? nullptr : &*found;
}

std::string format_names() {
  std::string names;
  for (const Format& format : all) {
    names.append(names.empty() ? "" : ", ").append(format.name);
  }
  return names;
}

std::size_t past_whole_lines(Bytes head, std::size_t from) {
  while (from < head.size()) {
    const Scan scan = scan_line(head.subspan(from), false);
    if (scan.kind == Scan::Kind::need_more) break;
    from += scan.size;
  }
  return from;
}

const Format* recognise(Bytes head, bool is_whole_file, std::size_t from) {
  const Format* first = nullptr;
  std::size_t first_at = head.size();
  for (const Format& format : all) {
    const auto at = format.first_sign(head, from, first_at, is_whole_file);
    if (!at) continue;
    first = &format;
    first_at = *at;
  }
  return first;
}

}  // namespace drydock::capture
