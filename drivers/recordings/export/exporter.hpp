#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "drivers/recordings/record/selection.hpp"

/// Converts recordings to the formats of other programs.
namespace drydock::exporting {

using record::RawBytes;
using record::RawFrame;
using record::RecordedLink;

enum class Format : std::uint8_t { candump, pcapng, raw, csv, nmea };

struct FormatEntry {
  const char* name;
  Format format;
  const char* suffix;  ///< of the file or folder that it makes
  bool folder;
};
inline constexpr std::array formats{FormatEntry{"candump", Format::candump, ".log", false},
                                    FormatEntry{"pcapng", Format::pcapng, ".pcapng", false},
                                    FormatEntry{"raw", Format::raw, "-raw", true},
                                    FormatEntry{"csv", Format::csv, "-csv", true},
                                    FormatEntry{"nmea", Format::nmea, ".nmea", false}};

struct Target {
  std::string path;  ///< file or folder
  bool overwrite = false;
  bool plain = false;      ///< format nmea: sentences without their time
  bool direction = false;  ///< format candump: who sent each frame
};

/// Takes the records that its format can hold and ignores the others.
class Exporter {
 public:
  virtual ~Exporter() = default;
  virtual void on_bytes(const RawBytes&, std::size_t /*link*/) {}
  virtual void on_frame(const RawFrame&, std::size_t /*link*/) {}
  virtual void on_message(const record::Understood&) {}
  virtual void finish() = 0;

  virtual std::string error() const = 0;  ///< empty, or one line
  /// What it passed over of what its format holds, a line each.
  virtual std::vector<std::string> notes() const { return {}; }
  std::uint64_t written() const { return written_; }

 protected:
  std::uint64_t written_ = 0;  ///< frames, reads, messages or sentences
};

std::unique_ptr<Exporter> make_candump(const std::vector<RecordedLink>& links, const Target& to);
std::unique_ptr<Exporter> make_pcapng(const std::vector<RecordedLink>& links, const Target& to);
std::unique_ptr<Exporter> make_raw(const std::vector<RecordedLink>& links, const Target& to);
std::unique_ptr<Exporter> make_csv(const Target& to);
std::unique_ptr<Exporter> make_nmea(const std::vector<RecordedLink>& links, const Target& to);

struct Exported {
  std::uint64_t written = 0;
  bool ended_early = false;  ///< the watch ended it
  std::string damage;        ///< of the recording; empty: none
  std::vector<std::string> notes;
};

/// Exports the selected part of a recording.
boost::system::result<Exported, record::RecordingError> export_recording(
    const std::string& recording, const record::Selection& selection, Format format,
    const Target& to, const record::Watch& watch);

}  // namespace drydock::exporting
