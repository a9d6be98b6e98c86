#include "drivers/device/clock_reader.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace drydock::device {
namespace {

using measurement::MessageTimes;
using std::chrono::nanoseconds;
using namespace std::chrono_literals;

constexpr nanoseconds place{10};  ///< of one byte or frame
constexpr unsigned baud_of_places = 1'000'000'000, slow_places = 2;

/// A byte takes `places`, and so do the bits of a CAN frame at most.
DriverOptions on_places(DriverOptions options, unsigned places = 1) {
  options.baud = options.bitrate = baud_of_places / places;
  options.byte_frame = {};
  return options;
}

/// How long ago a device took what it sends, and the bytes that the line carried since it began to.
struct Age {
  nanoseconds at_first_byte{};
  std::uint64_t bytes = 0;
};

/// On a line of half the rate a message is older by what its bytes take once more.
Age age_of_bytes(nanoseconds age, nanoseconds age_on_slow_line) {
  const nanoseconds of_bytes = std::max(age_on_slow_line - age, 0ns);
  return {std::max(age - of_bytes, 0ns), static_cast<std::uint64_t>(of_bytes / place)};
}

/// What frames take at their places is below the shortest.
Age age_of_frames(nanoseconds age) {
  constexpr nanoseconds shortest = 100us;
  return {age < shortest ? 0ns : age, 0};
}

/// Not every message tells its age: such a one was sent behind the one before all the same.
MessageTimes sent_times(const std::vector<PlacedOutput::Told>& told,
                        const std::vector<PlacedOutput::Told>& told_on_slow_line) {
  const bool bytes = told.size() == told_on_slow_line.size();
  MessageTimes times;
  nanoseconds clock{};  // that the last of them told
  for (std::size_t i = 0; i < told.size(); ++i) {
    const Age age =
        bytes ? age_of_bytes(told[i].age, told_on_slow_line[i].age) : age_of_frames(told[i].age);
    nanoseconds sent_at = told[i].clock + age.at_first_byte;
    if (i > 0 && told[i].clock >= clock) sent_at = std::max(sent_at, times.back().at);
    clock = told[i].clock;
    times.push_back({told[i].through, sent_at, age.bytes});
  }
  return times;
}

/// A clock that counts within a day or a week begins anew with a small step.
nanoseconds step_of(nanoseconds from, nanoseconds to) {
  const nanoseconds step = to - from;
  if (step >= 0ns) return step;
  for (const nanoseconds turn : {nanoseconds{24h}, nanoseconds{7 * 24h}})
    if (step + turn >= 0ns && step + turn < 1h) return step + turn;
  return step;
}

bool is_jump(nanoseconds step) { return step < 0ns || step > 24h; }

/// Messages of one instant may tell it with more and with fewer decimals, or change places.
bool is_rounding(nanoseconds step, nanoseconds usual) {
  return step < 0ns && -step < std::min<nanoseconds>(usual / 2, 100ms);
}

/// The median of the steps forward; zero if there are none.
nanoseconds usual_step(const MessageTimes& told) {
  std::vector<nanoseconds> steps;
  for (std::size_t i = 1; i < told.size(); ++i) {
    const nanoseconds step = step_of(told[i - 1].at, told[i].at);
    if (step > 0ns && !is_jump(step)) steps.push_back(step);
  }
  if (steps.empty()) return 0ns;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::ranges::nth_element(steps, middle);
  return *middle;
}

}  // namespace

RecordedTimes times_in_order(const MessageTimes& told) {
  RecordedTimes times;
  const nanoseconds usual = usual_step(told);
  if (usual == 0ns) return times;
  times.usual_step = usual;
  times.messages.push_back(told.front());
  nanoseconds ahead{};  // the last time, of the clock
  for (std::size_t i = 1; i < told.size(); ++i) {
    nanoseconds step = step_of(told[i - 1].at, told[i].at);
    const bool jumps = is_jump(step) && !is_rounding(step, usual);
    times.jumps += jumps;
    if (jumps) step = usual;
    const nanoseconds forward = std::max(0ns, step - ahead);
    ahead += forward - step;
    times.messages.push_back({told[i].through, times.messages.back().at + forward, told[i].bytes});
  }
  // A number that falls as often as it rises is no time.
  constexpr std::size_t fewest_steps_a_jump = 10;
  if (times.jumps * fewest_steps_a_jump > told.size()) times.messages.clear();
  return times;
}

boost::system::result<ClockReader, DriverError> ClockReader::make(DriverOptions options,
                                                                  Travels travels) {
  if (travels == Travels::as_frames) {
    auto driver = make_frame_driver(on_places(std::move(options)));
    if (!driver) return driver.error();
    return ClockReader(AnyDriver(std::move(*driver)), nullptr);
  }
  auto slow = make_byte_driver(on_places(options, slow_places));
  auto driver = make_byte_driver(on_places(std::move(options)));
  if (!driver) return driver.error();
  return ClockReader(AnyDriver(std::move(*driver)), std::move(*slow));
}

ClockReader::ClockReader(AnyDriver driver, std::unique_ptr<ByteDriver> slow)
    : driver_(std::move(driver)),
      slow_(std::move(slow)),
      output_(place),
      slow_output_(place * slow_places) {}

void ClockReader::feed(wire::Bytes bytes) {
  now_ += place * static_cast<std::int64_t>(bytes.size());
  std::get<std::unique_ptr<ByteDriver>>(driver_)->receive(bytes, now_, output_);
  slow_->receive(bytes, Stamp{now_.time_since_epoch() * slow_places}, slow_output_);
}

void ClockReader::feed(const wire::CanFrame& frame) {
  now_ += place;
  std::get<std::unique_ptr<FrameDriver>>(driver_)->receive(frame, now_, output_);
}

RecordedTimes ClockReader::finish() {
  std::visit([this](auto& driver) { driver->finish(output_); }, driver_);
  if (slow_) slow_->finish(slow_output_);
  return times_in_order(sent_times(output_.told(), slow_output_.told()));
}

void PlacedOutput::publish(const Measurement& measurement) {
  const measurement::Origin& origin = measurement::origin_of(measurement);
  const auto through = static_cast<std::uint64_t>(origin.received_at.time_since_epoch() / place_);
  if (places_.empty() || through > places_.back()) places_.push_back(through);
  if (!origin.device_time) return;
  if (!told_.empty() && through <= told_.back().through) return;
  told_.push_back({through, *origin.device_time, origin.received_at - origin.valid_at});
}

}  // namespace drydock::device
