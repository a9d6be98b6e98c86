#include "rig_config/device_description/frame_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rig_config/rules/explain.hpp"
#include "rig_config/toml/read_keys.hpp"

namespace drydock::rig_config {
namespace {

namespace dbc = wire::dbc;
using wire::described::Field;
using wire::described::FrameLayout;
using wire::described::Selection;

constexpr std::size_t ids_of_profile_2 = 16;

std::vector<std::string> checksum_names() {
  std::vector<std::string> names;
  for (int i = 0; i <= static_cast<int>(dbc::Checksum::xor_of_bytes); ++i)
    names.emplace_back(to_string(static_cast<dbc::Checksum>(i)));
  return names;
}

/// The selectors above a signal, with the first raw value of each that selects it.
Selection selection_of(const dbc::Message& message, std::size_t signal) {
  Selection found;
  for (const dbc::Signal* s = &message.signals[signal]; s->selected_by && !s->when.empty();
       s = &message.signals[*s->selected_by])
    found.emplace_back(*s->selected_by, s->when.front().first);
  return found;
}

class FrameReader {
 public:
  FrameReader(const Node& table, FrameLayout& layout, const std::string& file,
              const std::string& path, Problems& problems)
      : table_(table), layout_(layout), file_(file), path_(path), problems_(problems) {}

  void run(std::span<const Field> fields) {
    read(table_, "sample", layout_.sample);
    read_selections(fields);
    read_optional(fields);
    count_waited_turns(fields);
    if (const Node* checksum = table_.find("checksum")) read_checksum(*checksum);
    if (const Node* counter = table_.find("counter")) read_counter(*counter);
    for (const Field& field : fields) layout_.joins |= field.target || field.validity;
  }

 private:
  void read_selections(std::span<const Field> fields) {
    for (const Field& field : fields) {
      const Selection one = selection_of(layout_.message, field.at);
      const bool known = std::ranges::find(layout_.turns, one) != layout_.turns.end();
      if (!one.empty() && !known) layout_.turns.push_back(one);
    }
    const bool several = layout_.turns.size() > 1;
    for (std::size_t i = 0; several && i < fields.size(); ++i)
      if (!layout_.message.signals[fields[i].at].selected_by) layout_.shared |= 1u << i;
    if (layout_.turns.empty()) layout_.turns.emplace_back();
  }

  void read_optional(std::span<const Field> fields) {
    bool whole = false;
    read(table_, "optional", whole);
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (whole || fields[i].optional) layout_.optional |= 1u << i;
  }

  void count_waited_turns(std::span<const Field> fields) {
    std::vector<Selection> waited;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const bool waits =
          (layout_.optional >> i & 1) == 0 && (fields[i].target || fields[i].validity);
      const Selection one = selection_of(layout_.message, fields[i].at);
      if (waits && !one.empty() && std::ranges::find(waited, one) == waited.end())
        waited.push_back(one);
    }
    layout_.waited_turns = std::max<std::size_t>(1, waited.size());
  }

  /// The place of the signal that a key names. Empty after a problem.
  std::optional<std::size_t> signal_at(const Node& word, const std::string& key) {
    const auto& signals = layout_.message.signals;
    for (std::size_t i = 0; i < signals.size(); ++i)
      if (signals[i].name == word.text || signals[i].long_name == word.text) return i;
    std::vector<std::string> names;
    names.reserve(signals.size());
    for (const dbc::Signal& signal : signals) names.push_back(signal.long_name);
    add(word, key,
        fmt::format("message {} has no signal \"{}\"{}, allowed: {}", layout_.message.long_name,
                    word.text, did_you_mean(word.text, names), listed(names)));
    return {};
  }

  void read_counter(const Node& counter) {
    const Node& word = *counter.find("signal");
    const auto signal = signal_at(word, "/counter/signal");
    if (!signal) return;
    const dbc::Layout& bits = layout_.message.signals[*signal].layout;
    if (bits.number != dbc::Number::unsigned_integer || bits.bits > 16)
      return add(word, "/counter/signal", "a counter is an unsigned integer of at most 16 bits");
    const bool of_profile_1 = layout_.checksum && is_profile_1(layout_.checksum->checksum) &&
                              bits.bits == 4 && bits.start / 8 == 1;
    unsigned modulus = of_profile_1 ? dbc::modulus_of_profile_1 : 1u << bits.bits;
    if (const Node* wraps = counter.find("modulus")) {
      if (wraps->integer > modulus)
        add(*wraps, "/counter/modulus",
            of_profile_1
                ? fmt::format("{} counts from 0 to 14, allowed: up to {}",
                              to_string(layout_.checksum->checksum), modulus)
                : fmt::format("the signal has {} bits, allowed: up to {}", bits.bits, modulus));
      modulus = static_cast<unsigned>(wraps->integer);
    }
    layout_.counter = {*signal, modulus};
  }

