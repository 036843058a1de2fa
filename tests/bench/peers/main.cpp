// Checks that all agree with Blossom, measures them (arguments are Google Benchmark's), and prints one table: for every
// row the nanoseconds of each, medians of the repetitions in processor time (of a library with several functions for
// it, the fastest), the best peer, and how many times its time is Blossom's. Exit status 1: some result differs, and
// nothing was measured.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "comparison.hpp"

namespace {

using peers::blossom_evaluator;
using peers::blossom_plain;
using peers::entries;
using peers::Entry;

// "SISL s1221" is a function of SISL.
std::string library_of(const std::string& who) { return who.substr(0, who.find(' ')); }

bool is_blossom(const std::string& who) { return who == blossom_plain || who == blossom_evaluator; }

bool agrees(const std::vector<double>& values, const std::vector<double>& expected) {
  constexpr double tolerance = 1e-9;  // of the value, or of 1
  return std::equal(values.begin(), values.end(), expected.begin(), expected.end(),
                    [](double a, double b) { return std::abs(a - b) <= tolerance * std::max(1.0, std::abs(b)); });
}

bool all_agree() {
  bool agreed = true;
  std::map<std::string, std::vector<double>> expected;
  for (const Entry& entry : entries()) {
    if (entry.who == blossom_plain) expected[entry.row] = entry.results();
  }
  for (const Entry& entry : entries()) {
    if (agrees(entry.results(), expected[entry.row])) continue;
    std::fprintf(stderr, "%s: the result of %s is not Blossom's\n", entry.row.c_str(), entry.who.c_str());
    agreed = false;
  }
  return agreed;
}

using Key = std::pair<std::string, std::string>;  // row, who

// Collects the times; the table is printed at the end.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override {
    PrintBasicContext(&GetErrorStream(), context);
    return true;
  }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      const auto entry = std::find_if(entries().begin(), entries().end(), [&](const Entry& one) {
        return run.run_name.function_name == one.row + "/" + one.who;
      });
      if (entry == entries().end()) continue;
      const double seconds = run.cpu_accumulated_time / static_cast<double>(run.iterations);
      times_[{entry->row, entry->who}].push_back(seconds * 1e9 / entry->per);
    }
  }

  // f(entry) of all that were measured, each once, in the order of the entries.
  template <class F>
  std::vector<std::string> measured(F f) const {
    std::vector<std::string> found;
    for (const Entry& entry : entries()) {
      if (median({entry.row, entry.who}) == 0) continue;
      if (std::find(found.begin(), found.end(), f(entry)) == found.end()) found.push_back(f(entry));
    }
    return found;
  }

  // 0 where nothing was measured.
  double median(const Key& key) const {
    const auto found = times_.find(key);
    if (found == times_.end()) return 0;
    auto times = found->second;
    std::sort(times.begin(), times.end());
    const std::size_t middle = times.size() / 2;
    return times.size() % 2 == 1 ? times[middle] : (times[middle - 1] + times[middle]) / 2;
  }

 private:
  std::map<Key, std::vector<double>> times_;
};

std::string nanoseconds(double time) {
  char text[32];
  std::snprintf(text, sizeof text, time < 100 ? "%.1f" : "%.0f", time);
  return time > 0 ? text : "";
}

std::string ratio(double peer, double own) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", peer / own);
  return peer > 0 && own > 0 ? text : "";
}

void print_line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const int width = static_cast<int>(widths[c]);
    std::printf(c == 0 ? "| %-*s |" : " %*s |", width, cells[c].c_str());
  }
  std::printf("\n");
}

void print_table(const Collector& times) {
  const auto libraries = times.measured([](const Entry& entry) { return library_of(entry.who); });
  std::vector<std::vector<std::string>> lines{{"ns"}};
  lines[0].insert(lines[0].end(), libraries.begin(), libraries.end());
  lines[0].insert(lines[0].end(), {"best peer", "/ Blossom", "/ evaluator"});
  for (const std::string& row : times.measured([](const Entry& entry) { return entry.row; })) {
    std::map<std::string, double> fastest;  // by library
    std::string best;
    double best_time = 0;
    for (const Entry& entry : entries()) {
      const double time = entry.row == row ? times.median({row, entry.who}) : 0;
      if (time == 0) continue;
      double& known = fastest[library_of(entry.who)];
      if (known == 0 || time < known) known = time;
      if (is_blossom(entry.who) || (best_time > 0 && best_time <= time)) continue;
      best = entry.who;
      best_time = time;
    }
    std::vector<std::string> line{row};
    for (const std::string& library : libraries) line.push_back(nanoseconds(fastest[library]));
    line.push_back(best);
    for (const char* who : {blossom_plain, blossom_evaluator}) line.push_back(ratio(best_time, fastest[who]));
    lines.push_back(line);
  }

  std::vector<std::size_t> widths(lines[0].size(), 0);
  for (const auto& line : lines) {
    for (std::size_t c = 0; c < line.size(); ++c) widths[c] = std::max(widths[c], line[c].size());
  }
  for (const auto& line : lines) print_line(line, widths);
}

}  // namespace

int main(int argc, char** argv) {
  std::stable_sort(entries().begin(), entries().end(), [](const Entry& a, const Entry& b) {
    return std::pair(!is_blossom(a.who), a.who) < std::pair(!is_blossom(b.who), b.who);
  });
  for (const Entry& entry : entries()) {
    benchmark::RegisterBenchmark((entry.row + "/" + entry.who).c_str(), entry.measure);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  if (!all_agree()) return 1;
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  print_table(collector);
  benchmark::Shutdown();
  return 0;
}
