#pragma once

#include <dds/dds.h>

#include <string_view>

#include "drydock_messages.h"
#include "ros2_messages.h"

/// Short names for the generated C types, and the facts about each type that DDS and ROS 2 need.
/// Only .cpp files of the bus and its tests include this.
namespace drydock::bus {

using TimeMessage = builtin_interfaces_msg_dds__Time_;
using Vector3Message = geometry_msgs_msg_dds__Vector3_;
using ImuMessage = sensor_msgs_msg_dds__Imu_;
using NavSatFixMessage = sensor_msgs_msg_dds__NavSatFix_;
using FluidPressureMessage = sensor_msgs_msg_dds__FluidPressure_;
using TemperatureMessage = sensor_msgs_msg_dds__Temperature_;
using TwistMessage = geometry_msgs_msg_dds__TwistWithCovarianceStamped_;
using PoseMessage = geometry_msgs_msg_dds__PoseWithCovarianceStamped_;
using JointStateMessage = sensor_msgs_msg_dds__JointState_;
using WrenchMessage = geometry_msgs_msg_dds__Wrench_;
using ClockMessage = rosgraph_msgs_msg_dds__Clock_;
using DvlMessage = marine_acoustic_msgs_msg_dds__Dvl_;
using OdometryMessage = nav_msgs_msg_dds__Odometry_;
using DiagnosticsMessage = diagnostic_msgs_msg_dds__DiagnosticArray_;
using OptionalTimeMessage = drydock_msg_dds__OptionalTime_;
using DepthMessage = drydock_msg_dds__Depth_;
using BottomTrackMessage = drydock_msg_dds__BottomTrack_;
using WaterSpeedMessage = drydock_msg_dds__WaterSpeed_;
using GnssFixMessage = drydock_msg_dds__GnssFix_;
using GnssSatellitesMessage = drydock_msg_dds__GnssSatellites_;
using ActuatorStateMessage = drydock_msg_dds__ActuatorState_;
using AttitudeMessage = drydock_msg_dds__Attitude_;
using InnovationMessage = drydock_msg_dds__Innovation_;
using FaultsMessage = drydock_msg_dds__Faults_;

/// `hash` is the REP-2016 type hash that ROS 2 (Iron and later) expects in the USER_DATA of an
/// endpoint. It is empty for Drydock's own types; ROS 2 reads that as "not set".
struct MessageType {
  const dds_topic_descriptor_t* descriptor;
  std::string_view hash;
};

template <class Message>
inline const MessageType message_type{};

template <>
inline const MessageType message_type<ImuMessage>{
    &sensor_msgs_msg_dds__Imu__desc,
    "RIHS01_7d9a00ff131080897a5ec7e26e315954b8eae3353c3f995c55faf71574000b5b"};
template <>
inline const MessageType message_type<NavSatFixMessage>{
    &sensor_msgs_msg_dds__NavSatFix__desc,
    "RIHS01_62223ab3fe210a15976021da7afddc9e200dc9ec75231c1b6a557fc598a65404"};
template <>
inline const MessageType message_type<FluidPressureMessage>{
    &sensor_msgs_msg_dds__FluidPressure__desc,
    "RIHS01_22dfb2b145a0bd5a31a1ac3882a1b32148b51d9b2f3bab250290d66f3595bc32"};
template <>
inline const MessageType message_type<TemperatureMessage>{
    &sensor_msgs_msg_dds__Temperature__desc,
    "RIHS01_72514a14126ab9f8a9abec974c78e5610a367b59db5da355ff1fb982d5bad4b8"};
template <>
inline const MessageType message_type<TwistMessage>{
    &geometry_msgs_msg_dds__TwistWithCovarianceStamped__desc,
    "RIHS01_77b67434531e6529b7a0091357b186b6ebdb17fd9ffd3e0c7ce9d3fb11a44563"};
template <>
inline const MessageType message_type<PoseMessage>{
    &geometry_msgs_msg_dds__PoseWithCovarianceStamped__desc,
    "RIHS01_26432f9803e43727d3c8f668d1fdb3c630f548af631e2f4e31382371bfea3b6e"};
template <>
inline const MessageType message_type<JointStateMessage>{
    &sensor_msgs_msg_dds__JointState__desc,
    "RIHS01_a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e"};
template <>
inline const MessageType message_type<WrenchMessage>{
    &geometry_msgs_msg_dds__Wrench__desc,
    "RIHS01_018e8519d57c16adbe97c9fe1460ef21fec7e31bc541de3d653a35895677ce52"};
template <>
inline const MessageType message_type<ClockMessage>{
    &rosgraph_msgs_msg_dds__Clock__desc,
    "RIHS01_692f7a66e93a3c83e71765d033b60349ba68023a8c689a79e48078bcb5c58564"};
template <>
inline const MessageType message_type<DvlMessage>{
    &marine_acoustic_msgs_msg_dds__Dvl__desc,
    "RIHS01_77604ba1b113d1a39148d095ac2cb21540de83cff2bbc5443e06e25208afd421"};
template <>
inline const MessageType message_type<OdometryMessage>{
    &nav_msgs_msg_dds__Odometry__desc,
    "RIHS01_3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0"};
template <>
inline const MessageType message_type<DiagnosticsMessage>{
    &diagnostic_msgs_msg_dds__DiagnosticArray__desc,
    "RIHS01_5a8a36efb05fb25070fa0fb3810290c0e6cd4862b54a8fb975a1ee8dc55a333e"};
template <>
inline const MessageType message_type<DepthMessage>{&drydock_msg_dds__Depth__desc, ""};
template <>
inline const MessageType message_type<BottomTrackMessage>{&drydock_msg_dds__BottomTrack__desc, ""};
template <>
inline const MessageType message_type<WaterSpeedMessage>{&drydock_msg_dds__WaterSpeed__desc, ""};
template <>
inline const MessageType message_type<GnssFixMessage>{&drydock_msg_dds__GnssFix__desc, ""};
template <>
inline const MessageType message_type<GnssSatellitesMessage>{&drydock_msg_dds__GnssSatellites__desc,
                                                             ""};
template <>
inline const MessageType message_type<ActuatorStateMessage>{&drydock_msg_dds__ActuatorState__desc,
                                                            ""};
template <>
inline const MessageType message_type<AttitudeMessage>{&drydock_msg_dds__Attitude__desc, ""};
template <>
inline const MessageType message_type<InnovationMessage>{&drydock_msg_dds__Innovation__desc, ""};
template <>
inline const MessageType message_type<FaultsMessage>{&drydock_msg_dds__Faults__desc, ""};

}  // namespace drydock::bus
