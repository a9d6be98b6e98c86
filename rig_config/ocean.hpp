#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// The table [ocean] of a mission file as typed values; docs/world/ocean.md has the equations.
namespace drydock::rig_config {

enum class BedKind : std::uint8_t { plane, slope, raster };

struct BedConfig {
  BedKind kind = BedKind::plane;
  double depth_m = 100;     ///< plane: everywhere; slope: where the mission begins
  double gradient = 0;      ///< slope: m down per m
  double downhill_rad = 0;  ///< slope: course in which it goes down, from north
  std::string file;         ///< raster: ESRI ASCII grid
  bool in_metres = false;   ///< raster: x east, y north of the mission's begin; else degrees
  bool elevations = true;   ///< raster: values are heights over the sea surface; else depths
};

/// One knot of the current over depth.
struct CurrentConfig {
  double depth_m = 0;
  std::array<double, 3> velocity_ned_mps{};  ///< of the water over ground
};

/// A sinusoid that is added at all depths.
struct TideConfig {
  double period_s = 44714.16;  ///< M2, 12.4206 h
  double phase_rad = 0;        ///< of the sine when the mission begins
  std::array<double, 3> velocity_ned_mps{};
};

enum class WaterKind : std::uint8_t { uniform, layered, standard };

/// One knot of the density over depth.
struct DensityConfig {
  double depth_m = 0, density_kgm3 = 0;
};

struct WaterConfig {
  WaterKind kind = WaterKind::uniform;
  double density_kgm3 = 1025;          ///< uniform
  std::vector<DensityConfig> density;  ///< layered: depths rise
  double surface_pressure_pa = 101'325;
  double temperature_k = 283.15, salinity_ppt = 35;  ///< well mixed; for the speed of sound
};

struct OceanConfig {
  BedConfig bed;
  std::vector<CurrentConfig> current;  ///< depths rise; none: still water
  std::optional<TideConfig> tide;
  WaterConfig water;
};

}  // namespace drydock::rig_config
