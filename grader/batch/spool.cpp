#include "grader/batch/spool.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <system_error>

#include "base/json.hpp"
#include "grader/batch/descriptor.hpp"

namespace blossom {
namespace {

constexpr std::size_t header_bytes = 12;
constexpr std::size_t buffer_bytes = 16u << 10;  // 256 of them are 4 MiB
constexpr std::uint64_t offset_bits = 40;        // of a place within a part; the others say which student of it
constexpr std::string_view magic = "blossom spool 1\n";
constexpr std::uint64_t no_digest = 0xcbf29ce484222325;

std::string part_name(std::size_t part) {
  char name[16];
  std::snprintf(name, sizeof name, "%03zu.part", part);
  return name;
}

// FNV-1a by words of eight bytes rather than by bytes, with the length of what was digested: a million submissions are
// digested in a fraction of a second.
std::uint64_t digest(std::uint64_t h, std::string_view bytes) {
  constexpr std::uint64_t prime = 0x100000001b3;
  h = (h ^ bytes.size()) * prime;
  for (std::size_t i = 0; i < bytes.size(); i += 8) {
    std::uint64_t word = 0;
    for (std::size_t k = std::min(i + 8, bytes.size()); k > i; --k)
      word = word << 8 | static_cast<unsigned char>(bytes[k - 1]);
    h = (h ^ word) * prime;
    h ^= h >> 29;
  }
  return h;
}

void append_little_endian(std::string& out, std::uint64_t number, std::size_t bytes) {
  for (std::size_t i = 0; i < bytes; ++i) out += static_cast<char>(number >> (8 * i) & 0xFF);
}
std::uint64_t little_endian(std::string_view bytes) {
  std::uint64_t number = 0;
  for (std::size_t i = bytes.size(); i > 0; --i) number = number << 8 | static_cast<unsigned char>(bytes[i - 1]);
  return number;
}

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw std::system_error(errno, std::generic_category(), path.string());
}

void write_all(int fd, std::string_view content, const std::filesystem::path& path) {
  while (!content.empty()) {
    const ssize_t put = ::write(fd, content.data(), content.size());
    if (put < 0 && errno != EINTR) fail(path);
    content.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(put, 0)));
  }
}

void sync(const std::filesystem::path& path) {
  const Descriptor fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (fd < 0 || ::fsync(fd) != 0) fail(path);
}

// Up to so many bytes from there; fewer at the end of the file or when it can't be read.
std::size_t read_at(int fd, std::uint64_t offset, char* to, std::size_t count) {
  std::size_t done = 0;
  while (done < count) {
    const ssize_t got = ::pread(fd, to + done, count - done, static_cast<off_t>(offset + done));
    if (got == 0 || (got < 0 && errno != EINTR)) break;
    done += static_cast<std::size_t>(std::max<ssize_t>(got, 0));
  }
  return done;
}

}  // namespace

Spool::Spool(std::filesystem::path folder, std::uint64_t part_size)
    : folder_(std::move(folder)), part_size_(part_size) {
  if (part_size_ == 0 || part_size_ > most_spool_part_size) throw std::length_error("spool: size of a part");
  std::filesystem::create_directories(folder_);
  std::filesystem::remove(folder_ / "complete");
  for (std::size_t part = 0; part < most_spool_parts; ++part) std::filesystem::remove(folder_ / part_name(part));
  for (SpoolPart& part : parts_) part.digest = no_digest;
}

