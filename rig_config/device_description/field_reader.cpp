#include "rig_config/device_description/field_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "rig_config/device_description/field_target.hpp"
#include "rig_config/device_description/field_validity.hpp"
#include "rig_config/device_description/units.hpp"
#include "rig_config/rules/explain.hpp"
#include "rig_config/toml/read_keys.hpp"

namespace drydock::rig_config {
namespace {

namespace described = wire::described;
namespace dbc = wire::dbc;
using described::Field;
using described::Form;
using described::Type;

class FieldReader {
 public:
  FieldReader(const Node& table, const FieldContext& context, Problems& problems)
      : table_(table), context_(context), problems_(problems) {}

  Field run() {
    field_.end = context_.separator;
    if (context_.form == Form::frames)
      read_signal();
    else if (context_.groups)
      read_group();
    else
      read_kind();
    read_place();
    if (context_.form == Form::binary && field_.type == Type::constant) check_constant();
    const std::string unit(signal_ ? as_described(signal_->unit) : "");
    if (table_.find("field")) read_target(table_, context_, unit, field_, problems_);
    if (!field_.target) scale_plainly(table_, context_, field_, problems_);
    if (signal_) scale_by_file();
    if (signal_ && field_.key == "time_s") field_.key = "device_time_s";  // `decode` has a time_s
    read_validity(table_, context_, field_, problems_);
    read_emulated();
    if (const Node* none = table_.find("no_value"))
      for (const Node& number : none->items) field_.no_value.push_back(number.number);
    if (const Node* rank = table_.find("rank"))
      field_.rank = static_cast<std::uint8_t>(rank->integer);
    return std::move(field_);
  }

 private:
  /// A field is one of: a value with a name, a constant, something to leave out.
  void read_kind() {
    const Node* constant = table_.find(context_.form == Form::binary ? "is" : "text");
    const bool value = table_.find("field") || table_.find("name");
    const Node* skipped = table_.find("skip");
    const bool sign = table_.find("sign_of") != nullptr;
    if (value + (constant != nullptr) + (skipped != nullptr) + sign != 1)
      add(table_, fmt::format("a field has one of: 'field' or 'name' (a value), '{}' (a constant), "
                              "'sign_of', 'skip'",
                              context_.form == Form::binary ? "is" : "text"));
    if (const Node* group = table_.find("group")) add(*group, "only for a line with a 'pattern'");
    read(table_, "name", field_.key);
    if (context_.form != Form::binary) read_text_type(constant, skipped);
    if (context_.form == Form::binary && !read_binary_type(table_.find("type")->text, field_))
      add(*table_.find("type"),
          fmt::format("\"{}\" is no type, allowed: u8 u16 u24 u32 u48 u64, i8 to i64, f32, f64, "
                      "bcd1 to bcd6, septet1 to septet8",
                      table_.find("type")->text));
    if (context_.form == Form::binary && constant) {
      if (field_.type != Type::unsigned_integer) add(*constant, "a constant has a type u8 to u64");
      field_.type = Type::constant;
      field_.idle = constant->number;
    }
  }

  /// A field of a frame is a signal, shown under its name.
  void read_signal() {
    const Node& word = *table_.find("signal");
    const auto& signals = context_.message->signals;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < signals.size(); ++i) {
      names.push_back(signals[i].long_name);
      if (signals[i].name != word.text && signals[i].long_name != word.text) continue;
      field_.at = static_cast<std::uint16_t>(i);
      signal_ = &signals[i];
    }
    if (!signal_)
      return add(word, fmt::format("message {} has no signal \"{}\"{}, allowed: {}",
                                   context_.message->long_name, word.text,
                                   did_you_mean(word.text, names), listed(names)));
    const dbc::Number number = signal_->layout.number;
    field_.type = signal_->layout.is_float()              ? Type::real
                  : number == dbc::Number::signed_integer ? Type::signed_integer
                                                          : Type::unsigned_integer;
    if (!table_.find("field")) field_.key = signal_->long_name;
    read(table_, "name", field_.key);
    read(table_, "optional", field_.optional);
  }

