#include "drivers/recordings/mcap/reader.hpp"

#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>
#include <new>

#include "drivers/recordings/mcap/decoder.hpp"
#include "drivers/recordings/mcap/encoder.hpp"
#include "drivers/recordings/mcap/salvage.hpp"

namespace drydock::mcap {

namespace {

/// Opcode and length, at the start of every record.
struct Head {
  Opcode opcode;
  std::uint64_t length;
};

Head head_of(Bytes bytes) {
  Decoder fields(bytes);
  const auto opcode = static_cast<Opcode>(fields.number<std::uint8_t>());
  return {opcode, fields.number<std::uint64_t>()};
}

/// True for records between the data that a sequential reader does not need.
bool passed_over(Opcode opcode) {
  switch (opcode) {
    case Opcode::header:
    case Opcode::schema:
    case Opcode::channel:
    case Opcode::message:
    case Opcode::attachment:
    case Opcode::metadata:
    case Opcode::data_end: return false;
    default: return true;
  }
}

}  // namespace

void Reader::Free::operator()(ZSTD_DCtx_s* context) const { ZSTD_freeDCtx(context); }

Reader::Reader(std::unique_ptr<std::istream> file)
    : file_(std::move(file)), decompressor_(ZSTD_createDCtx()) {
  if (!decompressor_) throw std::bad_alloc();
  file_->seekg(0, std::ios::end);
  size_ = static_cast<std::uint64_t>(std::max<std::streamoff>(file_->tellg(), 0));
  file_->seekg(0);
}

void Reader::tell_damage() {
  damage_ = first_damage_;
  if (left_out_ > 0) {
    damage_ += fmt::format("; {} B left out", left_out_);
    if (places_ > 1) damage_ += fmt::format(" in {} places", places_);
  }
  if (!end_damage_.empty()) damage_ += (damage_.empty() ? "" : "; ") + end_damage_;
}

std::uint64_t Reader::fail(std::string_view what) {
  if (first_damage_.empty()) first_damage_ = fmt::format("byte {}: {}", position_, what);
  return 0;
}

std::optional<Record> Reader::damaged(std::string_view what) {
  end_damage_ = fmt::format("byte {}: {}", position_, what);
  ended_ = true;
  chunk_.clear();
  tell_damage();
  return {};
}

void Reader::note_loss() {
  if (!lost_ && places_ == 0) {
    definitions_ = definitions(*file_, size_);
    std::erase_if(definitions_, [](const Record& one) {  // those come at their own places
      return std::holds_alternative<Attachment>(one);
    });
    std::ranges::reverse(definitions_);
  }
  lost_ = true;
  tell_damage();
}

void Reader::note_sound(std::uint64_t end) {
  if (lost_) {
    left_out_ += position_ - sound_end_;
    ++places_;
    lost_ = false;
    tell_damage();
  }
  sound_end_ = end;
}

std::optional<Record> Reader::pass_over(std::uint64_t end) {
  search_from_ = std::max(search_from_, position_ + 1);
  note_loss();
  file_->clear();
  file_->seekg(static_cast<std::streamoff>(end));
  position_ = end;
  return {};
}

std::optional<Record> Reader::search_on(std::string_view what) {
  const auto chunk = find_chunk(*file_, std::max(search_from_, sound_end_ + 1), size_);
  if (!chunk) return damaged(what);
  fail(what);
  note_loss();
  file_->seekg(static_cast<std::streamoff>(*chunk));
  position_ = *chunk;
  return {};
}

std::vector<Record> Reader::summary() {
  const auto here = file_->tellg();
  auto found = definitions(*file_, size_);
  file_->clear();
  file_->seekg(here);
  return found;
}

bool Reader::read(Buffer& into, std::uint64_t size) {
  into.resize(static_cast<std::size_t>(size));
  file_->read(reinterpret_cast<char*>(into.data()), static_cast<std::streamsize>(size));
  return static_cast<std::uint64_t>(file_->gcount()) == size;
}

std::optional<Record> Reader::next() {
  if (!begun_) {
    begun_ = true;
    if (size_ < magic.size() || !read(content_, magic.size()) ||
        !std::equal(magic.begin(), magic.end(), content_.begin()))
      return damaged("not an MCAP file");
    position_ = sound_end_ = magic.size();
  }
  while (!ended_) {
    if (!definitions_.empty()) {
      auto record = std::move(definitions_.back());
      definitions_.pop_back();
      return record;
    }
    auto record = in_chunk_ < chunk_.size() ? next_in_chunk() : next_in_file();
    if (record && std::holds_alternative<DataEnd>(*record)) {
      ended_ = true;
      file_->seekg(static_cast<std::streamoff>(size_ - magic.size()));
      if (!read(content_, magic.size()) ||
          !std::equal(magic.begin(), magic.end(), content_.begin()))
        damaged("the file is cut behind here, in its summary");
    }
    if (record) return record;
  }
  return {};
}

std::optional<Record> Reader::next_in_file() {
  const std::uint64_t left = size_ - position_;
  if (left == 0) return search_on("the file ends without its summary");
  if (left < record_head || !read(content_, record_head)) return search_on("the file is cut here");
  const auto [opcode, length] = head_of(content_);
  if (length > left - record_head) return search_on("the file is cut here, inside a record");
  const std::uint64_t end = position_ + record_head + length;
  if (passed_over(opcode) && opcode != Opcode::chunk) {
    file_->seekg(static_cast<std::streamoff>(end));
    if (opcode <= Opcode::data_end) note_sound(end);
    position_ = end;
    return {};
  }
  if (length > largest_record) {
    fail(fmt::format("a record of {} bytes", length));
    return pass_over(end);
  }
  if (!read(content_, length)) return damaged("the file cannot be read on");
  if (opcode == Opcode::chunk) {
    const auto size = open_chunk(content_);
    if (size == 0) return pass_over(end);
    note_sound(position_ + record_head + size);
    position_ = sound_end_;
    file_->seekg(static_cast<std::streamoff>(position_));
    return {};
  }
  auto record = decode(opcode, content_);
  if (!record) {
    fail("a record's content is damaged");
    return pass_over(end);
  }
  note_sound(end);
  position_ = end;
  return record;
}

std::uint64_t Reader::open_chunk(Bytes content) {
  chunk_.clear();
  in_chunk_ = 0;
  Decoder fields(content);
  fields.number<std::uint64_t>();  // first and last time
  fields.number<std::uint64_t>();
  const auto size = fields.number<std::uint64_t>();
  const auto crc = fields.number<std::uint32_t>();
  const std::string compression = fields.text();
  const Bytes packed = fields.bytes(fields.number<std::uint64_t>());
  if (!fields.good()) return fail("a chunk's head is damaged");
  if (size > largest_record) return fail(fmt::format("a chunk of {} bytes", size));
  bool whole = true;
  if (compression == "zstd") {
    chunk_.resize(static_cast<std::size_t>(size));
    const std::size_t unpacked = ZSTD_decompressDCtx(decompressor_.get(), chunk_.data(),
                                                     chunk_.size(), packed.data(), packed.size());
    whole = ZSTD_isError(unpacked) == 0;
    chunk_.resize(whole ? unpacked : 0);
  } else if (compression.empty()) {
    chunk_.assign(packed.begin(), packed.end());
  } else {
    return fail(fmt::format("a chunk packed with \"{}\", known: zstd, none", compression));
  }
  if (!whole || chunk_.size() != size || (crc != 0 && crc32(chunk_) != crc)) {
    chunk_.clear();
    return fail("a chunk's content is not what its checksum says");
  }
  return content.size() - fields.rest().size();
}

std::optional<Record> Reader::next_in_chunk() {
  const Bytes rest = Bytes(chunk_).subspan(in_chunk_);
  const auto [opcode, length] = head_of(rest.first(std::min(rest.size(), record_head)));
  if (rest.size() < record_head || length > rest.size() - record_head) {
    fail("a chunk ends inside a record");
    chunk_.clear();
    tell_damage();
    return {};
  }
  in_chunk_ += record_head + static_cast<std::size_t>(length);
  if (opcode == Opcode::chunk) {  // its messages are nobody's: MCAP allows none here
    fail("a chunk inside a chunk");
    tell_damage();
  }
  if (passed_over(opcode)) return {};
  auto record = decode(opcode, rest.subspan(record_head, static_cast<std::size_t>(length)));
  if (!record) {
    fail("a record inside a chunk is damaged");
    tell_damage();
  }
  return record;
}

}  // namespace drydock::mcap
