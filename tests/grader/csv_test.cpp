// RFC 4180, section 2 ("Definition of the CSV Format"), and what spreadsheets make of cells (OWASP, "CSV Injection").

#include "grader/csv.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <sstream>

using namespace blossom;

namespace {

using Rows = std::vector<std::vector<std::string>>;

struct ReadCsv {
  Rows rows;
  std::vector<int> lines;
  std::vector<std::uint64_t> offsets;
  std::string mistakes;
  char separator = 0;
};

ReadCsv read(const std::string& text, const CsvLimits& limits = {}) {
  std::istringstream in(text);
  CsvReader reader("class.csv", in, limits);
  ReadCsv result;
  for (std::vector<std::string> cells; reader.next(cells);) {
    result.rows.push_back(cells);
    result.lines.push_back(reader.line());
    result.offsets.push_back(reader.offset());
  }
  result.mistakes = to_string(reader.diagnostics());
  result.separator = reader.separator();
  return result;
}

Rows rows(const std::string& text) {
  const ReadCsv result = read(text);
  CHECK(result.mistakes == "");
  return result.rows;
}

// A cell as somebody else's reader gets it.
std::string cell(const std::string& text) {
  const Rows read_back = rows("x," + csv_text(text) + "\r\n");
  REQUIRE(read_back.size() == 1);
  REQUIRE(read_back[0].size() == 2);
  return read_back[0][1];
}

}  // namespace

TEST_CASE("the examples of RFC 4180 are read as it says", "[csv]") {
  CHECK(rows("aaa,bbb,ccc\r\nzzz,yyy,xxx\r\n") == Rows{{"aaa", "bbb", "ccc"}, {"zzz", "yyy", "xxx"}});
  CHECK(rows("aaa,bbb,ccc\r\nzzz,yyy,xxx") == Rows{{"aaa", "bbb", "ccc"}, {"zzz", "yyy", "xxx"}});
  CHECK(rows("\"aaa\",\"bbb\",\"ccc\"\r\nzzz,yyy,xxx") == Rows{{"aaa", "bbb", "ccc"}, {"zzz", "yyy", "xxx"}});
  CHECK(rows("\"aaa\",\"b\r\nbb\",\"ccc\"\r\nzzz,yyy,xxx") == Rows{{"aaa", "b\r\nbb", "ccc"}, {"zzz", "yyy", "xxx"}});
  CHECK(rows("\"aaa\",\"b\"\"bb\",\"ccc\"") == Rows{{"aaa", "b\"bb", "ccc"}});
  CHECK(rows("a, b ,c") == Rows{{"a", " b ", "c"}});  // spaces are part of a field
}

TEST_CASE("cells may be empty, lines may end in any way, a byte order mark is no part of the first cell", "[csv]") {
  CHECK(rows("").empty());
  CHECK(rows("\n\r\n\r").empty());
  CHECK(rows(",") == Rows{{"", ""}});
  CHECK(rows("a,,\n\"\",b,") == Rows{{"a", "", ""}, {"", "b", ""}});
  CHECK(rows("a,b\n\n\nc,d\rl,m\r\ne,f") == Rows{{"a", "b"}, {"c", "d"}, {"l", "m"}, {"e", "f"}});
  CHECK(rows("\xEF\xBB\xBF\"id\",name\n1,2") == Rows{{"id", "name"}, {"1", "2"}});
  CHECK(rows("\xEF\xBB\xBF") == Rows{});
  CHECK(rows("5\" disk,x") == Rows{{"5\" disk", "x"}});  // a quotation mark inside a plain cell is itself
}

TEST_CASE("the separator is the one that the first row has most of", "[csv]") {
  CHECK(read("a;b;c\n1,5;2;3").rows == Rows{{"a", "b", "c"}, {"1,5", "2", "3"}});
  CHECK(read("a\tb\n1,5\t2").rows == Rows{{"a", "b"}, {"1,5", "2"}});
  CHECK(read("\"Last, First, Middle\";id\n\"x\";1").rows == Rows{{"Last, First, Middle", "id"}, {"x", "1"}});
  CHECK(read("id\n1;2").rows == Rows{{"id"}, {"1;2"}});
  CHECK(read("id\n1;2").separator == ',');
  CHECK(read("x,y,z;\"a,\"b").mistakes == "class.csv:1: a quotation mark that is never closed; end the cell with \"\n");
}

TEST_CASE("a row knows its line and its offset, from where it can be read again", "[csv]") {
  const std::string text = "\xEF\xBB\xBFid,name\r\n\r\n1,\"a\nb\"\r2,\"c\"\n\n3,d";
  const ReadCsv all = read(text);
  CHECK(all.rows == Rows{{"id", "name"}, {"1", "a\nb"}, {"2", "c"}, {"3", "d"}});
  CHECK(all.lines == std::vector<int>{1, 3, 5, 7});
  for (std::size_t i = 1; i < all.rows.size(); ++i) {
    std::istringstream in(text.substr(all.offsets[i]));
    CsvReader again("class.csv", in, {}, all.separator);
    std::vector<std::string> cells;
    REQUIRE(again.next(cells));
    CHECK(cells == all.rows[i]);
  }
}

