#pragma once

#include <array>
#include <memory>
#include <string_view>

#include "hil/emulate/sampling_device.hpp"

/// One emulated device per kind and protocol. docs/world/emulation.md describes what each one sends
/// and when, and what `primary` and `secondary` errors mean for it. For a new device, add its
/// function and its row in the table below.
namespace drydock::emulate {

using rig_config::DeviceKind;
using DevicePtr = std::unique_ptr<EmulatedDevice>;

/// One ensemble per sample, in the ship frame without tilts, which is the head's own axes.
DevicePtr make_pd0_dvl(const DeviceSetup& setup);

/// One report per sample, in the ship frame without tilts. PD5 also has the head's sensors.
DevicePtr make_pd4_dvl(const DeviceSetup& setup);
DevicePtr make_pd5_dvl(const DeviceSetup& setup);

/// One ensemble of ten lines per sample.
DevicePtr make_pd6_dvl(const DeviceSetup& setup);

/// Sends wrz, then wru for four transducers, per sample. Answers the command dialogue.
DevicePtr make_water_linked_dvl(const DeviceSetup& setup);

/// Sends a velocity report per sample and its dead reckoning five times a second. Answers commands.
DevicePtr make_water_linked_json_dvl(const DeviceSetup& setup);

/// One PNORBT9 per sample.
DevicePtr make_nortek_dvl(const DeviceSetup& setup);

/// One bottom track record (1B) per sample. Answers the command dialogue.
DevicePtr make_nortek_ad2cp_dvl(const DeviceSetup& setup);

/// One packet with data (05) per sample, in the instrument's axes. Answers binary commands.
DevicePtr make_wayfinder_dvl(const DeviceSetup& setup);

/// VBW (longitudinal and transverse speed), then VHW per sample, VLW once a second; talker VM.
DevicePtr make_nmea0183_em_log(const DeviceSetup& setup);

/// NAV-PVT, NAV-SAT, NAV-EOE per epoch.
DevicePtr make_ubx_gnss(const DeviceSetup& setup);

/// RMC, GGA, GSA, GSV, VTG, ZDA per epoch; talker GP.
DevicePtr make_nmea0183_gnss(const DeviceSetup& setup);

/// Address claim at boot, then SSI2, ACCS, ARI back to back per sample.
DevicePtr make_aceinna_imu(const DeviceSetup& setup);

/// Address claim at boot, then slope, acceleration and rate back to back per sample.
DevicePtr make_mv5_imu(const DeviceSetup& setup);

/// Boot-up message, heartbeat every second; after NMT start three TPDOs back to back per sample.
DevicePtr make_cia404_imu(const DeviceSetup& setup);

/// Like make_cia404_imu, with Epson's integers: TPDO1, 2 and 3 with one counter per sample. Sends
/// an emergency if the truth does not fit into the integers.
DevicePtr make_epson_g550(const DeviceSetup& setup);
DevicePtr make_epson_g552(const DeviceSetup& setup);

/// SampleTime, GroupCounter, StatusWord, RateOfTurn, Acceleration back to back per sample.
DevicePtr make_xsens_imu(const DeviceSetup& setup);

/// Time, acceleration, rate back to back per sample.
DevicePtr make_sbg_imu(const DeviceSetup& setup);

/// Address claim at boot, then 130314 (water pressure), 130312 (sea temperature) and 128267 (bed
/// below the transducer) per sample, with a common SID.
DevicePtr make_nmea2000_depth(const DeviceSetup& setup);

/// Boot-up message, heartbeat every second; after NMT start TPDO1 per sample, in the form, unit and
/// decimals of the configuration.
DevicePtr make_cia404_pressure(const DeviceSetup& setup);

/// Address claim at boot, then 127245 for rudder (instance 0), stern plane (1), bow plane (2) and
/// 127488 for the propeller per sample.
DevicePtr make_nmea2000_actuators(const DeviceSetup& setup);

/// Boot-up message, heartbeat every second; after NMT start TPDO1 per sample: status word and
/// actual value of one actuator.
DevicePtr make_cia402_drive(const DeviceSetup& setup);

/// Address claim at boot, then 128259 (speed through the water, electromagnetic) per sample, 128275
/// (distance) once a second.
DevicePtr make_nmea2000_log(const DeviceSetup& setup);

/// Address claim at boot, then 129026, 129029, 129025, 129539, 129540 per epoch with a common SID.
DevicePtr make_nmea2000_gnss(const DeviceSetup& setup);

/// Address claim at boot, then 127257 (tilt), 127250 (true heading) and 127251 (rate of turn) per
/// sample with a common SID.
DevicePtr make_nmea2000_attitude(const DeviceSetup& setup);

/// THS (mode A) and HDT per sample, talker HE; a magnetic compass HDG and HDM, talker HC.
DevicePtr make_nmea0183_attitude(const DeviceSetup& setup);

struct DeviceRow {
  DeviceKind kind;
  std::string_view protocol;
  DevicePtr (*make)(const DeviceSetup&);
};

/// The table of emulated devices: one row for each pair of kind and protocol.
inline constexpr auto device_rows = std::to_array<DeviceRow>({
    {DeviceKind::dvl, "pd0", make_pd0_dvl},
    {DeviceKind::dvl, "pd4", make_pd4_dvl},
    {DeviceKind::dvl, "pd5", make_pd5_dvl},
    {DeviceKind::dvl, "pd6", make_pd6_dvl},
    {DeviceKind::dvl, "water-linked", make_water_linked_dvl},
    {DeviceKind::dvl, "water-linked-json", make_water_linked_json_dvl},
    {DeviceKind::dvl, "nortek", make_nortek_dvl},
    {DeviceKind::dvl, "nortek-ad2cp", make_nortek_ad2cp_dvl},
    {DeviceKind::dvl, "wayfinder", make_wayfinder_dvl},
    {DeviceKind::emlog, "nmea0183", make_nmea0183_em_log},
    {DeviceKind::emlog, "nmea2000", make_nmea2000_log},
    {DeviceKind::gnss, "ubx", make_ubx_gnss},
    {DeviceKind::gnss, "nmea0183", make_nmea0183_gnss},
    {DeviceKind::gnss, "nmea2000", make_nmea2000_gnss},
    {DeviceKind::imu, "aceinna", make_aceinna_imu},
    {DeviceKind::imu, "microstrain-mv5", make_mv5_imu},
    {DeviceKind::imu, "cia404-imu", make_cia404_imu},
    {DeviceKind::imu, "epson-g550", make_epson_g550},
    {DeviceKind::imu, "epson-g552", make_epson_g552},
    {DeviceKind::imu, "xsens", make_xsens_imu},
    {DeviceKind::imu, "sbg", make_sbg_imu},
    {DeviceKind::depth, "nmea2000", make_nmea2000_depth},
    {DeviceKind::depth, "cia404-pressure", make_cia404_pressure},
    {DeviceKind::actuator, "nmea2000", make_nmea2000_actuators},
    {DeviceKind::actuator, "cia402", make_cia402_drive},
    {DeviceKind::attitude, "nmea2000", make_nmea2000_attitude},
    {DeviceKind::attitude, "nmea0183", make_nmea0183_attitude},
});

}  // namespace drydock::emulate
