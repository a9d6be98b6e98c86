#include "drivers/capture/capture_file.hpp"

#include <cstring>
#include <utility>

namespace drydock::capture {

CaptureFile::CaptureFile(const std::string& file, std::string_view format, std::string interface)
    : file_(file),
      interface_(std::move(interface)),
      blocks_(file),
      frames_(format.empty() ? nullptr : find_format(format)) {}

std::optional<Record> CaptureFile::next() {
  for (;;) {
    while (auto record = frames_.next()) {
      if (record->time) record->time = times_.of(record->interface, *record->time);
      if (interface_.empty() || record->interface == interface_) return record;
    }
    if (at_end_) return std::nullopt;
    const wire::Bytes block = blocks_.read();
    at_end_ = block.empty() || frames_.unknown();
    if (at_end_) {
      frames_.finish();
    } else {
      frames_.feed(block);
    }
  }
}

std::string CaptureFile::trouble() const {
  if (blocks_.error() != 0) {
    return "cannot read " + file_ + ": " + std::strerror(blocks_.error());
  }
  return frames_.unknown() ? unknown_format_text(file_, frames_) : std::string();
}

}  // namespace drydock::capture
