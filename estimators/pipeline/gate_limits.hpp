#pragma once

/// What the gates of an IMU and of a single gyro share: docs/estimators/integrity.md.
namespace drydock::pipeline::gate {

/// Differences before the noise counts as known; until then no step is judged.
inline constexpr int learn_samples = 50;

/// Eight times the mean absolute difference is 6.4 standard deviations of a normal difference.
inline constexpr double noise_times = 8;

/// Weight of a new difference, and how often the mean it counts at most: so wild differences that
/// are just below the limit do not lift it without end.
inline constexpr double newest_share = 0.05, most_usual = 2;

/// A step this small is no concern of a gate, however quiet the gyro is: rad/s.
inline constexpr double least_turn = 1e-3;

/// So many samples in a row that agree with each other make a step.
inline constexpr int step_samples = 8;

/// After this time without a good sample the next possible one is used, whatever it is.
inline constexpr double longest_doubt_s = 0.3;

}  // namespace drydock::pipeline::gate
