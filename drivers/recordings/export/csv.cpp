#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <set>

#include "drivers/recordings/export/exporter.hpp"
#include "drivers/recordings/export/output_file.hpp"
#include "drivers/recordings/export/units.hpp"
#include "drivers/recordings/record/layouts.hpp"

namespace drydock::exporting {

namespace {

using record::MessageNode;
using record::Scalar;

std::string as_cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string cell = "\"";
  for (const char c : text) cell.append(c == '"' ? 2 : 1, c);
  return cell + '"';
}

/// Names of the values of a message, flattened: `velocity.x`, `range[3]`. A sequence is one value.
void put_columns(const MessageNode& node, const std::string& path, std::string_view type,
                 std::string& header) {
  const bool is_array = node.repeat == MessageNode::Repeat::array;
  for (std::size_t i = 0; i < (is_array ? node.count : 1); ++i) {
    const std::string here = is_array ? fmt::format("{}[{}]", path, i) : path;
    if (node.scalar == Scalar::nested && node.repeat != MessageNode::Repeat::sequence) {
      for (const auto& member : node.members)
        put_columns(member, here.empty() ? member.name : here + "." + member.name, type, header);
      continue;
    }
    const auto unit = unit_of(type, here);
    header += ',' + here;
    if (!unit.empty()) header.append(" [").append(unit).append("]");
  }
}

template <class Number>
void put_number(std::string& text, mcap::Bytes bytes) {
  Number number;
  std::memcpy(&number, bytes.data(), sizeof number);
  if constexpr (std::is_floating_point_v<Number>) {
    if (std::isnan(number)) return;  // not available
  }
  std::array<char, 32> digits;
  text.append(digits.data(),
              std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

void put_value(std::string& text, Scalar scalar, mcap::Bytes bytes) {
  switch (scalar) {
    case Scalar::boolean:
    case Scalar::uint8: return put_number<std::uint8_t>(text, bytes);
    case Scalar::int8: return put_number<std::int8_t>(text, bytes);
    case Scalar::int16: return put_number<std::int16_t>(text, bytes);
    case Scalar::uint16: return put_number<std::uint16_t>(text, bytes);
    case Scalar::int32: return put_number<std::int32_t>(text, bytes);
    case Scalar::uint32: return put_number<std::uint32_t>(text, bytes);
    case Scalar::int64: return put_number<std::int64_t>(text, bytes);
    case Scalar::uint64: return put_number<std::uint64_t>(text, bytes);
    case Scalar::float32: return put_number<float>(text, bytes);
    case Scalar::float64: return put_number<double>(text, bytes);
    case Scalar::text: text.append(bytes.begin(), bytes.end()); return;
    case Scalar::nested: return;
  }
}

/// The cells of a row. A sequence is one cell: its values are separated by blanks, and an element
/// with several values ends with a `;`.
class Row {
 public:
  explicit Row(std::string& line) : line_(line) {}

  void value(const MessageNode& node, std::size_t, mcap::Bytes bytes) {
    if (in_sequence_ > 0 && !cell_.empty() && cell_.back() != ';') cell_ += ' ';
    put_value(cell_, node.scalar, bytes);
    if (in_sequence_ == 0) end_cell();
  }
  void begin(const MessageNode&, std::size_t) { ++in_sequence_; }
  void end(const MessageNode&) {
    if (--in_sequence_ == 0) end_cell();
  }
  void enter(const MessageNode&, std::size_t) {}
  void leave(const MessageNode& node) {
    if (node.repeat == MessageNode::Repeat::sequence) cell_ += ';';
  }

 private:
  void end_cell() {
    line_ += ',' + as_cell(cell_);
    cell_.clear();
  }

  std::string& line_;
  std::string cell_;
  int in_sequence_ = 0;
};

/// "/imu/data" -> "imu_data.csv". Control characters of a foreign topic are none of a name.
std::string file_name(std::string topic) {
  std::ranges::replace_if(
      topic, [](char c) { return c == '/' || static_cast<unsigned char>(c) < ' ' || c == '\x7F'; },
      '_');
  return topic.substr(topic.starts_with('_') ? 1 : 0) + ".csv";
}

/// One file for each topic, one row for each message, one column for each value. The columns come
/// from the message definitions in the recording. Thus the values are those that were decoded at
/// the time, and recordings of other programs work too.
class Csv final : public Exporter {
 public:
  explicit Csv(const Target& to) : folder_(to.path, to.overwrite) {}

  void on_message(const record::Understood& message) override {
    const std::string& topic = message.channel->topic;
    const record::Layout& layout = layouts_.of(message);
    if (!layout) return unread_.add(topic, layout.error().line);
    if (const auto why = record::misfit(*layout, message.cdr); !why.empty())
      return unread_.add(topic, why);
    OutputFile& file = folder_.file(file_name(topic));
    if (topics_.insert(topic).second) {
      line_ = "log_time [s]";
      put_columns(*layout, "", message.schema->name, line_);
      file.write(line_ + '\n');
    }
    const auto ns = message.at.time_since_epoch().count();
    line_ = fmt::format("{}.{:09}", ns / ns_a_second, ns % ns_a_second);
    record::visit_message(*layout, message.cdr, Row(line_));
    file.write(line_ + '\n');
    ++written_;
  }
  void finish() override { folder_.close(); }
  std::string error() const override { return folder_.error(); }
  std::vector<std::string> notes() const override { return unread_.notes(); }

 private:
  static constexpr std::int64_t ns_a_second = 1'000'000'000;

  OutputFolder folder_;
  record::Layouts layouts_;
  record::Unread unread_;
  std::set<std::string> topics_;  ///< with a file
  std::string line_;
};

}  // namespace

std::unique_ptr<Exporter> make_csv(const Target& to) { return std::make_unique<Csv>(to); }

}  // namespace drydock::exporting
