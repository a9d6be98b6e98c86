#include "rig_config/device_description/message_head.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rig_config/device_description/field_reader.hpp"
#include "rig_config/device_description/protocol_keys.hpp"
#include "rig_config/device_description/requests.hpp"
#include "rig_config/toml/read_keys.hpp"

namespace drydock::rig_config {
namespace {

namespace described = wire::described;
using described::Field;
using described::Form;
using described::Message;
using described::Plan;
using described::Type;

class HeadReader {
 public:
  HeadReader(const Node& protocol, const Node& table, const Plan& plan, Message& message,
             const std::string& file, const std::string& path, Problems& problems)
      : protocol_(protocol),
        table_(table),
        plan_(plan),
        message_(message),
        file_(file),
        path_(path),
        problems_(problems) {}

  void binary() {
    read_sync();
    read_extra(protocol_, "/protocol");
    read_extra(table_, path_);
    read_length();
    if (const Node* records = table_.find("records")) read_records(*records);
  }

  void text() {
    const bool has_id = plan_.form == Form::sentences && !table_.find("head");
    if (has_id && !table_.find("id"))
      add(table_, path_, "a sentence needs 'id', or 'head' if no separator is behind it");
    if (const Node* id = table_.find("id"); id && !has_id)
      add(*id, path_ + "/id", "a sentence has 'id' or 'head', not both");
    read(table_, has_id ? "id" : "head", message_.head);
    message_.name = message_.head;
    if (plan_.form == Form::lines) return;
    std::erase_if(message_.name, [](char c) { return c == '$' || c == '!' || c == '-'; });
    message_.any_talker =
        message_.head.substr(std::min<std::size_t>(1, message_.head.size())).starts_with("--");
    if (!has_id) return;
    const char separator = separator_of(protocol_);
    if (message_.head.find(separator) != message_.head.npos)
      add(*table_.find("id"), path_ + "/id",
          fmt::format("ends before the first '{}': what stands behind it is a field; of one that "
                      "never changes 'is' says what it is",
                      separator));
    message_.head += separator;
  }

 private:
  void read_sync() {
    const Node* sync = table_.find("sync");
    if (!sync) return;
    const auto bytes = hex_bytes(sync->text);
    if (!bytes || bytes->empty() || bytes->size() > 16)
      add(*sync, path_ + "/sync",
          "expected 1 to 16 bytes in hexadecimal digits, such as \"FA 49\"");
    else
      message_.head = *bytes;
  }

  void read_extra(const Node& table, const std::string& path) {
    const Node* extra = table.find("checksum_extra");
    if (!extra) return;
    const auto bytes = hex_bytes(extra->text);
    if (!bytes || bytes->empty() || bytes->size() > 16)
      add(*extra, path + "/checksum_extra", "expected 1 to 16 bytes in hexadecimal digits");
    else if (!plan_.checksum.is_crc())
      add(*extra, path + "/checksum_extra", "only a CRC takes in more than is sent");
    else
      message_.extra = *bytes;
  }

  void read_length() {
    const Node* length = table_.find("length");
    if (!length && plan_.stuffing != described::Stuffing::none) return;  // delimiters tell it
    if (!length) return add(table_, path_, "key 'length' is missing");
    if (length->kind == Node::Kind::integer) {
      message_.length.fixed = static_cast<std::uint16_t>(length->integer);
      return;
    }
    Field field;
    if (!read_binary_type(length->find("type")->text, field) ||
        field.type != Type::unsigned_integer || field.size > 4)
      add(*length, path_ + "/length", "a length has a type u8, u16, u24 or u32");
    message_.length.at = static_cast<std::uint16_t>(length->find("at")->integer);
    message_.length.size = field.size;
    message_.length.big_endian = order_of(protocol_).big_endian;
    if (const Node* order = length->find("order"))
      message_.length.big_endian = order->text == "big";
    if (const Node* plus = length->find("plus"))
      message_.length.plus = static_cast<std::uint16_t>(plus->integer);
  }

