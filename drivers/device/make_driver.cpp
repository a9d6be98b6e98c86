#include "drivers/device/make_driver.hpp"

#include <array>
#include <boost/throw_exception.hpp>
#include <stdexcept>

#include "drivers/device/described/described_driver.hpp"
#include "drivers/device/described/described_frame_driver.hpp"
#include "drivers/device/dvl/dvl_driver.hpp"
#include "drivers/device/dvl/nortek_ad2cp_driver.hpp"
#include "drivers/device/dvl/nortek_driver.hpp"
#include "drivers/device/dvl/pd4_driver.hpp"
#include "drivers/device/dvl/pd6_driver.hpp"
#include "drivers/device/dvl/water_linked_driver.hpp"
#include "drivers/device/dvl/water_linked_json_driver.hpp"
#include "drivers/device/dvl/wayfinder_driver.hpp"
#include "drivers/device/gnss/gnss_driver.hpp"
#include "drivers/device/gnss/nmea2000_gnss_driver.hpp"
#include "drivers/device/imu/aceinna_imu_driver.hpp"
#include "drivers/device/imu/cia404_imu_driver.hpp"
#include "drivers/device/imu/mv5_imu_driver.hpp"
#include "drivers/device/imu/sbg_imu_driver.hpp"
#include "drivers/device/imu/xsens_imu_driver.hpp"
#include "drivers/device/vessel/actuator_driver.hpp"
#include "drivers/device/vessel/attitude_driver.hpp"
#include "drivers/device/vessel/cia402_driver.hpp"
#include "drivers/device/vessel/cia404_pressure_driver.hpp"
#include "drivers/device/vessel/depth_driver.hpp"
#include "drivers/device/vessel/emlog_driver.hpp"
#include "drivers/device/vessel/nmea2000_attitude_driver.hpp"
#include "drivers/device/vessel/nmea2000_log_driver.hpp"

