#include "drivers/wire/can/sbg_names.hpp"

#include <algorithm>
#include <array>

namespace drydock::wire::sbg {
namespace {

struct NamedId {
  std::uint32_t id;
  std::string_view name;
};

/// can/sbgCan.dbc of SBG's sbgECom repository.
constexpr std::array named_ids{NamedId{0x100, "STATUS_01"},
                               NamedId{0x101, "STATUS_02"},
                               NamedId{0x102, "STATUS_03"},
                               NamedId{0x110, "UTC_0"},
                               NamedId{0x111, "UTC_1"},
                               NamedId{0x120, "IMU_INFO"},
                               NamedId{0x121, "IMU_ACCEL"},
                               NamedId{0x122, "IMU_GYRO"},
                               NamedId{0x123, "IMU_DELTA_VEL"},
                               NamedId{0x124, "IMU_DELTA_ANGLE"},
                               NamedId{0x130, "EKF_INFO"},
                               NamedId{0x131, "EKF_QUAT"},
                               NamedId{0x132, "EKF_EULER"},
                               NamedId{0x133, "EKF_ORIENTATION_ACC"},
                               NamedId{0x134, "EKF_POS"},
                               NamedId{0x135, "EKF_ALTITUDE"},
                               NamedId{0x136, "EKF_POS_ACC"},
                               NamedId{0x137, "EKF_VEL_NED"},
                               NamedId{0x138, "EKF_VEL_NED_ACC"},
                               NamedId{0x139, "EKF_VEL_BODY"},
                               NamedId{0x140, "SHIP_MOTION_INFO"},
                               NamedId{0x141, "SHIP_MOTION_0"},
                               NamedId{0x145, "SHIP_MOTION_1"},
                               NamedId{0x149, "SHIP_MOTION_2"},
                               NamedId{0x14A, "SHIP_MOTION_HP_INFO"},
                               NamedId{0x14B, "SHIP_MOTION_HP_0"},
                               NamedId{0x14C, "SHIP_MOTION_HP_1"},
                               NamedId{0x14D, "SHIP_MOTION_HP_2"},
                               NamedId{0x150, "MAG_0"},
                               NamedId{0x151, "MAG_1"},
                               NamedId{0x152, "MAG_2"},
                               NamedId{0x160, "ODO_INFO"},
                               NamedId{0x161, "ODO_VEL"},
                               NamedId{0x162, "AIR_DATA_INFO"},
                               NamedId{0x163, "AIR_DATA_ALTITUDE"},
                               NamedId{0x164, "AIR_DATA_AIRSPEED"},
                               NamedId{0x166, "DEPTH_INFO"},
                               NamedId{0x167, "DEPTH_ALTITUDE"},
                               NamedId{0x170, "GPS1_VEL_INFO"},
                               NamedId{0x171, "GPS1_VEL"},
                               NamedId{0x172, "GPS1_VEL_ACC"},
                               NamedId{0x173, "GPS1_VEL_COURSE"},
                               NamedId{0x174, "GPS1_POS_INFO"},
                               NamedId{0x175, "GPS1_POS"},
                               NamedId{0x176, "GPS1_POS_ALT"},
                               NamedId{0x177, "GPS1_POS_ACC"},
                               NamedId{0x178, "GPS1_HDT_INFO"},
                               NamedId{0x179, "GPS1_HDT"},
                               NamedId{0x180, "GPS2_VEL_INFO"},
                               NamedId{0x181, "GPS2_VEL"},
                               NamedId{0x182, "GPS2_VEL_ACC"},
                               NamedId{0x183, "GPS2_VEL_COURSE"},
                               NamedId{0x184, "GPS2_POS_INFO"},
                               NamedId{0x185, "GPS2_POS"},
                               NamedId{0x186, "GPS2_POS_ALT"},
                               NamedId{0x187, "GPS2_POS_ACC"},
                               NamedId{0x188, "GPS2_HDT_INFO"},
                               NamedId{0x189, "GPS2_HDT"},
                               NamedId{0x200, "EVENT_INFO_A"},
                               NamedId{0x201, "EVENT_TIME_A"},
                               NamedId{0x202, "EVENT_INFO_B"},
                               NamedId{0x203, "EVENT_TIME_B"},
                               NamedId{0x204, "EVENT_INFO_C"},
                               NamedId{0x205, "EVENT_TIME_C"},
                               NamedId{0x206, "EVENT_INFO_D"},
                               NamedId{0x207, "EVENT_TIME_D"},
                               NamedId{0x208, "EVENT_INFO_E"},
                               NamedId{0x209, "EVENT_TIME_E"},
                               NamedId{0x220, "AUTO_SLIP_CURV"}};

}  // namespace

std::string_view message_name(std::uint32_t id) {
  const auto found = std::ranges::find(named_ids, id, &NamedId::id);
  return found == named_ids.end() ? std::string_view() : found->name;
}

}  // namespace drydock::wire::sbg
