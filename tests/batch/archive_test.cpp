// Archives: those that a class is handed in as, and those that somebody made to do harm.

#include "grader/batch/archive.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <locale.h>
#include <signal.h>
#include <unistd.h>

#include <fstream>
#include <set>

#include "batch/sources.hpp"
#include "scratch.hpp"

using namespace blossom;

namespace {

struct Entry {
  std::string name;
  std::string content = "x";
  unsigned type = AE_IFREG;
  std::string link = {};
};

enum class Format { zip, tar, tar_gz, tar_bz2, tar_xz, tar_zst };
constexpr Format formats[] = {Format::zip,     Format::tar,    Format::tar_gz,
                              Format::tar_bz2, Format::tar_xz, Format::tar_zst};

class Writer {
 public:
  explicit Writer(Format format, const char* passphrase = nullptr) {
    // Names are written as UTF-8, as everybody's archiver does.
    locale_ = ::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
    before_ = ::uselocale(locale_);
    if (format == Format::zip)
      archive_write_set_format_zip(archive_);
    else
      archive_write_set_format_pax(archive_);
    if (format == Format::tar_gz) archive_write_add_filter_gzip(archive_);
    if (format == Format::tar_bz2) archive_write_add_filter_bzip2(archive_);
    if (format == Format::tar_xz) archive_write_add_filter_xz(archive_);
    if (format == Format::tar_zst) archive_write_add_filter_zstd(archive_);
    if (passphrase != nullptr) {
      REQUIRE(archive_write_set_options(archive_, "zip:encryption=aes256") == ARCHIVE_OK);
      REQUIRE(archive_write_set_passphrase(archive_, passphrase) == ARCHIVE_OK);
    }
    const auto append = [](archive*, void* out, const void* bytes, std::size_t size) -> la_ssize_t {
      static_cast<std::string*>(out)->append(static_cast<const char*>(bytes), size);
      return static_cast<la_ssize_t>(size);
    };
    archive_write_set_bytes_in_last_block(archive_, 1);
    REQUIRE(archive_write_open(archive_, &bytes_, nullptr, append, nullptr) == ARCHIVE_OK);
  }
  ~Writer() {
    archive_write_free(archive_);
    ::uselocale(before_);
    ::freelocale(locale_);
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  void add(const Entry& entry) {
    begin(entry, entry.content.size());
    if (entry.type == AE_IFREG && entry.link.empty())
      archive_write_data(archive_, entry.content.data(), entry.content.size());
  }
  void add_zeros(const std::string& name, std::size_t size) {
    begin({name}, size);
    const std::string zeros(1u << 20, '\0');
    for (std::size_t done = 0; done < size; done += zeros.size())
      archive_write_data(archive_, zeros.data(), zeros.size());
  }
  std::string bytes() {
    archive_write_close(archive_);
    return bytes_;
  }

 private:
  void begin(const Entry& entry, std::size_t size) {
    archive_entry* header = archive_entry_new();
    archive_entry_copy_pathname(header, entry.name.c_str());
    archive_entry_set_filetype(header, entry.type);
    archive_entry_set_perm(header, 0600);
    archive_entry_set_mtime(header, 1'790'000'000, 0);
    if (entry.type == AE_IFREG && entry.link.empty()) archive_entry_set_size(header, static_cast<la_int64_t>(size));
    if (entry.type == AE_IFLNK) archive_entry_copy_symlink(header, entry.link.c_str());
    if (entry.type == AE_IFREG && !entry.link.empty()) archive_entry_copy_hardlink(header, entry.link.c_str());
    REQUIRE(archive_write_header(archive_, header) >= ARCHIVE_WARN);
    archive_entry_free(header);
  }

  archive* archive_ = archive_write_new();
  std::string bytes_;
  locale_t locale_, before_;
};

std::string make(Format format, const std::vector<Entry>& entries) {
  Writer writer(format);
  for (const Entry& entry : entries) writer.add(entry);
  return writer.bytes();
}

// In this process, from memory.
Everything read(std::string_view bytes, const SourceLimits& limits = {}) {
  Everything all;
  ArchiveSink sink;
  sink.found = [&](Found&& found) {
    all.found.push_back(std::move(found));
    return true;
  };
  read_archive(bytes, limits, sink, all.failure);
  return all;
}

// In a process of its own, from a file: it must come to the same.
Everything read_apart(const std::string& bytes, const SourceLimits& limits = {}) {
  const test::Scratch folder;
  const Everything apart = read_all(folder.write("class.archive", bytes), limits);
  const Everything here = read(bytes, limits);
  CHECK(lines_of(apart) == lines_of(here));
  CHECK(apart.failure == here.failure);
  return apart;
}

pid_t child_of_this_process() {
  std::ifstream in("/proc/self/task/" + std::to_string(::getpid()) + "/children");
  pid_t child = 0;
  in >> child;
  return child;
}

}  // namespace

TEST_CASE("a class in an archive of each kind", "[archive]") {
  for (const Format format : formats) {
    INFO(static_cast<int>(format));
    const Everything all = read_apart(make(format, {{"./s2.json", "two"},
                                                    {"s10/", "", AE_IFDIR},
                                                    {"s10/deeper//a.json", "ten"},
                                                    {"lovelaceada_LATE_4711_99_a.json", "canvas"},
                                                    {"Ada Lovelace_4712_assignsubmission_file_/a.json", "moodle"},
                                                    {"__MACOSX/s10/._a.json", "clutter"},
                                                    {".DS_Store", "clutter"},
                                                    {".s11/a.json", "hidden"},
                                                    {"s\xC3\xA9.json", std::string(60'000, 'x')},
                                                    {"s1/notes.txt", "text"}}));
    CHECK(all.failure == "");
    CHECK(lines_of(all) ==
          "s2 < s2.json: two\n"
          "s10 < s10/deeper/a.json: ten\n"
          "lovelaceada_LATE_4711_99_a|#4711 < lovelaceada_LATE_4711_99_a.json: canvas\n"
          "Ada Lovelace_4712_assignsubmission_file_|#4712 < "
          "Ada Lovelace_4712_assignsubmission_file_/a.json: moodle\n"
          "refused .s11 < .s11/a.json ! not read: its name begins with a point, which hides it\n"
          "s\xC3\xA9 < s\xC3\xA9.json: 60000 of x\n"
          "refused s1 < s1/notes.txt ! not read: the name of a submission ends in .json\n");
    REQUIRE(!all.found.empty());
    CHECK(all.found.front().submission.submitted == Time(std::chrono::seconds(1'790'000'000)));
  }
}

TEST_CASE("names that lead outside are refused, whatever they look like", "[archive]") {
  for (const Format format : {Format::zip, Format::tar}) {
    const Everything all = read_apart(make(format, {{"../../evil.json"},
                                                    {"s1/../../evil.json"},
                                                    {"s1/.."},
                                                    {"/etc/evil.json"},
                                                    {"C:/evil.json"},
                                                    {"c:evil.json"},
                                                    {"s1\\..\\evil.json"},
                                                    {"a/b/c/d/e/f/g/h/i/j.json"},
                                                    {"s1/" + std::string(1100, 'x') + ".json"},
                                                    {"s2.json", "good"}}));
    CHECK(all.failure == "");
    REQUIRE(all.found.size() == 10);
    for (std::size_t i = 0; i < 9; ++i) {
      INFO(line_of(all.found[i]));
      CHECK(all.found[i].refused);
      CHECK(all.found[i].keys.empty());
      CHECK(all.found[i].submission.text.empty());
      CHECK(all.found[i].submission.problem.starts_with("not read: "));
    }
    CHECK(line_of(all.found[9]) == "s2 < s2.json: good");
  }
}

TEST_CASE("what is wrong with a name", "[archive]") {
  std::string path;
  const auto problem = [&](std::string_view name) { return problem_of_name(name, {}, path); };
  CHECK(problem("") == "it has no name");
  CHECK(problem("..") == "a name that leads outside");
  CHECK(problem("a/./../b") == "a name that leads outside");
  CHECK(problem("/a") == "an absolute name");
  CHECK(problem("\\\\server\\a") == "a name with a backslash");
  CHECK(problem("Z:a") == "a name with a drive letter");
  CHECK(problem("1/2/3/4/5/6/7/8/9/a") == "more than 8 folders inside each other");
  CHECK(problem("1/2/3/4/5/6/7/8/a") == "");
  CHECK(problem("./a//./b/") == "");
  CHECK(path == "a/b");
  CHECK(problem("...") == "");
  CHECK(problem("a..b/..c") == "");
  CHECK(path == "a..b/..c");
}

TEST_CASE("links and devices are refused, and what is said to be behind them is a file like any other", "[archive]") {
  const Everything all = read_apart(make(Format::tar, {{"s1/a.json", "a"},
                                                       {"s2", "", AE_IFLNK, "/etc"},
                                                       {"s2/passwd.json", "file"},
                                                       {"s3.json", "", AE_IFLNK, "../secret.json"},
                                                       {"s4.json", "", AE_IFREG, "s1/a.json"},
                                                       {"s5.json", "", AE_IFIFO},
                                                       {"s6.json", "", AE_IFCHR},
                                                       {"s7.json", "", AE_IFBLK}}));
  CHECK(lines_of(all) ==
        "s1 < s1/a.json: a\n"
        "refused s2 < s2 ! not read: a link\n"
        "s2 < s2/passwd.json: file\n"
        "refused s3 < s3.json ! not read: a link\n"
        "refused s4 < s4.json ! not read: a link\n"
        "refused s5 < s5.json ! not read: a pipe\n"
        "refused s6 < s6.json ! not read: a device, or of an unknown kind\n"
        "refused s7 < s7.json ! not read: a device, or of an unknown kind\n");
  CHECK(lines_of(read_apart(make(Format::zip, {{"s3.json", "", AE_IFLNK, "../secret.json"}}))) ==
        "refused s3 < s3.json ! not read: a link\n");
}

TEST_CASE("names that would be the same file somewhere are refused but for the first", "[archive]") {
  const std::string clash = "not read: its name is that of an earlier entry, but for case or the like";
  for (const Format format : {Format::zip, Format::tar}) {
    const Everything all = read_apart(make(format, {{"s1/a.json"},
                                                    {"S1/A.JSON"},
                                                    {"s1/a.json"},
                                                    {"./s1//a.json"},
                                                    {"\xC3\x89.json"},   // E with acute, as one character
                                                    {"e\xCC\x81.json"},  // e and the accent
                                                    {"stra\xC3\x9F"
                                                     "e.json"},  // sharp s
                                                    {"STRASSE.json"},
                                                    {"s1/b.json"}}));
    std::vector<std::string> problems;
    for (const Found& found : all.found) problems.push_back(found.submission.problem);
    CHECK(problems == std::vector<std::string>{"", clash, clash, clash, "", clash, "", clash, ""});
  }
}

TEST_CASE("SipHash-2-4 as its authors' test vectors have it", "[archive]") {
  const std::uint64_t key[2] = {0x0706050403020100, 0x0f0e0d0c0b0a0908};
  std::string bytes;
  for (char i = 0; i < 15; ++i) bytes += i;
  CHECK(sip_hash(key, bytes) == 0xa129ca6149be45e5);  // the paper's appendix A
  CHECK(sip_hash(key, "") == 0x726fdb47dd0e0e31);
  CHECK(sip_hash(key, bytes.substr(0, 8)) == 0x93f5f5799a932462);
}

TEST_CASE("a hundred thousand names are told apart", "[archive]") {
  NamesSeen seen;
  for (int i = 0; i < 100'000; ++i) REQUIRE(seen.add("s" + std::to_string(i) + ".json"));
  for (int i = 0; i < 100'000; i += 17) REQUIRE_FALSE(seen.add("S" + std::to_string(i) + ".JSON"));
}

TEST_CASE("a bomb costs no more than the limits allow", "[archive]") {
  SourceLimits limits;
  limits.total_bytes = 64u << 20;
  for (const Format format : {Format::tar_zst, Format::zip}) {
    Writer writer(format);
    writer.add({"s1.json", "before"});
    writer.add_zeros("bomb.json", format == Format::zip ? 100u << 20 : 1u << 30);
    writer.add({"s2.json", "after"});
    const std::string bytes = writer.bytes();
    CHECK(bytes.size() < 1u << 20);
    const Everything all = read_apart(bytes, limits);
    CHECK(lines_of(all) ==
          "s1 < s1.json: before\n"
          "bomb < bomb.json ! too large; a submission has at most 65536 bytes\n");
    CHECK(all.failure == "more than 67108864 bytes unpacked; what follows was not read");
  }
}

TEST_CASE("an entry that is too large is told, and those behind it are read", "[archive]") {
  for (const Format format : formats) {
    Writer writer(format);
    writer.add_zeros("s1.json", 8u << 20);
    writer.add({"s2.json", std::string(65'536, 'x')});
    writer.add({"s3.json", std::string(65'537, 'x')});
    writer.add({"s4.zip", make(Format::zip, {{"s5.json"}})});  // an archive in an archive is no submission
    writer.add({"s6.json", "after"});
    CHECK(lines_of(read_apart(writer.bytes())) ==
          "s1 < s1.json ! too large; a submission has at most 65536 bytes\n"
          "s2 < s2.json: 65536 of x\n"
          "s3 < s3.json ! too large; a submission has at most 65536 bytes\n"
          "refused s4.zip < s4.zip ! not read: the name of a submission ends in .json\n"
          "s6 < s6.json: after\n");
  }
}

TEST_CASE("an archive has at most so many entries", "[archive]") {
  std::vector<Entry> entries;
  for (int i = 0; i < 5000; ++i) entries.push_back({std::to_string(i) + ".json", ""});
  SourceLimits limits;
  limits.entries = 1000;
  for (const Format format : {Format::zip, Format::tar_gz}) {
    const Everything all = read_apart(make(format, entries), limits);
    CHECK(all.found.size() == 1000);
    CHECK(all.failure == "more than 1000 entries; what follows was not read");
  }
}

TEST_CASE("encrypted entries are refused", "[archive]") {
  Writer writer(Format::zip, "secret");
  writer.add({"s1.json", "x"});
  const Everything all = read_apart(writer.bytes());
  CHECK(lines_of(all) == "refused s1 < s1.json ! not read: it is encrypted\n");
}

TEST_CASE("what is no archive, or one that is not read, is told", "[archive]") {
  for (const std::string& bytes : {std::string(), std::string("hello"), std::string(5000, '\0'),
                                   std::string("7z\xBC\xAF\x27\x1C"), std::string("\x1F\x8B\x08")}) {
    const Everything all = read_apart(bytes);
    INFO(all.failure);
    CHECK(all.found.empty());
  }
  CHECK(read_apart("hello").failure.find("archive") != std::string::npos);
}

TEST_CASE("an archive torn anywhere gives what stands before the tear, or says what is damaged", "[archive]") {
  std::vector<Entry> entries;
  std::set<std::string> right;
  for (int i = 0; i < 20; ++i) {
    std::string content;
    for (int k = 0; k < 40 * i; ++k) content += static_cast<char>('a' + (k * k + i) % 26);
    entries.push_back({"s" + std::to_string(i) + ".json", content});
    right.insert("s" + std::to_string(i) + ".json: " + content);
  }
  for (const Format format : {Format::tar, Format::zip, Format::tar_gz}) {
    const std::string whole = make(format, entries);
    for (std::size_t size = 0; size < whole.size(); size += 97) {
      const Everything all = read(std::string_view(whole).substr(0, size));
      INFO(static_cast<int>(format) << " cut at " << size << ": " << all.failure);
      for (const Found& found : all.found)
        if (found.submission.problem.empty())
          REQUIRE(right.count(found.submission.source + ": " + found.submission.text) == 1);
      // Whoever is missing is not missing without a word.
      REQUIRE((all.found.size() == right.size() || !all.failure.empty()));
    }
  }
}

TEST_CASE("no changed byte makes an entry lead outside or be larger than allowed", "[archive]") {
  SourceLimits limits;
  limits.submission_bytes = 500;
  limits.entries = 100;
  limits.total_bytes = 10'000'000;
  for (const Format format : formats) {
    const std::string whole =
        make(format, {{"s1.json", "one"}, {"s2/a.json", std::string(400, 'x')}, {"s3.json", "three"}});
    for (std::size_t i = 0; i < whole.size(); i += format == Format::tar ? 3 : 1) {
      std::string changed = whole;
      changed[i] = static_cast<char>(changed[i] ^ (1 << i % 8));
      for (const Found& found : read(changed, limits).found) {
        REQUIRE(found.submission.text.size() <= 500);
        REQUIRE(found.submission.source == printable(found.submission.source));
        std::string path;
        if (!found.refused)
          REQUIRE(problem_of_name(found.submission.source, limits, path).find("outside") == std::string::npos);
      }
    }
  }
}

TEST_CASE("a process that dies while unpacking leaves what came before, and a sentence", "[archive]") {
  const test::Scratch folder;
  std::vector<Entry> entries;
  for (int i = 0; i < 200; ++i) entries.push_back({"s" + std::to_string(i) + ".json", std::string(10'000, 'x')});
  const std::string path = folder.write("class.tar", make(Format::tar, entries));
  auto source = open_submissions(path);
  REQUIRE(source);
  Found found;
  REQUIRE((*source)->next(found));  // more than a pipe holds is still to come
  const pid_t child = child_of_this_process();
  REQUIRE(child > 0);
  ::kill(child, SIGKILL);
  const Everything rest = read_all(**source);
  CHECK(rest.found.size() < 199);
  for (const Found& each : rest.found) CHECK(each.submission.text == std::string(10'000, 'x'));
  CHECK(rest.failure == "cannot be read on: what unpacks it died of signal 9 (Killed)");
  CHECK_FALSE((*source)->next(found));
  CHECK(child_of_this_process() == 0);
}

TEST_CASE("a source that is left early leaves no process behind, and progress goes from 0 to 1", "[archive]") {
  const test::Scratch folder;
  std::vector<Entry> entries;
  for (int i = 0; i < 2000; ++i) entries.push_back({"s" + std::to_string(i) + ".json", std::string(10'000, 'x')});
  const std::string path = folder.write("class.tar", make(Format::tar, entries));
  {
    auto source = open_submissions(path);
    REQUIRE(source);
    Found found;
    REQUIRE((*source)->next(found));
  }
  CHECK(child_of_this_process() == 0);
  auto source = open_submissions(path);
  REQUIRE(source);
  double last = 0;
  for (Found found; (*source)->next(found);) {
    REQUIRE((*source)->progress().value() >= last);
    last = (*source)->progress().value();
  }
  CHECK((*source)->failure() == "");
  CHECK((*source)->progress().value() > 0.99);
}
