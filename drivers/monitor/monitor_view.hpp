#pragma once

#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/device/health_account.hpp"
#include "drivers/diagnosis/finding_account.hpp"
#include "drivers/host/follower.hpp"

namespace drydock::monitor {

/// The last measured value of one field, as text for a person: "velocity", "1.2 0.1 0.0 m/s".
struct ShownValue {
  std::string name, text;
};

/// One device in the display of a monitor or a run.
struct DeviceView : device::HealthAccount {
  bool streaming = false;
  std::optional<double> bus_load;  ///< on a CAN bus: share of its bit rate, 0 to 1
  std::optional<double> bits_per_second;
  std::string can_state;  ///< state of the CAN controller; empty: not known
  /// Time of validity and arrival are separate; their difference is the latency.
  std::optional<double> valid_at_s, received_at_s, device_time_s, latency_s;
  std::optional<diagnosis::FindingAccount> finding;  ///< what is wrong now; times are UTC
  std::vector<ShownValue> values;
};

/// Fills a view from health. `values` and times stay empty.
DeviceView view_of(const device::Device& device, const device::Health& health);

/// The last measurement of each device, for every type that it gives.
class Latest final : public host::Follower {
 public:
  void on_measurement(const measurement::Measurement& measurement) override;
  /// Puts the values and the times of the newest measurement into a view.
  void show(std::uint16_t device, DeviceView& view) const;

 private:
  std::map<std::pair<std::uint16_t, std::size_t>, measurement::Measurement> measurements_;
};

/// Colours and bold text on a terminal. Nothing if the output is no terminal or NO_COLOR is set.
class Palette {
 public:
  explicit Palette(bool terminal);
  std::string state(std::string_view state, std::string_view text) const;
  std::string changed(std::string_view text) const;

 private:
  bool colour_;
};

/// The line of a device. The table of a run uses it too.
std::string headline(const DeviceView& view, const Palette& palette);

/// All lines of the devices. Values that changed since the previous call are highlighted.
class DeviceTable {
 public:
  explicit DeviceTable(bool terminal) : palette_(terminal) {}
  std::vector<std::string> lines(const std::vector<DeviceView>& views);

 private:
  std::string value_text(const DeviceView& view, const ShownValue& value);

  Palette palette_;
  std::map<std::string, std::string, std::less<>> before_;
};

/// Draws lines over the previous ones.
class Overdrawn {
 public:
  explicit Overdrawn(std::FILE* out) : out_(out) {}
  void draw(const std::vector<std::string>& lines);
  void finish() { drawn_ = 0; }

 private:
  std::FILE* out_;
  std::size_t drawn_ = 0;
};

/// Prints one JSON object for each device: its health account, then the other fields of DeviceView.
void print_json(const std::vector<DeviceView>& views, std::FILE* out);

}  // namespace drydock::monitor
