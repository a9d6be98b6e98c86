#include "drivers/host/page_recorder.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "drivers/measurement/stamp.hpp"

namespace drydock::host {

namespace {

namespace fs = std::filesystem;

/// "demo-20261121T090000Z.mcap": the rig and the UTC time of the start.
std::string file_name(std::string rig, measurement::Stamp at) {
  std::ranges::replace_if(
      rig, [](unsigned char c) { return std::isalnum(c) == 0; }, '-');
  const auto seconds = std::chrono::floor<std::chrono::seconds>(at.time_since_epoch()).count();
  return fmt::format("{}-{:%Y%m%dT%H%M%SZ}.mcap", rig, fmt::gmtime(std::time_t{seconds}));
}

constexpr const char* nothing_asked = R"({"type":"object","properties":{}})";
constexpr const char* state_schema = R"({"type":"object","properties":{
"recording":{"type":"boolean"},"file":{"type":"string"},"since_s":{"type":"number"},
"bytes":{"type":"number"},"last":{"type":"string"}}})";

}  // namespace

PageRecorder::PageRecorder(const rig_config::Rig& rig, std::string folder, Now now)
    : rig_(rig), folder_(std::move(folder)), now_(std::move(now)) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (!fs::is_directory(folder_))
    throw std::runtime_error(fmt::format("--allow-recording {}: cannot make this folder{}", folder_,
                                         error ? ": " + error.message() : ""));
}

std::vector<live::Service> PageRecorder::services() {
  const auto service = [](const char* name, const char* type, auto serve) {
    return live::Service{
        name, type, nothing_asked, state_schema,
        [serve](std::string_view, const live::Service::Answered& answered) { answered(serve()); }};
  };
  return {service("/drydock/recording/start", "drydock/StartRecording", [this] { return start(); }),
          service("/drydock/recording/stop", "drydock/StopRecording", [this] { return stop(); }),
          service("/drydock/recording/state", "drydock/RecordingState",
                  [this] { return live::ServiceAnswer{state_json()}; })};
}

live::ServiceAnswer PageRecorder::start() {
  if (recorder_) return live::Refused{"already recording to " + path_};
  const Stamp now = now_();
  const auto path = (fs::path(folder_) / file_name(rig_.name, now)).string();
  try {
    recorder_.emplace(rig_, RecordOptions{.path = path}, now, record::WhenBehind::lose);
  } catch (const std::exception& error) {
    return live::Refused{error.what()};
  }
  path_ = path;
  since_ = now;
  if (!faults_.empty()) recorder_->on_faults(faults_, now);
  return state_json();
}

live::ServiceAnswer PageRecorder::stop() {
  if (!recorder_) return live::Refused{"nothing is recorded"};
  finish();
  return state_json();
}

std::string PageRecorder::finish() {
  if (!recorder_) return {};
  last_ = recorder_->finish();
  recorder_.reset();
  return last_;
}

std::string PageRecorder::state_json() const {
  nlohmann::json state{{"recording", records()}};
  if (recorder_) {
    state["file"] = path_;
    state["since_s"] = measurement::seconds(since_.time_since_epoch());
    state["bytes"] = recorder_->bytes();
  } else if (!last_.empty()) {
    state["last"] = last_;
  }
  return state.dump();
}

void PageRecorder::on_bytes(std::string_view link, shell::Direction way, wire::Bytes bytes,
                            Stamp at) {
  if (recorder_) recorder_->on_bytes(link, way, bytes, at);
}

void PageRecorder::on_frame(std::string_view link, shell::Direction way,
                            const wire::CanFrame& frame, Stamp at) {
  if (recorder_) recorder_->on_frame(link, way, frame, at);
}

void PageRecorder::on_measurement(const measurement::Measurement& measurement) {
  if (recorder_) recorder_->on_measurement(measurement);
}

void PageRecorder::on_estimate(const Estimate& estimate) {
  if (recorder_) recorder_->on_estimate(estimate);
}

void PageRecorder::on_truth(const Estimate& truth) {
  if (recorder_) recorder_->on_truth(truth);
}

void PageRecorder::on_innovation(const bus::Innovation& innovation) {
  if (recorder_) recorder_->on_innovation(innovation);
}

void PageRecorder::on_health(const HealthReport& health, Stamp now) {
  if (recorder_) recorder_->on_health(health, now);
}

void PageRecorder::on_finding(const diagnosis::Finding& finding) {
  if (recorder_) recorder_->on_finding(finding);
}

void PageRecorder::on_faults(std::span<const bus::Fault> faults, Stamp now) {
  faults_.assign(faults.begin(), faults.end());
  if (recorder_) recorder_->on_faults(faults, now);
}

void PageRecorder::tick(Stamp now) {
  if (recorder_) recorder_->tick(now);
}

}  // namespace drydock::host
