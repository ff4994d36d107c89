// Files are mapped: what the page cache holds is not copied. A file that somebody else cuts short while it is
// read raises SIGBUS; that is the price. Pipes are read into a mapping that the kernel moves as it grows.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "io/reader.h"

namespace blysk::io {
namespace {

constexpr std::size_t kFirstBlock = std::size_t{1} << 20;

struct Descriptor {
  int number = -1;
  ~Descriptor() {
    if (number > STDIN_FILENO) close(number);
  }
};

std::string shown(const std::string& path) { return path == "-" ? "standard input" : path; }

std::string what_to_do(int error) {
  switch (error) {
    case ENOENT:
    case ENOTDIR:
      return "there is no such file; check its name and folder";
    case EACCES:
      return "no permission; change the permissions of the file or its folder";
    case ENAMETOOLONG:
      return "the name is too long; shorten it";
    case ENOMEM:
      return "there is not enough memory for it; free some, or take a smaller model";
    default:
      return std::generic_category().message(error) + "; check the file and its disk";
  }
}

Error unreadable(const std::string& path, int error) {
  if (path.empty()) return {ErrorCode::input, "a model's name is empty; give the name of a file", ""};
  return {ErrorCode::input, "cannot be read: " + what_to_do(error), shown(path)};
}

Error too_large(const std::string& path, std::uint64_t max_bytes) {
  return {ErrorCode::limit,
          "is larger than the limit of " + std::to_string(max_bytes) + " bytes; raise --max-memory",
          shown(path)};
}

// A growing anonymous mapping.
struct Block {
  void* memory = MAP_FAILED;
  std::size_t capacity = 0;

  ~Block() {
    if (memory != MAP_FAILED) munmap(memory, capacity);
  }
  bool grow() {
    const std::size_t larger = capacity == 0 ? kFirstBlock : 2 * capacity;
    void* moved = capacity == 0
                      ? mmap(nullptr, larger, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)
                      : mremap(memory, capacity, larger, MREMAP_MAYMOVE);
    if (moved == MAP_FAILED) return false;
    memory = moved;
    capacity = larger;
    return true;
  }
  std::byte* bytes() const { return static_cast<std::byte*>(memory); }
};

}  // namespace

FileBytes::~FileBytes() {
  if (mapped_ != 0) munmap(const_cast<std::byte*>(bytes_.data()), mapped_);
}

FileBytes::FileBytes(FileBytes&& other) noexcept
    : bytes_(std::exchange(other.bytes_, {})), mapped_(std::exchange(other.mapped_, 0)) {}

FileBytes& FileBytes::operator=(FileBytes&& other) noexcept {
  std::swap(bytes_, other.bytes_);
  std::swap(mapped_, other.mapped_);
  return *this;
}

Result<FileBytes> FileBytes::open(const std::string& path, std::uint64_t max_bytes) {
  Descriptor file;
  file.number = path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status {};
  if (file.number < 0 || fstat(file.number, &status) != 0) return unreadable(path, errno);
  if (S_ISDIR(status.st_mode)) return Error{ErrorCode::input, "is a folder; name a file in it", shown(path)};

  FileBytes result;
  const auto size = static_cast<std::uint64_t>(status.st_size);
  const bool from_start = path != "-" || lseek(file.number, 0, SEEK_CUR) == 0;
  if (S_ISREG(status.st_mode) && size > 0 && from_start) {
    if (size > max_bytes) return too_large(path, max_bytes);
    void* memory = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.number, 0);
    if (memory != MAP_FAILED) {
      result.bytes_ = {static_cast<const std::byte*>(memory), size};
      result.mapped_ = size;
      return result;
    }
  }

  Block block;
  std::size_t used = 0;
  for (;;) {
    if (used > max_bytes) return too_large(path, max_bytes);
    if (used == block.capacity && !block.grow()) return unreadable(path, ENOMEM);
    const ssize_t got = read(file.number, block.bytes() + used, block.capacity - used);
    if (got == 0) break;
    if (got < 0 && errno != EINTR) return unreadable(path, errno);
    if (got > 0) used += static_cast<std::size_t>(got);
  }
  result.bytes_ = {block.bytes(), used};
  result.mapped_ = std::exchange(block.capacity, 0);
  block.memory = MAP_FAILED;
  return result;
}

}  // namespace blysk::io
