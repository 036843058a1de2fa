// The page a student gets (grader/page/student_page.hpp), for browsers.

#include "grader/page/student_page.hpp"
#include "grader/report/report.hpp"

namespace blossom {
namespace {

class HtmlReport final : public Report {
 public:
  void add(const StudentResult& result, std::string& out) override { out += student_page(result); }
};

}  // namespace

const ReportFormat& report_html() {
  static const ReportFormat format{
      "html", "the page a student gets, of one student", "html", ReportFormat::Scope::student,
      [](const ReportContext&) -> std::unique_ptr<Report> { return std::make_unique<HtmlReport>(); }};
  return format;
}

}  // namespace blossom
