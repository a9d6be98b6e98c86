#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "estimators/hydrodynamics/coefficient_table.hpp"
#include "estimators/hydrodynamics/model.hpp"
#include "estimators/vehicle/vehicle.hpp"
#include "rig_config/load.hpp"

namespace drydock::hydrodynamics::test {

inline constexpr double degree = 0.017453292519943295;

inline rig_config::VehicleConfig nps_file(const std::string& name = "nps-auv-ii") {
  return rig_config::load_vehicle(DRYDOCK_SOURCE_DIR "/rig_config/vehicles/" + name + ".toml")
      .value();
}

inline Model nps_auv() { return Model{vehicle::dimensional(nps_file())}; }

/// One of the tables in the vehicle folder of the corpora. Empty if the folder does not exist.
class Table {
 public:
  explicit Table(const std::string& file) {
    const char* corpora = std::getenv("DRYDOCK_CORPORA");
    const std::filesystem::path folder =
        corpora ? corpora : DRYDOCK_SOURCE_DIR "/../shared/corpora";
    std::ifstream in(folder / "vehicle" / file);
    for (std::string line; std::getline(in, line);) rows_.push_back(split(line));
    if (rows_.empty()) return;
    for (std::size_t i = 0; i < rows_[0].size(); ++i) columns_[rows_[0][i]] = i;
  }

  bool empty() const { return rows_.size() < 2; }
  std::size_t rows() const { return rows_.size() - 1; }  ///< below the header
  std::string text(std::size_t row, const std::string& column) const {
    return rows_.at(row + 1).at(columns_.at(column));
  }
  double at(std::size_t row, const std::string& column) const {
    return std::stod(text(row, column));
  }
  double cell(std::size_t line, std::size_t column) const {  ///< for a table without a header
    return std::stod(rows_.at(line).at(column));
  }
  Velocity velocity(std::size_t row) const {
    return {at(row, "u"), at(row, "v"), at(row, "w"), at(row, "p"), at(row, "q"), at(row, "r")};
  }

 private:
  static std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    return cells;
  }

  std::vector<std::vector<std::string>> rows_;
  std::map<std::string, std::size_t> columns_;
};

/// A vehicle with the mass of the NPS AUV II. All coefficients are random and not zero; weight,
/// buoyancy and both centres differ too.
inline Vehicle vehicle_of_all_coefficients(std::mt19937_64& random) {
  std::uniform_real_distribution<double> factor(0.5, 1.5), sign(-1, 1);
  const auto file = nps_file();
  Vehicle vehicle = vehicle::dimensional(file);
  vehicle.body.buoyancy *= 0.9;
  vehicle.body.z_B = -0.02;
  for (const NamedCoefficient& entry : coefficient_table()) {
    double& value = vehicle.coefficients.*entry.member;
    const double unit = prime_unit(entry.length_power, file.water_density_kgm3, file.length_m);
    value = entry.name.ends_with("dot") ? factor(random) * value
                                        : std::copysign(0.05 * factor(random), sign(random)) * unit;
  }
  return vehicle;
}

}  // namespace drydock::hydrodynamics::test
