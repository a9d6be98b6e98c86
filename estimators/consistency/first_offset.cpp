#include "estimators/consistency/first_offset.hpp"

#include <cmath>

namespace drydock::consistency {
namespace {

constexpr double agree_mps = 0.15;
constexpr double certain = 6;  // sigmas

}  // namespace

std::optional<FirstOffset> first_offset(double dvl_over_receiver, double dvl_over_log,
                                        double sigma) {
  using Of = FirstOffset::Of;
  const double receiver_over_log = dvl_over_log - dvl_over_receiver;
  const auto agree = [](double difference) { return std::abs(difference) < agree_mps; };
  if (sigma > FirstOffset::least_mps / certain) return {};
  if (agree(dvl_over_receiver)) {
    if (std::abs(dvl_over_log) < FirstOffset::least_of_log_mps) return {};
    return FirstOffset{Of::log, -dvl_over_log};
  }
  if (std::abs(dvl_over_receiver) < FirstOffset::least_mps) return {};
  if (agree(receiver_over_log)) return FirstOffset{Of::dvl, dvl_over_receiver};
  if (agree(dvl_over_log)) return FirstOffset{Of::receiver, -dvl_over_receiver};
  return {};
}

}  // namespace drydock::consistency
