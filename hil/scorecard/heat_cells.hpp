#pragma once

#include "hil/scorecard/heat_map.hpp"
#include "hil/scorecard/score.hpp"

/// Figures of a score as cells of a heat map.
namespace drydock::scorecard {

/// "0.1", "2.4", "31": short enough for a cell.
std::string short_number(double x);

HeatCell detect_cell(const Score& score);
HeatCell found_cell(const Score& score);   ///< amber if the device or the word is wrong
HeatCell others_cell(const Score& score);  ///< how many sound devices and causes were accused
HeatCell recover_cell(const Score& score);
HeatCell lost_cell(std::int64_t lost);
HeatCell wrong_cell(const Score& score);
HeatCell mistimed_cell(const Score& score);
HeatCell lies_cell(const Score& score);
HeatCell growth_cell(const EstimatorScore& estimator);  ///< factor on the error without a fault
HeatCell nees_cell(const EstimatorScore& estimator);
HeatCell recover_cell(const EstimatorScore& estimator);

/// Factor on the error without a fault: of the position if there is one and it grew more, else of
/// the attitude.
double growth_of(const EstimatorScore& estimator);

}  // namespace drydock::scorecard
