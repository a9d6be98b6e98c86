#include "rig_config/device_description/description_page.hpp"

#include <fmt/format.h>

#include "drivers/wire/described/frame_plan.hpp"
#include "rig_config/device_description/page_framing.hpp"

namespace drydock::rig_config {
namespace {

namespace described = wire::described;
using described::Field;
using described::Form;
using described::Message;
using described::Plan;
using described::Type;

std::string type_of(const Field& field) {
  const int bits = 8 * field.size;
  switch (field.type) {
    case Type::unsigned_integer: return fmt::format("u{}", bits);
    case Type::signed_integer: return fmt::format("i{}", bits);
    case Type::real: return fmt::format("f{}", bits);
    case Type::bcd: return fmt::format("bcd{}", field.size);
    case Type::septet: return fmt::format("septet{}", field.size);
    case Type::constant: return "constant";
    case Type::ignored: return "left out";
    case Type::sign: return "sign";
    case Type::text: return "text";
    case Type::hex:
    case Type::hex_signed: return "hexadecimal";
    case Type::number: break;
  }
  return "number";
}

/// Frames: the signal. Binary: the first byte. Texts: which one.
std::string place_of(const Field& field, const described::FrameLayout* frame, const Plan& plan,
                     std::size_t i) {
  if (frame) return fmt::format("signal {}", frame->message.signals[field.at].long_name);
  if (plan.form != Form::binary) return std::to_string(i + 1);
  const std::string at = fmt::format("byte {}", field.at);
  return field.record ? fmt::format("record {}, {}", *field.record, at) : at;
}

/// `i16 from bit 32, Intel`: bits are counted as DBC files do.
std::string layout_of(const wire::dbc::Layout& layout) {
  using wire::dbc::Number;
  const char letter = layout.is_float() ? 'f' : layout.number == Number::signed_integer ? 'i' : 'u';
  return fmt::format("{}{} from bit {}, {}", letter, layout.bits, layout.start,
                     layout.order == wire::dbc::ByteOrder::intel ? "Intel" : "Motorola");
}

std::string bits_of(const Field& field) {
  return field.bits == 0
             ? std::string()
             : fmt::format(", bits {} to {}", field.first_bit, field.first_bit + field.bits - 1);
}

std::string meaning_of(const Field& field) {
  if (field.type == Type::constant)
    return field.text.empty() ? fmt::format("always {:g}", field.idle)
                              : fmt::format("always `{}`", readable(field.text));
  std::string text;
  if (field.target) text = fmt::format("`{}`", described::row_of(*field.target).name);
  if (field.validity) text = "says whether the measurement holds";
  if (text.empty()) return {};
  if (field.target && (field.factor != 1 || field.offset != 0))
    text += fmt::format(", SI = number * {:.9g}{}", field.factor,
                        field.offset != 0 ? fmt::format(" + {:.9g}", field.offset) : "");
  return text;
}

std::string fields_text(const Plan& plan, const Message& message,
                        const described::FrameLayout* frame) {
  std::string text = "| field | place | type | meaning |\n|---|---|---|---|\n";
  const auto fields = plan.fields_of(message);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const Field& field = fields[i];
    const std::string type =
        frame ? layout_of(frame->message.signals[field.at].layout) : type_of(field);
    text += fmt::format("| {} | {} | {}{} | {} |\n",
                        field.key.empty() ? std::string() : fmt::format("`{}`", field.key),
                        place_of(field, frame, plan, i), type, bits_of(field), meaning_of(field));
  }
  return text;
}

/// Lines of Markdown that follow each other are one paragraph; these are a list.
std::string listed_lines(const std::string& lines) {
  std::string text;
  for (std::size_t at = 0; at < lines.size();) {
    const std::size_t end = lines.find('\n', at);
    text += "- " + lines.substr(at, end - at) + "\n";
    at = end + 1;
  }
  return text.empty() ? text : text + "\n";
}

std::string requests_text(std::string_view title, const std::vector<described::Request>& requests) {
  if (requests.empty()) return {};
  std::string text = fmt::format("\n## {}\n\n", title);
  for (const auto& one : requests)
    text += fmt::format("- `{}`{}\n", readable(one.bytes),
                        one.reply.empty() ? "" : ", answered with " + one.reply);
  return text;
}

}  // namespace

std::string description_page(const described::Description& description) {
  const Plan& plan = description.plan;
  std::string text = fmt::format("# {}\n\n", description.title);
  text += description.kind ? fmt::format("Described by `{}`; it measures as kind `{}`.\n",
                                         description.name, to_string(*description.kind))
                           : fmt::format("Described by `{}`; only `drydock decode` reads it.\n",
                                         description.name);
  const std::string framing = listed_lines(description.frames ? "" : protocol_framing(plan));
  if (!framing.empty()) text += "\n" + framing.substr(0, framing.size() - 1);
  for (std::size_t i = 0; i < plan.messages.size(); ++i) {
    const Message& message = plan.messages[i];
    const auto* frame = description.frames ? &description.frames->frames[i] : nullptr;
    text +=
        fmt::format("\n## {}\n\n{}{}", message.name,
                    listed_lines(frame ? frame_framing(*frame) : message_framing(plan, message)),
                    fields_text(plan, message, frame));
  }
  text += requests_text("Said when the link opens", description.start);
  text += requests_text("Said at the rate of the rig", description.poll);
  return text;
}

}  // namespace drydock::rig_config