void Spool::add(std::uint64_t student, std::string_view record) {
  const std::uint64_t part = student / part_size_;
  if (part >= most_spool_parts) throw std::length_error("spool: more students than its parts have room for");
  if (record.size() > most_spool_record_bytes) throw std::length_error("spool: size of a record");
  SpoolPart& known = parts_[part];
  if (known.bytes + header_bytes + record.size() > most_spool_part_bytes)
    throw std::length_error("spool: size of a part");
  std::string header;
  append_little_endian(header, student, 8);
  append_little_endian(header, record.size(), 4);
  known.bytes += header.size() + record.size();
  known.records += 1;
  known.digest = digest(digest(known.digest, header), record);

  std::string& buffer = buffers_[part];
  if (buffer.capacity() < buffer_bytes) buffer.reserve(buffer_bytes);
  if (buffer.size() + header.size() + record.size() > buffer_bytes) flush(part);
  buffer += header;
  if (buffer.size() + record.size() <= buffer_bytes) {
    buffer += record;
    return;
  }
  const std::filesystem::path path = folder_ / part_name(part);
  flush(part);
  const Descriptor fd(::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
  if (fd < 0) fail(path);
  write_all(fd, record, path);
}

// Files are opened for each buffer: 256 open ones would be a quarter of what a process may have.
void Spool::flush(std::size_t part) {
  if (buffers_[part].empty()) return;
  const std::filesystem::path path = folder_ / part_name(part);
  const Descriptor fd(::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
  if (fd < 0) fail(path);
  write_all(fd, buffers_[part], path);
  buffers_[part].clear();
}

void Spool::finish() {
  std::string content(magic);
  append_little_endian(content, part_size_, 8);
  for (std::size_t part = 0; part < most_spool_parts; ++part) {
    flush(part);
    std::string().swap(buffers_[part]);
    if (parts_[part].records > 0) sync(folder_ / part_name(part));
    append_little_endian(content, parts_[part].bytes, 8);
    append_little_endian(content, parts_[part].records, 8);
    append_little_endian(content, parts_[part].digest, 8);
  }
  append_little_endian(content, digest(no_digest, content), 8);

  const std::filesystem::path temporary = folder_ / "complete.tmp";
  {
    const Descriptor fd(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (fd < 0) fail(temporary);
    write_all(fd, content, temporary);
    if (::fsync(fd) != 0) fail(temporary);
  }
  std::filesystem::rename(temporary, folder_ / "complete");
  sync(folder_);
}

std::optional<SpoolReader> SpoolReader::open(const std::filesystem::path& folder) {
  const Descriptor fd(::open((folder / "complete").c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  constexpr std::size_t size = magic.size() + 8 + most_spool_parts * 24 + 8;
  std::string content(size + 1, '\0');
  if (fd < 0 || read_at(fd, 0, content.data(), content.size()) != size) return std::nullopt;
  content.resize(size);
  const std::string_view told = std::string_view(content).substr(0, size - 8);
  if (!told.starts_with(magic) || little_endian(std::string_view(content).substr(size - 8)) != digest(no_digest, told))
    return std::nullopt;

  SpoolReader reader;
  reader.folder_ = folder;
  const auto number = [&](std::size_t i) { return little_endian(told.substr(magic.size() + 8 * i, 8)); };
  reader.part_size_ = number(0);
  for (std::size_t part = 0; part < most_spool_parts; ++part)
    reader.parts_.push_back({number(1 + 3 * part), number(2 + 3 * part), number(3 + 3 * part)});
  while (!reader.parts_.empty() && reader.parts_.back().records == 0) reader.parts_.pop_back();
  return reader;
}

std::uint64_t SpoolReader::records() const {
  std::uint64_t sum = 0;
  for (const SpoolPart& part : parts_) sum += part.records;
  return sum;
}

// First all of the part is looked through, and compared with what was finished; then its records are read one by one.
Checked<SpoolReader::Walk> SpoolReader::walk(std::size_t part) const {
  if (part >= parts_.size() || parts_[part].records == 0) return Walk();
  const std::filesystem::path path = folder_ / part_name(part);
  const auto problem = [&](std::string message) { return Diagnostics{{path.string(), 0, 0, "", std::move(message)}}; };
  auto file = std::make_shared<const Descriptor>(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  const int fd = *file;
  if (fd < 0) return problem("cannot be read: " + std::generic_category().message(errno));

  constexpr std::size_t chunk = 256u << 10;
  const std::uint64_t first = part * part_size_;
  SpoolPart seen;
  seen.digest = no_digest;
  std::vector<std::uint64_t> order;
  order.reserve(std::min<std::uint64_t>(parts_[part].records, parts_[part].bytes / header_bytes));
  std::string buffer;
  std::uint64_t at = 0;  // of the buffer's begin
  std::size_t used = 0;
  const auto want = [&](std::size_t count) {
    if (buffer.size() - used >= count) return true;
    at += used;
    buffer.resize(std::max(chunk, count));
    buffer.resize(read_at(fd, at, buffer.data(), buffer.size()));
    used = 0;
    return buffer.size() >= count;
  };
  while (seen.bytes < parts_[part].bytes && want(header_bytes)) {
    const std::string_view header = std::string_view(buffer).substr(used, header_bytes);
    const std::uint64_t student = little_endian(header.substr(0, 8)), length = little_endian(header.substr(8));
    if (student < first || student - first >= part_size_ || length > most_spool_record_bytes) break;
    if (!want(header_bytes + length)) break;
    const std::string_view whole = std::string_view(buffer).substr(used, header_bytes + length);
    seen.digest = digest(digest(seen.digest, whole.substr(0, header_bytes)), whole.substr(header_bytes));
    order.push_back((student - first) << offset_bits | seen.bytes);
    seen.bytes += whole.size();
    seen.records += 1;
    used += whole.size();
  }
  if (seen != parts_[part] || want(1)) return problem("is not what was written");

  std::ranges::sort(order);
  Walk walk;
  walk.file_ = std::move(file);
  walk.order_ = std::move(order);
  walk.first_ = first;
  return walk;
}

bool SpoolReader::Walk::next(std::uint64_t& student, std::string& record) {
  if (at_ == order_.size()) return false;
  const std::uint64_t place = order_[at_++];
  const std::uint64_t offset = place & ((1ull << offset_bits) - 1);
  const auto failed = [&] {
    failure_ = "cannot be read any more";
    return false;
  };
  char header[header_bytes];
  if (read_at(*file_, offset, header, header_bytes) != header_bytes) return failed();
  record.resize(std::min<std::uint64_t>(little_endian({header + 8, 4}), most_spool_record_bytes));
  if (read_at(*file_, offset + header_bytes, record.data(), record.size()) != record.size()) return failed();
  student = first_ + (place >> offset_bits);
  return true;
}

Checked<bool> SpoolReader::read(std::size_t part, const Visit& visit) const {
  auto walk = this->walk(part);
  if (!walk) return walk.diagnostics;
  std::uint64_t student = 0;
  std::string record;
  while (walk->next(student, record)) visit(student, record);
  if (walk->failure().empty()) return true;
  return Diagnostics{{(folder_ / part_name(part)).string(), 0, 0, "", walk->failure()}};
}

}  // namespace blossom
