#pragma once
// A stream of submissions, JSON Lines in and JSON Lines out: each line is graded by itself, whatever stands before or
// after it, so that anything that splits lines can spread them over machines, and the outputs one after the other are
// what one process would have written.
//
// A line is as read_line (source.hpp) takes it. It gives one line, in the same order: the grade (blossom.grade/1) with
// its "student". A line that cannot be graded gives an object, too, of exercise "": score 0, no parts, the reason, the
// student if that is known, and "digest", the first 16 hexadecimal digits of the SHA-256 of the line without its end.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "grader/batch/workers.hpp"
#include "grader/examiner.hpp"

namespace blossom {

inline constexpr std::size_t longest_line = 256u
                                            << 10;  // more is refused, and not held in memory; read_line takes less

// Of a file: the lines that begin in [begin, end).
struct Extent {
  std::uint64_t begin = 0;
  std::uint64_t end = UINT64_MAX;
};
// The index-th of `count` parts of so many bytes, index from 1. Together they are the whole, whatever the count.
Extent shard_of(std::uint64_t bytes, unsigned index, unsigned count);

// Lines of an open file, read in large blocks; as items for workers. What has no beginning (a pipe) can only be read as
// a whole.
class LineReader {
 public:
  LineReader(int file, const Extent& extent);
  ~LineReader();
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

  // A line without its end; of one that is too long its digest, after a line break. False when there are no more.
  // Throws std::system_error when the file cannot be read.
  bool next(std::string& item);

 private:
  bool fill();
  std::string rest_of_long_line();

  int file_;
  Extent extent_;
  std::unique_ptr<char[]> buffer_;
  std::size_t at_ = 0;         // the next line begins here
  std::size_t looked_at_ = 0;  // there is no line break between there and here
  std::size_t filled_ = 0;
  std::uint64_t offset_ = 0;  // of at_ in the file
  bool ended_ = false;
};

// What a line of the output is made of one of the input: what workers do. Not for several threads at once.
void grade_line(Examiner&, std::string_view item, std::string& line);

struct StreamCounts {
  std::uint64_t lines = 0;
  std::uint64_t ungraded = 0;  // they gave an object of exercise ""
};

// Grades all lines. `write` gets whole lines, many at once. Throws what it throws, and std::system_error.
StreamCounts grade_stream(LineReader&, Workers&, const std::function<void(std::string_view)>& write);

// What has to have happened before the workers are started, for they can open nothing.
void prepare_for_workers(Examiner&);

}  // namespace blossom
