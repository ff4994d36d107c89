// Picture files: their bytes come as those of models do.
#include "blysk/image.h"
#include "io/reader.h"

namespace blysk {

Result<Image> read_picture(const std::string& path, const Limits& limits) {
  const Result<io::FileBytes> file = io::FileBytes::open(path, limits.max_memory);
  if (!file) return file.error();
  return read_picture(file->bytes(), path == "-" ? "standard input" : path, limits);
}

}  // namespace blysk
