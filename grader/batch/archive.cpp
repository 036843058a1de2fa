#include "grader/batch/archive.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <locale.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "base/diagnostics.hpp"
#include "grader/batch/sources.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_name_bytes = 1024;
constexpr std::size_t block_bytes = 64u << 10;
constexpr std::uint64_t progress_every = 4u << 20;  // bytes unpacked

// libarchive gives names in the locale's encoding: in the C locale it would lose all but ASCII. C.UTF-8 knows no
// language, so that it is the same everywhere.
locale_t names_locale() {
  static const locale_t utf8 = ::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
  return utf8;
}

class WithNamesLocale {
 public:
  WithNamesLocale() : before_(names_locale() == nullptr ? nullptr : ::uselocale(names_locale())) {}
  ~WithNamesLocale() {
    if (before_ != nullptr) ::uselocale(before_);
  }
  WithNamesLocale(const WithNamesLocale&) = delete;
  WithNamesLocale& operator=(const WithNamesLocale&) = delete;

 private:
  locale_t before_;
};

using Archive = std::unique_ptr<archive, int (*)(archive*)>;

// The formats a class is handed in as. All the others that libarchive can read are so much less code to trust; those
// that start other programs are among them.
Archive new_archive() {
  Archive reader(archive_read_new(), archive_read_free);
  if (!reader) return reader;
  archive_read_support_format_zip(reader.get());
  archive_read_support_format_tar(reader.get());
  archive_read_support_filter_gzip(reader.get());
  archive_read_support_filter_bzip2(reader.get());
  archive_read_support_filter_xz(reader.get());
  archive_read_support_filter_zstd(reader.get());
  return reader;
}

std::string archive_says(archive* reader) {
  const char* text = archive_error_string(reader);
  return text == nullptr ? "it is damaged" : printable(std::string_view(text).substr(0, 200));
}

class Reading {
 public:
  Reading(archive* reader, const SourceLimits& limits, const ArchiveSink& sink, std::string& failure)
      : reader_(reader), limits_(limits), sink_(sink), failure_(failure) {}

  void all() {
    std::size_t entries = 0;
    for (;;) {
      archive_entry* entry = nullptr;
      const int status = archive_read_next_header(reader_, &entry);
      if (status == ARCHIVE_EOF) break;
      if (status == ARCHIVE_RETRY) continue;
      if (status == ARCHIVE_FATAL) return fail("cannot be read on: " + archive_says(reader_));
      if (++entries > limits_.entries)
        return fail("more than " + std::to_string(limits_.entries) + " entries; what follows was not read");
      Found found;
      const bool told = status == ARCHIVE_FAILED ? damaged_header(entry, found) : look(entry, found);
      if (!failure_.empty()) {
        if (told) sink_.found(std::move(found));
        return;
      }
      if (told && !sink_.found(std::move(found))) return;
      if (!skip()) return;
    }
    tell_progress(true);
  }

 private:
  void fail(std::string why) { failure_ = std::move(why); }

  static bool refuse(std::string why, Found& found) {
    found.refused = true;
    found.submission.problem = "not read: " + std::move(why);
    return true;
  }

  bool damaged_header(archive_entry* entry, Found& found) {
    const char* name = entry == nullptr ? nullptr : archive_entry_pathname(entry);
    if (name != nullptr) found.submission.source = printable(std::string_view(name).substr(0, most_name_bytes));
    return refuse("it is damaged: " + archive_says(reader_), found);
  }

  // True if it is to be told of.
  bool look(archive_entry* entry, Found& found) {
    const char* given = archive_entry_pathname(entry);
    const std::string_view name = given == nullptr ? "" : given;
    found.submission.source = printable(name.substr(0, most_name_bytes));
    std::string path;
    if (std::string problem = problem_of_name(name, limits_, path); !problem.empty())
      return refuse(std::move(problem), found);
    const auto type = archive_entry_filetype(entry);
    if (path.empty() || has_part(path, is_litter)) return false;
    path = printable(path);
    found.submission.source = path;
    if (type == AE_IFDIR) return false;
    found.keys = keys_of(path);
    if (has_part(path, [](std::string_view part) { return part.starts_with('.'); })) {
      found.refused = true;
      found.submission.problem = hidden_name;
      return true;
    }
    if (archive_entry_hardlink(entry) != nullptr || archive_entry_symlink(entry) != nullptr || type == AE_IFLNK)
      return refuse("a link", found);
    if (type != AE_IFREG) return refuse(type == AE_IFIFO ? "a pipe" : "a device, or of an unknown kind", found);
    if (!is_json_name(path)) {
      found.refused = true;
      found.submission.problem = no_json_name;
      return true;
    }
    if (archive_entry_is_encrypted(entry) != 0) return refuse("it is encrypted", found);
    if (!seen_.add(path)) return refuse("its name is that of an earlier entry, but for case or the like", found);
    if (archive_entry_mtime_is_set(entry) != 0) found.submission.submitted = time_of(archive_entry_mtime(entry));
    read(found);
    return true;
  }

