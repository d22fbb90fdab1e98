#include "render/scene/json_fields.h"

#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

namespace pdr {
namespace {

using nlohmann::json;

/// Refuses a field that is written twice in one object; the parser would silently keep the last one.
class TwinGuard {
  public:
    bool operator()(int, json::parse_event_t event, json& parsed) {
        if (event == json::parse_event_t::object_start)
            open_.emplace_back();
        else if (event == json::parse_event_t::object_end)
            open_.pop_back();
        else if (event == json::parse_event_t::key && !open_.back().insert(parsed.get<std::string>()).second)
            throw FieldError{{phrase("is written twice in the same object"), parsed.get<std::string>(),
                              phrase("Remove one of them.")}};
        return true;
    }

  private:
    std::vector<std::set<std::string>> open_;
};

constexpr int kDeepest = 64;                    ///< largest depth of nested lists and objects; a scene has six
constexpr std::size_t kMostValues = 1'000'000;  ///< largest number; 4096 nodes with all their fields have 60,000

/// Refuses text that would cost the parser much time or memory. Counts brackets and commas outside strings, without
/// parsing; errors of syntax are left to the parser.
Result<void> checkAmount(std::string_view text) {
    int depth = 0;
    std::size_t values = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted && c == '\\')
            ++i;
        else if (c == '"')
            quoted = !quoted;
        if (quoted)
            continue;
        depth += (c == '[' || c == '{') - (c == ']' || c == '}');
        values += c == ',';
        if (depth > kDeepest)
            return Error{phrase("lists and objects lie in one another deeper than %1", kDeepest), "", ""};
        if (values > kMostValues)
            return Error{phrase("holds more than %1 values", kMostValues), "", ""};
    }
    return {};
}

/// Returns the parser's message without its own name and number in front: "parse error at line 3, column 5: ...".
std::string parserMessage(const json::exception& failure) {
    const std::string message = failure.what();
    const std::size_t end = message.find("] ");
    return end == std::string::npos ? message : message.substr(end + 2);
}

Error inFile(std::string_view file, Error error) {
    error.where = error.where.empty() ? std::string(file) : std::string(file) + ", " + error.where;
    return error;
}

}  // namespace

JsonFields::JsonFields(const json& value, std::string path) : value_(&value), path_(std::move(path)) {
    if (!value.is_object())
        throw FieldError{{phrase("must be an object { ... }"), path_, ""}};
}

bool JsonFields::has(std::string_view name) {
    known_.emplace(name);
    return value_->contains(name);
}

std::string JsonFields::pathOf(std::string_view name) const {
    return path_.empty() ? std::string(name) : path_ + "." + std::string(name);
}

void JsonFields::fail(std::string_view name, const Text& what, const Text& hint) const {
    throw FieldError{{what, pathOf(name), hint}};
}

const json& JsonFields::field(std::string_view name) {
    known_.emplace(name);
    const auto found = value_->find(name);
    if (found == value_->end())
        fail(name, phrase("is missing"));
    return *found;
}

void JsonFields::required(std::string_view name, double& value) {
    const json& found = field(name);
    if (!found.is_number())
        fail(name, phrase("must be a number"));
    value = found.get<double>();
}

void JsonFields::required(std::string_view name, float& value) {
    double exact = 0;
    required(name, exact);
    value = float(exact);
}

void JsonFields::required(std::string_view name, int& value) {
    const json& found = field(name);
    if (!found.is_number_integer())
        fail(name, phrase("must be a whole number"));
    const double exact = found.get<double>();
    if (std::abs(exact) > std::numeric_limits<int>::max())
        fail(name, phrase("is too large a number"));
    value = int(exact);
}

void JsonFields::required(std::string_view name, std::uint64_t& value) {
    const json& found = field(name);
    if (!found.is_number_unsigned())
        fail(name, phrase("must be a whole number from 0 to 18446744073709551615"));
    value = found.get<std::uint64_t>();
}

void JsonFields::required(std::string_view name, bool& value) {
    const json& found = field(name);
    if (!found.is_boolean())
        fail(name, phrase("must be true or false"));
    value = found.get<bool>();
}

void JsonFields::required(std::string_view name, std::string& value) {
    const json& found = field(name);
    if (!found.is_string() || found.get_ref<const std::string&>().empty())
        fail(name, phrase("must be a text in quotes"));
    value = found.get<std::string>();
}

