#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <random>
#include <set>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/j1939/aceinna.hpp"
#include "tests/drivers/wire/can_fixture.hpp"
#include "tests/drivers/wire/dbc_reader.hpp"

/// Compares our layouts with every SG_ line of the vendor's DBC 19.1.51.
namespace drydock::wire::aceinna {
namespace aceinna_dbc_test {

using Message = Aceinna::Message;
using Number = std::optional<double>;

/// Our decoder's value for a signal of the DBC, in the DBC's unit.
using Reading = std::function<Number(const Message&)>;

template <class M, class Get>
Reading reads(Get get) {
  return [get](const Message& m) { return Number(get(std::get<M>(m))); };
}

/// A bit of a status message, by its key in our decoder.
template <class Layout>
Reading flag(std::string key) {
  return [key](const Message& m) -> Number {
    for (const Flag& f : Layout::flags) {
      if (f.key == key) return std::get<Flags<Layout>>(m).has(f);
    }
    ADD_FAILURE() << "no flag " << key;
    return {};
  };
}

Number degrees_of(const Number& rad) { return degrees(rad); }

Number milliseconds(const Number& s) { return scaled(s, 1e3); }

double merit(FigureOfMerit m) { return static_cast<double>(m); }

std::map<std::string, Reading> name_fields(const std::string& message) {
  std::map<std::string, Reading> fields;
  const auto add = [&](const std::string& name, auto get) {
    fields[message + ".J1939_Name_" + name] =
        reads<AddressClaimed>([get](const auto& m) { return double(get(m.name)); });
  };
  using N = const j1939::Name&;
  add("ID_Code", [](N n) { return n.identity_number; });
  add("Manufacture_Code", [](N n) { return n.manufacturer_code; });
  add("ECU_Example", [](N n) { return n.ecu_instance; });
  add("Function_Example", [](N n) { return n.function_instance; });
  add("Function", [](N n) { return n.function; });
  add("Vehicle_System", [](N n) { return n.vehicle_system; });
  add("Vehicle_Example", [](N n) { return n.vehicle_system_instance; });
  add("Industry_Group", [](N n) { return n.industry_group; });
  add("Arbitrary_Address", [](N n) { return n.arbitrary_address_capable; });
  return fields;
}

std::map<std::string, Reading> readings() {
  auto r = name_fields("Aceinna_Address_Claiming");
  using A = const Acceleration&;
  using W = const AngularRate&;
  using S = const SlopeSensor&;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string axis(1, "XYZ"[i]);
    r["Aceinna_Accel.Aceinna_Acc" + axis] =
        reads<Acceleration>([i](A m) { return m.acceleration_mps2[i]; });
    r["Aceinna_AngleRate.Aceinna_Gyro" + axis] =
        reads<AngularRate>([i](W m) { return degrees_of(m.rate_radps[i]); });
    const std::array<std::string, 3> force{"LateralAcc", "LongiAcc", "VerticAcc"};
    r["Aceinna_Accel.Aceinna_" + force[i] + "_FigureOfMerit"] =
        reads<Acceleration>([i](A m) { return merit(m.merit[i]); });
    const std::array<std::string, 3> rate{"PitchRate", "RollRate", "YawRate"};
    r["Aceinna_AngleRate.Aceinna_" + rate[i] + "_Figure_OfMerit"] =
        reads<AngularRate>([i](W m) { return merit(m.merit[i]); });
  }
  r["Aceinna_Accel.Aceinna_Support_Rate_Acc"] =
      reads<Acceleration>([](A m) { return double(m.rate_support); });
  r["Aceinna_AngleRate.Aceinna_AngleRate_Latency"] =
      reads<AngularRate>([](W m) { return milliseconds(m.latency_s); });
  const std::string angles = "Aceinna_Angles.Aceinna_";
  r[angles + "Pitch"] = reads<SlopeSensor>([](S m) { return degrees_of(m.pitch_rad); });
  r[angles + "Roll"] = reads<SlopeSensor>([](S m) { return degrees_of(m.roll_rad); });
  r[angles + "PitchRoll_Latency"] =
      reads<SlopeSensor>([](S m) { return milliseconds(m.latency_s); });
  r[angles + "Pitch_Figure_OfMerit"] = reads<SlopeSensor>([](S m) { return merit(m.pitch_merit); });
  r[angles + "Roll_Figure_OfMerit"] = reads<SlopeSensor>([](S m) { return merit(m.roll_merit); });
  r[angles + "Pitch_Compensation"] =
      reads<SlopeSensor>([](S m) { return double(m.pitch_compensation); });
  r[angles + "Roll_Compensation"] =
      reads<SlopeSensor>([](S m) { return double(m.roll_compensation); });