  template <class Is>
  static bool has_part(std::string_view path, Is&& is) {
    for (std::size_t begin = 0; begin <= path.size();) {
      const std::size_t end = std::min(path.find('/', begin), path.size());
      if (is(path.substr(begin, end - begin))) return true;
      begin = end + 1;
    }
    return false;
  }

  // Up to one byte more than allowed. What is told of the size is not believed.
  void read(Found& found) {
    std::string& text = found.submission.text;
    while (text.size() <= limits_.submission_bytes) {
      const std::size_t before = text.size();
      const std::size_t wanted = std::min<std::size_t>(4096, limits_.submission_bytes + 1 - before);
      text.resize(before + wanted);
      const la_ssize_t got = archive_read_data(reader_, text.data() + before, wanted);
      text.resize(before + static_cast<std::size_t>(std::max<la_ssize_t>(got, 0)));
      if (got == 0) return count(text.size());
      if (got < 0 && got != ARCHIVE_RETRY) {
        text.clear();
        found.submission.problem = "it is damaged: " + archive_says(reader_);
        if (got == ARCHIVE_FATAL) fail("cannot be read on: " + archive_says(reader_));
        return;
      }
    }
    count(text.size());
    text.clear();
    found.submission.problem = too_large(limits_);
  }

  // What is left of an entry, block by block, for it may be more than anybody wants to unpack.
  bool skip() {
    const void* block = nullptr;
    std::size_t size = 0;
    la_int64_t offset = 0;
    for (int complaints = 0; complaints < 100;) {
      const int status = archive_read_data_block(reader_, &block, &size, &offset);
      if (status == ARCHIVE_EOF || status == ARCHIVE_FAILED) break;  // the next header is still to be had
      if (status == ARCHIVE_FATAL) return fail("cannot be read on: " + archive_says(reader_)), false;
      if (status == ARCHIVE_OK)
        count(size);
      else
        ++complaints;
      if (!failure_.empty()) return false;
    }
    tell_progress(false);
    return true;
  }

  void count(std::uint64_t bytes) {
    unpacked_ += bytes;
    if (unpacked_ > limits_.total_bytes)
      fail("more than " + std::to_string(limits_.total_bytes) + " bytes unpacked; what follows was not read");
    tell_progress(false);
  }

  void tell_progress(bool now) {
    const auto consumed = static_cast<std::uint64_t>(std::max<la_int64_t>(archive_filter_bytes(reader_, -1), 0));
    const std::uint64_t work = std::max(consumed, unpacked_);
    if (!sink_.progress || (!now && work < told_ + progress_every)) return;
    told_ = work;
    sink_.progress(consumed);
  }

  archive* reader_;
  const SourceLimits& limits_;
  const ArchiveSink& sink_;
  std::string& failure_;
  NamesSeen seen_;
  std::uint64_t unpacked_ = 0;
  std::uint64_t told_ = 0;
};

template <class Open>
void read_with(Open&& open, const SourceLimits& limits, const ArchiveSink& sink, std::string& failure) {
  const WithNamesLocale locale;
  const Archive reader = new_archive();
  if (!reader || open(reader.get()) != ARCHIVE_OK)
    failure = "is no archive that can be read (zip, tar, tar.gz, tar.bz2, tar.xz, tar.zst)" +
              (reader ? ": " + archive_says(reader.get()) : std::string());
  else
    Reading(reader.get(), limits, sink, failure).all();
}

}  // namespace

void prepare_archives() {
  // The old times of zip know no zone: the same archive is to mean the same everywhere. And where none is named, the C
  // library would look at a file for each time that it converts.
  ::setenv("TZ", "UTC0", 1);
  ::tzset();
  const WithNamesLocale locale;
  const Archive reader = new_archive();
}

void read_archive(int file, const SourceLimits& limits, const ArchiveSink& sink, std::string& failure) {
  read_with([&](archive* reader) { return archive_read_open_fd(reader, file, block_bytes); }, limits, sink, failure);
}

void read_archive(std::string_view bytes, const SourceLimits& limits, const ArchiveSink& sink, std::string& failure) {
  read_with([&](archive* reader) { return archive_read_open_memory(reader, bytes.data(), bytes.size()); }, limits, sink,
            failure);
}

std::string problem_of_name(std::string_view name, const SourceLimits& limits, std::string& path) {
  const auto is_letter = [](char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); };
  path.clear();
  if (name.empty()) return "it has no name";
  if (name.size() > most_name_bytes)
    return "its name is too long; at most " + std::to_string(most_name_bytes) + " bytes";
  if (name.starts_with('/')) return "an absolute name";
  if (name.find('\\') != std::string_view::npos) return "a name with a backslash";
  int depth = 0;
  for (std::size_t begin = 0; begin < name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    const std::string_view part = name.substr(begin, end - begin);
    begin = end + 1;
    if (part.empty() || part == ".") continue;
    if (part == "..") return "a name that leads outside";
    if (!path.empty()) {
      path += '/';
      ++depth;
    }
    path += part;
  }
  if (path.size() >= 2 && is_letter(path[0]) && path[1] == ':') return "a name with a drive letter";
  if (depth > limits.depth) return "more than " + std::to_string(limits.depth) + " folders inside each other";
  return {};
}

}  // namespace blossom
