#include "drivers/device/dvl/water_linked_dialogue.hpp"

#include "drivers/device/dvl/water_linked_settings.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::device {

namespace {

namespace water_linked = wire::water_linked;

using namespace water_linked_patience;

constexpr int known_major_version = 2;

}  // namespace

void WaterLinkedDialogue::start(Stamp now, Output& out) {
  stop();
  refusal_ = {};
  sound_speed_mps_.reset();
  if (!wanted_) return;
  settings_hold_ = nothing_to_set(*wanted_);
  step_ = Step::version;
  tries_ = 0;
  ask(now, out);
}

void WaterLinkedDialogue::stop() {
  step_ = Step::idle;
  gave_up_ = false;
  due_.reset();
}

void WaterLinkedDialogue::tick(Stamp now, Output& out) {
  if (!due_ || now < *due_) return;
  if (gave_up_) return start(now, out);
  if (tries_ < most_tries) return ask(now, out);
  if (!replayed_) tell("no answer to", out);
  settings_hold_ = true;
  gave_up_ = true;
  due_ = now + start_again_after;
}

void WaterLinkedDialogue::receive(const wire::WaterLinked::Message& message, Stamp now,
                                  Output& out) {
  if (step_ == Step::idle) return;
  std::visit([&](const auto& sentence) { on(sentence, now, out); }, message);
}

void WaterLinkedDialogue::on(const water_linked::Version& version, Stamp now, Output& out) {
  if (step_ != Step::version) return;
  if (version.major != known_major_version) {
    out.report("the DVL speaks another major version of its protocol than 2");
  }
  next(now, out);
}

void WaterLinkedDialogue::on(const water_linked::Configuration& read, Stamp now, Output& out) {
  if (step_ != Step::check) return;
  const auto agreement = compare(*wanted_, read, out);
  settings_hold_ = agreement.velocities;
  sound_speed_mps_ = read.sound_speed_mps;
  // Of several troubles health shows the last: a refusal tells more than the values that it left.
  if (!refusal_.empty())
    out.report(refusal_.view());
  else if (!agreement.settings && !nothing_to_set(*wanted_))
    out.report(keeps_other_values("wcs").view());
  next(now, out);
}

void WaterLinkedDialogue::on(const water_linked::Answer& answer, Stamp now, Output& out) {
  using enum water_linked::Verdict;
  switch (answer.verdict) {
    case done:
      if (step_ == Step::set || step_ == Step::output) next(now, out);
      return;
    case refused:
      tell("the DVL refuses", out);
      if (step_ == Step::set) refusal_ = in_words("the DVL refuses");
      return next(now, out);
    case not_understood: return ask_again_or("the DVL does not understand", now, out);
    case bad_checksum: return ask_again_or("the DVL hears with a bad checksum", now, out);
  }
}

void WaterLinkedDialogue::ask_again_or(std::string_view trouble, Stamp now, Output& out) {
  if (tries_ < most_tries) return ask(now, out);
  tell(trouble, out);
  next(now, out);
}

void WaterLinkedDialogue::next(Stamp now, Output& out) {
  step_ = static_cast<Step>(static_cast<int>(step_) + 1);
  if (step_ == Step::set && nothing_to_set(*wanted_)) step_ = Step::check;
  tries_ = 0;
  gave_up_ = false;  // a slow answer is one too
  due_.reset();
  if (!finished()) ask(now, out);
}

void WaterLinkedDialogue::ask(Stamp now, Output& out) {
  ++tries_;
  due_ = now + answer_within;
  std::array<std::uint8_t, 96> line;
  const std::size_t size = write_command(line);
  const std::string_view text = wire::as_text({line.data(), size});
  command_ = FixedText<64>{text.substr(0, text.rfind('*'))};
  out.send(std::span{line}.first(size));
}

std::size_t WaterLinkedDialogue::write_command(std::span<std::uint8_t> to) const {
  switch (step_) {
    case Step::version: return encode(water_linked::Command{'v', {}}, to);
    case Step::set: return water_linked::encode_settings(to_set(*wanted_), to);
    case Step::check: return encode(water_linked::Command{'c', {}}, to);
    case Step::output:
      return encode(water_linked::Command{'p', wanted_->old_sentences ? "1" : "3"}, to);
    case Step::idle: return 0;
  }
  return 0;
}

Reason WaterLinkedDialogue::in_words(std::string_view trouble) const {
  Reason text{trouble};
  text += " \"";
  text += command_.view();
  text += "\"";
  return text;
}

}  // namespace drydock::device
