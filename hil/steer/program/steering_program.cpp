#include "hil/steer/program/steering_program.hpp"

#include <utility>

#include "drivers/text/json_lines.hpp"
#include "hil/steer/program/steering_hello.hpp"
#include "hil/steer/program/told_truth.hpp"

namespace drydock::steer {
namespace {

std::vector<std::string> names_of(const SteeringProgram::Devices& devices) {
  std::vector<std::string> names;
  for (const auto& device : devices) names.push_back(device.name);
  return names;
}

external::ProgramOptions program_of(const rig_config::SteeringConfig& steering,
                                    JointHelm::Say say) {
  return {.command = steering.command,
          .folder = steering.folder,
          .name = "steering",
          .lockstep = true,
          .answer_within = measurement::from_seconds(steering.answer_within_s),
          .say = std::move(say)};
}

}  // namespace

SteeringProgram::SteeringProgram(const std::string& rig, const rig_config::MissionConfig& mission,
                                 const Devices& devices, JointHelm& helm, JointHelm::Say say)
    : tells_truth_(mission.steering.value().truth),
      names_(names_of(devices)),
      lines_(names_),
      helm_(helm),
      dialogue_(
          program_of(*mission.steering, std::move(say)),
          hello_of(rig, mission.steering->step_s, helm.joints(), devices),
          [this](std::string_view line) {
            answer_ = read_orders(line, helm_.joints());
            return answer_.heard;
          },
          [this] { obey(); }) {}

void SteeringProgram::receive(const measurement::Measurement& measurement) {
  std::visit([this](const auto& sample) { samples_.emplace_back(sample); }, measurement);
}

void SteeringProgram::end_step(Stamp now, const motion::Truth& truth) {
  now_ = now;
  if (dialogue_.begin_step(now)) {
    ++step_;
    dialogue_.send(step_, line_of(now, truth));
  }
  samples_.clear();
}

std::string_view SteeringProgram::line_of(Stamp now, const motion::Truth& truth) {
  const std::string_view line = lines_.line_of({step_, now, samples_});
  if (!tells_truth_) return line;
  text::JsonText text;
  text::JsonWriter(text).value(ToldTruth{truth});
  line_ = line.substr(0, line.size() - 1);
  line_ += ",\"truth\":";
  line_ += text.view();
  line_ += '}';
  return line_;
}

void SteeringProgram::obey() {
  if (!answer_.orders.empty()) helm_.order(answer_.orders, now_);
  if (answer_.wrench) helm_.order(*answer_.wrench, now_);
}

}  // namespace drydock::steer
