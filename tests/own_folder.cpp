// Tests run side by side, each in a process of its own. Two that write one file name would read the
// file of the other, so each process has a folder of its own for what it writes.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace drydock::test {
namespace {

/// Names the folder in the variables which GoogleTest's TempDir, the standard library and child
/// programs read, and deletes it when this process ends. Without a folder, the usual one stays.
class OwnFolder {
 public:
  OwnFolder() : path_(std::filesystem::temp_directory_path() / "drydock-test-XXXXXX") {
    if (::mkdtemp(path_.data()) == nullptr) {
      path_.clear();
      return;
    }
    ::setenv("TEST_TMPDIR", path_.c_str(), 1);
    ::setenv("TMPDIR", path_.c_str(), 1);
  }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;
  ~OwnFolder() {
    std::error_code ignored;
    if (!path_.empty() && ::getpid() == owner_) std::filesystem::remove_all(path_, ignored);
  }

 private:
  std::string path_;
  pid_t owner_ = ::getpid();
};

const OwnFolder own_folder;

}  // namespace
}  // namespace drydock::test
