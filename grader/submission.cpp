#include "grader/submission.hpp"

#include <algorithm>

#include "grader/student.hpp"

namespace blossom {

bool is_litter(std::string_view file_name) {
  constexpr std::string_view known[] = {".ds_store", ".localized", "__macosx", ".git", "thumbs.db", "desktop.ini"};
  return file_name.starts_with("._") || std::ranges::find(known, folded(file_name)) != std::end(known);
}

}  // namespace blossom
