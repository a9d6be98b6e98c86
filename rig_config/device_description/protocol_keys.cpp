#include "rig_config/device_description/protocol_keys.hpp"

#include "rig_config/device_description/checksum_reader.hpp"
#include "rig_config/device_description/requests.hpp"
#include "rig_config/toml/read_keys.hpp"

namespace drydock::rig_config {
namespace {

namespace described = wire::described;
using described::Form;
using described::Plan;

class KeysReader {
 public:
  KeysReader(const Node& protocol, Plan& plan, const std::string& file, Problems& problems)
      : protocol_(protocol), plan_(plan), file_(file), problems_(problems) {}

  void run() {
    read_checksums();
    read_decimal();
    if (plan_.form == Form::binary)
      read_frames();
    else
      refuse_keys_of_frames();
    plan_.longest = plan_.form == Form::binary ? 1024 : 256;
    if (const Node* longest = protocol_.find("longest"))
      plan_.longest = static_cast<std::size_t>(longest->integer);
  }

 private:
  void read_checksums() {
    plan_.checksum_big_endian = order_of(protocol_).big_endian;
    if (const Node* order = protocol_.find("checksum_order"))
      plan_.checksum_big_endian = order->text == "big";
    if (const Node* word = protocol_.find("checksum"))
      read_checksum(*word, "/protocol/checksum", plan_.checksum, file_, problems_);
    else if (plan_.form == Form::sentences)
      described::Checksum::find("xor", plan_.checksum);
    const bool is_fletcher = plan_.checksum.name().starts_with("fletcher");
    if (is_fletcher && plan_.checksum_big_endian && !protocol_.find("checksum_order"))
      add("checksum",
          "its two sums would change places with the 'order' of the numbers; allowed: "
          "'checksum_order', \"little\" where the sum of the bytes comes first (UBX, MIP) or "
          "\"big\"");
    plan_.checksum_from = plan_.form == Form::sentences ? 1 : 0;
    if (const Node* from = protocol_.find("checksum_from"))
      plan_.checksum_from = static_cast<std::uint16_t>(from->integer);
    read(protocol_, "checksum_optional", plan_.checksum_optional);
    if (plan_.form == Form::lines && plan_.checksum.size() > 0)
      add("checksum", "lines have none; with one behind a '*' they are sentences");
  }

  void read_decimal() {
    const Node* decimal = protocol_.find("decimal");
    if (!decimal) return;
    plan_.decimal_comma = decimal->text == ",";
    if (plan_.form != Form::sentences && plan_.form != Form::lines)
      add("decimal", "only numbers of a text have it");
  }

  void refuse_keys_of_frames() {
    for (const char* key : {"end", "checksum_at", "checksum_extra", "header_checksum", "stuffing"})
      if (protocol_.find(key)) add(key, "only binary frames have it");
  }

  void read_frames() {
    if (protocol_.find("stuffing"))
      plan_.stuffing = named<described::Stuffing>(
          protocol_, std::array{"none", "dle", "slip", "hdlc", "cobs"}, "stuffing");
    read_end();
    read_checksum_at();
    read_header();
  }

  void read_end() {
    const Node* end = protocol_.find("end");
    if (!end) return;
    const auto bytes = hex_bytes(end->text);
    if (!bytes || bytes->empty() || bytes->size() > 16)
      add("end", "expected 1 to 16 bytes in hexadecimal digits, such as \"0D 0A\"");
    else
      plan_.end = *bytes;
  }

  void read_checksum_at() {
    const Node* at = protocol_.find("checksum_at");
    if (!at) return;
    plan_.checksum_at = static_cast<std::uint16_t>(at->integer);
    if (plan_.checksum.size() == 0)
      add("checksum_at", "there is no checksum: the key 'checksum' is missing");
    else if (*plan_.checksum_at + plan_.checksum.size() > plan_.checksum_from)
      add("checksum_at", "the checksum stands in what it covers; 'checksum_from' is behind it");
  }

  void read_header() {
    const Node* table = protocol_.find("header_checksum");
    if (!table) return;
    described::HeaderChecksum header;
    read_checksum(*table->find("checksum"), "/protocol/header_checksum/checksum", header.checksum,
                  file_, problems_);
    const auto place = [&](const char* key) {
      return static_cast<std::uint16_t>(table->find(key)->integer);
    };
    header.at = place("at"), header.from = place("from"), header.to = place("to");
    const bool inside = header.at + header.checksum.size() > header.from && header.at < header.to;
    if (header.checksum.size() == 0)
      add("header_checksum", "it has no bytes; allowed: any checksum but none");
    else if (header.from >= header.to || inside)
      add("header_checksum",
          "it covers the bytes from 'from' to before 'to', and 'at' is not among them");
    else
      plan_.header = header;
  }

  void add(const char* key, std::string what) {
    const auto at = protocol_.find(key)->at;
    problems_.push_back(
        {file_, at.line, at.column, std::string("/protocol/") + key, std::move(what)});
  }

  const Node& protocol_;
  Plan& plan_;
  const std::string& file_;
  Problems& problems_;
};

}  // namespace

void read_protocol_keys(const Node& protocol, Plan& plan, const std::string& file,
                        Problems& problems) {
  KeysReader(protocol, plan, file, problems).run();
}

NumberOrder order_of(const Node& table, NumberOrder usual) {
  const Node* order = table.find("order");
  if (!order) return usual;
  const std::string_view word = order->text;
  return {word == "big" || word == "CDAB", word == "CDAB" || word == "BADC"};
}

char separator_of(const Node& protocol) {
  const Node* one = protocol.find("separator");
  return one ? one->text[0] : ',';
}

}  // namespace drydock::rig_config
