#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

namespace geargraph::test {

/// A JSON Schema, held against documents by a validator that is not of this project. The schemas keep to
/// keywords that draft 7 and draft 2020-12 share.
class JsonSchema {
 public:
  explicit JsonSchema(nlohmann::json source) : m_source(std::move(source)) {
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(Adapter(m_source), m_schema);
  }

  /// "" where the document fits; else the first thing that is wrong.
  [[nodiscard]] std::string complaint(const nlohmann::json& document) const {
    valijson::ValidationResults results;
    if (valijson::Validator().validate(m_schema, Adapter(document), &results)) return {};
    valijson::ValidationResults::Error error;
    if (!results.popError(error)) return "rejected";
    std::string where;
    for (const std::string& step : error.context) where += step;
    return where + ": " + error.description;
  }

 private:
  using Adapter = valijson::adapters::NlohmannJsonAdapter;

  nlohmann::json m_source;
  valijson::Schema m_schema;
};

}  // namespace geargraph::test
