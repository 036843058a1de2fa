#pragma once
// The only door for files from outside. Reads JSON (RFC 8259, UTF-8) through nlohmann-json's SAX interface into a small
// tree that knows where each value stood, keeps each number's own text, and refuses what is hostile: too large, too
// deep, too many values, duplicate keys, numbers above the largest double (1e400; 1e-400 is an exact number like any
// other), bytes after the document, a NUL byte, lone surrogates, invalid UTF-8. A byte order mark before the document
// is skipped.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostics.hpp"
#include "base/scalar.hpp"

namespace blossom {

struct JsonLimits {
  std::size_t bytes = 16u << 20;  // of 4 GB at most
  int depth = 32;
  std::size_t values = 2'000'000;  // of every kind, keys not counted
};
inline constexpr JsonLimits submission_limits{64u << 10, 32, 4096};

struct Json {
  enum class Kind : std::uint8_t { null, boolean, number, string, array, object };
  Kind kind = Kind::null;
  bool boolean = false;
  std::uint32_t token = 0;                // its place: the how-many-th key or value of the document, from 0
  std::string text;                       // a string's value; a number's own text as typed
  std::vector<Json> items;                // an array's items; an object's values, in the order of the file
  std::vector<std::string> keys;          // an object's keys, beside items
  std::vector<std::uint32_t> key_tokens;  // and their places

  const Json* find(std::string_view key) const;  // an object's value of that key, or nullptr
};

// A read document: its tree, and how to find the line and column of any part (computed on demand: they are only needed
// when something is wrong).
class JsonDocument {
 public:
  // The name stands in diagnostics. Every syntax mistake gives one diagnostic (a JSON reader cannot go on after one).
  static Checked<JsonDocument> parse(std::string name, std::string text, const JsonLimits& = {});
  // Reads a regular file; never follows it beyond limits.bytes. A missing, unreadable or non-regular file (a folder, a
  // device, a pipe) is a diagnostic. Name "-" is standard input.
  static Checked<JsonDocument> load(const std::filesystem::path&, const JsonLimits& = {});

  const Json& root() const { return root_; }
  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }
  std::pair<int, int> line_and_column(std::uint32_t token) const;

 private:
  std::string name_;
  std::string text_;
  Json root_;
  mutable std::shared_ptr<const std::vector<std::pair<int, int>>> places_;  // line and column of each token
};

inline constexpr std::size_t most_diagnostics = 10'000;

// Walks a document and collects every mistake: a cursor is a place in the tree with its path. A reader asks for what it
// wants; a wrong kind, a missing or an unknown key adds a diagnostic and reading goes on. From most_diagnostics on no
// more are added: a hostile file must not fill the memory with them.
class Cursor {
 public:
  Cursor(const JsonDocument& document, Diagnostics& diagnostics);  // at the root

  const Json& json() const { return *json_; }
  const JsonDocument& document() const { return *document_; }
  const std::string& path() const { return path_; }
  bool is(Json::Kind kind) const { return json_->kind == kind; }

  // Adds a diagnostic at this place. "must be a positive integer, not \"x\"".
  void error(std::string message) const;
  bool has_errors() const { return !diagnostics_->empty(); }
  // For a reader that must know whether its own part was right: error_count() before, errors_since(count) after.
  std::size_t error_count() const { return diagnostics_->size(); }
  bool errors_since(std::size_t count) const { return diagnostics_->size() > std::min(count, most_diagnostics); }

  // Objects. expect_object says if this is none, and names every key that is not in `known` (with "did you mean"), but
  // "$comment", which may stand everywhere, as in JSON Schema; true if it is an object, unknown keys or not.
  bool expect_object(const std::vector<std::string>& known) const;
  std::optional<Cursor> optional(std::string_view key) const;    // nothing when absent, silently
  std::optional<Cursor> required(std::string_view key) const;    // nothing when absent, with a diagnostic
  Cursor member(std::size_t index) const;                        // the index-th member's value
  void key_error(std::size_t index, std::string message) const;  // at the key itself

  // Arrays. Says if this is none or its length is outside [at_least, at_most].
  bool expect_array(std::size_t at_least = 0, std::size_t at_most = SIZE_MAX) const;
  std::size_t size() const { return json_->items.size(); }
  Cursor operator[](std::size_t index) const;

  // Scalars: nothing, with a diagnostic, when it is not one. A number may be a JSON number or an exact string ("2/5"),
  // is what Exact::parse accepts, and is refused above the largest double.
  std::optional<Exact> number() const;
  std::optional<int> integer(int at_least, int at_most) const;
  // A string has no control characters (see utf8.hpp) but line breaks and tabs.
  std::optional<std::string> string() const;
  std::optional<bool> boolean() const;

 private:
  Cursor(const JsonDocument* document, Diagnostics* diagnostics, const Json* json, std::string path)
      : document_(document), diagnostics_(diagnostics), json_(json), path_(std::move(path)) {}

  const JsonDocument* document_;
  Diagnostics* diagnostics_;
  const Json* json_;
  std::string path_;
};

// Writes to a temporary name beside `path` and renames: a reader sees the old file or the whole new one.
// A file that is replaced keeps its permissions; a new one has `mode` but what the umask takes away. The diagnostic
// says what the system said.
Checked<bool> write_file(const std::filesystem::path& path, std::string_view content, unsigned mode = 0666);

// A JSON string literal, quotes included; invalid UTF-8 becomes U+FFFD.
std::string json_quote(std::string_view text);

}  // namespace blossom
