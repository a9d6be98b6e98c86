#include "drivers/wire/described/frame_codec.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "drivers/wire/described/codec.hpp"

namespace drydock::wire::described {
namespace {

std::size_t most_signals_of(const FramePlan& plan) {
  std::size_t most = 0;
  for (const FrameLayout& one : plan.frames) most = std::max(most, one.plan.size());
  return most;
}

/// SAE J1939-71: integers of whole bytes whose highest byte is FBh or more are no numbers.
bool says_no_number(const dbc::Layout& layout, std::uint64_t raw) {
  return layout.number == dbc::Number::unsigned_integer && layout.bits % 8 == 0 &&
         layout.bits <= 32 && raw >> (layout.bits - 8) >= 0xFB;
}

std::uint64_t lowest(unsigned bits) {
  return bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
}

/// The number on the wire, before factor and offset.
double raw_number(const Field& field, const dbc::Layout& layout, std::uint64_t raw) {
  if (field.bits != 0) return static_cast<double>(raw >> field.first_bit & lowest(field.bits));
  if (layout.number == dbc::Number::float32)
    return std::bit_cast<float>(static_cast<std::uint32_t>(raw));
  if (layout.number == dbc::Number::float64) return std::bit_cast<double>(raw);
  if (layout.number == dbc::Number::unsigned_integer) return static_cast<double>(raw);
  return static_cast<double>(static_cast<std::int64_t>(raw));
}

/// The nearest raw value that the signal, or the bits of it, can hold.
std::uint64_t raw_of(const Field& field, const dbc::Layout& layout, double number, bool j1939) {
  if (layout.number == dbc::Number::float32)
    return std::bit_cast<std::uint32_t>(static_cast<float>(number));
  if (layout.number == dbc::Number::float64) return std::bit_cast<std::uint64_t>(number);
  const unsigned bits = field.bits != 0 ? field.bits : layout.bits;
  const bool is_signed = layout.number == dbc::Number::signed_integer && field.bits == 0;
  const double end = std::ldexp(1.0, static_cast<int>(is_signed ? bits - 1 : bits));
  double top = bits > 53 ? std::nextafter(end, 0) : end - 1;
  if (j1939 && field.bits == 0 && says_no_number(layout, lowest(bits)))
    top = std::ldexp(0xFB, static_cast<int>(bits) - 8) - 1;
  const double low = is_signed ? -end : 0;
  const double whole = std::clamp(std::round(within_turn(field, number, low, top)), low, top);
  return whole < 0 ? static_cast<std::uint64_t>(static_cast<std::int64_t>(whole))
                   : static_cast<std::uint64_t>(whole);
}

void take_field(const Field& field, double number, std::size_t i, Record& record) {
  Value& value = record.values[i];
  if (field.validity) take_validity(field, {Value::State::number, number}, {}, record);
  if (std::isnan(number)) return;  // it says: no value
  take_number(field, number, value);
  if (value.state == Value::State::malformed) record.malformed |= 1u << i;
}

}  // namespace

FrameDecoder::FrameDecoder(DescriptionPtr description)
    : description_(std::move(description)), values_(most_signals_of(*description_->frames)) {}

Taken FrameDecoder::take(const CanFrame& frame, Record& record) {
  const FramePlan& plan = *description_->frames;
  const auto place = plan.catalogue.find(frame);
  if (!place) return Taken::other;
  place_ = *place;
  const FrameLayout& layout = plan.frames[place_];
  const bool intact = frame.size >= layout.message.size &&
                      (!layout.checksum || dbc::is_intact(*layout.checksum, frame));
  counters_.bytes_in += frame.size;
  (intact ? counters_.bytes_good : counters_.bytes_skipped) += frame.size;
  ++(intact ? counters_.frames : counters_.bad_checksums);
  if (!intact) return Taken::damaged;
  layout.plan.decode(frame.payload(), values_);
  record.begin(description_->plan, description_->plan.messages[place_]);
  read_fields(layout, record);
  return Taken::message;
}

void FrameDecoder::read_fields(const FrameLayout& layout, Record& record) const {
  const auto fields = record.plan->fields_of(*record.message);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    record.values[i] = {};
    const dbc::Value& value = values_[fields[i].at];
    if (!value.present) continue;
    record.present |= 1u << i;
    const dbc::Layout& bits = layout.message.signals[fields[i].at].layout;
    if (layout.is_j1939() && fields[i].bits == 0 && says_no_number(bits, value.raw)) continue;
    take_field(fields[i], raw_number(fields[i], bits, value.raw), i, record);
  }
  divide(record);
}