  /// A field of a pattern is a group, shown under its name.
  void read_group() {
    for (const char* key : {"text", "skip", "ends"})
      if (const Node* one = table_.find(key))
        add(*one, fmt::format("'{}' is only for fields in order; the pattern has the text", key));
    const Node* word = table_.find("group");
    if (!word) return add(table_, "a field of a pattern needs the key 'group'");
    const auto& names = *context_.groups;
    const auto found = std::ranges::find(names, word->text);
    if (found == names.end())
      return add(*word, fmt::format("the pattern has no group \"{}\"{}, allowed: {}", word->text,
                                    did_you_mean(word->text, names), listed(names)));
    field_.at = static_cast<std::uint16_t>(found - names.begin());
    read_text_type(nullptr, nullptr);
    if (!table_.find("field") && field_.type != Type::sign) field_.key = word->text;
    read(table_, "name", field_.key);
  }

  /// Behind the raw number comes the DBC file's scale, then that of the description.
  void scale_by_file() {
    const auto& layout = signal_->layout;
    field_.offset += layout.offset * field_.factor;
    field_.factor *= layout.factor;
  }

  void read_text_type(const Node* constant, const Node* skipped) {
    std::string type = "number";
    read(table_, "type", type);
    field_.type = type == "hex"          ? Type::hex
                  : type == "hex_signed" ? Type::hex_signed
                  : type == "text"       ? Type::text
                                         : Type::number;
    if (skipped) field_.type = Type::ignored;
    if (constant) field_.type = Type::constant;
    read(table_, "text", field_.text);
    read_sign();
    read_hex_bits();
    read_before();
    read(table_, "optional", field_.optional);
    if (const Node* end = table_.find("ends")) {
      field_.end = end->text.empty() ? '\0' : end->text[0];
      field_.closed = field_.end != '\0' && field_.end != ' ';  // blanks may stand behind any text
    }
  }

  void read_hex_bits() {
    const Node* bits = table_.find("bits");
    if (!bits) return;
    if (field_.type != Type::hex) return add(*bits, "only a number of type \"hex\" has bits");
    read_bits(64);
  }

  void read_before() {
    const Node* before = table_.find("before");
    if (!before) return;
    const bool number =
        field_.type == Type::number || field_.type == Type::hex || field_.type == Type::hex_signed;
    if (context_.groups || !number)
      add(*before, "'before' is only for a number of fields in order; a pattern has the text");
    read(table_, "before", field_.before);
  }

  void read_sign() {
    const Node* of = table_.find("sign_of");
    if (!of) return;
    field_.type = Type::sign;
    field_.text = "+";
    field_.minus = "-";
    read(table_, "plus", field_.text);
    read(table_, "minus", field_.minus);
    if (field_.text == field_.minus) add(*of, "'plus' and 'minus' are the same");
  }

  void read_place() {
    if (context_.form == Form::frames && signal_) return read_bits(signal_->layout.bits);
    if (context_.form != Form::binary) return;
    field_.at = static_cast<std::uint16_t>(table_.find("at")->integer);
    read_order();
    if (const Node* record = table_.find("record")) read_record(*record);
    read_bits(8u * field_.size);
  }

  void read_order() {
    const NumberOrder order = order_of(table_, context_.order);
    field_.big_endian = order.big_endian;
    field_.low_word_first = order.low_word_first && field_.size > 1;
    if (field_.low_word_first && field_.size % 2 != 0)
      add(*table_.find("type"),
          fmt::format("\"{}\" is no number of whole words; CDAB and BADC are orders of words",
                      table_.find("type")->text));
  }