  void read_checksum(const Node& checksum) {
    const Node& word = *checksum.find("kind");
    const auto kind = dbc::checksum_named(word.text);
    if (!kind)
      add(word, "/checksum/kind",
          fmt::format("\"{}\" is no checksum of frames{}, allowed: {}", word.text,
                      did_you_mean(word.text, checksum_names()), listed(checksum_names())));
    const auto signal = signal_at(*checksum.find("signal"), "/checksum/signal");
    if (!kind || !signal) return;
    dbc::Protection protection;
    protection.checksum = *kind;
    protection.at = layout_.message.signals[*signal].layout.start / 8;
    if (const Node* id = checksum.find("data_id"))
      protection.data_id = static_cast<std::uint16_t>(id->integer);
    if (const Node* seed = checksum.find("seed"))
      protection.seed = static_cast<std::uint8_t>(seed->integer);
    read_ids(checksum, *kind, protection);
    check_place(*checksum.find("signal"), *signal, *kind);
    layout_.checksum = protection;
  }

  void read_ids(const Node& checksum, dbc::Checksum kind, dbc::Protection& protection) {
    const Node* ids = checksum.find("data_ids");
    if ((kind == dbc::Checksum::e2e_2) != (ids != nullptr))
      add(checksum, "/checksum", "e2e-2, and only that, has 'data_ids': 16 numbers");
    for (std::size_t i = 0; ids && i < ids_of_profile_2; ++i)
      protection.data_ids[i] = static_cast<std::uint8_t>(ids->items[i].integer);
  }

  /// The DBC file must have the checksum where the method has it.
  void check_place(const Node& word, std::size_t signal, dbc::Checksum kind) {
    const dbc::Layout& bits = layout_.message.signals[signal].layout;
    const unsigned size = kind == dbc::Checksum::e2e_5 ? 16 : 8;
    const unsigned in_byte = bits.order == dbc::ByteOrder::intel ? 0 : 7;
    if (bits.bits != size || bits.start % 8 != in_byte)
      add(word, "/checksum/signal",
          fmt::format("{} is {} bits of whole bytes", to_string(kind), size));
    else if (kind <= dbc::Checksum::e2e_5 && bits.start / 8 != 0)
      add(word, "/checksum/signal", fmt::format("{} begins in byte 0", to_string(kind)));
  }

  void add(const Node& at, const std::string& key, std::string what) {
    problems_.push_back({file_, at.at.line, at.at.column, path_ + key, std::move(what)});
  }

  const Node& table_;
  FrameLayout& layout_;
  const std::string& file_;
  const std::string& path_;
  Problems& problems_;
};

/// From one frame of a selection to the next; 0: not known.
unsigned sample_ms(const FrameLayout& frame) {
  return frame.message.cycle_ms * static_cast<unsigned>(frame.waited_turns);
}

std::string time_text(const FrameLayout& frame) {
  return frame.waited_turns == 1 ? fmt::format("cycle time is {} ms", sample_ms(frame))
                                 : fmt::format("cycle time for its {} frames in turn is {} ms",
                                               frame.waited_turns, sample_ms(frame));
}

/// The targets of a message.
wire::described::TargetSet targets(const wire::described::Plan& plan, std::size_t place) {
  wire::described::TargetSet found;
  for (const Field& field : plan.fields_of(plan.messages[place]))
    if (field.target) found.set(index_of(*field.target));
  return found;
}

}  // namespace

void read_frame(const Node& table, std::span<const Field> fields, FrameLayout& layout,
                const std::string& file, const std::string& path, Problems& problems) {
  FrameReader(table, layout, file, path, problems).run(fields);
}

Problems check_samples(const wire::described::Plan& plan, const wire::described::FramePlan& frames,
                       std::span<const Node> tables, const std::string& file) {
  Problems problems;
  const auto& all = frames.frames;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (all[i].sample != all[j].sample) continue;
      const auto add = [&](std::string what) {
        problems.push_back({file, tables[i].at.line, tables[i].at.column,
                            fmt::format("/protocol/frames/{}", i), std::move(what)});
      };
      if ((targets(plan, i) & targets(plan, j)).any())
        add(fmt::format("the message of line {} measures the same; allowed: another 'sample'",
                        tables[j].at.line));
      const unsigned a = sample_ms(all[i]), b = sample_ms(all[j]);
      if (a != b && a != 0 && b != 0 && all[i].optional == 0 && all[j].optional == 0)
        add(
            fmt::format("its {}, and that of line {} is {} ms: they cannot make one sample; "
                        "allowed: another 'sample', 'optional = true'",
                        time_text(all[i]), tables[j].at.line, b));
    }
  return problems;
}

}  // namespace drydock::rig_config
