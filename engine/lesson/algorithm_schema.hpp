#pragma once
// The part of the JSON Schemas that follows from the table of algorithms: which algorithms there are, and for each the
// keys of its "inputs". It is kept as lessons/algorithms.schema.json, which the schemas of lessons, exercises and
// traces refer to, so that editors complete it; a test says when that file is not this text any more.

#include <string>

namespace blossom {

std::string algorithm_schema();

}  // namespace blossom