void JsonFields::required(std::string_view name, ivec3& value) {
    const Text shape = phrase("must be three whole numbers [x, y, z]");
    const std::vector<double> read = numbers(name, 3, shape);
    for (int i = 0; i < 3; ++i) {
        if (read[i] != std::trunc(read[i]) || std::abs(read[i]) > std::numeric_limits<int>::max())
            fail(name, shape);
        value[i] = int(read[i]);
    }
}

void JsonFields::required(std::string_view name, dvec3& value) {
    const std::vector<double> read = numbers(name, 3, "must be three numbers [x, y, z]");
    value = {read[0], read[1], read[2]};
}

void JsonFields::required(std::string_view name, vec3& value) {
    if (field(name).is_number()) {
        value = vec3(field(name).get<float>());
        return;
    }
    const std::vector<double> read = numbers(name, 3, "must be a number or three numbers [r, g, b]");
    value = vec3(dvec3(read[0], read[1], read[2]));
}

void JsonFields::required(std::string_view name, std::pair<int, int>& value) {
    const Text shape = phrase("must be two whole numbers [lowest, highest]");
    const std::vector<double> read = numbers(name, 2, shape);
    for (double number : read)
        if (number != std::trunc(number) || std::abs(number) > std::numeric_limits<int>::max())
            fail(name, shape);
    value = {int(read[0]), int(read[1])};
}

void JsonFields::required(std::string_view name, segment::Labels& value) {
    const json& found = field(name);
    const Text shape = phrase("must be a list of different texts in quotes");
    if (!found.is_array())
        fail(name, shape);
    segment::Labels read;
    for (const json& element : found)
        if (!element.is_string() || element.get_ref<const std::string&>().empty() ||
            !read.insert(element.get<std::string>()).second)
            fail(name, shape);
    value = std::move(read);
}

std::vector<double> JsonFields::numbers(std::string_view name, std::size_t count, const Text& shape) {
    const json& found = field(name);
    if (!found.is_array() || found.size() != count)
        fail(name, shape);
    std::vector<double> read;
    for (const json& element : found) {
        if (!element.is_number())
            fail(name, shape);
        read.push_back(element.get<double>());
    }
    return read;
}

std::size_t JsonFields::wordIndex(std::string_view name, const std::vector<std::string_view>& words) {
    const json& found = field(name);
    for (std::size_t i = 0; found.is_string() && i < words.size(); ++i)
        if (found.get_ref<const std::string&>() == words[i])
            return i;
    std::string known;
    for (std::string_view word : words)
        known += (known.empty() ? "" : ", ") + std::string(word);
    fail(name, phrase("must be one of: %1", known));
}

JsonFields JsonFields::object(std::string_view name) {
    return JsonFields(field(name), pathOf(name));
}

std::vector<JsonFields> JsonFields::objects(std::string_view name) {
    const json& found = field(name);
    if (!found.is_array())
        fail(name, phrase("must be a list [ ... ]"));
    std::vector<JsonFields> list;
    for (std::size_t i = 0; i < found.size(); ++i)
        list.emplace_back(found[i], pathOf(name) + "[" + std::to_string(i) + "]");
    return list;
}

void JsonFields::finish() const {
    for (const auto& [name, value] : value_->items())
        if (!known_.contains(name))
            fail(name, phrase("is no field here"), phrase("Known here: %1.", listed(known_)));
}

Result<void> readForeignJson(std::string_view text, std::string_view where,
                             const std::function<void(JsonFields&)>& read) {
    if (auto ok = checkAmount(text); !ok)
        return inFile(where, ok.error());
    try {
        const json document = json::parse(text, TwinGuard());
        JsonFields fields(document, "");
        read(fields);
        return {};
    } catch (const FieldError& failure) {
        return inFile(where, failure.error);
    } catch (const json::exception& failure) {
        return Error{phrase("is no JSON that can be read (%1)", parserMessage(failure)), std::string(where), ""};
    }
}

Result<void> readJson(std::string_view text, std::string_view where, std::string_view format,
                      const std::function<void(JsonFields&)>& read) {
    return readForeignJson(text, where, [&](JsonFields& fields) {
        std::string found;
        int version = 0;
        fields.required("format", found);
        if (found != format)
            fields.fail("format", phrase("is \"%1\", must be \"%2\"", found, std::string(format)));
        fields.required("version", version);
        if (version != 1)
            fields.fail("version", phrase("is %1, this program reads version 1", version));
        read(fields);
        fields.finish();
    });
}

}  // namespace pdr