std::optional<FrameDecoder::Message> FrameDecoder::receive(const CanFrame& frame) {
  std::optional<Message> message(std::in_place);
  if (take(frame, std::get<Record>(*message)) != Taken::message) message.reset();
  return message;
}

std::optional<unsigned> FrameDecoder::counter() const {
  const auto& counter = description_->frames->frames[place_].counter;
  if (!counter || !values_[counter->signal].present) return {};
  return static_cast<unsigned>(values_[counter->signal].raw);
}

FrameEncoder::FrameEncoder(const Description& description, std::uint8_t address)
    : description_(description),
      address_(address),
      values_(most_signals_of(*description.frames)),
      counts_(description.frames->frames.size()) {}

std::uint32_t FrameEncoder::id_of(const FrameLayout& layout) const {
  const std::uint32_t id = layout.message.id;
  const bool any = layout.is_j1939() && (id & 0xFF) == dbc::any_source;
  return any && address_ != 0 ? (id & ~0xFFu) | address_ : id;
}

bool FrameEncoder::put_fields(const FrameLayout& layout, const Message& message,
                              const Readings& readings) {
  const auto fields = description_.plan.fields_of(message);
  for (const Field& field : fields) {
    const dbc::Layout& bits = layout.message.signals[field.at].layout;
    const auto number = wire_number(fields, field, readings);
    std::uint64_t& raw = values_[field.at].raw;
    if (!number && bits.is_float())
      raw = raw_of(field, bits, std::nan(""), false);
    else if (!number && layout.is_j1939() && says_no_number(bits, lowest(bits.bits)))
      raw = lowest(bits.bits);
    else if (!number && says_nothing_holds(fields, readings))
      continue;
    else if (!number)
      return false;
    else if (field.bits == 0)
      raw = raw_of(field, bits, *number, layout.is_j1939());
    else
      raw = (raw & ~(lowest(field.bits) << field.first_bit)) | raw_of(field, bits, *number, false)
                                                                   << field.first_bit;
  }
  return true;
}

std::optional<CanFrame> FrameEncoder::encode(std::size_t place, const Selection& selection,
                                             const Readings& readings) {
  const FrameLayout& layout = description_.frames->frames[place];
  std::ranges::fill(values_, dbc::Value{});
  if (!put_fields(layout, description_.plan.messages[place], readings)) return {};
  for (const auto& [signal, raw] : selection) values_[signal].raw = static_cast<std::uint64_t>(raw);
  if (layout.counter)
    values_[layout.counter->signal].raw = counts_[place] % layout.counter->modulus;
  ++counts_[place];
  CanFrame frame;
  frame.id = id_of(layout);
  frame.extended = layout.message.extended;
  frame.fd = layout.message.format == dbc::FrameFormat::fd;
  frame.size = static_cast<std::uint8_t>(layout.message.size);
  if (layout.is_j1939()) frame.data.fill(0xFF);  // bits that no signal has: not available
  layout.plan.encode(std::span(values_).first(layout.plan.size()),
                     std::span(frame.data).first(frame.size));
  if (layout.checksum) dbc::protect(*layout.checksum, frame);
  return frame;
}

}  // namespace drydock::wire::described
