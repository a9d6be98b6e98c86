#include "drivers/wire/pgn_table/decode.hpp"

#include <algorithm>
#include <utility>

#include "drivers/wire/pgn_table/bits.hpp"
#include "drivers/wire/pgn_table/content.hpp"

namespace drydock::wire::pgn_table {
namespace {

constexpr std::size_t most_repeats = 2000;  ///< more than bytes of any message

/// Goes through a message from field to field.
class Walk {
 public:
  Walk(const Catalogue& catalogue, const Definition& definition, Bytes message)
      : catalogue_(catalogue),
        definition_(definition),
        message_(message),
        raw_(definition.fields.size()) {}

  Message run() {
    Message m{&definition_, {}, false};
    for (std::size_t i = 0; i < definition_.fields.size();) {
      const std::size_t set = set_that_begins_at(i);
      if (set == none) {
        take(i++, m.record);
        continue;
      }
      repeat(definition_.sets[set], m.record.sets[set]);
      i += definition_.sets[set].size;
    }
    m.cut_short = cut_short_;
    return m;
  }

 private:
  std::size_t set_that_begins_at(std::size_t i) const {
    for (std::size_t set = 0; set < definition_.sets.size(); ++set)
      if (definition_.sets[set].size > 0 && definition_.sets[set].first == i) return set;
    return none;
  }

  std::size_t left() const { return 8 * message_.size() - at_; }

  void repeat(const RepeatedFields& fields, std::vector<Record>& records) {
    const std::size_t wanted =
        fields.count == none ? most_repeats
                             : std::min<std::size_t>(raw_[fields.count].value_or(0), most_repeats);
    for (std::size_t n = 0; n < wanted && left() > 0; ++n) {
      const std::size_t begun_at = at_;
      Record& record = records.emplace_back();
      for (std::size_t i = 0; i < fields.size; ++i) take(fields.first + i, record);
      if (at_ == begun_at) return;
    }
    cut_short_ = cut_short_ || (fields.count != none && records.size() < wanted);
  }

  void take(std::size_t i, Record& record) {
    const Field& field = definition_.fields[i];
    if (field.if_proprietary && !is_proprietary(parameter_pgn_)) return;
    if (left() == 0) cut_short_ = true;
    const Field* const is_like = like(field);
    const std::size_t bits = bits_of(field, is_like);
    const Bytes there = message_.subspan(std::min(at_ / 8, message_.size()));
    const Slice slice{there, at_ % 8, std::min(bits, left())};
    Extent extent = is_like ? read(catalogue_.table(), *is_like, slice,
                                   is_like == &field ? other_raw(field) : std::nullopt)
                            : read_bytes(slice);
    if (bits != all_left && slice.bits < bits) cut_short_ = true;
    remember(i, field, extent);
    at_ += std::min(length_of(field, bits, extent), left());
    if (field.kind == FieldKind::left_out) return;
    extent.value.field = &field;
    if (field.kind == FieldKind::key) name_key(extent);
    if (field.kind == FieldKind::parameter) name_parameter(extent);
    record.values.push_back(std::move(extent.value));
  }

  static std::size_t length_of(const Field& field, std::size_t bits, const Extent& extent) {
    if (bits == all_left) return extent.bits;
    return is_whole(field) ? (bits + 7) / 8 * 8 : bits;
  }

  /// A keyed value or the value of a parameter fills whole bytes.
  static bool is_whole(const Field& field) {
    return field.kind == FieldKind::key_value || field.kind == FieldKind::parameter_value;
  }

  /// Of the message, or among its parameters.
  bool is_manufacturer(const Field& field) const {
    const bool is_parameter = field.kind == FieldKind::parameter_value && parameter_ != nullptr;
    return (is_parameter ? *parameter_ : field).id == "manufacturerCode";
  }

  /// The field that says how to read this one; null: nobody knows.
  const Field* like(const Field& field) const {
    if (field.kind == FieldKind::key_value) return keyed_ ? &keyed_->field : nullptr;
    if (field.kind == FieldKind::parameter_value)
      return parameter_ && !is_whole(*parameter_) ? parameter_ : nullptr;
    return &field;
  }

  std::size_t bits_of(const Field& field, const Field* is_like) const {
    if (field.kind == FieldKind::key_value && key_bytes_) return 8 * *key_bytes_;
    if (field.kind == FieldKind::bytes && field.other != none)
      return static_cast<std::size_t>(
          std::min<std::uint64_t>(raw_[field.other].value_or(0), left()));
    if (!is_like) return all_left;
    return is_like->bits > 0 ? is_like->bits : all_left;
  }

  /// The field on which an indirect lookup depends may come behind it.
  std::optional<std::uint64_t> other_raw(const Field& field) const {
    if (field.kind != FieldKind::indirect_lookup) return {};
    const Field& other = definition_.fields[field.other];
    return bits_at(message_, other.bit_offset, other.bits);
  }

  void remember(std::size_t i, const Field& field, const Extent& extent) {
    raw_[i] = extent.raw;
    if (field.kind == FieldKind::key)
      keyed_ = extent.raw ? find_keyed(field, *extent.raw) : nullptr;
    if (field.kind == FieldKind::key_length) key_bytes_ = extent.raw;
    if (field.id == "pgn" && extent.raw) parameter_pgn_ = static_cast<std::uint32_t>(*extent.raw);
    if (is_manufacturer(field)) manufacturer_ = extent.raw;
    if (field.kind == FieldKind::parameter)
      parameter_ =
          extent.raw ? catalogue_.field(parameter_pgn_, *extent.raw, manufacturer_) : nullptr;
  }

  const KeyedField* find_keyed(const Field& field, std::uint64_t raw) const {
    const auto& keys = catalogue_.table().keyed[field.lookup];
    const auto found = keys.find(raw);
    return found == keys.end() ? nullptr : &found->second;
  }

  void name_key(Extent& extent) const {
    extent.value.has_meaning = true;
    if (keyed_) extent.value.meaning = Name{keyed_->name};
  }

  void name_parameter(Extent& extent) const {
    extent.value.has_meaning = true;
    if (parameter_) extent.value.meaning = Name{parameter_->id};
  }

  const Catalogue& catalogue_;
  const Definition& definition_;
  Bytes message_;
  std::size_t at_ = 0;  ///< bit
  std::vector<std::optional<std::uint64_t>> raw_;
  const KeyedField* keyed_ = nullptr;
  std::optional<std::size_t> key_bytes_;
  std::uint32_t parameter_pgn_ = 0;
  std::optional<std::uint64_t> manufacturer_;
  const Field* parameter_ = nullptr;
  bool cut_short_ = false;
};

}  // namespace

Message decode(const Catalogue& catalogue, const Definition& definition, Bytes message) {
  return Walk(catalogue, definition, message).run();
}

}  // namespace drydock::wire::pgn_table
