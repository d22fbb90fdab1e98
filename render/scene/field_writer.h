#pragma once
/// Writes described structs (field.h) as JSON objects; reading them again gives equal values, to the bit. Numbers of
/// single precision are written with the fewest digits that identify them.

#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/scene/field.h"
#include "render/segment/labels.h"

namespace pdr {

/// Returns `fields` as the text of a file of that format, version 1, for readJson().
std::string jsonText(std::string_view format, const nlohmann::ordered_json& fields);

class FieldWriter {
  public:
    static constexpr bool kBranches = false;
    static constexpr bool kReads = false;

    template <class T>
    void operator()(const Field& field, const T& value) {
        object_[std::string(field.name)] = json(value);
    }
    /// Writes a text; an empty one counts as absent and is left out unless the field is required.
    void operator()(const Field& field, const std::string& value) {
        if (!value.empty() || field.required)
            object_[std::string(field.name)] = value;
    }
    template <class T>
    void operator()(const Field& field, const std::optional<T>& value) {
        if (value)
            (*this)(field, *value);
    }
    void direction(const Field& field, const dvec3& value) { (*this)(field, value); }

    template <class T, std::size_t N>
    void word(const Field& field, const T& value, const Words<T, N>& words) {
        for (const auto& [word, meaning] : words)
            if (meaning == value)
                object_[std::string(field.name)] = std::string(word);
    }
    /// Writes the labels; an empty set counts as absent.
    void labels(const Field& field, const segment::Labels& value) {
        if (!value.empty())
            object_[std::string(field.name)] = value;
    }
    template <class T>
    void object(const Field& field, T& value) {
        object_[std::string(field.name)] = written(value);
    }
    template <class T>
    void object(const Field& field, std::optional<T>& value) {
        if (value)
            object(field, *value);
    }
    template <class T>
    void list(const Field& field, std::vector<T>& values) {
        if (values.empty() && !field.required)
            return;
        nlohmann::ordered_json& all = object_[std::string(field.name)] = nlohmann::ordered_json::array();
        for (T& value : values)
            all.push_back(written(value));
    }

    template <class T>
    static nlohmann::ordered_json written(T& value) {
        FieldWriter writer;
        describe(writer, value);
        return std::move(writer.object_);
    }

  private:
    using Json = nlohmann::ordered_json;

    static Json json(double value) { return value; }
    static Json json(float value) {
        char text[32];
        const auto end = std::to_chars(text, text + sizeof text, value).ptr;
        double shortest = 0;
        std::from_chars(text, end, shortest);
        return shortest;
    }
    static Json json(bool value) { return value; }
    static Json json(int value) { return value; }
    static Json json(std::uint64_t value) { return value; }
    static Json json(const std::string& value) { return value; }
    static Json json(const vec3& value) { return {json(value.x), json(value.y), json(value.z)}; }
    static Json json(const dvec3& value) { return {value.x, value.y, value.z}; }
    static Json json(const ivec3& value) { return {value.x, value.y, value.z}; }
    static Json json(const std::pair<int, int>& value) { return {value.first, value.second}; }

    Json object_ = Json::object();
};

}  // namespace pdr
