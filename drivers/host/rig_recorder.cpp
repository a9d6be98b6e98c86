#include "drivers/host/rig_recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

#include "drivers/host/rig_bus.hpp"
#include "drivers/link/uri.hpp"
#include "drivers/recordings/record/part_files.hpp"
#include "drivers/terminal/data_size.hpp"
#include "drivers/wire/protocols.hpp"
#include "rig_config/estimator_name.hpp"

namespace drydock::host {

namespace {

namespace fs = std::filesystem;

/// "serial:/dev/ttyUSB0?baud=9600" -> "ttyUSB0", "tcp:10.0.0.2:4001" -> "10.0.0.2_4001".
std::string short_name(const link::Uri& uri) {
  std::string name = uri.target.substr(uri.target.rfind('/') + 1);
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '-') c = '_';
  return name.empty() ? "link" : name;
}

bool speaks_frames(const rig_config::DeviceConfig& device) {
  const wire::Protocol* known = rig_config::protocol_of(device);
  return known && known->travels == wire::Travels::as_frames;
}

std::vector<record::RecordedLink> links_of(const rig_config::Rig& rig) {
  std::vector<record::RecordedLink> links;
  std::set<std::string> names;
  for (const auto& device : rig.devices) {
    const auto known = std::ranges::find(links, device.link, &record::RecordedLink::uri);
    if (known != links.end()) {
      known->devices.push_back(device.name);
      continue;
    }
    const auto uri = link::parse_uri(device.link).value();
    std::string name = short_name(uri);
    for (int i = 2; !names.insert(name).second; ++i)
      name = fmt::format("{}-{}", short_name(uri), i);
    const bool frames =
        uri.recorded() ? speaks_frames(device) : uri.carries() == link::Carries::frames;
    links.push_back({device.link, name, frames, {device.name}});
  }
  return links;
}

/// How the rig's files refer to one of them. The loader may have shortened its path.
std::string reference(const fs::path& path, const fs::path& folder) {
  const bool as_it_stands = path.string().starts_with((folder / "").string());
  return path.lexically_relative(as_it_stands ? folder : folder.lexically_normal())
      .lexically_normal()
      .string();
}

/// The rig's files as attachments. Each has the path by which the files refer to it; the rig's own
/// file is "rig.toml".
std::vector<mcap::Attachment> attachments_of(const rig_config::Rig& rig, std::uint64_t time) {
  std::vector<mcap::Attachment> attachments;
  for (const auto& path : rig.files) {
    std::ifstream in(path, std::ios::binary);
    const bool own = attachments.empty();
    const auto folder = fs::path(rig.file).parent_path();
    attachments.push_back({time,
                           time,
                           own ? "rig.toml" : reference(path, folder),
                           "application/toml",
                           {std::istreambuf_iterator<char>(in), {}}});
  }
  return attachments;
}

record::RecorderOptions recorder_options(const rig_config::Rig& rig, measurement::Stamp start,
                                         record::WhenBehind when_behind) {
  record::RecorderOptions options;
  options.links = links_of(rig);
  options.devices = bus_devices(rig);
  options.estimators = estimator_names(rig);
  options.navigators = navigator_names(rig);
  for (auto* names : {&options.estimators, &options.navigators})
    names->emplace_back(rig_config::name_of_truth);
  options.innovations = innovation_sources(rig);
  options.versions = {{"drydock", DRYDOCK_VERSION}, {"rig", rig.name}};
  options.attachments =
      attachments_of(rig, static_cast<std::uint64_t>(start.time_since_epoch().count()));
  options.when_behind = when_behind;
  return options;
}

[[noreturn]] void refuse(const std::string& path, const boost::system::error_code& error) {
  throw std::runtime_error("cannot record to " + mcap::refused(path, error));
}

record::Parts one_file(const RecordOptions& options, mcap::Sync sync) {
  auto sink = mcap::file_sink(options.path, options.overwrite, sync);
  if (!sink) refuse(options.path, sink.error());
  return {{std::move(*sink), options.path}};
}

record::Parts many_files(const RecordOptions& options, mcap::Sync sync) {
  auto files = std::make_shared<record::PartFiles>(options.path, sync);
  auto first = files->next();
  if (!first) refuse(options.path, first.error());
  return {std::move(*first), options.split, [files] { return files->next(); }};
}

record::Parts open_files(const RecordOptions& options, record::WhenBehind when_behind) {
  const bool real_time = when_behind == record::WhenBehind::lose;
  const auto sync = real_time ? mcap::Sync::each_write : mcap::Sync::never;
  if (!options.split.divides()) return one_file(options, sync);
  auto parts = many_files(options, sync);
  parts.split.virtual_time = !real_time;
  return parts;
}

}  // namespace

RigRecorder::RigRecorder(const rig_config::Rig& rig, const RecordOptions& options, Stamp start,
                         record::WhenBehind when_behind)
    : RigRecorder(rig, open_files(options, when_behind), start, when_behind) {}

RigRecorder::RigRecorder(const rig_config::Rig& rig, record::Parts parts, Stamp start,
                         record::WhenBehind when_behind)
    : path_(parts.first.path),
      recorder_(std::move(parts), recorder_options(rig, start, when_behind)),
      findings_(bus_devices(rig)),
      integrity_(estimator_names(rig)),
      truth_(rig.estimators.size()) {}

RigRecorder::~RigRecorder() {
  std::error_code ignored;
  if (!finished_ && recorder_.status().messages == 0 && fs::is_regular_file(path_, ignored))
    fs::remove(path_, ignored);
}

void RigRecorder::record(const Estimate& estimate, std::size_t index) {
  recorder_.topics().publish(estimate.attitude, index);
  if (estimate.navigation) recorder_.topics().publish(*estimate.navigation, index);
}

void RigRecorder::tick(Stamp now) {
  recorder_.tick(now);
  if (told_ || !failed()) return;
  told_ = true;
  const auto status = recorder_.status();
  fmt::print(stderr, "recording to {} has failed: {}; the drivers go on without\n",
             status.failed_file.empty() ? path_ : status.failed_file, status.error.message());
}

std::string RigRecorder::finish() {
  finished_ = true;
  const auto error = recorder_.finish();
  const auto status = recorder_.status();
  if (error)
    return fmt::format("recording {}: {} messages, then: {}; {} lost",
                       status.failed_file.empty() ? path_ : status.failed_file, status.messages,
                       error.message(), status.lost);
  std::string files = path_;
  if (status.files > 1) files += fmt::format(" and {} more", status.files - 1);
  if (status.deleted > 0) files += fmt::format(", the oldest {} deleted", status.deleted);
  const auto clock = recorder_.clock_note();
  return fmt::format("recording {}: {} messages, {}, {} lost{}", files, status.messages,
                     terminal::data_size_text(status.bytes), status.lost,
                     clock.empty() ? "" : "; " + clock);
}

}  // namespace drydock::host
