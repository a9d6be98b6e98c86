#include "drivers/recordings/slice/move_understood.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "drivers/measurement/units.hpp"
#include "drivers/wire/bytes.hpp"
#include "drivers/wire/fields.hpp"

namespace drydock::slice {

namespace {

constexpr std::string_view nav_sat_fix = "sensor_msgs/msg/NavSatFix";
constexpr std::string_view gnss_fix = "drydock/msg/GnssFix";

constexpr std::array placeless{nav_sat_fix,
                               gnss_fix,
                               std::string_view("sensor_msgs/msg/Imu"),
                               std::string_view("sensor_msgs/msg/FluidPressure"),
                               std::string_view("sensor_msgs/msg/Temperature"),
                               std::string_view("geometry_msgs/msg/TwistWithCovarianceStamped"),
                               std::string_view("marine_acoustic_msgs/msg/Dvl"),
                               std::string_view("diagnostic_msgs/msg/DiagnosticArray"),
                               std::string_view("drydock/msg/Depth"),
                               std::string_view("drydock/msg/BottomTrack"),
                               std::string_view("drydock/msg/WaterSpeed"),
                               std::string_view("drydock/msg/ActuatorState")};

struct FindStamps {
  std::vector<std::size_t> at{};

  void enter(const record::MessageNode& node, std::size_t offset) {
    if (node.type == "builtin_interfaces/Time") at.push_back((offset + 3) / 4 * 4);
  }
  void leave(const record::MessageNode&) {}
  void begin(const record::MessageNode&, std::size_t) {}
  void end(const record::MessageNode&) {}
  void value(const record::MessageNode&, std::size_t, mcap::Bytes) {}
};

struct FindPosition {
  std::optional<std::size_t> latitude{}, longitude{}, height{};

  void enter(const record::MessageNode&, std::size_t) {}
  void leave(const record::MessageNode&) {}
  void begin(const record::MessageNode&, std::size_t) {}
  void end(const record::MessageNode&) {}
  void value(const record::MessageNode& node, std::size_t offset, mcap::Bytes) {
    if (node.name == "latitude") latitude = offset;
    if (node.name == "longitude") longitude = offset;
    if (node.name == "altitude" || node.name == "ellipsoidal_height") height = offset;
  }
};

}  // namespace

bool may_be_kept(std::string_view type) {
  return std::ranges::find(placeless, type) != placeless.end();
}

void shift_stamps(const record::MessageNode& layout, std::span<std::uint8_t> cdr,
                  std::chrono::nanoseconds shift) {
  constexpr std::int64_t second = 1'000'000'000;
  FindStamps stamps;
  if (!record::visit_message(layout, cdr, stamps)) return;
  for (const std::size_t at : stamps.at) {
    const std::int64_t ns = wire::load_le<std::int32_t>(cdr, at) * second +
                            wire::load_le<std::uint32_t>(cdr, at + 4) + shift.count();
    const std::int64_t whole = ns >= 0 ? ns / second : (ns - second + 1) / second;
    wire::store_le<std::int32_t>(cdr, at, static_cast<std::int32_t>(whole));
    wire::store_le<std::uint32_t>(cdr, at + 4, static_cast<std::uint32_t>(ns - whole * second));
  }
}

bool move_position(std::string_view type, const record::MessageNode& layout,
                   std::span<std::uint8_t> cdr, Displacement& place) {
  if (type != nav_sat_fix && type != gnss_fix) return false;
  FindPosition found;
  if (!record::visit_message(layout, cdr, found) || !found.latitude || !found.longitude)
    return false;
  if (found.height)
    wire::store_le<double>(cdr, *found.height, std::numeric_limits<double>::quiet_NaN());
  const double unit = type == nav_sat_fix ? units::degree : 1;
  const measurement::Geodetic old{wire::load_le<double>(cdr, *found.latitude) * unit,
                                  wire::load_le<double>(cdr, *found.longitude) * unit};
  if (!std::isfinite(old.latitude_rad) || !std::isfinite(old.longitude_rad)) return false;
  place.start_at(old);
  wire::store_le<double>(cdr, *found.latitude, place.latitude(old.latitude_rad) / unit);
  wire::store_le<double>(cdr, *found.longitude, place.longitude(old.longitude_rad) / unit);
  return true;
}

}  // namespace drydock::slice
