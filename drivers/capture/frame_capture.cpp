#include "drivers/capture/frame_capture.hpp"

#include <algorithm>
#include <utility>

#include "drivers/capture/foreign_content.hpp"
#include "drivers/wire/packed_content.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::capture {
namespace {

/// So much of a head is the same in all files of a program: `date`, `;$FI`, `Time`.
constexpr std::size_t begin_to_compare = 4;

}  // namespace

std::string left_out_text(const Tally& tally) {
  if (tally.left_out == 0) return {};
  return std::to_string(tally.left_out) + " frames of more than " +
         std::to_string(most_interfaces) + " interfaces left out";
}

std::string damage_text(const Tally& tally) {
  std::string left_out = left_out_text(tally);
  if (tally.damaged == 0) return left_out;
  std::string text = std::to_string(tally.damaged);
  text +=
      tally.damaged == 1 ? " line or block not understood: " : " lines or blocks not understood: ";
  for (std::size_t i = 0; i < tally.where.size(); ++i) {
    text.append(i == 0 ? "" : ", ").append(std::to_string(tally.where[i]));
  }
  if (tally.damaged > tally.where.size()) text += ", ...";
  return left_out.empty() ? text : text + "; " + left_out;
}

std::string unknown_format_text(std::string_view file, const FrameCapture& capture) {
  const std::string name(file);
  if (!capture.advice().empty()) return name + ": " + std::string(capture.advice());
  return name + ": no CAN capture of a known format; known are: " + format_names();
}

FrameCapture::FrameCapture(const Format* format)
    : named_(format),
      format_(format),
      reader_(format ? format->make() : nullptr),
      may_be_packed_(format != nullptr) {}

void FrameCapture::feed(Bytes block) {
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(at_));
  at_ = 0;
  if (unknown_) return;
  if (begin_.empty() && buffer_.empty() && Utf16Text::recognises(block)) utf16_.emplace();
  if (utf16_) block = utf16_->of(block);
  if (begin_.size() < begin_to_compare)
    begin_ += wire::as_text(block.first(std::min(block.size(), begin_to_compare - begin_.size())));
  const bool magic_was_short = buffer_.size() < longest_magic;
  buffer_.insert(buffer_.end(), block.begin(), block.end());
  const bool line_ended =
      std::ranges::any_of(block, [](std::uint8_t byte) { return byte == '\n' || byte == '\r'; });
  may_show_format_ = may_show_format_ || line_ended || magic_was_short;
}

void FrameCapture::finish() { finished_ = true; }

bool FrameCapture::begins_anew(Bytes head) const {
  if (utf16_ || Utf16Text::recognises(head)) return Utf16Text::recognises(head);
  const Format* own = named_ != nullptr ? named_ : recognise(head, true);
  if (own == nullptr || format_ == nullptr) return false;
  if (own->has_magic) return own->first_sign(head, 0, head.size(), true).has_value();
  if (own != format_) return true;
  if (begin_.size() < begin_to_compare || !wire::as_text(head).starts_with(begin_)) return false;
  const auto reader = own->make();
  const Scan first = reader->scan(head, true);
  if (first.kind != Scan::Kind::frame) return false;
  const auto reading = reader->read(head.first(first.size));
  return !reading.record && !reading.damaged;  // as the line of a table that names its columns
}

void FrameCapture::restart() {
  format_ = named_;
  reader_ = format_ != nullptr ? format_->make() : nullptr;
  may_be_packed_ = format_ != nullptr;
  buffer_.clear();
  begin_.clear();
  utf16_.reset();
  at_ = searched_ = 0;
  finished_ = may_show_format_ = more_in_unit_ = cut_ = false;
}

std::optional<Record> FrameCapture::next() {
  if (!know_format()) return std::nullopt;
  if (auto record = more_of_unit()) return record;
  while (at_ < buffer_.size()) {
    const Bytes bytes = rest();
    const Scan scan = reader_->scan(bytes, finished_);
    if (scan.kind == Scan::Kind::need_more) {
      if (finished_) {
        ++tally_.units;
        note_damage(bytes.size());
        at_ = buffer_.size();
      }
      break;
    }
    at_ += scan.size;
    if (scan.kind != Scan::Kind::frame) {
      tally_.bytes_skipped += scan.size;
      continue;
    }
    ++tally_.units;
    const Reading reading = reader_->read(bytes.first(scan.size));
    if (reading.damaged) note_damage(reading.record ? 0 : scan.size);
    if (!reading.record) continue;
    more_in_unit_ = true;
    if (gives(*reading.record)) return reading.record;
    if (auto record = more_of_unit()) return record;
  }
  if (finished_ && reader_->is_inside_block() && !std::exchange(cut_, true)) {
    ++tally_.units;
    note_damage(0);
  }
  return std::nullopt;
}

bool FrameCapture::know_format() {
  if (may_be_packed_) return is_not_packed();
  if (format_ || unknown_) return !unknown_;
  if (!finished_ && rest().size() < longest_magic) return false;
  if (!may_show_format_ && !finished_ && rest().size() < head_to_recognise) return false;
  may_show_format_ = false;
  format_ = recognise(rest(), finished_, searched_);
  if (format_) {
    reader_ = format_->make();
  } else if (finished_ || rest().size() >= head_to_recognise) {
    unknown_ = true;
    advice_ = foreign_content(rest());
  } else {
    searched_ = past_whole_lines(rest(), searched_);
  }
  return format_ != nullptr;
}

/// A format was named, and somebody may have packed the file since.
bool FrameCapture::is_not_packed() {
  if (!finished_ && rest().size() < wire::longest_packed_magic) return false;
  may_be_packed_ = false;
  advice_ = wire::packed_content(wire::as_text(rest()));
  unknown_ = !advice_.empty();
  return !unknown_;
}

std::optional<Record> FrameCapture::more_of_unit() {
  while (more_in_unit_) {
    auto record = reader_->more();
    more_in_unit_ = record.has_value();
    if (record && gives(*record)) return record;
  }
  return std::nullopt;
}

bool FrameCapture::gives(const Record& record) {
  if (!interfaces_.contains(record.interface)) {
    if (interfaces_.size() == most_interfaces) return ++tally_.left_out, false;
    interfaces_.emplace(record.interface);
  }
  ++tally_.frames;
  return true;
}

void FrameCapture::note_damage(std::size_t bytes) {
  ++tally_.damaged;
  tally_.bytes_skipped += bytes;
  if (tally_.where.size() < tally_.where.capacity()) tally_.where.push_back(tally_.units);
}

}  // namespace drydock::capture
