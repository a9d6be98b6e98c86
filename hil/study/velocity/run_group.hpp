#pragma once

#include <array>
#include <memory>
#include <span>
#include <string_view>

#include "estimators/hydrodynamics/model.hpp"
#include "hil/study/velocity/velocity_methods.hpp"

/// Some runs of the velocity study whose methods take each step together, side by side in the lanes
/// of wide registers where the processor has them. What lies behind RunGroup is compiled once for
/// each kind of register, so plain numbers alone cross this border.
namespace drydock::study {

/// The widest registers hold so many runs.
inline constexpr std::size_t most_runs = 8;

/// A value in each run.
using Runs = std::array<double, most_runs>;

/// MeasuredStep of each run. The control and the times of log and DVL are those of all runs.
struct MeasuredRuns {
  static constexpr std::size_t samples = MeasuredStep::samples;
  std::array<std::array<Runs, 3>, samples> angle, velocity;
  std::array<Runs, samples> height_m;
  Runs mean_height_m;
  std::array<hydrodynamics::Control, samples> control;
  bool has_log, has_ground;
  Runs log_mps;
  std::array<Runs, 3> ground;

  void put(std::size_t run, const MeasuredStep& measured);
};

/// What a method says of one run.
struct NavigatorReading {
  frame::Position position;
  double velocity_body[3];          ///< m/s
  double horizontal_covariance[4];  ///< latitude, longitude; rad2
};

/// A method, and its vehicle model in each run.
struct GroupContender {
  Method method;
  std::array<const hydrodynamics::Model*, most_runs> models;
};

struct GroupStart {
  std::array<const navigation::NavigationState*, most_runs> states;
  std::span<const GroupContender> contenders;
};

class RunGroup {
 public:
  virtual ~RunGroup();
  virtual void step(const MeasuredRuns& measured) = 0;
  virtual NavigatorReading read(std::size_t contender, std::size_t run) const = 0;
};

/// A kind of register: the runs that it holds, and the methods as they are compiled for it.
struct Registers {
  std::string_view name;
  std::size_t width;
  std::unique_ptr<RunGroup> (*make)(const GroupStart& start);
};

/// The kinds that this processor has, the narrowest first, which holds one run.
std::span<const Registers> registers();

/// The narrowest that hold `runs`, or else the widest; none wider than those of this name, if it is
/// not empty.
const Registers& registers_for(std::size_t runs, std::string_view widest = {});

std::unique_ptr<RunGroup> one_by_one(const GroupStart& start);
std::unique_ptr<RunGroup> by_sse2(const GroupStart& start);
std::unique_ptr<RunGroup> by_avx2(const GroupStart& start);
std::unique_ptr<RunGroup> by_avx512(const GroupStart& start);

}  // namespace drydock::study
