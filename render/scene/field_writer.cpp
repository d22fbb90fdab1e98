#include "render/scene/field_writer.h"

namespace pdr {

std::string jsonText(std::string_view format, const nlohmann::ordered_json& fields) {
    nlohmann::ordered_json document{{"format", format}, {"version", 1}};
    document.update(fields);
    return document.dump(2) + '\n';
}

}  // namespace pdr
