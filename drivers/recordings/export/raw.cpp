#include "drivers/recordings/export/exporter.hpp"
#include "drivers/recordings/export/output_file.hpp"

namespace drydock::exporting {

namespace {

/// `<link>.bin`: the bytes that a port received; `<link>.sent.bin`: the bytes that it sent.
class Raw final : public Exporter {
 public:
  Raw(const std::vector<RecordedLink>& links, const Target& to)
      : links_(links), folder_(to.path, to.overwrite) {}

  void on_bytes(const RawBytes& raw, std::size_t link) override {
    const bool sent = raw.direction == record::Direction::sent;
    folder_.file(links_[link].name + (sent ? ".sent.bin" : ".bin")).write(raw.data);
    ++written_;
  }
  void finish() override { folder_.close(); }
  std::string error() const override { return folder_.error(); }

 private:
  std::vector<RecordedLink> links_;
  OutputFolder folder_;
};

}  // namespace

std::unique_ptr<Exporter> make_raw(const std::vector<RecordedLink>& links, const Target& to) {
  return std::make_unique<Raw>(links, to);
}

}  // namespace drydock::exporting
