#include "drivers/wire/can/candump.hpp"

#include "drivers/recordings/export/exporter.hpp"
#include "drivers/recordings/export/output_file.hpp"

namespace drydock::exporting {

namespace {

/// The format of `candump -L`: all buses in one log, with ` R` or ` T` at the end as in `candump
/// -x`.
class Candump final : public Exporter {
 public:
  Candump(const std::vector<RecordedLink>& links, const Target& to) : file_(to.path, to.overwrite) {
    for (const auto& link : links) names_.push_back(link.name);
  }

  void on_frame(const RawFrame& raw, std::size_t link) override {
    std::array<std::uint8_t, wire::candump::longest_line> line;
    const auto direction = raw.direction == record::Direction::received
                               ? wire::candump::Direction::received
                               : wire::candump::Direction::transmitted;
    const auto size = wire::candump::encode(
        {raw.at.time_since_epoch(), names_[link], raw.frame, direction}, line);
    file_.write(std::span(line).first(size));
    ++written_;
  }
  void finish() override { file_.close(); }
  std::string error() const override { return file_.error(); }

 private:
  OutputFile file_;
  std::vector<std::string> names_;
};

}  // namespace

std::unique_ptr<Exporter> make_candump(const std::vector<RecordedLink>& links, const Target& to) {
  return std::make_unique<Candump>(links, to);
}

}  // namespace drydock::exporting
