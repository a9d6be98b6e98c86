#include <fmt/format.h>

#include <filesystem>

#include "rig_config/checks/checks.hpp"
#include "rig_config/nearest_file.hpp"
#include "rig_config/shipped.hpp"

namespace drydock::rig_config {

namespace {

double number_at(const Node* table, std::string_view key, double otherwise) {
  const Node* value = table ? table->find(key) : nullptr;
  const bool number =
      value && (value->kind == Node::Kind::number || value->kind == Node::Kind::integer);
  return number ? value->number : otherwise;
}

class MissionChecks {
 public:
  MissionChecks(const Node& root, const std::string& file)
      : root_(root), file_(file), ocean_(root.find("ocean")) {
    if (ocean_) bed_ = ocean_->find("bed");
    const Node* kind = bed_ ? bed_->find_text("kind") : nullptr;
    if (kind) bed_kind_ = kind->text;
  }

  Problems run() {
    if (const Node* mission = root_.find("mission")) {
      legs_stay_in_the_water();
      waypoints_make_lines();
      vehicle_fits(mission->find_text("vehicle"));
    }
    if (bed_kind_ == "raster") raster_exists();
    if (const Node* track = root_.find("track"))
      if (const Node* file = track->find_text("file")) exists(*file, "/track/file", {});
    if (ocean_) depths_rise(*ocean_, "current", "/ocean/current");
    const Node* water = ocean_ ? ocean_->find("water") : nullptr;
    if (water) depths_rise(*water, "layer", "/ocean/water/layer");
    return std::move(problems_);
  }

 private:
  /// For other beds than a plane the motion itself checks this.
  void legs_stay_in_the_water() {
    double depth_m = number_at(root_.find("mission"), "depth_m", 0);
    const bool plane = bed_kind_ == "plane";
    const double bed_m = plane ? number_at(bed_, "depth_m", BedConfig{}.depth_m) : 11'000;
    for_each_table(root_, "leg", [&](const Node& leg, std::size_t i) {
      if (const Node* kind = leg.find_text("kind"); kind && kind->text == "surface") depth_m = 0;
      const Node* change = leg.find("depth_change_m");
      if (!change) return;
      depth_m += number_at(&leg, "depth_change_m", 0);
      if (depth_m < -1e-9 || depth_m > bed_m)
        add(*change, fmt::format("/leg/{}/depth_change_m", i),
            fmt::format("the leg ends at a depth of {} m, allowed: 0 (the surface) to {}{}",
                        depth_m, bed_m, plane ? " (the bed)" : ""));
    });
  }

  /// A line has two ends.
  void waypoints_make_lines() {
    const Node* before = nullptr;
    for_each_table(root_, "waypoint", [&](const Node& waypoint, std::size_t i) {
      const auto same = [&](const char* key) {
        return number_at(before, key, 0) == number_at(&waypoint, key, 0);
      };
      if (before && same("north_m") && same("east_m"))
        add(waypoint, fmt::format("/waypoint/{}", i),
            "is at the place of the one before it, allowed: another north_m or east_m");
      before = &waypoint;
    });
  }

  /// The file of the vehicle must exist. A turning circle needs a vehicle; a prescribed heel is not
  /// allowed with a vehicle.
  void vehicle_fits(const Node* vehicle) {
    if (vehicle) exists(*vehicle, "/mission/vehicle", vehicles);
    for_each_table(root_, "leg", [&](const Node& leg, std::size_t i) {
      const Node* kind = leg.find_text("kind");
      if (!vehicle && kind && kind->text == "turning_circle")
        add(*kind, fmt::format("/leg/{}/kind", i),
            "a turning_circle is steered by a rudder: give the mission a vehicle, or take a turn");
      const Node* roll = leg.find("roll_deg");
      if (vehicle && roll)
        add(*roll, fmt::format("/leg/{}/roll_deg", i),
            "not allowed here, a vehicle heels as its equations of motion say");
    });
  }

  void raster_exists() {
    if (const Node* file = bed_->find_text("file")) exists(*file, "/ocean/bed/file", {});
  }

  /// `kind`: of the shipped files that it may be; empty: none.
  void exists(const Node& file, const std::string& path, std::string_view kind) {
    if (file.text.empty()) return;
    const std::string full = beside(file_, file.text);
    if (std::filesystem::is_regular_file(full)) return;
    add(file, path, why_no_file(full, kind));
  }

  void depths_rise(const Node& table, const char* key, const std::string& path) {
    double above = -1;
    for_each_table(table, key, [&](const Node& knot, std::size_t i) {
      const double depth = number_at(&knot, "depth_m", above);
      if (knot.find("depth_m") && depth <= above)
        add(*knot.find("depth_m"), fmt::format("{}/{}/depth_m", path, i),
            fmt::format("{} is not below the one before, allowed: more than {}", depth, above));
      above = depth;
    });
  }

  void add(const Node& at, std::string path, std::string what) {
    problems_.push_back({file_, at.at.line, at.at.column, std::move(path), std::move(what)});
  }

  const Node& root_;
  const std::string& file_;
  const Node* ocean_;
  const Node* bed_ = nullptr;
  std::string bed_kind_ = "plane";
  Problems problems_;
};

}  // namespace

Problems check_mission(const Node& root, const std::string& file) {
  return MissionChecks(root, file).run();
}

}  // namespace drydock::rig_config
