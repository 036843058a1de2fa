#include "lesson/algorithm_schema.hpp"

#include "algorithms/algorithm.hpp"
#include "base/json.hpp"

namespace blossom {
namespace {

std::string geometry(std::string_view definition) {
  return R"("$ref": "geometry.schema.json#/$defs/)" + std::string(definition) + "\"";
}

// What an input must look like: members of a schema, without its braces.
std::string form(const InputSpec& spec) {
  switch (spec.type) {
    case InputSpec::Type::number:
      return geometry("number");
    case InputSpec::Type::integer:
      return R"("type": "integer", "minimum": )" + std::to_string(spec.at_least) + R"(, "maximum": )" +
             std::to_string(spec.at_most);
    case InputSpec::Type::choice: {
      std::string text = R"("enum": [)";
      for (std::size_t i = 0; i < spec.choices.size(); ++i) text += (i > 0 ? ", " : "") + json_quote(spec.choices[i]);
      return text + "]";
    }
    case InputSpec::Type::curve:
      return geometry("curve");
    case InputSpec::Type::surface:
      return geometry("surface");
    case InputSpec::Type::curves:
      return R"("type": "array", "minItems": )" + std::to_string(spec.at_least) + R"(, "items": {)" +
             geometry("curve") + "}";
    case InputSpec::Type::numbers:
      return R"("type": "array", "minItems": )" + std::to_string(spec.at_least) + R"(, "maxItems": )" +
             std::to_string(spec.at_most) + R"(, "items": {)" + geometry("number") + "}";
    case InputSpec::Type::points:
      return R"("type": "array", "minItems": )" + std::to_string(spec.at_least) + R"(, "maxItems": )" +
             std::to_string(spec.at_most) + R"(, "items": {)" + geometry("point") + "}";
    case InputSpec::Type::net:
      return R"("type": "array", "minItems": 2, "items": {"type": "array", "minItems": 2, "items": {)" +
             geometry("point") + "}}";
  }
  return {};
}

// The schema of an algorithm's "inputs".
std::string inputs(const Algorithm& algorithm) {
  std::string properties = "\n        \"$comment\": {" + geometry("comment") + "}", required;
  for (const InputSpec& spec : algorithm.inputs) {
    properties += ",\n        " + json_quote(spec.name) + R"(: {"description": )" + json_quote(spec.description) +
                  ", " + form(spec) + (spec.fallback.empty() ? "" : R"(, "default": )" + std::string(spec.fallback)) +
                  "}";
    if (spec.fallback.empty()) required += (required.empty() ? "" : ", ") + json_quote(spec.name);
  }
  return "    " + json_quote(algorithm.id) + ": {\n      \"description\": " + json_quote(algorithm.summary) +
         ",\n      \"type\": \"object\",\n      \"properties\": {" + properties + "\n      },\n      \"required\": [" +
         required + "],\n      \"additionalProperties\": false\n    }";
}

}  // namespace

std::string algorithm_schema() {
  std::string choices, conditions, definitions;
  for (const Algorithm* algorithm : algorithms()) {
    const std::string id = json_quote(algorithm->id);
    choices += choices.empty() ? "\n" : ",\n";
    choices += "        {\"const\": " + id + ", \"title\": " + json_quote(algorithm->title) +
               ", \"description\": " + json_quote(algorithm->summary) + "}";
    conditions += conditions.empty() ? "\n" : ",\n";
    conditions += R"(    {"if": {"properties": {"algorithm": {"const": )" + id +
                  R"(}}, "required": ["algorithm"]}, "then": {"properties": {"inputs": {"$ref": "#/$defs/)" +
                  std::string(algorithm->id) + "\"}}}}";
    definitions += (definitions.empty() ? "\n" : ",\n") + inputs(*algorithm);
  }
  return R"({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "$id": "algorithms.schema.json",
  "title": "The algorithms and their inputs",
  "description": "The keys \"algorithm\" and \"inputs\" of lessons, exercises and traces. Written from the table of algorithms.",
  "properties": {
    "algorithm": {
      "description": "The algorithm by its id.",
      "oneOf": [)" +
         choices + R"(
      ]
    }
  },
  "allOf": [)" +
         conditions + R"(
  ],
  "$defs": {)" +
         definitions + "\n  }\n}\n";
}

}  // namespace blossom
