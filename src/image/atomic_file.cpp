#include "image/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace blysk {
namespace {

constexpr int kTries = 100;
constexpr mode_t kMode = 0644;  // less the process's umask

// A temporary file's name where a signal handler finds it. The owner goes free -> filling -> set -> free; a
// handler takes set -> taken and keeps it, so that nobody fills the name while it is read.
struct Slot {
  enum State : int { free, filling, set, taken };
  std::atomic<int> state{free};
  char path[PATH_MAX];
};
static_assert(std::atomic<int>::is_always_lock_free);

// More files than this at once are written too, but a signal leaves them.
std::array<Slot, 16> slots;

class Registration {
 public:
  explicit Registration(const std::string& path) {
    if (path.size() >= sizeof Slot::path) return;
    for (Slot& slot : slots) {
      int expected = Slot::free;
      if (!slot.state.compare_exchange_strong(expected, Slot::filling)) continue;
      std::memcpy(slot.path, path.c_str(), path.size() + 1);
      slot.state.store(Slot::set);
      slot_ = &slot;
      return;
    }
  }
  ~Registration() {
    int expected = Slot::set;
    if (slot_ != nullptr) slot_->state.compare_exchange_strong(expected, Slot::free);
  }
  Registration(const Registration&) = delete;
  Registration& operator=(const Registration&) = delete;

 private:
  Slot* slot_ = nullptr;
};

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

bool is_folder(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

std::string reason_of(int error, const std::string& path) {
  if (path.empty()) return "its name is empty; give one";
  switch (error) {
    case ENOENT:
      if (is_folder(folder_of(path)))  // of those that a kernel makes
        return "the folder " + folder_of(path) + " takes no files; choose another place";
      return "the folder " + folder_of(path) + " does not exist; create it first";
    case ENOTDIR:
      return folder_of(path) + " is not a folder; choose another one";
    case EISDIR:
      return "this is a folder; name a file in it";
    case EACCES:
    case EPERM:
      return "no permission; choose another place or change the permissions of the file or its folder";
    case EROFS:
      return "the file system is read-only; choose another place";
    case ENOSPC:
    case EDQUOT:
      return "no space left; free some or choose another place";
    case ENAMETOOLONG:
      return "the name is too long; choose a shorter one";
    default:
      break;
  }
  const char* description = strerrordesc_np(error);  // unlike strerror, the same in every locale
  return description != nullptr ? description : "system error " + std::to_string(error);
}

Error failure(int error, const std::string& path) {
  return Error{.code = ErrorCode::output,
               .message = "cannot write the file: " + reason_of(error, path),
               .source = path == "-" ? "standard output" : path};
}

// 0 or an errno.
int write_all(int file, std::span<const ByteSpan> pieces) {
  for (ByteSpan piece : pieces) {
    while (!piece.empty()) {
      const ssize_t written = ::write(file, piece.data(), std::min<std::size_t>(piece.size(), 1 << 30));
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return errno;
      piece = piece.subspan(static_cast<std::size_t>(written));
    }
  }
  return 0;
}

// Writes and closes; 0 or an errno. A close may bring the error of an earlier write (NFS, quotas).
int write_and_close(int file, std::span<const ByteSpan> pieces) {
  const int error = write_all(file, pieces);
  const bool closed = ::close(file) == 0 || errno == EINTR;
  return error != 0 ? error : closed ? 0 : errno;
}

std::string temporary_name(const std::string& path) {
  static std::atomic<unsigned> counter{0};
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  return folder_of(path) + "/.blysk-" + std::to_string(::getpid()) + "-" + std::to_string(now) + "-" +
         std::to_string(counter.fetch_add(1)) + ".tmp";
}

int replace_file(const std::string& path, std::span<const ByteSpan> pieces) {
  for (int i = 0; i < kTries; ++i) {
    const std::string temporary = temporary_name(path);
    const Registration registration(temporary);  // before there is a file, lest a signal come between
    const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kMode);
    if (file < 0 && errno == EEXIST) continue;
    if (file < 0) return errno;
    int error = write_and_close(file, pieces);
    if (error == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
    if (error != 0) ::unlink(temporary.c_str());
    return error;
  }
  return EEXIST;
}

// Where a symbolic link leads: the link is to stay.
std::string target_of(const std::string& path) {
  char* resolved = ::realpath(path.c_str(), nullptr);
  std::string target = resolved != nullptr ? resolved : path;
  std::free(resolved);
  return target;
}

int write_path(const std::string& path, std::span<const ByteSpan> pieces) {
  if (path == "-") return write_all(STDOUT_FILENO, pieces);
  if (path.empty()) return EINVAL;
  if (path.back() == '/') return EISDIR;
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return replace_file(path, pieces);
  if (S_ISDIR(status.st_mode)) return EISDIR;
  if (S_ISREG(status.st_mode)) {
    // Renaming would also replace a file that its owner has made read-only.
    return ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0 ? errno
                                                                      : replace_file(target_of(path), pieces);
  }
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  return file < 0 ? errno : write_and_close(file, pieces);
}

}  // namespace

Status write_whole_file(const std::string& path, std::span<const ByteSpan> pieces) {
  const int error = write_path(path, pieces);
  if (error != 0) return failure(error, path);
  return Done{};
}

void remove_unfinished_files() noexcept {
  const int saved = errno;
  for (Slot& slot : slots) {
    int expected = Slot::set;
    if (slot.state.compare_exchange_strong(expected, Slot::taken)) ::unlink(slot.path);
  }
  errno = saved;
}

}  // namespace blysk
