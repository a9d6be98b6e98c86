#include <fmt/format.h>

#include <array>

#include "drivers/wire/described/frame_plan.hpp"
#include "rig_config/device_description/plan_reader.hpp"

namespace drydock::rig_config {
namespace {

namespace described = wire::described;
using described::Kind;
using described::Target;
using enum described::Target;

/// What has a value only if all of its components came in one sample.
struct Whole {
  Kind kind;
  const char* needs;
  std::span<const Target> components;
};

constexpr std::array inertial{force_x, force_y, force_z, rate_x, rate_y, rate_z};
constexpr std::array bottom_track{forward, starboard, down};
constexpr std::array covariance{covariance_xx, covariance_xy, covariance_xz,
                                covariance_yx, covariance_yy, covariance_yz,
                                covariance_zx, covariance_zy, covariance_zz};
constexpr std::array position{latitude, longitude};
constexpr std::array ground_velocity{north, east, down};
constexpr std::array rotation{quaternion_w, quaternion_x, quaternion_y, quaternion_z};
constexpr std::array enu_rotation{enu_quaternion_w, enu_quaternion_x, enu_quaternion_y,
                                  enu_quaternion_z};

constexpr std::array<Whole, 7> wholes{{
    {Kind::imu, "a sample of an IMU has three forces and three rates", inertial},
    {Kind::dvl, "a velocity has three components", bottom_track},
    {Kind::dvl, "a covariance has nine entries", covariance},
    {Kind::gnss, "a position has a latitude and a longitude", position},
    {Kind::gnss, "a velocity has three components", ground_velocity},
    {Kind::attitude, "a quaternion has four components", rotation},
    {Kind::attitude, "a quaternion has four components", enu_rotation},
}};

/// The first message of the sample in which each message takes part.
std::vector<std::size_t> first_of(const described::Description& description) {
  const auto& messages = description.plan.messages;
  std::vector<std::size_t> first(messages.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    first[i] = messages[i].follows ? first[*messages[i].follows] : i;
    for (std::size_t j = 0; description.frames && j < i; ++j)
      if (description.frames->frames[j].sample == description.frames->frames[i].sample)
        first[i] = std::min(first[i], j);
  }
  return first;
}

/// Components that the messages of a sample do not measure, each behind a blank. Empty: all are
/// there, or none is.
std::string missing(const described::Plan& plan, std::span<const std::size_t> first,
                    std::size_t sample, const Whole& whole) {
  std::string names;
  std::size_t absent = 0;
  for (const Target component : whole.components) {
    bool found = false;
    for (std::size_t i = sample; i < first.size(); ++i)
      for (const auto& field : plan.fields_of(plan.messages[i]))
        found |= first[i] == sample && field.target == component;
    if (found) continue;
    names += fmt::format(" {}", row_of(component).name);
    ++absent;
  }
  return absent == whole.components.size() ? "" : names;
}

/// True if the sample has the time of day of a UTC, and not its date.
bool lacks_date(const described::Plan& plan, std::span<const std::size_t> first,
                std::size_t sample) {
  bool of_day = false, dated = false;
  for (std::size_t i = sample; i < first.size(); ++i)
    for (const auto& field : plan.fields_of(plan.messages[i])) {
      if (first[i] != sample) continue;
      of_day |= field.target == utc && field.notation.digits == described::Digits::clock;
      dated |= field.target == date;
    }
  return of_day && !dated;
}

}  // namespace

Problems check_whole(const described::Description& description, std::span<const Node> tables,
                     const std::string& file, const std::string& path) {
  const auto first = first_of(description);
  Problems problems;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] != i) continue;
    const auto add = [&](std::string_view needs, std::string_view names) {
      problems.push_back(
          {file, tables[i].at.line, tables[i].at.column, fmt::format("{}/{}", path, i),
           fmt::format("{}; this one lacks{}; messages with one 'sample' make one", needs, names)});
    };
    if (lacks_date(description.plan, first, i)) add("a UTC has a time and a date", " date_s");
    for (const Whole& whole : wholes) {
      if (whole.kind != description.kind) continue;
      if (const auto names = missing(description.plan, first, i, whole); !names.empty())
        add(whole.needs, names);
    }
  }
  return problems;
}

}  // namespace drydock::rig_config
