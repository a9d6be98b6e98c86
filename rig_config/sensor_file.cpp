#include "rig_config/sensor_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "rig_config/typed/build.hpp"

namespace drydock::rig_config {

namespace {

constexpr int digits_in_file = 7;

bool any_nonzero(const Axes& axes) {
  return std::ranges::any_of(axes, [](double x) { return x != 0; });
}

/// The lines of the keys of a kind. A correlation time appears only with a bias instability.
std::string quantity_lines(DeviceKind kind, const EmulateConfig& grade, const KeyComment& comment) {
  std::string out;
  for (const ErrorKey& key : error_keys) {
    const Axes& figures = grade.*key.quantity.*key.part;
    if (key.kind != kind || !any_nonzero(figures)) continue;
    const std::string behind = comment ? comment(key) : std::string();
    out += fmt::format("{} = {}{}\n", key.key, figures_text(figures, key.unit, digits_in_file),
                       behind.empty() ? "" : "  # " + behind);
  }
  for (const CorrelationKey& key : correlation_keys)
    if (key.kind == kind && any_nonzero((grade.*key.quantity).bias_instability))
      out += fmt::format("{} = {:.{}g}\n", key.key, (grade.*key.quantity).correlation_s,
                         digits_in_file);
  return out;
}

}  // namespace

std::string figures_text(const Axes& si, double unit, int digits) {
  const auto text = [&](double x) { return fmt::format("{:.{}g}", x / unit, digits); };
  if (si[0] == si[1] && si[1] == si[2]) return text(si[0]);
  return fmt::format("[{}, {}, {}]", text(si[0]), text(si[1]), text(si[2]));
}

std::string sensor_text(DeviceKind kind, const EmulateConfig& grade, const std::string& head,
                        const KeyComment& comment) {
  std::string out = "#:schema ../schema/rig.schema.json\n\n";
  std::istringstream lines(head);
  for (std::string line; std::getline(lines, line);)
    out += line.empty() ? "#\n" : "# " + line + "\n";
  out += fmt::format("\n[{}]\nfixed_bias = {}\n", to_string(kind), grade.fixed_bias);
  if (grade.rate_hz) out += fmt::format("rate_hz = {:.{}g}\n", *grade.rate_hz, digits_in_file);
  if (grade.latency_s > 0) out += fmt::format("latency_ms = {:.4g}\n", grade.latency_s * 1e3);
  if (grade.dropout.probability > 0)
    out += fmt::format("dropout_probability = {:.4g}\ndropout_mean_samples = {:.4g}\n",
                       grade.dropout.probability, grade.dropout.mean_samples);
  if (grade.primary.quantisation_carried) out += "quantisation_carried = true\n";
  return out + quantity_lines(kind, grade, comment);
}

}  // namespace drydock::rig_config
