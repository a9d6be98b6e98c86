// MCAP files of other programs, with the definitions that rosbag2 writes: the .msg files of ROS 2
// unchanged, where a type of the same package has no package before its name.
#pragma once

#include <unistd.h>

#include <gtest/gtest.h>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "drivers/recordings/mcap/encoder.hpp"

namespace message_file {

namespace mcap = drydock::mcap;

struct Cdr {
  std::vector<std::uint8_t> bytes{0, 1, 0, 0};
  template <class Number>
  Cdr& put(Number number) {
    while ((bytes.size() - 4) % sizeof number != 0) bytes.push_back(0);
    bytes.resize(bytes.size() + sizeof number);
    std::memcpy(&bytes[bytes.size() - sizeof number], &number, sizeof number);
    return *this;
  }
  Cdr& put(const std::string& text) {
    put(static_cast<std::uint32_t>(text.size() + 1));
    bytes.insert(bytes.end(), text.c_str(), text.c_str() + text.size() + 1);
    return *this;
  }
  Cdr& put(const std::vector<double>& numbers) {
    for (const double number : numbers) put(number);
    return *this;
  }
  Cdr& header(std::int64_t ns, const std::string& frame) {
    put(static_cast<std::int32_t>(ns / 1'000'000'000));
    put(static_cast<std::uint32_t>(ns % 1'000'000'000));
    return put(frame);
  }
};

/// A diagonal matrix of 6 by 6 or 3 by 3, row by row.
inline std::vector<double> diagonal(const std::vector<double>& values) {
  std::vector<double> all(values.size() * values.size());
  for (std::size_t i = 0; i < values.size(); ++i) all[i * values.size() + i] = values[i];
  return all;
}

/// The text of a definition, with those of the types in it.
inline std::string with_types(std::string text, const std::vector<std::string>& types) {
  static const std::map<std::string, std::string> known{
      {"std_msgs/Header", "builtin_interfaces/Time stamp\n\nstring frame_id\n"},
      {"builtin_interfaces/Time", "int32 sec\n\nuint32 nanosec\n"},
      {"geometry_msgs/PoseWithCovariance", "Pose pose\n\n# x, y, z\nfloat64[36] covariance\n"},
      {"geometry_msgs/Pose", "Point position\nQuaternion orientation\n"},
      {"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"},
      {"geometry_msgs/Quaternion", "float64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n"},
      {"geometry_msgs/TwistWithCovariance", "Twist twist\n\nfloat64[36] covariance\n"},
      {"geometry_msgs/Twist", "Vector3  linear\nVector3  angular\n"},
      {"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"},
      {"sensor_msgs/NavSatStatus",
       "int8 STATUS_NO_FIX =  -1\nint8 STATUS_FIX =      0\n\nint8 status -2 # STATUS_UNKNOWN\n\n"
       "uint16 SERVICE_GPS =     1\n\nuint16 service\n"}};
  for (const auto& type : types)
    text += "\n" + std::string(80, '=') + "\nMSG: " + type + "\n" + known.at(type);
  return text;
}

struct Topic {
  std::string name, type, definition;  ///< type: "nav_msgs/msg/Odometry"
  std::vector<std::vector<std::uint8_t>> messages;
};

inline void write(const std::string& path, const std::vector<Topic>& topics) {
  mcap::Buffer file(mcap::magic.begin(), mcap::magic.end());
  mcap::encode(file, mcap::Header{"ros2", "rosbag2"});
  std::uint16_t id = 0;
  for (const Topic& topic : topics) {
    ++id;
    mcap::encode(file, mcap::Schema{id, topic.type, "ros2msg", topic.definition});
    mcap::encode(file, mcap::Channel{id, id, topic.name, "cdr", {}});
    for (const auto& message : topic.messages)
      mcap::encode(file, mcap::Message{id, 1, 9, 9, message});
  }
  mcap::Encoder(file).record(mcap::Opcode::data_end,
                             [&] { mcap::Encoder(file).number(std::uint32_t{0}); });
  mcap::Encoder(file).record(mcap::Opcode::footer, [&] {
    mcap::Encoder(file).number(std::uint64_t{0}).number(std::uint64_t{0}).number(std::uint32_t{0});
  });
  file.insert(file.end(), mcap::magic.begin(), mcap::magic.end());
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
}

/// Tests with an MCAP file.
class WithFile : public testing::Test {
 protected:
  ~WithFile() override { std::filesystem::remove(path_); }
  std::string path_ = testing::TempDir() + "messages-" + std::to_string(::getpid()) + ".mcap";
};

}  // namespace message_file
