#pragma once

#include <cstdio>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace drydock::exporting {

/// A new file that is written in blocks. It keeps the first error and ignores all later writes.
class OutputFile {
 public:
  /// `path` must not exist, unless `overwrite`. "-" means standard output.
  OutputFile(std::string path, bool overwrite);

  void write(std::string_view text);
  void write(std::span<const std::uint8_t> bytes);
  void close();

  /// Empty, or one line.
  const std::string& error() const { return error_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const {
      if (file != stdout) std::fclose(file);
    }
  };
  void fail();

  std::string path_, error_;
  std::unique_ptr<std::FILE, Close> file_;
};

/// Files of one folder by name. Each is made when it is first requested.
class OutputFolder {
 public:
  OutputFolder(std::string folder, bool overwrite)
      : folder_(std::move(folder)), overwrite_(overwrite) {}

  OutputFile& file(const std::string& name);
  void close();
  std::string error() const;
  std::size_t size() const { return files_.size(); }

 private:
  std::string folder_, folder_error_;
  bool overwrite_;
  std::map<std::string, OutputFile> files_;
};

}  // namespace drydock::exporting