  const std::string hardware = "Feedback_Hardware_BIT.Aceinna_HW_";
  r[hardware + "Master_Fai"] = flag<HardwareLayout>("master_fail");
  r[hardware + "Sensor_Error"] = flag<HardwareLayout>("sensor_error");
  r[hardware + "Rate_Error"] = flag<HardwareLayout>("rate_error");
  r[hardware + "Accell_Error"] = flag<HardwareLayout>("acceleration_error");
  const std::string software = "Feedback_Software_Bit.Aceinna_SW_";
  r[software + "Software_Error"] = flag<SoftwareLayout>("software_error");
  r[software + "Algorithm_Error"] = flag<SoftwareLayout>("algorithm_error");
  r[software + "Data_Error"] = flag<SoftwareLayout>("data_error");
  r[software + "Initialization_Error"] = flag<SoftwareLayout>("initialization_error");
  r[software + "Over_Range"] = flag<SoftwareLayout>("over_range");
  r[software + "CalibrationCRC_Error"] = flag<SoftwareLayout>("calibration_error");
  const std::string status = "Feedback_Sensor_Status.Aceinna_";
  r[status + "Master_Status"] = flag<StatusLayout>("master_status");
  r[status + "Hardware_Status"] = flag<StatusLayout>("hardware_status");
  r[status + "Software_Status"] = flag<StatusLayout>("software_status");
  r[status + "Sensor_Status"] = flag<StatusLayout>("sensor_status");
  r[status + "Unlocked_Eeprom"] = flag<StatusLayout>("eeprom_unlocked");
  r[status + "Algo_Init"] = flag<StatusLayout>("algorithm_initializing");
  r[status + "Attitude_Only_Algo"] = flag<StatusLayout>("attitude_only");
  r[status + "Turn_Switch"] = flag<StatusLayout>("turn_switch");
  r[status + "Sensor_Over_Range"] = flag<StatusLayout>("sensor_over_range");

  const std::string to = ".Aceinna_Destination_Address";
  r["Set_Packet_Rate_Divider" + to] = reads<PacketRate>([](auto& m) { return double(m.device); });
  r["Set_Packet_Rate_Divider.Aceinna_New_Pocket_Rate"] =
      reads<PacketRate>([](auto& m) { return double(m.divider); });
  r["Set_Data_Pcket_Type" + to] = reads<PacketType>([](auto& m) { return double(m.device); });
  r["Set_Data_Pcket_Type.Aceinna_New_Packet_Type"] =
      reads<PacketType>([](auto& m) { return double(m.packets); });
  r["Set_Digital_Filter" + to] = reads<DigitalFilter>([](auto& m) { return double(m.device); });
  r["Set_Digital_Filter.Aceinna_New_Gyro_Low_Pass"] =
      reads<DigitalFilter>([](auto& m) { return double(m.rate_hz); });
  r["Set_Digital_Filter.Aceinna_New_Acc_Low_Pass"] =
      reads<DigitalFilter>([](auto& m) { return double(m.acceleration_hz); });
  r["Set_Orientation" + to] = reads<Orientation>([](auto& m) { return double(m.device); });
  r["Set_Orientation.Aceinna_New_Orientation_Type"] =
      reads<Orientation>([](auto& m) { return double(m.code); });
  return r;
}

/// A bench does not need these messages. They store settings permanently, restart the device's own
/// filter, move its PGNs or name its firmware; one repeats the claim as an answer.
const std::set<std::string> unread{"Set_Configuration_Save",    "Feedback_Configuration_Save",
                                   "Set_Algorithm_Reset",       "Feedback_ECU_ID",
                                   "Feedback_Firmware_Version", "Set_Bank0_PS_Num",
                                   "Set_Bank1_PS_Num"};

TEST(AceinnaDbc, EverySignalOfTheVendorIsReadWhereItStands) {
  const auto path = test::corpus("can_imu/MTLT305D_dbc_19.1.51_20190621.dbc");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "corpora absent: can_imu";
  const auto known = readings();
  std::mt19937_64 random(1);
  std::set<std::string> checked;
  std::size_t signals = 0;
  for (const test::DbcMessage& sent : test::DbcReader::read(path)) {
    signals += sent.signals.size();
    if (unread.contains(sent.name)) continue;
    for (const auto& [name, s] : sent.signals) {
      ASSERT_FALSE(s.big_endian) << name;
      if (name.find("Reserved") != std::string::npos) continue;
      const auto reading = known.find(sent.name + "." + name);
      ASSERT_NE(reading, known.end()) << sent.name << "." << name;
      checked.insert(reading->first);
      for (int trial = 0; trial < 200; ++trial) {
        CanFrame frame;
        frame.id = sent.id;
        frame.extended = true;
        frame.size = 8;
        store_le<std::uint64_t>(frame.data, 0, random());
        Aceinna::Decoder decoder;
        const auto message = decoder.receive(frame);
        ASSERT_TRUE(message) << sent.name;
        const auto shown = reading->second(*message);
        if (!shown) continue;  // reserved by J1939-71, or not valid
        const double raw = static_cast<double>(s.raw(frame.payload()));
        EXPECT_NEAR(*shown, raw * s.factor + s.offset, 1e-9) << sent.name << "." << name;
      }
    }
  }
  EXPECT_EQ(signals, 96u);
  EXPECT_EQ(checked.size(), known.size());
}

}  // namespace aceinna_dbc_test
}  // namespace drydock::wire::aceinna
