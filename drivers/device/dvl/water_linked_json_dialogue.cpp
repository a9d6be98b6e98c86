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
  due_.reset();
  if (!wanted_) return;
  settings_hold_ = nothing_to_set(*wanted_);
  go_to(settings_hold_ ? Step::check : Step::set, now, out);
}

void WaterLinkedJsonDialogue::tick(Stamp now, Output& out) {
  if (!due_ || now < *due_) return;
  if (finished()) return start(now, out);
  if (tries_ < most_tries) return ask(now, out);
  if (!replayed_) tell("no answer to ", {}, out);
  settings_hold_ = true;
  step_ = Step::idle;
  due_ = now + start_again_after;
}

void WaterLinkedJsonDialogue::receive(const water_linked_json::Response& answer, Stamp now,
                                      Output& out) {
  if (finished() || answer.response_to != command()) return;
  if (!answer.success) tell("the DVL refuses ", answer.error_message, out);
  if (step_ == Step::set) return go_to(Step::check, now, out);
  if (answer.success) compare(answer, out);
  go_to(Step::idle, now, out);
}

void WaterLinkedJsonDialogue::compare(const water_linked_json::Response& answer, Output& out) {
  const auto read = water_linked_json::read_configuration(answer.result);
  if (!read) return tell("no values in the answer to ", {}, out);
  settings_hold_ = settings_agree(*wanted_, *read, out);
}

void WaterLinkedJsonDialogue::go_to(Step step, Stamp now, Output& out) {
  step_ = step;
  tries_ = 0;
  due_.reset();
  if (!finished()) ask(now, out);
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

void WaterLinkedJsonDialogue::tell(std::string_view trouble, std::string_view why,
                                   Output& out) const {
  Reason text{trouble};
  text += command();
  if (!why.empty()) text += ": ";
  text += why;
  out.report(text.view());
}

}  // namespace drydock::device
