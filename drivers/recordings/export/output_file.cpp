#include "drivers/recordings/export/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace drydock::exporting {

OutputFile::OutputFile(std::string path, bool overwrite) : path_(std::move(path)) {
  file_.reset(path_ == "-" ? stdout : std::fopen(path_.c_str(), overwrite ? "wb" : "wbx"));
  if (!file_) fail();
}

void OutputFile::fail() {
  const int why = errno;
  if (!error_.empty()) return;
  std::error_code gone;
  const bool folder = std::filesystem::is_directory(path_, gone);
  error_ = path_ + ": " + (folder ? "is a folder, not a file" : std::strerror(why)) +
           (why == EEXIST && !folder ? "; --overwrite replaces it" : "");
}

void OutputFile::write(std::string_view text) {
  if (!error_.empty()) return;
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) fail();
}

void OutputFile::write(std::span<const std::uint8_t> bytes) {
  write(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void OutputFile::close() {
  if (error_.empty() && std::fflush(file_.get()) != 0) fail();
}

OutputFile& OutputFolder::file(const std::string& name) {
  const auto known = files_.find(name);
  if (known != files_.end()) return known->second;
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) folder_error_ = folder_ + ": " + error.message();
  return files_.try_emplace(name, (std::filesystem::path(folder_) / name).string(), overwrite_)
      .first->second;
}

void OutputFolder::close() {
  for (auto& [name, file] : files_) file.close();
}

std::string OutputFolder::error() const {
  if (!folder_error_.empty()) return folder_error_;
  for (const auto& [name, file] : files_)
    if (!file.error().empty()) return file.error();
  return {};
}

}  // namespace drydock::exporting