namespace drydock::device {

namespace {

using ByteDriverPtr = std::unique_ptr<ByteDriver>;
using FrameDriverPtr = std::unique_ptr<FrameDriver>;

template <class Interface, class Implementation>
std::unique_ptr<Interface> make(const DriverOptions& options) {
  return std::make_unique<Implementation>(options);
}

/// The registry of drivers: one row for each pair of sensor kind and protocol.
struct Row {
  Kind kind;
  ProtocolEntry protocol;
  ByteDriverPtr (*make_byte)(const DriverOptions&);
  FrameDriverPtr (*make_frame)(const DriverOptions&);
};

template <class Implementation>
constexpr Row byte_row(Kind kind, std::string_view protocol) {
  return {kind, {protocol, Travels::as_bytes}, make<ByteDriver, Implementation>, nullptr};
}

template <class Implementation>
constexpr Row frame_row(Kind kind, std::string_view protocol) {
  return {kind, {protocol, Travels::as_frames}, nullptr, make<FrameDriver, Implementation>};
}

constexpr std::array rows{
    byte_row<DvlDriver>(Kind::dvl, wire::Pd0::name),
    byte_row<Pd4Driver<wire::Pd4>>(Kind::dvl, wire::Pd4::name),
    byte_row<Pd4Driver<wire::Pd5>>(Kind::dvl, wire::Pd5::name),
    byte_row<Pd6Driver>(Kind::dvl, wire::Pd6::name),
    byte_row<WaterLinkedDriver>(Kind::dvl, wire::WaterLinked::name),
    byte_row<WaterLinkedJsonDriver>(Kind::dvl, wire::WaterLinkedJson::name),
    byte_row<NortekDriver>(Kind::dvl, wire::Nortek::name),
    byte_row<NortekAd2cpDriver>(Kind::dvl, wire::NortekAd2cp::name),
    byte_row<WayfinderDriver>(Kind::dvl, wire::Wayfinder::name),
    byte_row<EmLogDriver>(Kind::emlog, wire::Nmea0183::name),
    frame_row<Nmea2000LogDriver>(Kind::emlog, wire::Nmea2000::name),
    byte_row<GnssDriver>(Kind::gnss, wire::Ubx::name),
    byte_row<GnssDriver>(Kind::gnss, wire::Nmea0183::name),
    byte_row<GnssDriver>(Kind::gnss, wire::UbxNmea::name),
    frame_row<Nmea2000GnssDriver>(Kind::gnss, wire::Nmea2000::name),
    frame_row<AceinnaImuDriver>(Kind::imu, wire::Aceinna::name),
    frame_row<Mv5ImuDriver>(Kind::imu, wire::Mv5::name),
    frame_row<Cia404ImuDriver<wire::Cia404Imu>>(Kind::imu, wire::Cia404Imu::name),
    frame_row<Cia404ImuDriver<wire::EpsonG550>>(Kind::imu, wire::EpsonG550::name),
    frame_row<Cia404ImuDriver<wire::EpsonG552>>(Kind::imu, wire::EpsonG552::name),
    frame_row<XsensImuDriver>(Kind::imu, wire::Xsens::name),
    frame_row<SbgImuDriver>(Kind::imu, wire::Sbg::name),
    frame_row<DepthDriver>(Kind::depth, wire::Nmea2000::name),
    frame_row<Cia404PressureDriver>(Kind::depth, wire::Cia404Pressure::name),
    frame_row<ActuatorDriver>(Kind::actuator, wire::Nmea2000::name),
    frame_row<Cia402Driver>(Kind::actuator, wire::Cia402::name),
    byte_row<AttitudeDriver>(Kind::attitude, wire::Nmea0183::name),
    frame_row<Nmea2000AttitudeDriver>(Kind::attitude, wire::Nmea2000::name),
};

bool is_described(const DriverOptions& options, Travels travels) {
  if (!options.description) return false;
  const wire::Protocol& facts = options.description->facts;
  return facts.travels == travels && facts.kinds.has(options.kind);
}

const Row* find(const DriverOptions& options, Travels travels) {
  for (const Row& row : rows) {
    if (row.kind == options.kind && row.protocol.name == options.protocol &&
        row.protocol.travels == travels) {
      return &row;
    }
  }
  return nullptr;
}

std::string_view in_words(Travels travels) {
  return travels == Travels::as_bytes ? "bytes" : "CAN frames";
}

DriverError no_driver(const DriverOptions& options, Travels travels) {
  std::string text = "no driver for kind \"";
  text.append(to_string(options.kind)).append("\" with protocol \"").append(options.protocol);
  text.append("\" over ").append(in_words(travels)).append("; allowed:");
  for (const ProtocolEntry& entry : protocols_of(options.kind)) {
    text.append(" ").append(entry.name).append(" (").append(in_words(entry.travels)).append(")");
  }
  return {text};
}

}  // namespace

boost::container::static_vector<ProtocolEntry, 16> protocols_of(Kind kind) {
  boost::container::static_vector<ProtocolEntry, 16> found;
  for (const Row& row : rows) {
    if (row.kind == kind) found.push_back(row.protocol);
  }
  return found;
}

void throw_exception_from_error(const DriverError& error, const boost::source_location& where) {
  boost::throw_exception(std::invalid_argument(error.message), where);
}

boost::system::result<ByteDriverPtr, DriverError> make_byte_driver(const DriverOptions& options) {
  if (is_described(options, Travels::as_bytes)) return make<ByteDriver, DescribedDriver>(options);
  const Row* row = find(options, Travels::as_bytes);
  if (!row) return no_driver(options, Travels::as_bytes);
  return row->make_byte(options);
}

boost::system::result<FrameDriverPtr, DriverError> make_frame_driver(const DriverOptions& options) {
  if (is_described(options, Travels::as_frames))
    return make<FrameDriver, DescribedFrameDriver>(options);
  const Row* row = find(options, Travels::as_frames);
  if (!row) return no_driver(options, Travels::as_frames);
  return row->make_frame(options);
}

}  // namespace drydock::device
