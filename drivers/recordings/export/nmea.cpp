#include <fmt/format.h>

#include "drivers/recordings/export/exporter.hpp"
#include "drivers/recordings/export/output_file.hpp"
#include "drivers/wire/nmea0183/nmea0183.hpp"

namespace drydock::exporting {

namespace {

constexpr std::int64_t ns_a_second = 1'000'000'000;

/// The valid NMEA 0183 sentences that the ports received, one `time sentence` on each line. The
/// time is that of the read in which the sentence ended.
class Nmea final : public Exporter {
 public:
  Nmea(const std::vector<RecordedLink>& links, const Target& to)
      : file_(to.path, to.overwrite), plain_(to.plain), framers_(links.size()) {}

  void on_bytes(const RawBytes& raw, std::size_t link) override {
    if (raw.direction != record::Direction::received) return;
    if (!framers_[link]) framers_[link] = std::make_unique<Framer>();
    framers_[link]->feed(raw.data, wire::Nmea0183::scan,
                         [&](wire::Bytes frame, std::size_t) { write(frame, raw.at); });
  }
  void finish() override { file_.close(); }
  std::string error() const override { return file_.error(); }

 private:
  using Framer = wire::Framer<wire::Nmea0183::max_frame>;

  void write(wire::Bytes frame, record::Stamp at) {
    while (!frame.empty() && (frame.back() == '\r' || frame.back() == '\n'))
      frame = frame.first(frame.size() - 1);
    const auto ns = at.time_since_epoch().count();
    if (!plain_) file_.write(fmt::format("{}.{:09} ", ns / ns_a_second, ns % ns_a_second));
    file_.write(frame);
    file_.write("\n");
    ++written_;
  }

  OutputFile file_;
  bool plain_;
  std::vector<std::unique_ptr<Framer>> framers_;
};

}  // namespace

std::unique_ptr<Exporter> make_nmea(const std::vector<RecordedLink>& links, const Target& to) {
  return std::make_unique<Nmea>(links, to);
}

}  // namespace drydock::exporting
