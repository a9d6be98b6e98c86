#include <gtest/gtest.h>

#include <map>

#include "drivers/wire/can/xsens.hpp"
#include "tests/drivers/wire/can_fixture.hpp"

/// Our codec beside a public driver's DBC: 338 frames whose raw values three programs read
/// (corpora, dbc). Steps are those of the manual, where the DBC's are wrong or rounded.
namespace drydock::wire::xsens {
namespace xsens_dbc_test {

using nlohmann::json;

struct Field {
  std::string key;
  double step = 1;
  int index = -1;  ///< in an array
  double zero = 0;
};

constexpr double degree = 180 / 3.14159265358979323846;

std::map<std::string, Field> fields() {
  std::map<std::string, Field> f;
  const auto three = [&](const std::string& message, std::array<const char*, 3> theirs,
                         std::array<const char*, 3> ours, double step) {
    for (std::size_t i = 0; i < 3; ++i) f[message + "." + theirs[i]] = {ours[i], step};
  };
  f["Warning.WarningCode"] = {"code"};
  f["SampleTime.Timestamp"] = {"device_time_s", 1e-4};
  f["GroupCounter.Counter"] = {"counter"};
  f["StatusWord.SelfTestOk"] = {"self_test_passed"};
  f["StatusWord.OrientationValid"] = {"filter_valid"};
  f["StatusWord.GpsValid"] = {"gnss_fix"};
  f["StatusWord.ExternalClockSynced"] = {"clock_synchronized"};
  f["StatusWord.FilterMode"] = {"filter_mode"};
  f["StatusWord.RtkStatus"] = {"rtk"};
  for (int i = 0; i < 4; ++i) {
    f["Quaternion.Q" + std::to_string(i + 1)] = {"wxyz", 1.0 / 32767, i};
    f["DeltaQ.DeltaQ" + std::to_string(i + 1)] = {"wxyz", 1.0 / 32767, i};
  }
  three("RateOfTurn", {"gyrX", "gyrY", "gyrZ"}, {"rate_x_degps", "rate_y_degps", "rate_z_degps"},
        degree / 512);
  three("RateOfTurnHR", {"HrGyrX", "HrGyrY", "HrGyrZ"},
        {"rate_x_degps", "rate_y_degps", "rate_z_degps"}, degree / 512);
  const std::array<const char*, 3> force{"acceleration_x_mps2", "acceleration_y_mps2",
                                         "acceleration_z_mps2"};
  three("Acceleration", {"accX", "accY", "accZ"}, force, 1.0 / 256);
  three("AccelerationHR", {"HrAccX", "HrAccY", "HrAccZ"}, force, 1.0 / 256);
  three("FreeAcceleration", {"FreeAccX", "FreeAccY", "FreeAccZ"}, force, 1.0 / 256);
  three("MagneticField", {"magX", "magY", "magZ"}, {"field_x", "field_y", "field_z"}, 1.0 / 1024);
  three("Velocity", {"velX", "velY", "velZ"},
        {"velocity_x_mps", "velocity_y_mps", "velocity_z_mps"}, 1.0 / 64);
  three("EulerAngles", {"roll", "pitch", "yaw"}, {"roll_deg", "pitch_deg", "yaw_deg"}, 1.0 / 128);
  f["Temperature.Temperature"] = {"temperature_k", 1.0 / 256, -1, 273.15};
  f["BarometricPressure.Pressure"] = {"pressure_pa", 1.0 / 32768};
  f["UTC.month"] = {"month"};
  f["UTC.day"] = {"day"};
  f["LatLon.latitude"] = {"latitude_deg", 1.0 / (1 << 24)};
  f["LatLon.longitude"] = {"longitude_deg", 1.0 / (1 << 23)};
  f["AltitudeEllipsoid.altEllipsoid"] = {"ellipsoid_height_m", 1.0 / 32768};
  f["PositionEcef_X.PositionEcef_X"] = {"ecef_x_m", 1.0 / 256};
  f["PositionEcef_Y.PositionEcef_Y"] = {"ecef_y_m", 1.0 / 256};
  f["PositionEcef_Z.PositionEcef_Z"] = {"ecef_z_m", 1.0 / 256};
  f["GnssReceiverStatus.fixType"] = {"fix_type"};
  f["GnssReceiverStatus.numSv"] = {"satellites"};
  f["GnssReceiverStatus.flags"] = {"flags"};
  f["GnssReceiverStatus.valid"] = {"valid"};
  f["GnssReceiverDop.pdop"] = {"position_dop", 0.01};
  f["GnssReceiverDop.tdop"] = {"time_dop", 0.01};
  f["GnssReceiverDop.vdop"] = {"vertical_dop", 0.01};
  f["GnssReceiverDop.hdop"] = {"horizontal_dop", 0.01};
  return f;
}

double number(const json& value) {
  return value.is_boolean() ? value.get<bool>() : value.get<double>();
}

/// The DBC calls the pressure signed.
double raw_of(const std::string& name, const json& value) {
  const double raw = value["raw"].get<double>();
  return name == "BarometricPressure.Pressure" && raw < 0 ? raw + 4294967296.0 : raw;
}

TEST(XsensDbc, EverySignalOfThePublicDbcIsReadWhereItStands) {
  const auto lines = test::lines_of(test::corpus("dbc/expected/xsens_mti.jsonl"));
  if (lines.empty()) GTEST_SKIP() << "corpora absent: dbc";
  const auto known = fields();
  std::map<std::string, unsigned> compared;
  std::size_t read = 0, refused = 0;
  for (const std::string& text : lines) {
    const json line = json::parse(text);
    if (line["msg"] == "Error" || line["msg"] == "VECTOR__INDEPENDENT_SIG_MSG") continue;
    char id[4];
    std::snprintf(id, sizeof id, "%03X", line["id"].get<unsigned>());
    Xsens::Decoder decoder;
    const auto message =
        decoder.receive(test::frame(std::string(id) + "#" + line["data"].get<std::string>()));
    if (!message) {  // an increment whose exponent no device sends
      EXPECT_EQ(line["msg"], "DeltaV");
      EXPECT_GT(line["sig"]["Exponent"]["raw"], 31);
      ++refused;
      continue;
    }
    ++read;
    const json ours = test::to_json(*message);
    for (const auto& [signal, value] : line["sig"].items()) {
      const std::string name = line["msg"].get<std::string>() + "." + signal;
      const auto field = known.find(name);
      if (field == known.end()) continue;
      const json& shown = field->second.index < 0 ? ours.at(field->second.key)
                                                  : ours.at(field->second.key)[field->second.index];
      const double expected = raw_of(name, value) * field->second.step + field->second.zero;
      EXPECT_NEAR(number(shown), expected, 1e-9 * std::max(1.0, std::abs(expected)))
          << name << text;
      ++compared[name];
    }
  }
  EXPECT_EQ(compared.size(), known.size());
  EXPECT_GT(read, 280u);
  EXPECT_LT(refused, 14u);
}

// The MTi says 0.5 m/s with the step of its rate: 2^-8 at 1 Hz. A DBC cannot follow the exponent.
TEST(XsensDbc, AVelocityIncrementHasItsOwnStep) {
  const auto m = test::only<DeltaV, Xsens>({test::frame("031#00800000FF8008")});
  EXPECT_EQ(m.velocity_mps, (std::array<double, 3>{0.5, 0, -0.5}));
}

}  // namespace xsens_dbc_test
}  // namespace drydock::wire::xsens
