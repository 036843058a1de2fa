// Any bytes as an archive: what is found keeps the limits and has a name that stays inside, what is refused says why.

#include "fuzz.hpp"
#include "grader/batch/archive.hpp"

using namespace blossom;
using namespace blossom::fuzz;

namespace {

constexpr SourceLimits limits{4096, 200, 4, 1u << 20};

void check(const Found& found) {
  const Submission& submission = found.submission;
  require(!found.refused || !submission.problem.empty(), "what is refused has a reason", submission.source);
  require(is_harmless(submission.problem), "a problem is harmless text", submission.problem);
  require(submission.text.size() <= limits.submission_bytes, "a submission keeps its limit", submission.source);
  if (found.refused) {
    require(submission.text.empty(), "nothing of what is refused is kept", submission.source);
    return;
  }
  const std::string inside = "/" + submission.source + "/";
  require(is_harmless(submission.source) && !submission.source.empty(), "a name is harmless text", submission.source);
  require(inside.find("/../") == std::string::npos && inside.find("/./") == std::string::npos &&
              inside.find("//") == std::string::npos,
          "a name stays inside, in its simplest form", submission.source);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bool prepared = (prepare_archives(), true);
  require(prepared, "archives can be read");
  std::size_t count = 0;
  const ArchiveSink sink{[&](Found&& found) {
    check(found);
    require(++count <= limits.entries + 1, "there are no more entries than the limit");
    return true;
  }};
  std::string failure;
  read_archive(text_of(data, size), limits, sink, failure);
  require(is_harmless(failure), "a failure is harmless text", failure);
  const std::string name = text_of(data, std::min<std::size_t>(size, 300));
  std::string path, again;
  // "./" is the archive's own top folder, whose path is empty.
  if (problem_of_name(name, limits, path).empty() && !path.empty()) {
    require(problem_of_name(path, limits, again).empty() && again == path, "a simple name stays as it is", path);
    require(!path.starts_with('/') && ("/" + path + "/").find("/../") == std::string::npos,
            "a name that is taken leads inside", path);
  }
  return 0;
}
