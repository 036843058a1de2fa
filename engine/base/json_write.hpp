#pragma once
// From the tree of a JSON document back to text that people like to read and edit.

#include <string>
#include <string_view>
#include <utility>

#include "base/json.hpp"

namespace blossom {

// Parts of a tree that is made, not read.
Json json_string(std::string_view text);
Json json_number(std::string text);  // precondition: a number as JSON has it
Json json_number(const Exact&);      // a number if a short decimal is its value, otherwise an exact string "2/5"
Json json_array(std::vector<Json> items = {});
Json json_object(std::vector<std::pair<std::string, Json>> members = {});

// Two blanks deeper for each level, which begins at `indent` after the first line. An object or array that holds
// objects has one member on each line, and so has an object that is too long for a line of 100 characters; an array of
// anything else that is too long is filled line by line.
std::string write_json(const Json&, int indent = 0);

}  // namespace blossom