TEST_CASE("what cannot be read ends the reading with a sentence; the rows before it stand", "[csv]") {
  const auto mistake = [](const std::string& text, const CsvLimits& limits = {}) {
    const ReadCsv result = read("id,name\n1,a\n" + text, limits);
    CHECK(result.rows.size() == 2);
    return result.mistakes;
  };
  CHECK(mistake("2,\"b\n3,c\n") == "class.csv:3: a quotation mark that is never closed; end the cell with \"\n");
  CHECK(mistake("\n2,\"b\"c\n3,d") ==
        "class.csv:4: text behind the end of a quoted cell; a quotation mark inside it is written \"\"\n");
  CHECK(mistake(std::string("2,b\0c\n", 6)) == "class.csv:3: a NUL byte; CSV is text, saved as UTF-8\n");
  CHECK(mistake("2,\xE9t\xE9\n") == "class.csv:3: invalid UTF-8; the file must be saved as UTF-8\n");
  CHECK(mistake("2,b,c,d,e\n", {64, 4}) == "class.csv:3: more than 4 columns\n");
  CHECK(mistake("2," + std::string(100, 'b'), {64, 4}) == "class.csv:3: a row of more than 64 bytes\n");
  CHECK(mistake("2,\"" + std::string(100, '\n'), {64, 4}) ==
        "class.csv:3: a row of more than 64 bytes; is a quotation mark not closed?\n");
  CHECK(read("2," + std::string(62, 'b'), {64, 2}).mistakes == "");
}

TEST_CASE("text that a spreadsheet would run is defused, and no other text is changed", "[csv]") {
  for (const char* formula : {"=1+2", "+1", "-1", "@SUM(A1)", "\tx", "\rx", "  =1", " \t =cmd|'/c calc'!A0", "\n=1",
                              "\xC2\xA0=1", "\xEF\xBB\xBF=1", "\x1B=1", "\xC2\x9B+1",
                              "\xEF\xBC\x9D"
                              "1",
                              "=\"a\",b"}) {
    INFO(formula);
    CHECK(cell(formula).starts_with('\''));
  }
  CHECK(csv_text("=1+2") == "'=1+2");
  CHECK(csv_text("=HYPERLINK(\"x\")") == "\"'=HYPERLINK(\"\"x\"\")\"");
  for (const char* text : {"", "Lovelace, Ada", "a\"b", "3-4", "a=b", "O'Brien", "\xC3\x89va", "a;b", " padded ", "'"})
    CHECK(cell(text) == text);
  CHECK(csv_text("plain") == "plain");
  CHECK(csv_text("a\nb\x1B[31m\xC2\x85") == "\"a b [31m \"");
  CHECK(csv_text("a\xFF"
                 "b") ==
        "a\xEF\xBF\xBD"
        "b");
}

TEST_CASE("numbers are plain decimals in every locale and of every size", "[csv]") {
  CHECK(csv_number(0) == "0");
  CHECK(csv_number(-0.0) == "0");
  CHECK(csv_number(-0.00001) == "0");
  CHECK(csv_number(12.5) == "12.5");
  CHECK(csv_number(-12.5) == "-12.5");
  CHECK(csv_number(100) == "100");
  CHECK(csv_number(2.0 / 3) == "0.6667");
  CHECK(csv_number(2.0 / 3, 2) == "0.67");
  CHECK(csv_number(2.0 / 3, 0) == "1");
  CHECK(csv_number(1e15) == "1000000000000000");
  CHECK(csv_number(1e300).size() == 301);
  CHECK(csv_number(1e-300) == "0");
  CHECK(csv_number(std::numeric_limits<double>::infinity()) == "");
  CHECK(csv_number(std::numeric_limits<double>::quiet_NaN()) == "");
}

TEST_CASE("whatever cells are written are read back, but for what is defused", "[csv]") {
  const unsigned seed = 4180;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  const std::string letters = "ab,;\"' \t\n=1-\xC3\xA9";
  for (int i = 0; i < 3000; ++i) {
    std::vector<std::string> row(1 + random() % 5), written;
    for (std::string& text : row) {
      for (std::size_t n = random() % 6; n > 0; --n) {
        const std::size_t k = random() % (letters.size() - 1);
        text += k == letters.size() - 2 ? letters.substr(k, 2) : letters.substr(k, 1);
      }
      written.push_back(csv_text(text));
    }
    std::string out = "h,h\r\n";  // so that the separator is a comma
    write_csv_row(written, out);
    const Rows back = rows(out);
    REQUIRE(back.size() == 2);
    REQUIRE(back[1].size() == row.size());
    for (std::size_t k = 0; k < row.size(); ++k) {
      std::string expected = row[k];
      for (char& c : expected) c = c == '\t' || c == '\n' ? ' ' : c;
      REQUIRE((back[1][k] == expected || back[1][k] == "'" + expected));
    }
  }
}
