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
  double depth_m = 100;     ///< plane: everywhere; slope: at the start of the mission
  double gradient = 0;      ///< slope: m down per m
  double downhill_rad = 0;  ///< slope: downhill course, from north
  std::string file;         ///< raster: ESRI ASCII grid
  bool in_metres = false;   ///< raster: x east, y north of the mission's start; false: degrees
  bool elevations = true;   ///< raster: heights above the sea surface; false: depths
};

/// One knot of the current as a function of depth.
struct CurrentConfig {
  double depth_m = 0;
  std::array<double, 3> velocity_ned_mps{};  ///< of the water over ground
};

/// A sinusoidal current, added at all depths.
struct TideConfig {
  double period_s = 44714.16;  ///< M2, 12.4206 h
  double phase_rad = 0;        ///< of the sine at the start of the mission
  std::array<double, 3> velocity_ned_mps{};
};

enum class WaterKind : std::uint8_t { uniform, layered, standard };

/// One knot of the density as a function of depth.
struct DensityConfig {
  double depth_m = 0, density_kgm3 = 0;
};

struct WaterConfig {
  WaterKind kind = WaterKind::uniform;
  double density_kgm3 = 1025;          ///< uniform
  std::vector<DensityConfig> density;  ///< layered: depths increase
  double surface_pressure_pa = 101'325;
  double temperature_k = 283.15, salinity_ppt = 35;  ///< well mixed; for the speed of sound
};

struct OceanConfig {
  BedConfig bed;
  std::vector<CurrentConfig> current;  ///< depths increase; empty: still water
  std::optional<TideConfig> tide;
  WaterConfig water;
};

}  // namespace drydock::rig_config
