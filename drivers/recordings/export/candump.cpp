#include "drivers/wire/can/candump.hpp"

#include "drivers/recordings/export/exporter.hpp"
#include "drivers/recordings/export/output_file.hpp"

namespace drydock::exporting {

namespace {

/// The format of `candump -L`: all buses in one log. Where it is asked for, with ` R` or ` T` at
/// the end as in `candump -x`; some readers refuse such lines.
class Candump final : public Exporter {
 public:
  Candump(const std::vector<RecordedLink>& links, const Target& to)
      : file_(to.path, to.overwrite), with_direction_(to.direction) {
    for (const auto& link : links) names_.push_back(link.name);
  }

  void on_frame(const RawFrame& raw, std::size_t link) override {
    std::array<std::uint8_t, wire::candump::longest_line> line;
    using enum wire::candump::Direction;
    const auto direction = !with_direction_                               ? unknown
                           : raw.direction == record::Direction::received ? received
                                                                          : transmitted;
    const auto size = wire::candump::encode(
        {raw.at.time_since_epoch(), names_[link], raw.frame, direction}, line);
    file_.write(std::span(line).first(size));
    ++written_;
  }
  void finish() override { file_.close(); }
  std::string error() const override { return file_.error(); }

 private:
  OutputFile file_;
  bool with_direction_;
  std::vector<std::string> names_;
};

}  // namespace

std::unique_ptr<Exporter> make_candump(const std::vector<RecordedLink>& links, const Target& to) {
  return std::make_unique<Candump>(links, to);
}

}  // namespace drydock::exporting
