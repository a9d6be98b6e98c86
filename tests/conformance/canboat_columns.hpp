#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <span>
#include <string_view>

#include "tests/conformance/reading.hpp"

/// The PGNs that Drydock reads: canboat's name of each field beside ours, in the unit and
/// resolution of canboat's analyzer.
namespace drydock::conformance::canboat {

/// How canboat prints a value without -si: ours * scale + offset, to that resolution.
struct Shown {
  double resolution = 0, scale = 1, offset = 0;
};
inline constexpr Shown as_is{}, in_degrees{0.1, degree}, in_degrees_per_second{2e-6, degree},
    in_celsius{0.01, 1, -273.15}, in_bar{0.001, 1e-5};

/// Our value in canboat's unit is ours * scale.
struct Column {
  const char* theirs;
  const char* ours;
  double resolution, scale = 1;
  Shown shown = as_is;  ///< without -si, if otherwise
};

inline constexpr double rpm = 30 / std::numbers::pi;

inline constexpr std::array rudder{
    Column{"Instance", "instance", 1}, Column{"Direction Order", "direction_order", 1},
    Column{"Angle Order", "angle_order_rad", 1e-4}, Column{"Position", "position_rad", 1e-4}};
inline constexpr std::array engine{
    Column{"Instance", "instance", 1}, Column{"Speed", "speed_radps", 0.25, rpm},
    Column{"Boost Pressure", "boost_pressure_pa", 100}, Column{"Tilt/Trim", "tilt_percent", 1}};
inline constexpr std::array water_depth{
    Column{"SID", "sequence", 1}, Column{"Depth", "depth_m", 0.01},
    Column{"Offset", "offset_m", 0.001}, Column{"Range", "maximum_range_m", 10}};
inline constexpr std::array gnss_position{Column{"SID", "sequence", 1},
                                          Column{"Latitude", "latitude_rad", 1e-7, degree},
                                          Column{"Longitude", "longitude_rad", 1e-7, degree},
                                          Column{"Altitude", "altitude_m", 1e-6},
                                          Column{"GNSS type", "system", 1},
                                          Column{"Method", "method", 1},
                                          Column{"Number of SVs", "satellites", 1},
                                          Column{"HDOP", "horizontal_dop", 0.01},
                                          Column{"PDOP", "position_dop", 0.01},
                                          Column{"Geoidal Separation", "geoid_height_m", 0.01},
                                          Column{"Integrity", "integrity", 1},
                                          Column{"Reference Stations", "reference_stations", 1}};
inline constexpr std::array temperature{
    Column{"SID", "sequence", 1}, Column{"Instance", "instance", 1}, Column{"Source", "kind", 1},
    Column{"Actual Temperature", "actual_k", 0.01}, Column{"Set Temperature", "set_k", 0.01}};
inline constexpr std::array pressure{Column{"SID", "sequence", 1},
                                     Column{"Instance", "instance", 1}, Column{"Source", "kind", 1},
                                     Column{"Pressure", "pressure_pa", 0.1}};
inline constexpr std::array address_claim{
    Column{"Unique Number", "identity_number", 1},
    Column{"Manufacturer Code", "manufacturer_code", 1},
    Column{"Device Instance Lower", "ecu_instance", 1},
    Column{"Device Instance Upper", "function_instance", 1},
    Column{"Device Function", "function", 1},
    Column{"Device Class", "vehicle_system", 1},
    Column{"System Instance", "vehicle_system_instance", 1},
    Column{"Industry Group", "industry_group", 1},
    Column{"Arbitrary address capable", "arbitrary_address_capable", 1}};
inline constexpr std::array request{Column{"PGN", "requested_pgn", 1}};

inline constexpr std::array heading{
    Column{"SID", "sequence", 1}, Column{"Heading", "heading_rad", 1e-4, 1, in_degrees},
    Column{"Deviation", "deviation_rad", 1e-4, 1, in_degrees},
    Column{"Variation", "variation_rad", 1e-4, 1, in_degrees}, Column{"Reference", "reference", 1}};
inline constexpr std::array rate_of_turn{
    Column{"SID", "sequence", 1}, Column{"Rate", "rate_radps", 3.125e-8, 1, in_degrees_per_second}};
inline constexpr std::array heave{Column{"SID", "sequence", 1}, Column{"Heave", "heave_m", 0.01}};
inline constexpr std::array attitude{Column{"SID", "sequence", 1},
                                     Column{"Yaw", "yaw_rad", 1e-4, 1, in_degrees},
                                     Column{"Pitch", "pitch_rad", 1e-4, 1, in_degrees},
                                     Column{"Roll", "roll_rad", 1e-4, 1, in_degrees}};
inline constexpr std::array variation{Column{"SID", "sequence", 1}, Column{"Source", "model", 1},
                                      Column{"Age of service", "date_days", 1},
                                      Column{"Variation", "variation_rad", 1e-4, 1, in_degrees}};
inline constexpr std::array speed{
    Column{"SID", "sequence", 1}, Column{"Speed Water Referenced", "water_mps", 0.01},
    Column{"Speed Ground Referenced", "ground_mps", 0.01},
    Column{"Speed Water Referenced Type", "sensor", 1}, Column{"Speed Direction", "direction", 1}};
inline constexpr std::array distance_log{Column{"Log", "total_m", 1},
                                         Column{"Trip Log", "trip_m", 1}};
inline constexpr std::array heading_control{
    Column{"Rudder Limit Exceeded", "rudder_limit_exceeded", 1},
    Column{"Off-Heading Limit Exceeded", "off_heading_limit_exceeded", 1},
    Column{"Off-Track Limit Exceeded", "off_track_limit_exceeded", 1},
    Column{"Override", "override_active", 1},
    Column{"Steering Mode", "steering_mode", 1},
    Column{"Turn Mode", "turn_mode", 1},
    Column{"Heading Reference", "reference", 1},
    Column{"Commanded Rudder Direction", "commanded_rudder_direction", 1},
    Column{"Commanded Rudder Angle", "commanded_rudder_rad", 1e-4},
    Column{"Heading-To-Steer (Course)", "heading_to_steer_rad", 1e-4},
    Column{"Track", "track_rad", 1e-4},
    Column{"Rudder Limit", "rudder_limit_rad", 1e-4},
    Column{"Off-Heading Limit", "off_heading_limit_rad", 1e-4},
    Column{"Radius of Turn Order", "turn_radius_m", 1},
    Column{"Rate of Turn Order", "commanded_rate_radps", 3.125e-5},
    Column{"Off-Track Limit", "off_track_limit_m", 1},
    Column{"Vessel Heading", "heading_rad", 1e-4}};
inline constexpr std::array rapid_position{Column{"Latitude", "latitude_rad", 1e-7, degree},
                                           Column{"Longitude", "longitude_rad", 1e-7, degree}};
inline constexpr std::array course_and_speed{
    Column{"SID", "sequence", 1}, Column{"COG Reference", "reference", 1},
    Column{"COG", "course_rad", 1e-4, 1, in_degrees}, Column{"SOG", "speed_mps", 0.01}};
inline constexpr std::array dilutions{Column{"SID", "sequence", 1},
                                      Column{"Desired Mode", "desired_mode", 1},
                                      Column{"Actual Mode", "actual_mode", 1},
                                      Column{"HDOP", "horizontal_dop", 0.01},
                                      Column{"VDOP", "vertical_dop", 0.01},
                                      Column{"TDOP", "time_dop", 0.01}};
inline constexpr std::array satellites_in_view{Column{"SID", "sequence", 1},
                                               Column{"Range Residual Mode", "residual_mode", 1},
                                               Column{"Sats in View", "in_view", 1}};
inline constexpr std::array satellite{Column{"PRN", "number", 1},
                                      Column{"Elevation", "elevation_rad", 1e-4, 1, in_degrees},
                                      Column{"Azimuth", "azimuth_rad", 1e-4, 1, in_degrees},
                                      Column{"SNR", "snr_db", 0.01},
                                      Column{"Range residuals", "residual_m", 1e-5},
                                      Column{"Status", "status", 1},
                                      Column{"GNSS System", "system", 1}};
inline constexpr std::array water_and_air{
    Column{"SID", "sequence", 1}, Column{"Water Temperature", "water_k", 0.01, 1, in_celsius},
    Column{"Outside Ambient Air Temperature", "air_k", 0.01, 1, in_celsius},
    Column{"Atmospheric Pressure", "air_pressure_pa", 100, 1, in_bar}};
inline constexpr std::array environment{
    Column{"SID", "sequence", 1},
    Column{"Temperature Source", "kind", 1},
    Column{"Humidity Source", "humidity_kind", 1},
    Column{"Temperature", "temperature_k", 0.01, 1, in_celsius},
    Column{"Humidity", "humidity_percent", 0.004},
    Column{"Atmospheric Pressure", "air_pressure_pa", 100, 1, in_bar}};
inline constexpr std::array system_time{Column{"SID", "sequence", 1}, Column{"Source", "clock", 1}};

/// A PGN that Drydock reads.
struct Message {
  std::uint32_t pgn;
  std::string_view type;
  std::span<const Column> columns;
};
inline constexpr std::array messages{
    Message{127245, "rudder", rudder},
    Message{127488, "engine", engine},
    Message{128267, "water_depth", water_depth},
    Message{129029, "gnss_position", gnss_position},
    Message{130312, "temperature", temperature},
    Message{130314, "pressure", pressure},
    Message{126992, "system_time", system_time},
    Message{127237, "heading_control", heading_control},
    Message{127250, "vessel_heading", heading},
    Message{127251, "turn_rate", rate_of_turn},
    Message{127252, "heave", heave},
    Message{127257, "attitude", attitude},
    Message{127258, "magnetic_variation", variation},
    Message{128259, "speed", speed},
    Message{128275, "distance_log", distance_log},
    Message{129025, "rapid_position", rapid_position},
    Message{129026, "course_and_speed", course_and_speed},
    Message{129539, "dilutions", dilutions},
    Message{129540, "satellites_in_view", satellites_in_view},
    Message{130310, "water_and_air", water_and_air},
    Message{130311, "environment", environment},
    Message{60928, "address_claimed", address_claim},
    Message{59904, "request", request},
};

}  // namespace drydock::conformance::canboat