  /// The size of the integer that names a record, or tells its length.
  std::uint8_t record_part(const Node& records, const char* key) {
    Field field;
    const Node& part = *records.find(key);
    if (!read_binary_type(part.find("type")->text, field) || field.type != Type::unsigned_integer ||
        field.size > 2)
      add(part, path_ + "/records/" + key, "expected a type u8 or u16");
    return field.size;
  }

  void read_records(const Node& table) {
    auto& records = message_.records.emplace();
    records.from = static_cast<std::uint16_t>(table.find("from")->integer);
    records.big_endian = order_of(protocol_).big_endian;
    if (message_.length.size == 0 && !message_.length.is_any())
      add(table, path_ + "/records", "a message of records has a 'length' that a field says");
    const bool by_mask = table.find("mask") && table.find("sizes");
    const bool by_id = table.find("id") && table.find("length");
    const int keys = (table.find("mask") != nullptr) + (table.find("sizes") != nullptr) +
                     (table.find("id") != nullptr) + (table.find("length") != nullptr);
    if (keys != 2 || by_mask == by_id)
      add(table, path_ + "/records", "needs 'id' and 'length', or 'mask' and 'sizes'");
    else if (by_mask)
      read_blocks(table, records);
    else
      read_headed_records(table, records);
  }

  void read_blocks(const Node& table, described::Records& blocks) {
    Field field;
    const Node& mask = *table.find("mask");
    const auto& sizes = table.find("sizes")->items;
    const bool is_unsigned =
        read_binary_type(mask.find("type")->text, field) && field.type == Type::unsigned_integer;
    blocks.mask_at = static_cast<std::uint16_t>(mask.find("at")->integer);
    blocks.mask_size = field.size;
    for (const Node& size : sizes) blocks.sizes.push_back(static_cast<std::uint8_t>(size.integer));
    if (!is_unsigned || field.size > 4)
      add(mask, path_ + "/records/mask", "a mask has a type u8, u16, u24 or u32");
    else if (sizes.size() > 8 * std::size_t{field.size})
      add(*table.find("sizes"), path_ + "/records/sizes",
          fmt::format("has {} sizes, the mask has {} bits", sizes.size(), 8 * field.size));
    if (blocks.mask_at + blocks.mask_size > blocks.from)
      add(mask, path_ + "/records/mask", "stands in front of the blocks, which begin at 'from'");
  }

  void read_headed_records(const Node& table, described::Records& records) {
    records.id_at = static_cast<std::uint8_t>(table.find("id")->find("at")->integer);
    records.id_size = record_part(table, "id");
    records.length_at = static_cast<std::uint8_t>(table.find("length")->find("at")->integer);
    records.length_size = record_part(table, "length");
    if (const Node* plus = table.find("length")->find("plus"))
      records.plus = static_cast<std::uint8_t>(plus->integer);
    const bool apart = records.id_at + records.id_size <= records.length_at ||
                       records.length_at + records.length_size <= records.id_at;
    if (!apart)
      add(table, path_ + "/records", "the id and the length of a record have a byte in common");
  }

  void add(const Node& at, const std::string& path, std::string what) {
    problems_.push_back({file_, at.at.line, at.at.column, path, std::move(what)});
  }

  const Node& protocol_;
  const Node& table_;
  const Plan& plan_;
  Message& message_;
  const std::string& file_;
  const std::string& path_;
  Problems& problems_;
};

}  // namespace

void read_binary_head(const Node& protocol, const Node& table, const Plan& plan, Message& message,
                      const std::string& file, const std::string& path, Problems& problems) {
  HeadReader(protocol, table, plan, message, file, path, problems).binary();
}

void read_text_head(const Node& protocol, const Node& table, const Plan& plan, Message& message,
                    const std::string& file, const std::string& path, Problems& problems) {
  HeadReader(protocol, table, plan, message, file, path, problems).text();
}

}  // namespace drydock::rig_config
