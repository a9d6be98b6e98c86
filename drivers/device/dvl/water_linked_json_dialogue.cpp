#include "drivers/device/dvl/water_linked_json_dialogue.hpp"

#include "drivers/device/dvl/water_linked_settings.hpp"
#include "drivers/device/fixed_text.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::device {

namespace {

namespace water_linked_json = wire::water_linked_json;
using namespace water_linked_patience;

}  // namespace

void WaterLinkedJsonDialogue::start(Stamp now, Output& out) {
  step_ = Step::idle;
  gave_up_ = false;
  refusal_ = {};
  sound_speed_mps_.reset();
  due_.reset();
  if (!wanted_) return;
  settings_hold_ = nothing_to_set(*wanted_);
  go_to(settings_hold_ ? Step::check : Step::set, now, out);
}

void WaterLinkedJsonDialogue::tick(Stamp now, Output& out) {
  if (!due_ || now < *due_) return;
  if (gave_up_) return start(now, out);
  if (tries_ < most_tries) return ask(now, out);
  if (!replayed_) out.report(in_words("no answer to ").view());
  settings_hold_ = true;
  gave_up_ = true;
  due_ = now + start_again_after;
}

void WaterLinkedJsonDialogue::receive(const water_linked_json::Response& answer, Stamp now,
                                      Output& out) {
  if (step_ == Step::idle || answer.response_to != command()) return;
  gave_up_ = false;  // a slow answer is one too
  if (!answer.success) {
    const Reason refusal = in_words("the DVL refuses ", answer.error_message);
    out.report(refusal.view());
    if (step_ == Step::set) refusal_ = refusal;
  }
  if (step_ == Step::set) return go_to(Step::check, now, out);
  if (answer.success) compare(answer, out);
  go_to(Step::idle, now, out);
}

/// Of several troubles health shows the last: a refusal tells more than the values that it left.
void WaterLinkedJsonDialogue::compare(const water_linked_json::Response& answer, Output& out) {
  const auto read = water_linked_json::read_configuration(answer.result);
  if (!read) return out.report(in_words("no values in the answer to ").view());
  const auto agreement = device::compare(*wanted_, *read, out);
  settings_hold_ = agreement.velocities;
  sound_speed_mps_ = read->sound_speed_mps;
  if (!refusal_.empty())
    out.report(refusal_.view());
  else if (!agreement.settings && !nothing_to_set(*wanted_))
    out.report(keeps_other_values("set_config").view());
}

void WaterLinkedJsonDialogue::go_to(Step step, Stamp now, Output& out) {
  step_ = step;
  tries_ = 0;
  due_.reset();
  if (step_ != Step::idle) ask(now, out);
}

void WaterLinkedJsonDialogue::ask(Stamp now, Output& out) {
  ++tries_;
  due_ = now + answer_within;
  std::array<std::uint8_t, 256> settings, line;
  water_linked_json::Command asked{command(), {}};
  if (step_ == Step::set) {
    const std::size_t size = water_linked_json::encode_configuration(to_set(*wanted_), settings);
    asked.parameters = wire::as_text(wire::Bytes{settings}.first(size));
  }
  out.send(std::span{line}.first(encode(asked, line)));
}

std::string_view WaterLinkedJsonDialogue::command() const {
  return step_ == Step::set ? "set_config" : "get_config";
}

Reason WaterLinkedJsonDialogue::in_words(std::string_view trouble, std::string_view why) const {
  Reason text{trouble};
  text += command();
  if (!why.empty()) text += ": ";
  text += why;
  return text;
}

}  // namespace drydock::device