  void read_record(const Node& record) {
    field_.record = static_cast<std::uint16_t>(record.integer);
    if (!context_.records) add(record, "its message has no 'records'");
    if (field_.type == Type::constant && context_.records && !context_.records->are_blocks())
      add(record, "a constant is in front of the records: it tells what the message is");
  }

  /// A part of an integer, which has `size` bits.
  void read_bits(unsigned size) {
    const Node* bits = table_.find("bits");
    if (!bits) return;
    const auto first = bits->items[0].integer, count = bits->items[1].integer;
    if (field_.type == Type::real || field_.type == Type::bcd || field_.type == Type::septet)
      add(*bits, "only an integer has bits");
    else if (count < 1)
      add(*bits, "expected the first bit and at least one bit");
    else if (first + count > size)
      add(*bits,
          fmt::format("bits {} to {} are beyond the {} of {}", first, first + count - 1, size,
                      table_.find(context_.form == Form::frames ? "signal" : "type")->text));
    field_.first_bit = static_cast<std::uint8_t>(first);
    field_.bits = static_cast<std::uint8_t>(count);
  }

  void check_constant() {
    const int bits = field_.bits > 0 ? field_.bits : 8 * field_.size;
    if (field_.idle >= std::ldexp(1.0, bits))
      add(*table_.find("is"), fmt::format("{} has more than {} bits", field_.idle, bits));
  }

  /// Latitude and longitude have steps of a centimetre, or those of a good receiver's minutes.
  std::uint8_t usual_decimals() const {
    const auto target = field_.target;
    if (target != described::Target::latitude && target != described::Target::longitude)
      return field_.decimals;
    constexpr std::uint8_t of_minutes = 5;
    constexpr double step_rad = 1.75e-9;
    if (field_.notation.digits == described::Digits::degrees_minutes) return of_minutes;
    return static_cast<std::uint8_t>(
        std::clamp(std::ceil(-std::log10(step_rad / std::abs(field_.factor))), 0.0, 12.0));
  }

  void read_emulated() {
    field_.decimals = usual_decimals();
    if (const Node* decimals = table_.find("decimals"))
      field_.decimals = static_cast<std::uint8_t>(decimals->integer);
    if (const Node* width = table_.find("width"))
      field_.width = static_cast<std::uint8_t>(width->integer);
    if (const Node* sign = table_.find("sign")) field_.sign = sign->text[0];
    if (field_.type == Type::hex_signed && (field_.width < 1 || field_.width > 16))
      add(table_, "a field of type hex_signed has a 'width', its 1 to 16 digits");
    if (const Node* emulate = table_.find("emulate")) {
      field_.idle = emulate->number;
      if (field_.type == Type::text || field_.type == Type::ignored) field_.text = emulate->text;
    }
    if (field_.factor == 0) add(*table_.find("scale"), "a scale of 0 loses the value");
  }

  void add(const Node& at, std::string what) {
    problems_.push_back({context_.file, at.at.line, at.at.column, context_.path, std::move(what)});
  }

  const Node& table_;
  const FieldContext& context_;
  Problems& problems_;
  Field field_;
  const wire::dbc::Signal* signal_ = nullptr;  ///< frames
};

}  // namespace

bool read_binary_type(std::string_view name, Field& field) {
  for (std::uint8_t size = 1; size <= 8; ++size) {
    field.size = size;
    const auto is = [&](std::string_view letter, int figure, Type type) {
      field.type = type;
      return name == fmt::format("{}{}", letter, figure);
    };
    if (is("u", 8 * size, Type::unsigned_integer) || is("i", 8 * size, Type::signed_integer))
      return true;
    if ((size == 4 || size == 8) && is("f", 8 * size, Type::real)) return true;
    if (size <= 6 && is("bcd", size, Type::bcd)) return true;
    if (is("septet", size, Type::septet)) return true;
  }
  return false;
}

Field read_field(const Node& table, const FieldContext& context, Problems& problems) {
  return FieldReader(table, context, problems).run();
}

}  // namespace drydock::rig_config
