// What a JSON reader may meet, by the classes of "Parsing JSON is a minefield" (Seriot, 2016): what must be accepted
// (y_), what must be refused (n_), and what RFC 8259 leaves open (i_), each of these with what this reader does and
// why. The cases and their texts are ours, and more than there; names follow the suite's where the case is in it.

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <string>
#include <vector>

#include "base/json.hpp"

using namespace blossom;
using namespace std::string_literals;

namespace {

struct Case {
  const char* name;
  std::string text;
};

// A case that is decided: by a phrase of the reason for which it is refused, or "yes".
struct Decided {
  const char* name;
  std::string text;
  const char* decision;
  const char* because;
};

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

const std::vector<Case>& must_be_accepted() {
  static const std::vector<Case> cases{
      {"y_array_arraysWithSpaces", "[[]   ]"s},
      {"y_array_empty-string", "[\"\"]"s},
      {"y_array_empty", "[]"s},
      {"y_array_ending_with_newline", "[\"a\"]\n"s},
      {"y_array_false", "[false]"s},
      {"y_array_heterogeneous", "[null, 1, \"1\", {}]"s},
      {"y_array_null", "[null]"s},
      {"y_array_with_1_and_newline", "[1\n]"s},
      {"y_array_with_leading_space", " [1]"s},
      {"y_array_with_several_null", "[1,null,null,null,2]"s},
      {"y_array_with_trailing_space", "[2] "s},
      {"y_array_nested_objects", "[{\"a\": [{\"b\": []}]}]"s},
      {"y_number", "[123e65]"s},
      {"y_number_0e+1", "[0e+1]"s},
      {"y_number_0e1", "[0e1]"s},
      {"y_number_0e-1", "[0e-1]"s},
      {"y_number_after_space", "[ 4]"s},
      {"y_number_double_close_to_zero",
       "[-0.000000000000000000000000000000000000000000000000000000000000000000000000000001]"s},
      {"y_number_int_with_exp", "[20e1]"s},
      {"y_number_minus_zero", "[-0]"s},
      {"y_number_minus_zero_real", "[-0.0]"s},
      {"y_number_negative_int", "[-123]"s},
      {"y_number_negative_one", "[-1]"s},
      {"y_number_negative_zero", "[-0]"s},
      {"y_number_real_capital_e", "[1E22]"s},
      {"y_number_real_capital_e_neg_exp", "[1E-2]"s},
      {"y_number_real_capital_e_pos_exp", "[1E+2]"s},
      {"y_number_real_exponent", "[123e45]"s},
      {"y_number_real_exponent_leading_zeros", "[1e0007]"s},
      {"y_number_real_fraction_exponent", "[123.456e78]"s},
      {"y_number_real_neg_exp", "[1e-2]"s},
      {"y_number_real_pos_exponent", "[1e+2]"s},
      {"y_number_simple_int", "[123]"s},
      {"y_number_simple_real", "[123.456789]"s},
      {"y_number_largest_double", "[1.7976931348623157e308]"s},
      {"y_number_smallest_double", "[5e-324]"s},
      {"y_number_zero", "[0]"s},
      {"y_number_trailing_zeros", "[1.5000]"s},
      {"y_number_int64_max", "[9223372036854775807]"s},
      {"y_number_int64_min", "[-9223372036854775808]"s},
      {"y_number_uint64_max", "[18446744073709551615]"s},
      {"y_object", "{\"asd\":\"sdf\", \"dfg\":\"fgh\"}"s},
      {"y_object_basic", "{\"asd\":\"sdf\"}"s},
      {"y_object_empty", "{}"s},
      {"y_object_empty_key", "{\"\":0}"s},
      {"y_object_escaped_null_in_key", "{\"foo\\u0000bar\": 42}"s},
      {"y_object_extreme_numbers", "{ \"min\": -1.0e+28, \"max\": 1.0e+28 }"s},
      {"y_object_long_strings",
       "{\"x\":[{\"id\": \"xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx\"}], \"id\": \"xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx\"}"s},
      {"y_object_simple", "{\"a\":[]}"s},
      {"y_object_string_unicode", "{\"title\":\"\\u041f\\u043e\\u043b\\u0442\\u043e\\u0440\\u0430\" }"s},
      {"y_object_with_newlines", "{\n\"a\": \"b\"\n}"s},
      {"y_object_same_key_in_different_objects", "{\"a\": {\"a\": 1}, \"b\": {\"a\": 1}}"s},
      {"y_object_keys_differ_in_case", "{\"a\": 1, \"A\": 2}"s},
      {"y_object_keys_differ_in_normal_form", "{\"\xC3\xA9\": 1, \"e\xCC\x81\": 2}"s},
      {"y_string_1_2_3_bytes_UTF-8_sequences", "[\"\\u0060\\u012a\\u12AB\"]"s},
      {"y_string_accepted_surrogate_pair", "[\"\\uD801\\udc37\"]"s},
      {"y_string_accepted_surrogate_pairs", "[\"\\ud83d\\ude39\\ud83d\\udc8d\"]"s},
      {"y_string_allowed_escapes", "[\"\\\"\\\\\\/\\b\\f\\n\\r\\t\"]"s},
      {"y_string_backslash_and_u_escaped_zero", "[\"\\\\u0000\"]"s},
      {"y_string_backslash_doublequotes", "[\"\\\"\"]"s},
      {"y_string_comments", "[\"a/*b*/c/*d//e\"]"s},
      {"y_string_double_escape_a", "[\"\\\\a\"]"s},
      {"y_string_double_escape_n", "[\"\\\\n\"]"s},
      {"y_string_escaped_control_character", "[\"\\u0012\"]"s},
      {"y_string_escaped_noncharacter", "[\"\\uFFFF\"]"s},
      {"y_string_in_array", "[\"asd\"]"s},
      {"y_string_in_array_with_leading_space", "[ \"asd\"]"s},
      {"y_string_last_surrogates_1_and_2", "[\"\\uDBFF\\uDFFF\"]"s},
      {"y_string_nbsp_uescaped", "[\"new\\u00A0line\"]"s},
      {"y_string_nonCharacterInUTF-8_U+10FFFF", "[\"\xF4\x8F\xBF\xBF\"]"s},
      {"y_string_nonCharacterInUTF-8_U+FFFF", "[\"\xEF\xBF\xBF\"]"s},
      {"y_string_null_escape", "[\"\\u0000\"]"s},
      {"y_string_one-byte-utf-8", "[\"\\u002c\"]"s},
      {"y_string_pi", "[\"\xCF\x80\"]"s},
      {"y_string_reservedCharacterInUTF-8_U+1BFFF", "[\"\xF0\x9B\xBF\xBF\"]"s},
      {"y_string_simple_ascii", "[\"asd \"]"s},
      {"y_string_space", "\" \""s},
      {"y_string_surrogates_U+1D11E_MUSICAL_SYMBOL_G_CLEF", "[\"\\uD834\\uDd1e\"]"s},
      {"y_string_three-byte-utf-8", "[\"\\u0821\"]"s},
      {"y_string_two-byte-utf-8", "[\"\\u0123\"]"s},
      {"y_string_u+2028_line_sep", "[\"\xE2\x80\xA8\"]"s},
      {"y_string_u+2029_par_sep", "[\"\xE2\x80\xA9\"]"s},
      {"y_string_uEscape", "[\"\\u0061\\u30af\\u30EA\\u30b9\"]"s},
      {"y_string_uescaped_newline", "[\"new\\u000Aline\"]"s},
      {"y_string_unescaped_char_delete", "[\"\x7F\"]"s},
      {"y_string_unicode", "[\"\\uA66D\"]"s},
      {"y_string_unicode_2", "[\"\xE2\x8D\x82\xE3\x88\xB4\xE2\x8D\x82\"]"s},
      {"y_string_unicode_U+10FFFE_nonchar", "[\"\\uDBFF\\uDFFE\"]"s},
      {"y_string_unicode_U+1FFFE_nonchar", "[\"\\uD83F\\uDFFE\"]"s},
      {"y_string_unicode_U+200B_ZERO_WIDTH_SPACE", "[\"\\u200B\"]"s},
      {"y_string_unicode_U+2064_invisible_plus", "[\"\\u2064\"]"s},
      {"y_string_unicode_U+FDD0_nonchar", "[\"\\uFDD0\"]"s},
      {"y_string_unicode_U+FFFE_nonchar", "[\"\\uFFFE\"]"s},
      {"y_string_unicode_escaped_double_quote", "[\"\\u0022\"]"s},
      {"y_string_unicodeEscapedBackslash", "[\"\\u005C\"]"s},
      {"y_string_utf8", "[\"\xE2\x82\xAC\xF0\x9D\x84\x9E\"]"s},
      {"y_string_first_characters_of_each_length", "[\"\xC2\x80\xE0\xA0\x80\xF0\x90\x80\x80\"]"s},
      {"y_string_around_the_surrogates", "[\"\xED\x9F\xBF\xEE\x80\x80\"]"s},
      {"y_string_byte_order_mark_inside", "[\"\xEF\xBB\xBF\"]"s},
      {"y_string_with_del_character",
       "[\"a\x7F"
       "a\"]"s},
      {"y_structure_lonely_false", "false"s},
      {"y_structure_lonely_int", "42"s},
      {"y_structure_lonely_negative_real", "-0.1"s},
      {"y_structure_lonely_null", "null"s},
      {"y_structure_lonely_string", "\"asd\""s},
      {"y_structure_lonely_true", "true"s},
      {"y_structure_string_empty", "\"\""s},
      {"y_structure_trailing_newline", "[\"a\"]\n"s},
      {"y_structure_true_in_array", "[true]"s},
      {"y_structure_whitespace_array", " [] "s},
      {"y_structure_all_kinds_of_whitespace", "\t\r\n [\t\r\n 1\t\r\n ,\t\r\n 2\t\r\n ]\t\r\n "s},
      {"y_structure_32_nested_arrays", repeated("[", 32) + repeated("]", 32)},
      {"y_string_long", "[\"" + repeated("x", 100'000) + "\"]"},
  };
  return cases;
}

const std::vector<Case>& must_be_refused() {
  static const std::vector<Case> cases{
      {"n_array_1_true_without_comma", "[1 true]"s},
      {"n_array_a_invalid_utf8", "[a\xE5]"s},
      {"n_array_colon_instead_of_comma", "[\"\": 1]"s},
      {"n_array_comma_after_close", "[\"\"],"s},
      {"n_array_comma_and_number", "[,1]"s},
      {"n_array_double_comma", "[1,,2]"s},
      {"n_array_double_extra_comma", "[\"x\",,]"s},
      {"n_array_extra_close", "[\"x\"]]"s},
      {"n_array_extra_comma", "[\"\",]"s},
      {"n_array_incomplete", "[\"x\""s},
      {"n_array_incomplete_invalid_value", "[x"s},
      {"n_array_inner_array_no_comma", "[3[4]]"s},
      {"n_array_invalid_utf8", "[\xFF]"s},
      {"n_array_items_separated_by_semicolon", "[1:2]"s},
      {"n_array_just_comma", "[,]"s},
      {"n_array_just_minus", "[-]"s},
      {"n_array_missing_value", "[   , \"\"]"s},
      {"n_array_newlines_unclosed", "[\"a\",\n4\n,1,"s},
      {"n_array_number_and_comma", "[1,]"s},
      {"n_array_number_and_several_commas", "[1,,]"s},
      {"n_array_spaces_vertical_tab_formfeed", "[\"\va\"\\f]"s},
      {"n_array_star_inside", "[*]"s},
      {"n_array_unclosed", "[\"\""s},
      {"n_array_unclosed_trailing_comma", "[1,"s},
      {"n_array_unclosed_with_new_lines", "[1,\n1\n,1"s},
      {"n_array_unclosed_with_object_inside", "[{}"s},
      {"n_incomplete_false", "[fals]"s},
      {"n_incomplete_null", "[nul]"s},
      {"n_incomplete_true", "[tru]"s},
      {"n_multidigit_number_then_00", "123\0"s},
      {"n_number_++", "[++1234]"s},
      {"n_number_+1", "[+1]"s},
      {"n_number_+Inf", "[+Inf]"s},
      {"n_number_-01", "[-01]"s},
      {"n_number_-1.0.", "[-1.0.]"s},
      {"n_number_-2.", "[-2.]"s},
      {"n_number_-NaN", "[-NaN]"s},
      {"n_number_.-1", "[.-1]"s},
      {"n_number_.2e-3", "[.2e-3]"s},
      {"n_number_0.1.2", "[0.1.2]"s},
      {"n_number_0.3e+", "[0.3e+]"s},
      {"n_number_0.3e", "[0.3e]"s},
      {"n_number_0.e1", "[0.e1]"s},
      {"n_number_0_capital_E+", "[0E+]"s},
      {"n_number_0_capital_E", "[0E]"s},
      {"n_number_0e+", "[0e+]"s},
      {"n_number_0e", "[0e]"s},
      {"n_number_1.0e+", "[1.0e+]"s},
      {"n_number_1.0e-", "[1.0e-]"s},
      {"n_number_1.0e", "[1.0e]"s},
      {"n_number_1_000", "[1 000.0]"s},
      {"n_number_1eE2", "[1eE2]"s},
      {"n_number_2.e+3", "[2.e+3]"s},
      {"n_number_2.e-3", "[2.e-3]"s},
      {"n_number_2.e3", "[2.e3]"s},
      {"n_number_9.e+", "[9.e+]"s},
      {"n_number_Inf", "[Inf]"s},
      {"n_number_NaN", "[NaN]"s},
      {"n_number_U+FF11_fullwidth_digit_one", "[\xEF\xBC\x91]"s},
      {"n_number_arabic_digit", "[\xD9\xA1]"s},
      {"n_number_comma_for_a_point", "0,5"s},
      {"n_number_expression", "[1+2]"s},
      {"n_number_fraction", "[2/5]"s},
      {"n_number_hex_1_digit", "[0x1]"s},
      {"n_number_hex_2_digits", "[0x42]"s},
      {"n_number_octal", "[0o17]"s},
      {"n_number_binary", "[0b1]"s},
      {"n_number_infinity", "[Infinity]"s},
      {"n_number_invalid+-", "[0e+-1]"s},
      {"n_number_invalid-negative-real", "[-123.123foo]"s},
      {"n_number_invalid-utf-8-in-bigger-int", "[123\xE5]"s},
      {"n_number_invalid-utf-8-in-exponent", "[1e1\xE5]"s},
      {"n_number_invalid-utf-8-in-int", "[0\xE5]"s},
      {"n_number_minus_infinity", "[-Infinity]"s},
      {"n_number_minus_sign_with_trailing_garbage", "[-foo]"s},
      {"n_number_minus_space_1", "[- 1]"s},
      {"n_number_minus_U+2212",
       "[\xE2\x88\x92"
       "1]"s},
      {"n_number_neg_int_starting_with_zero", "[-012]"s},
      {"n_number_neg_real_without_int_part", "[-.123]"s},
      {"n_number_neg_with_garbage_at_end", "[-1x]"s},
      {"n_number_real_garbage_after_e", "[1ea]"s},
      {"n_number_real_with_invalid_utf8_after_e", "[1e\xE5]"s},
      {"n_number_real_without_fractional_part", "[1.]"s},
      {"n_number_starting_with_dot", "[.123]"s},
      {"n_number_then_00", "1\0"s},
      {"n_number_underscore", "[1_000]"s},
      {"n_number_suffix_f", "[1.5f]"s},
      {"n_number_with_alpha", "[1.2a-3]"s},
      {"n_number_with_alpha_char", "[1.8011670033376514H-308]"s},
      {"n_number_with_leading_zero", "[012]"s},
      {"n_object_bad_value", "[\"x\", truth]"s},
      {"n_object_bracket_key", "{[: \"x\"}\n"s},
      {"n_object_comma_instead_of_colon", "{\"x\", null}"s},
      {"n_object_double_colon", "{\"x\"::\"b\"}"s},
      {"n_object_emoji", "{\xF0\x9F\x87\xA8}"s},
      {"n_object_garbage_at_end", "{\"a\":\"a\" 123}"s},
      {"n_object_key_with_single_quotes", "{key: 'value'}"s},
      {"n_object_lone_continuation_byte_in_key_and_trailing_comma", "{\"\xB9\":\"0\",}"s},
      {"n_object_missing_colon", "{\"a\" b}"s},
      {"n_object_missing_key", "{:\"b\"}"s},
      {"n_object_missing_semicolon", "{\"a\" \"b\"}"s},
      {"n_object_missing_value", "{\"a\":"s},
      {"n_object_no-colon", "{\"a\""s},
      {"n_object_non_string_key", "{1:1}"s},
      {"n_object_non_string_key_but_huge_number_instead", "{9999E9999:1}"s},
      {"n_object_null_key", "{null:1}"s},
      {"n_object_array_key", "{[]:1}"s},
      {"n_object_repeated_null_null", "{null:null,null:null}"s},
      {"n_object_several_trailing_commas", "{\"id\":0,,,,,}"s},
      {"n_object_single_quote", "{'a':0}"s},
      {"n_object_trailing_comma", "{\"id\":0,}"s},
      {"n_object_trailing_comment", "{\"a\":\"b\"}/**/"s},
      {"n_object_trailing_comment_open", "{\"a\":\"b\"}/**//"s},
      {"n_object_trailing_comment_slash_open", "{\"a\":\"b\"}//"s},
      {"n_object_trailing_comment_slash_open_incomplete", "{\"a\":\"b\"}/"s},
      {"n_object_two_commas_in_a_row", "{\"a\":\"b\",,\"c\":\"d\"}"s},
      {"n_object_unquoted_key", "{a: \"b\"}"s},
      {"n_object_unterminated-value", "{\"a\":\"a"s},
      {"n_object_with_single_string", "{ \"foo\" : \"bar\", \"a\" }"s},
      {"n_object_with_trailing_garbage", "{\"a\":\"b\"}#"s},
      {"n_object_equals_sign", "{\"a\"=1}"s},
      {"n_object_semicolon", "{\"a\":1;\"b\":2}"s},
      {"n_single_space", " "s},
      {"n_string_1_surrogate_then_escape", "[\"\\uD800\\\"]"s},
      {"n_string_1_surrogate_then_escape_u", "[\"\\uD800\\u\"]"s},
      {"n_string_1_surrogate_then_escape_u1", "[\"\\uD800\\u1\"]"s},
      {"n_string_1_surrogate_then_escape_u1x", "[\"\\uD800\\u1x\"]"s},
      {"n_string_accentuated_char_no_quotes", "[\xC3\xA9]"s},
      {"n_string_backslash_00", "[\"\\\0\"]"s},
      {"n_string_escape_x", "[\"\\x00\"]"s},
      {"n_string_escape_octal", "[\"\\00012\"]"s},
      {"n_string_escape_quote", "[\"\\'\"]"s},
      {"n_string_escape_capital_U", "[\"\\U0061\"]"s},
      {"n_string_escaped_backslash_bad", "[\"\\\\\\\"]"s},
      {"n_string_escaped_ctrl_char_tab", "[\"\\\t\"]"s},
      {"n_string_escaped_emoji", "[\"\\\xF0\x9F\x8C\x80\"]"s},
      {"n_string_incomplete_escape", "[\"\\\"]"s},
      {"n_string_incomplete_escaped_character", "[\"\\u00A\"]"s},
      {"n_string_incomplete_surrogate", "[\"\\uD834\\uDd\"]"s},
      {"n_string_incomplete_surrogate_escape_invalid", "[\"\\uD800\\uD800\\x\"]"s},
      {"n_string_invalid-utf-8-in-escape", "[\"\\u\xE5\"]"s},
      {"n_string_invalid_backslash_esc", "[\"\\a\"]"s},
      {"n_string_invalid_unicode_escape", "[\"\\uqqqq\"]"s},
      {"n_string_invalid_utf8_after_escape", "[\"\\\xE5\"]"s},
      {"n_string_leading_uescaped_thinspace", "[\\u0020\"asd\"]"s},
      {"n_string_no_quotes_with_bad_escape", "[\\n]"s},
      {"n_string_single_doublequote", "\""s},
      {"n_string_single_quote", "['single quote']"s},
      {"n_string_single_string_no_double_quotes", "abc"s},
      {"n_string_start_escape_unclosed", "[\"\\"s},
      {"n_string_unescaped_ctrl_char", "[\"a\0a\"]"s},
      {"n_string_unescaped_ctrl_char_1F", "[\"\x1F\"]"s},
      {"n_string_unescaped_escape", "[\"\x1B[31m\"]"s},
      {"n_string_unescaped_newline", "[\"new\nline\"]"s},
      {"n_string_unescaped_carriage_return", "[\"a\r\"]"s},
      {"n_string_unescaped_tab", "[\"\t\"]"s},
      {"n_string_unicode_CapitalU", "\"\\UA66D\""s},
      {"n_string_with_trailing_garbage", "\"\"x"s},
      {"n_structure_angle_bracket_.", "<.>"s},
      {"n_structure_angle_bracket_null", "[<null>]"s},
      {"n_structure_array_trailing_garbage", "[1]x"s},
      {"n_structure_array_with_extra_array_close", "[1]]"s},
      {"n_structure_array_with_unclosed_string", "[\"asd]"s},
      {"n_structure_ascii-unicode-identifier", "a\xC3\xA5"s},
      {"n_structure_capitalized_True", "[True]"s},
      {"n_structure_upper_case_null", "NULL"s},
      {"n_structure_undefined", "[undefined]"s},
      {"n_structure_close_unopened_array", "1]"s},
      {"n_structure_comma_instead_of_closing_brace", "{\"x\": true,"s},
      {"n_structure_double_array", "[][]"s},
      {"n_structure_end_array", "]"s},
      {"n_structure_incomplete_UTF8_BOM", "\xEF\xBB{}"s},
      {"n_structure_lone-invalid-utf-8", "\xE5"s},
      {"n_structure_lone-open-bracket", "["s},
      {"n_structure_no_data", ""s},
      {"n_structure_null-byte-outside-string", "[\0]"s},
      {"n_structure_number_with_trailing_garbage", "2@"s},
      {"n_structure_object_followed_by_closing_object", "{}}"s},
      {"n_structure_object_unclosed_no_value", "{\"\":"s},
      {"n_structure_object_with_comment", "{\"a\":/*comment*/\"b\"}"s},
      {"n_structure_object_with_trailing_garbage", "{\"a\": true} \"x\""s},
      {"n_structure_open_array_apostrophe", "['"s},
      {"n_structure_open_array_comma", "[,"s},
      {"n_structure_open_array_open_object", "[{"s},
      {"n_structure_open_array_open_string", "[\"a"s},
      {"n_structure_open_array_string", "[\"a\""s},
      {"n_structure_open_object", "{"s},
      {"n_structure_open_object_close_array", "{]"s},
      {"n_structure_open_object_comma", "{,"s},
      {"n_structure_open_object_open_array", "{["s},
      {"n_structure_open_object_open_string", "{\"a"s},
      {"n_structure_open_object_string_with_apostrophes", "{'a'"s},
      {"n_structure_open_open", "[\"\\{[\"\\{[\"\\{[\"\\{"s},
      {"n_structure_single_eacute", "\xE9"s},
      {"n_structure_single_star", "*"s},
      {"n_structure_trailing_#", "{\"a\":\"b\"}#{}"s},
      {"n_structure_two_documents_on_two_lines", "{}\n{}"s},
      {"n_structure_two_byte_order_marks", "\xEF\xBB\xBF\xEF\xBB\xBF[]"s},
      {"n_structure_byte_order_mark_behind", "[]\xEF\xBB\xBF"s},
      {"n_structure_U+2060_word_joined", "[\xE2\x81\xA0]"s},
      {"n_structure_uescaped_LF_before_string", "[\\u000A\"\"]"s},
      {"n_structure_unclosed_array", "[1"s},
      {"n_structure_unclosed_array_partial_null", "[ false, nul"s},
      {"n_structure_unclosed_array_unfinished_false", "[ true, fals"s},
      {"n_structure_unclosed_array_unfinished_true", "[ false, tru"s},
      {"n_structure_unclosed_object", "{\"asd\":\"asd\""s},
      {"n_structure_unicode-identifier", "\xC3\xA5"s},
      {"n_structure_UTF8_BOM_no_data", "\xEF\xBB\xBF"s},
      {"n_structure_whitespace_U+2060_word_joiner", "[\xE2\x81\xA0]"s},
      {"n_structure_whitespace_formfeed", "[\f]"s},
      {"n_structure_whitespace_vertical_tab", "[\v]"s},
      {"n_structure_whitespace_U+0085_next_line", "[\xC2\x85]"s},
      {"n_structure_whitespace_U+00A0_no-break_space", "[\xC2\xA0]"s},
      {"n_structure_xml", "<a/>"s},
      {"n_structure_python", "{'a': (1, 2), 'b': None}"s},
      {"n_structure_100000_opening_arrays", repeated("[", 100'000)},
      {"n_structure_open_array_object", repeated("[{\"\":", 50'000)},
      {"n_structure_100000_closing_arrays", repeated("]", 100'000)},
      {"n_string_unclosed_long", "[\"" + repeated("x", 100'000)},
  };
  return cases;
}

// Valid by RFC 8259, which lets a reader set limits and calls names that are not unique unpredictable (sections 4 and
// 9).
const std::vector<Decided>& stricter() {
  static const std::vector<Decided> cases{
      {"y_object_duplicated_key", "{\"a\":\"b\",\"a\":\"c\"}"s, "duplicate key",
       "two answers to one question: which counts would depend on the reader"},
      {"y_object_duplicated_key_and_value", "{\"a\":\"b\",\"a\":\"b\"}"s, "duplicate key", "likewise"},
      {"y_object_duplicated_key_by_escape", "{\"a\":1,\"\\u0061\":2}"s, "duplicate key",
       "the same key spelled otherwise"},
      {"y_structure_33_nested_arrays", repeated("[", 33) + repeated("]", 33), "nested too deep",
       "Blossom's own files are at most some 8 deep"},
      {"y_structure_2000001_values", "[" + repeated("0,", 2'000'000) + "0]", "too many values",
       "memory for a document is bounded"},
      {"y_structure_16_MiB_and_a_byte", "[]" + repeated(" ", (16 << 20) - 1), "too large", "likewise"},
  };
  return cases;
}

const std::vector<Decided>& left_open() {
  static const std::vector<Decided> cases{
      {"i_number_double_huge_neg_exp", "[123.456e-789]"s, "yes",
       "a number's text is kept; whoever wants its value gets it or a mistake at its place"},
      {"i_number_real_underflow", "[123e-10000000]"s, "yes", "likewise; it is not silently 0"},
      {"i_number_exponent_of_many_digits", "[1e-99999999999999999999]"s, "yes", "likewise"},
      {"i_number_too_big_neg_int", "[-123123123123123123123123123123]"s, "yes",
       "exact numbers have no largest whole number"},
      {"i_number_too_big_pos_int", "[100000000000000000000]"s, "yes", "likewise"},
      {"i_number_very_big_negative_int", "[-237462374673276894279832749832423479823246327846]"s, "yes", "likewise"},
      {"i_number_more_digits_than_a_double", "[0.1000000000000000055511151231257827021181583404541015625]"s, "yes",
       "no digit is lost"},
      {"i_number_huge_exp",
       "[0.4e00669999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999969999999006]"s,
       "too large", "numbers end at the largest double"},
      {"i_number_neg_int_huge_exp", "[-1e+9999]"s, "too large", "likewise"},
      {"i_number_pos_double_huge_exp", "[1.5e+9999]"s, "too large", "likewise"},
      {"i_number_real_neg_overflow", "[-123123e100000]"s, "too large", "likewise"},
      {"i_number_real_pos_overflow", "[123123e100000]"s, "too large", "likewise"},
      {"i_number_just_above_the_largest_double", "[1.8e308]"s, "too large", "likewise"},
      {"i_object_key_lone_2nd_surrogate", "{\"\\uDFAA\":0}"s, "surrogate",
       "half a pair is no character and cannot be written as UTF-8"},
      {"i_string_1st_surrogate_but_2nd_missing", "[\"\\uDADA\"]"s, "surrogate", "likewise"},
      {"i_string_1st_valid_surrogate_2nd_invalid", "[\"\\uD888\\u1234\"]"s, "surrogate", "likewise"},
      {"i_string_incomplete_surrogate_and_escape_valid", "[\"\\uD800\\n\"]"s, "surrogate", "likewise"},
      {"i_string_incomplete_surrogate_pair", "[\"\\uDd1ea\"]"s, "surrogate", "likewise"},
      {"i_string_incomplete_surrogates_escape_valid", "[\"\\uD800\\uD800\\n\"]"s, "surrogate", "likewise"},
      {"i_string_invalid_lonely_surrogate", "[\"\\ud800\"]"s, "surrogate", "likewise"},
      {"i_string_invalid_surrogate", "[\"\\ud800abc\"]"s, "surrogate", "likewise"},
      {"i_string_inverted_surrogates_U+1D11E", "[\"\\uDd1e\\uD834\"]"s, "surrogate", "likewise"},
      {"i_string_lone_second_surrogate", "[\"\\uDFAA\"]"s, "surrogate", "likewise"},
      {"i_string_invalid_utf-8", "[\"\xFF\"]"s, "UTF-8",
       "bytes that are no character would go into reports as they are"},
      {"i_string_iso_latin_1", "[\"\xE9\"]"s, "UTF-8", "likewise; the message says how to save the file"},
      {"i_string_lone_utf8_continuation_byte", "[\"\x81\"]"s, "UTF-8", "likewise"},
      {"i_string_not_in_unicode_range", "[\"\xF4\xBF\xBF\xBF\"]"s, "UTF-8", "likewise"},
      {"i_string_overlong_sequence_2_bytes", "[\"\xC0\xAF\"]"s, "UTF-8",
       "a second spelling of / that a check for / would miss"},
      {"i_string_overlong_sequence_3_bytes", "[\"\xE0\x80\xAF\"]"s, "UTF-8", "likewise"},
      {"i_string_overlong_sequence_4_bytes", "[\"\xF0\x80\x80\xAF\"]"s, "UTF-8", "likewise"},
      {"i_string_overlong_sequence_6_bytes", "[\"\xFC\x83\xBF\xBF\xBF\xBF\"]"s, "UTF-8", "likewise"},
      {"i_string_overlong_sequence_6_bytes_null", "[\"\xFC\x80\x80\x80\x80\x80\"]"s, "UTF-8", "likewise"},
      {"i_string_overlong_null", "[\"\xC0\x80\"]"s, "UTF-8", "likewise"},
      {"i_string_truncated-utf-8", "[\"\xE0\xFF\"]"s, "UTF-8", "half a character"},
      {"i_string_truncated_at_the_quote", "[\"\xC3\"]"s, "UTF-8", "likewise; it must not swallow the quotation mark"},
      {"i_string_UTF-8_invalid_sequence", "[\"\xE6\x97\xA5\xD1\x88\xFA\"]"s, "UTF-8", "likewise"},
      {"i_string_UTF8_surrogate_U+D800", "[\"\xED\xA0\x80\"]"s, "UTF-8", "a surrogate is no character in UTF-8 either"},
      {"i_string_CESU-8_pair", "[\"\xED\xA0\xB4\xED\xB4\x9E\"]"s, "UTF-8", "likewise"},
      {"i_string_UTF-16LE_with_BOM", "\xFF\xFE[\0\"\0\xE9\0\"\0]\0"s, "NUL", "RFC 8259, 8.1: files are UTF-8"},
      {"i_string_utf16BE_no_BOM", "\0[\0\"\0\xE9\0\"\0]"s, "NUL", "likewise"},
      {"i_string_utf16LE_no_BOM", "[\0\"\0\xE9\0\"\0]\0"s, "NUL", "likewise"},
      {"i_structure_UTF-8_BOM_empty_object", "\xEF\xBB\xBF{}"s, "yes",
       "editors on Windows put it there; RFC 8259 allows to ignore it"},
      {"i_structure_500_nested_arrays", repeated("[", 500) + repeated("]", 500), "nested too deep",
       "deep documents are an attack on whoever recurses"},
  };
  return cases;
}

void check_refused(const std::string& text, const std::string& phrase) {
  const auto document = JsonDocument::parse("f", text);
  REQUIRE_FALSE(document);
  REQUIRE(document.diagnostics.size() == 1);
  const Diagnostic& d = document.diagnostics.front();
  INFO(to_string(d));
  CHECK(d.message.find(phrase) != std::string::npos);
  // In the file: not beyond the line after its last line break, nor beyond that line's bytes.
  CHECK(d.line <= 1 + static_cast<int>(std::count(text.begin(), text.end(), '\n')));
  CHECK(d.column <= 1 + static_cast<int>(text.size()));
}

}  // namespace

TEST_CASE("JSON that must be accepted is accepted", "[json]") {
  for (const Case& c : must_be_accepted()) {
    INFO(c.name);
    const auto document = JsonDocument::parse("f", c.text);
    INFO(to_string(document.diagnostics));
    CHECK(document);
    CHECK(document.diagnostics.empty());
  }
}

TEST_CASE("what is no JSON is refused, with one mistake at a place in the file", "[json]") {
  for (const Case& c : must_be_refused()) {
    INFO(c.name);
    check_refused(c.text, "");
  }
}

TEST_CASE("valid JSON that is refused on purpose", "[json]") {
  for (const Decided& c : stricter()) {
    INFO(c.name << ": " << c.because);
    check_refused(c.text, c.decision);
  }
}

TEST_CASE("what the standard leaves open is decided", "[json]") {
  for (const Decided& c : left_open()) {
    INFO(c.name << ": " << c.because);
    if (c.decision == "yes"s)
      CHECK(JsonDocument::parse("f", c.text));
    else
      check_refused(c.text, c.decision);
  }
}

TEST_CASE("the cases have different names", "[json]") {
  std::set<std::string> names;
  std::size_t count = 0;
  const auto add = [&](const auto& cases, const std::string& prefix) {
    for (const auto& c : cases) {
      INFO(c.name);
      CHECK(std::string(c.name).starts_with(prefix));
      CHECK(names.insert(c.name).second);
      ++count;
    }
  };
  add(must_be_accepted(), "y_");
  add(must_be_refused(), "n_");
  add(stricter(), "y_");
  add(left_open(), "i_");
  CHECK(count >= 300);
}
