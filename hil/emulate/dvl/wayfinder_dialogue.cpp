#include "hil/emulate/dvl/wayfinder_dialogue.hpp"

#include <algorithm>
#include <utility>

#include "drivers/wire/bytes.hpp"
#include "hil/emulate/dvl/wayfinder_structures.hpp"

namespace drydock::emulate {
namespace {

enum Commands : std::uint32_t {
  stop_pings = 0x0F,
  start_pings = 0x10,
  trigger = 0x11,
  restore_defaults = 0x17,
  get_features = 0x10000001,
  get_tests = 0x19000001,
  get_clock = 0x1D000001,
  put_clock = 0x1F000002,
  get_system = 0x81000001,
  get_setup = 0x85000001,
  put_sound_speed = 0x86000003,
  put_setup = 0x87000002,
};

bool is_got(std::uint32_t command) {
  return command == get_features || command == get_tests || command == get_clock ||
         command == get_system || command == get_setup;
}

bool is_set(std::uint32_t command) {
  return command == put_clock || command == put_setup || command == put_sound_speed;
}

bool is_sound_speed(float mps) { return mps >= 1400 && mps <= 1600; }

}  // namespace

enum class WayfinderDialogue::Status : std::uint8_t {
  done = 1,
  unknown = 2,
  wrong_parameter = 3,
  not_carried_out = 4,
  not_set = 5,
  not_while_it_pings = 7,
};

enum class WayfinderDialogue::Trouble : std::uint8_t {
  none = 0,
  baud = 1,
  trigger = 2,
  sound_speed = 3,
  longest_range = 4,
  clock = 5,
};

std::vector<std::uint8_t> WayfinderDialogue::answer(wire::Bytes command, Clock now, bool refuses) {
  const auto number = command.size() < 4 ? 0 : wire::load_le<std::uint32_t>(command, 0);
  trouble_ = Trouble::none;
  Status status = Status::done;
  if (refuses && !is_got(number))
    status = is_set(number) ? Status::not_set : Status::not_carried_out;
  else
    status = obey(number, command.subspan(std::min<std::size_t>(4, command.size())), now);
  std::vector<std::uint8_t> said(6);
  wire::store_le<std::uint32_t>(said, 0, number);
  said[4] = static_cast<std::uint8_t>(status);
  said[5] = static_cast<std::uint8_t>(trouble_);
  if (status != Status::done) return said;
  switch (number) {
    case get_clock: wayfinder::append_clock(said, now + clock_offset_); break;
    case get_system: wayfinder::append_system(said); break;
    case get_setup: wayfinder::append_setup(said, setup_); break;
    case get_tests: wayfinder::append_tests(said); break;
    case get_features: wayfinder::append_features(said); break;
    default: break;
  }
  return said;
}

WayfinderDialogue::Status WayfinderDialogue::obey(std::uint32_t command, wire::Bytes parameters,
                                                  Clock now) {
  if (is_got(command)) return Status::done;
  switch (command) {
    case stop_pings: pings_ = false; return Status::done;
    case start_pings: pings_ = true; return Status::done;
    case restore_defaults: setup_ = {}; return Status::done;
    case trigger:
      if (!pings_ || !setup_.software_trigger) return Status::not_carried_out;
      triggered_ = true;
      return Status::done;
    case put_sound_speed: return set_sound_speed(parameters);
    case put_clock: return pings_ ? Status::not_while_it_pings : set_clock(parameters, now);
    case put_setup: return pings_ ? Status::not_while_it_pings : set_setup(parameters);
    default: return Status::unknown;
  }
}

WayfinderDialogue::Status WayfinderDialogue::set_clock(wire::Bytes parameters, Clock now) {
  const auto clock = wayfinder::clock_of(parameters);
  if (!clock) return wrong(Trouble::clock);
  clock_offset_ = *clock - now;
  return Status::done;
}

WayfinderDialogue::Status WayfinderDialogue::set_setup(wire::Bytes parameters) {
  const auto asked = wayfinder::setup_of(parameters);
  if (!asked) return Status::wrong_parameter;
  if (asked->baud_type != 3 && asked->baud_type != 7) return wrong(Trouble::baud);
  if (!is_sound_speed(asked->sound_speed_mps)) return wrong(Trouble::sound_speed);
  if (!(asked->longest_range_m >= 1 && asked->longest_range_m <= 60))
    return wrong(Trouble::longest_range);
  setup_ = *asked;
  return Status::done;
}

WayfinderDialogue::Status WayfinderDialogue::set_sound_speed(wire::Bytes parameters) {
  if (parameters.size() < 4) return wrong(Trouble::sound_speed);
  const auto asked = wire::load_le<float>(parameters, 0);
  if (!is_sound_speed(asked)) return wrong(Trouble::sound_speed);
  setup_.sound_speed_mps = asked;
  return Status::done;
}

WayfinderDialogue::Status WayfinderDialogue::wrong(Trouble trouble) {
  trouble_ = trouble;
  return Status::wrong_parameter;
}

bool WayfinderDialogue::take_trigger() { return std::exchange(triggered_, false); }

}  // namespace drydock::emulate
