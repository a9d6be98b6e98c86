#pragma once

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/decode/decode.hpp"

/// Runs `decode` and keeps its output.
namespace drydock::decode {

/// A file in memory. `text()` is the text written to it.
class MemoryFile {
 public:
  MemoryFile() : file_(open_memstream(&data_, &size_)) {}
  ~MemoryFile() {
    std::fclose(file_);
    std::free(data_);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::FILE* file() { return file_; }
  std::string text() {
    std::fflush(file_);
    return {data_, size_};
  }

 private:
  char* data_ = nullptr;
  std::size_t size_ = 0;
  std::FILE* file_;
};

struct Decoded {
  int exit_code = 0;
  std::string out, err;

  /// Each line, parsed by another JSON library.
  std::vector<nlohmann::json> lines() const {
    std::vector<nlohmann::json> parsed;
    std::istringstream in(out);
    for (std::string line; std::getline(in, line);) parsed.push_back(nlohmann::json::parse(line));
    return parsed;
  }
};

inline Decoded run_decode(const DecodeOptions& options) {
  MemoryFile out, err;
  Decoded result;
  result.exit_code = decode(options, out.file(), err.file());
  result.out = out.text();
  result.err = err.text();
  return result;
}

/// A file with these bytes. It is deleted after the test.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::string_view bytes) {
    const int fd = mkstemp(path_.data());
    if (::write(fd, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) std::abort();
    ::close(fd);
  }
  ~TemporaryFile() { ::unlink(path_.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_ = "/tmp/drydock_decode_XXXXXX";
};

inline std::string read_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return std::move(text).str();
}

}  // namespace drydock::decode
