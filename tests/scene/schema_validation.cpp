// SPDX-License-Identifier: MIT
// The only file that includes valijson, which is slow to compile.
#include "schema_validation.hpp"

#include <fstream>
#include <stdexcept>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

namespace raytorus::test {

std::string schemaComplaint(const nlohmann::json& document) {
    using valijson::adapters::NlohmannJsonAdapter;
    std::ifstream file(RAYTORUS_SOURCE_DIR "/docs/scene.schema.json");
    const nlohmann::json text = nlohmann::json::parse(file);
    valijson::Schema schema;
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(NlohmannJsonAdapter(text), schema);

    valijson::ValidationResults results;
    if (valijson::Validator(valijson::Validator::kStrongTypes)
            .validate(schema, NlohmannJsonAdapter(document), &results)) {
        return "";
    }
    valijson::ValidationResults::Error error;
    std::string complaint = "does not fit";
    while (results.popError(error)) {
        complaint = error.description;
        for (const std::string& part : error.context) {
            complaint += " " + part;
        }
    }
    return complaint;
}

}  // namespace raytorus::test
